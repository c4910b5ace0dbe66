//! Forward and inverse kinematics and Jacobians of a serial chain (Craig, *Introduction to
//! Robotics*, ch. 3–5).
//!
//! Positions are in mm in the robot frame. Angles are in degrees at this module's border and in
//! radians inside; a Jacobian is in mm/rad.

mod chain;
mod inverse;
mod resolved_rate;
mod search;
mod statics;
mod two_joints;

pub use chain::Chain;
pub use inverse::inverse;
pub use resolved_rate::{Point, nearest, resolve, resolve_towards};
pub use search::search;
pub(crate) use search::starts;

use crate::model::Leg;

/// Whether every angle lies within its joint's working limits, rounding aside.
#[must_use]
pub fn within_limits<const J: usize>(leg: &Leg<J>, angles: &[f64; J]) -> bool {
    first_beyond_limits(leg, angles).is_none()
}

/// The first joint (from 0) whose angle lies beyond its working limits, rounding aside.
#[must_use]
pub fn first_beyond_limits<const J: usize>(leg: &Leg<J>, angles: &[f64; J]) -> Option<usize> {
    leg.joints
        .iter()
        .zip(angles)
        .position(|(joint, angle)| !joint.limits.widened(ROUNDING).contains(*angle))
}

/// Angles that differ by less than this come from rounding: deg.
pub(crate) const ROUNDING: f64 = 1e-6;
