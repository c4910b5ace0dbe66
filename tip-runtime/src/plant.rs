//! Simulated hardware: a robot and what it stands on or holds, deterministic to the bit.
//!
//! ```
//! use tip_runtime::command::Port;
//! use tip_runtime::hardware::{Hardware, Sensors};
//! use tip_runtime::model::{hand, titan8};
//! use tip_runtime::plant::{Plant, SimulatedHand, SimulatedPlant};
//!
//! let mut titan = SimulatedPlant::new(&titan8::MODEL);
//! assert!(titan.set_sensor(Port::Knob(1), 2.5));
//! let mut sensors = Sensors::ZERO;
//! assert_eq!(titan.read(&mut sensors), Ok(()));
//! assert_eq!(sensors.inputs.of(Port::Knob(1)), [2.5, 0.0, 0.0]);
//! assert_eq!(titan.motion().map(|motion| motion.falls), Some(0));
//!
//! let mut hand = SimulatedHand::new(&hand::MODEL);
//! assert!(!hand.set_sensor(Port::Paw(1), 1.0), "it has no soles");
//! assert_eq!(hand.motion(), None, "it is bolted down");
//! ```

mod cuboid;
pub mod dynamic;
pub mod hand;
mod override_sensors;
pub mod walker;

pub use crate::analog::volts_of_load;
pub use crate::scene::{
    BLOCKS, Block, Floor, OBJECTS, Object, Scene, SceneError, Shape, Simulation,
};
pub use dynamic::{Drives, DynamicPlant};
pub use hand::{Fingertip, ObjectState, SimulatedHand};
pub use walker::{Fall, Following, Foot, Pose, ServoDynamics, SimulatedPlant, Travel, Unmodelled};

use crate::command::Port;
use crate::hardware::{Hardware, HardwareFault};
use crate::model::Point;

/// How the body of a simulated robot moves.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Motion {
    /// Where the body is in the world.
    pub pose: Pose,
    /// How far it has come from where it began.
    pub travel: Travel,
    /// Number of falls so far: its body came down, or its support was lost.
    pub falls: u32,
    /// Number of these falls that left the body upright. One without mass would have fallen; one with mass caught itself.
    pub upright_falls: u32,
    /// How far inside the support polygon the centre of mass is: mm; negative outside.
    pub margin: f64,
    /// The least that this margin has been so far: mm.
    pub least_margin: f64,
    /// The farthest that any foot has slipped on one stance so far: mm.
    pub slip: f64,
    /// Commands that joints and feet could not follow.
    pub following: Following,
    /// What the simulation leaves out, counted; none if it leaves nothing out.
    pub unmodelled: Option<Unmodelled>,
}

/// The legs or fingers of a simulated robot as they are, whatever its sensors say.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Limbs<const L: usize, const J: usize> {
    /// Of each joint: deg.
    pub angles: [[f64; J]; L],
    /// How much of the robot each foot carries, or how hard each fingertip pushes: N. None if it is bolted down.
    pub loads: Option<[f64; L]>,
    /// With what force the ground pushes each foot, friction included, in the world: N. None where only loads are known; those of a
    /// hand are in [`Grasp`].
    pub forces: Option<[[f64; 3]; L]>,
    /// What each motor gives: in the robot's torque unit, in N·m if it has none.
    pub torques: [[f64; J]; L],
}

/// What a simulated hand does to the things around it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Grasp<const L: usize> {
    /// The ends of its fingers.
    pub fingertips: [Fingertip; L],
    /// The objects, in the order of the scene.
    pub objects: [Option<ObjectState>; OBJECTS],
    /// Where the slider is that carries the floor: mm.
    pub slider: Point,
}

/// Normally distributed errors of sensors, the same in every run that begins with the same seed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Noise {
    /// The standard deviation of each joint angle: deg.
    pub angle: f64,
    /// That of each sole's reading: V.
    pub volts: f64,
    /// Where its random numbers begin.
    pub seed: u64,
}

/// The fault of a plant whose numbers have grown beyond all bounds. It stays as it was before.
const DIVERGED: HardwareFault =
    HardwareFault("the simulation diverged: a force or a mass is too great for its time steps");

/// How far beyond its outer limits a joint meets its mechanical stops: deg.
const STOP: f64 = 2.0;

/// What turns a joint in a step: `torque - inertia × acceleration`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Effort {
    /// N·m.
    torque: f64,
    /// What stands for how the torque changes in the step: kg·m².
    inertia: f64,
}

/// Positions, speeds and torques beyond this are no robot's, in any unit of this module.
const BOUND: f64 = 1e9;

/// Returns true if numbers are what a robot's can be.
fn are_sane(mut values: impl Iterator<Item = f64>) -> bool {
    values.all(|value| libm::fabs(value) < BOUND)
}

/// Hardware that is simulated, so that the readings of its inputs can be set.
pub trait Plant<const L: usize, const J: usize>: Hardware<L, J> {
    /// Returns true if the robot has this input.
    fn has_input(&self, port: Port) -> bool;

    /// Makes an input read `volts` from now on; `false` if the robot lacks it.
    fn set_sensor(&mut self, port: Port, volts: f64) -> bool;

    /// Returns true if a force can move the body.
    fn can_be_pushed(&self) -> bool {
        false
    }

    /// Returns true if sensors can read with noise.
    fn can_have_noise(&self) -> bool {
        false
    }

    /// Pushes the body at its origin with a force in the world (N) for so many control cycles from now on; `false` if
    /// no force moves it. One push takes the place of the one before.
    fn push(&mut self, force: [f64; 3], cycles: u32) -> bool {
        let _ = (force, cycles);
        false
    }

    /// Lets sensors read with noise from now on; `false` if this plant has none.
    fn set_noise(&mut self, noise: Noise) -> bool {
        let _ = noise;
        false
    }

    /// How the body moves; `None` for a robot that stays where it is.
    fn motion(&self) -> Option<Motion> {
        None
    }

    /// When it first fell, if it did.
    fn first_fall(&self) -> Option<Fall> {
        None
    }

    /// Its legs or fingers; `None` where nothing but joints is simulated.
    fn limbs(&self) -> Option<Limbs<L, J>> {
        None
    }

    /// What it grasps; `None` for a robot that is not a hand.
    fn grasp(&self) -> Option<Grasp<L>> {
        None
    }
}
