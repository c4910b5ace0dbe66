//! Simulated hardware: a robot and what it stands on or holds, deterministic to the bit.

pub mod hand;
mod override_sensors;
mod scene;
pub mod walker;

pub use hand::{Fingertip, ObjectState, SimulatedHand};
pub use scene::{OBJECTS, Object, Scene, SceneError, Shape};
pub use walker::{Fall, Floor, Foot, Pose, ServoDynamics, SimulatedPlant};

use crate::command::Port;
use crate::hardware::Hardware;

/// Hardware that is simulated, so that its inputs can be told what to read.
pub trait Plant<const L: usize, const J: usize>: Hardware<L, J> {
    /// Makes an input read `volts` from now on; `false` if the robot lacks it.
    fn set_sensor(&mut self, port: Port, volts: f64) -> bool;
}
