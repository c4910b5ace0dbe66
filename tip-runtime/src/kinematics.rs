//! Forward and inverse kinematics and Jacobians of a serial chain (Craig, *Introduction to
//! Robotics*, ch. 3–5).
//!
//! Positions are in mm in the robot frame. Angles are in degrees at this module's border and in
//! radians inside; a Jacobian is in mm/rad.
//!
//! The front left leg of TITAN VIII: 50 mm and 240 mm outwards from its hip at (−101, 201, 0), then 200 mm down.
//!
//! ```
//! use tip_runtime::kinematics::{Chain, inverse};
//! use tip_runtime::model::titan8;
//!
//! let is_near = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9);
//!
//! let leg = &titan8::MODEL.legs[0];
//! let chain = Chain::new(leg, &[0.0, 0.0, 90.0]);
//! assert!(is_near(chain.foot(), [-101.0 - 290.0, 201.0, -200.0]));
//!
//! // The first joint turns the foot on a circle of 290 mm; on the left a positive angle is forwards.
//! assert!(is_near(chain.foot_jacobian()[0], [0.0, 290.0, 0.0]));
//!
//! let angles = inverse(titan8::MODEL.inverse, leg, chain.foot()).expect("it is there");
//! assert!(is_near(angles, [0.0, 0.0, 90.0]));
//! ```

mod chain;
mod closed_form;
mod frames;
mod inverse;
mod planar;
mod resolved_rate;
mod roll_pitch_pitch;
mod search;
mod statics;
mod yaw_pitch_pitch;

pub use chain::Chain;
pub use frames::{Frame, frames};
pub(crate) use inverse::inverse_next;
pub use inverse::{inverse, inverse_from};
pub use resolved_rate::{LegPoint, nearest, resolve, resolve_towards};
pub(crate) use resolved_rate::{is_straight, resolve_piece};
pub use search::search;
pub(crate) use search::starts;

use crate::model::Leg;

/// Returns true if every angle (deg) lies within its joint's working limits, rounding aside.
#[must_use]
pub fn within_limits<const J: usize>(leg: &Leg<J>, angles: &[f64; J]) -> bool {
    first_beyond_limits(leg, angles).is_none()
}

/// Returns the first joint (from 0) whose angle (deg) lies beyond its working limits, rounding
/// aside.
#[must_use]
pub fn first_beyond_limits<const J: usize>(leg: &Leg<J>, angles: &[f64; J]) -> Option<usize> {
    leg.joints
        .iter()
        .zip(angles)
        .position(|(joint, angle)| !joint.limits.widened(ROUNDING).contains(*angle))
}

/// Greatest difference of angles that rounding explains, deg.
pub(crate) const ROUNDING: f64 = 1e-6;

/// The solutions of a closed form for a leg of three joints (deg), the preferred ones first.
type Solutions = [Option<[f64; 3]>; 4];

/// Greatest distance of a foot from its first axis at which it counts as on it, as a share of the
/// leg's length.
const NEAR_AXIS: f64 = 1e-10;
