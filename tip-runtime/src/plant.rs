//! Simulated hardware: a robot and what it stands on or holds, deterministic to the bit.

pub mod hand;
mod override_sensors;
pub mod walker;

pub use crate::scene::{Floor, OBJECTS, Object, Scene, SceneError, Shape};
pub use hand::{Fingertip, ObjectState, SimulatedHand};
pub use walker::{Fall, Foot, Pose, ServoDynamics, SimulatedPlant};

use crate::command::Port;
use crate::hardware::Hardware;

/// How the body of a simulated robot moves.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Motion {
    /// Where the body is in the world.
    pub pose: Pose,
    /// How often the centre of mass has left the support polygon so far.
    pub falls: u32,
    /// How far inside the support polygon the centre of mass is: mm; negative outside.
    pub margin: f64,
    /// The farthest that any foot has slipped on one stance so far: mm.
    pub slip: f64,
}

/// Hardware that is simulated, so that the readings of its inputs can be set.
pub trait Plant<const L: usize, const J: usize>: Hardware<L, J> {
    /// Makes an input read `volts` from now on; `false` if the robot lacks it.
    fn set_sensor(&mut self, port: Port, volts: f64) -> bool;

    /// How the body moves; `None` for a robot that stays where it is.
    fn motion(&self) -> Option<Motion> {
        None
    }
}
