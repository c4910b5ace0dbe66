//! Simulated hardware: a robot with its floor, obstacles and objects, deterministic to the bit.
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
#[cfg(feature = "std")]
mod distances;
pub mod dynamic;
pub mod hand;
pub mod self_collision;
mod sensors;
pub mod walker;

pub use crate::analog::volts_of_load;
pub use crate::scene::{
    BLOCKS, Block, Floor, OBJECTS, Object, Scene, SceneError, Shape, Simulation,
};
#[cfg(feature = "std")]
pub use distances::Distances;
pub use dynamic::{Drives, DynamicPlant};
pub use hand::{Fingertip, ObjectState, SimulatedHand};
pub use self_collision::{Clearance, Gap, SelfCollision};
pub use walker::{
    Fall, Foot, Pose, ServoDynamics, SimulatedPlant, TrackingErrors, Travel, Unmodelled,
};

use crate::command::Port;
use crate::hardware::{Hardware, HardwareFault};
use crate::model::Point;

/// The motion of a simulated robot's body.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Motion {
    /// Pose of the body in the world.
    pub pose: Pose,
    /// Travel of the body from its start.
    pub travel: Travel,
    /// Number of falls so far: the body came down, or lost its support.
    pub falls: u32,
    /// Number of these falls that left the body upright. A robot without mass would have fallen;
    /// one with mass caught itself.
    pub upright_falls: u32,
    /// Distance of the centre of mass from the edge of the support polygon, mm; negative outside.
    pub margin: f64,
    /// The least margin so far, mm.
    pub least_margin: f64,
    /// The greatest slip of a foot in one stance at the end of a cycle so far, mm.
    pub slip: f64,
    /// Commands that joints and feet could not follow.
    pub tracking_errors: TrackingErrors,
    /// Counts of the effects that the simulation leaves out; `None` if it leaves nothing out.
    pub unmodelled: Option<Unmodelled>,
}

/// The true state of a simulated robot's legs or fingers, whatever its sensors read.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Limbs<const L: usize, const J: usize> {
    /// Joint angles, deg.
    pub angles: [[f64; J]; L],
    /// The load of each foot or the contact force of each fingertip, N; `None` if the robot is
    /// bolted down.
    pub loads: Option<[f64; L]>,
    /// The force of the ground on each foot, friction included, in the world, N; `None` where only
    /// loads are known. Those of a hand are in [`Grasp`].
    pub forces: Option<[[f64; 3]; L]>,
    /// The slip of each foot since its touchdown, mm; `None` unless the robot walks.
    pub slips: Option<[f64; L]>,
    /// Motor torques, in the robot's torque unit, or in N·m if it has none.
    pub torques: [[f64; J]; L],
}

/// The contacts of a simulated hand with its surroundings.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Grasp<const L: usize> {
    /// The fingertips.
    pub fingertips: [Fingertip; L],
    /// The objects, in the order of the scene.
    pub objects: [Option<ObjectState>; OBJECTS],
    /// Position of the slider that carries the floor, mm.
    pub slider: Point,
}

/// Normally distributed errors of sensors, equal in every run with the same seed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Noise {
    /// Standard deviation of each joint angle, deg.
    pub angle: f64,
    /// Standard deviation of each sole's reading, V.
    pub volts: f64,
    /// Seed of the random numbers.
    pub seed: u64,
}

/// The fault of a plant whose state has diverged. The plant keeps its last valid state.
const DIVERGED: HardwareFault = HardwareFault::new(
    "the simulation diverged: a force or a mass is too great for its time steps",
);

/// Standard gravity: m/s² (3rd CGPM, 1901).
const GRAVITY: f64 = 9.80665;

/// Angle beyond its outer limit at which a joint meets its mechanical stop, deg.
const STOP: f64 = 2.0;

/// The effort on a joint in a step: `torque - inertia × acceleration`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Effort {
    /// N·m.
    torque: f64,
    /// Inertia that represents the change of the torque in the step, kg·m².
    inertia: f64,
}

impl Effort {
    /// Returns the torque of a joint that accelerates (rad/s²), N·m.
    #[inline]
    fn at(self, acceleration: f64) -> f64 {
        self.torque - self.inertia * acceleration
    }

    #[inline]
    fn plus(self, other: Self) -> Self {
        Effort {
            torque: self.torque + other.torque,
            inertia: self.inertia + other.inertia,
        }
    }
}

/// Stiffness and damping of a contact, along its normal and across it.
#[derive(Clone, Copy, Debug, PartialEq)]
struct ContactLaw {
    /// N/m.
    stiffness: f64,
    /// N·s/m.
    damping: f64,
}

impl ContactLaw {
    /// Returns the force along the normal (N) on bodies that overlap by `depth` (m) and move apart at
    /// `away` (m/s): that of a spring and a damper, which push and never pull.
    #[inline]
    fn push(&self, depth: f64, away: f64) -> f64 {
        (self.stiffness * depth - self.damping * away).max(0.0)
    }
}

/// Copies one value of each servo into `into`. Out of line, so that it is compiled once for all
/// numbers of legs.
#[inline(never)]
fn fill_joints<G, S, const J: usize>(
    legs: &[G],
    servos: fn(&G) -> &[S; J],
    into: &mut [[f64; J]],
    value: fn(&S) -> f64,
) {
    for (row, leg) in into.iter_mut().zip(legs) {
        for (place, servo) in row.iter_mut().zip(servos(leg)) {
            *place = value(servo);
        }
    }
}

/// Returns true if a lamp or relay of these words is on.
fn is_lit(lamps: &[u32; 8], device: u8) -> bool {
    let word = lamps.get(usize::from(device / 32));
    word.is_some_and(|word| word >> (device % 32) & 1 == 1)
}

/// The bound of positions, speeds and torques of a valid state, in any unit of this module.
const BOUND: f64 = 1e9;

/// Returns true if all values are within the bound.
fn are_sane(mut values: impl Iterator<Item = f64>) -> bool {
    values.all(|value| libm::fabs(value) < BOUND)
}

/// Hardware that is simulated, so that the readings of its inputs can be set.
pub trait Plant<const L: usize, const J: usize>: Hardware<L, J> {
    /// Returns true if the robot has this input.
    fn has_input(&self, port: Port) -> bool;

    /// Makes an input read `volts` from now on; returns `false` if the robot lacks it.
    fn set_sensor(&mut self, port: Port, volts: f64) -> bool;

    /// Returns true if a force can move the body.
    fn can_be_pushed(&self) -> bool {
        false
    }

    /// Returns true if sensors can read with noise.
    fn can_have_noise(&self) -> bool {
        false
    }

    /// Pushes the body at its origin with a force in the world (N) for `cycles` control cycles from
    /// now on; returns `false` if no force moves it. A push replaces the previous one.
    fn push(&mut self, force: [f64; 3], cycles: u32) -> bool {
        let _ = (force, cycles);
        false
    }

    /// Adds noise to the sensors from now on; returns `false` if this plant has none.
    fn set_noise(&mut self, noise: Noise) -> bool {
        let _ = noise;
        false
    }

    /// Returns the motion of the body; `None` for a robot that stays where it is.
    fn motion(&self) -> Option<Motion> {
        None
    }

    /// Returns the first fall, if any.
    fn first_fall(&self) -> Option<Fall> {
        None
    }

    /// Measures the least distance of two parts of the robot; `None` where it cannot be measured, or no pair is compared.
    /// A control cycle does not need the distance, so that a run that does not ask for it saves the time.
    fn gap(&self) -> Option<Gap> {
        None
    }

    /// Returns the state of the legs or fingers; `None` where nothing but joints is simulated.
    fn limbs(&self) -> Option<Limbs<L, J>> {
        None
    }

    /// Returns the contacts of a hand; `None` for other robots.
    fn grasp(&self) -> Option<Grasp<L>> {
        None
    }
}
