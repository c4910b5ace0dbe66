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
mod resolved_rate;

pub use chain::{Chain, Frame, frames};
pub use resolved_rate::{LegPoint, nearest, resolve, resolve_towards, search};
pub(crate) use resolved_rate::{is_straight, resolve_piece, starts};

use crate::model::{Inverse, Leg, Point};
use closed_form::ClosedFormLeg;

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

/// Returns the largest turn of a joint from one posture to another, deg.
pub(crate) fn largest_turn<const J: usize>(from: &[f64; J], to: &[f64; J]) -> f64 {
    let turns = from.iter().zip(to).map(|(from, to)| libm::fabs(to - from));
    turns.fold(0.0, f64::max)
}

/// Greatest difference of angles that rounding explains, deg.
pub(crate) const ROUNDING: f64 = 1e-6;

/// The solutions of a closed form for a leg of three joints (deg), the preferred ones first.
type Solutions = [Option<[f64; 3]>; 4];

/// Greatest distance of a foot from its first axis at which it counts as on it, as a share of the
/// leg's length.
const NEAR_AXIS: f64 = 1e-10;

/// Returns the joint angles (deg) that put the foot of `leg` at `foot` (mm); `None` if the links do
/// not reach it. Of several solutions within the limits, a closed form takes the one nearest to the
/// initial posture; if there is none, it returns its first solution, so that the caller can name
/// the joint that would have to turn too far. Least squares keep within the limits. See
/// [`within_limits`].
#[must_use]
pub fn inverse<const J: usize>(kind: Inverse, leg: &Leg<J>, foot: Point) -> Option<[f64; J]> {
    if !kind.is_closed() {
        return search(leg, LegPoint::Tip, foot, kind.axes());
    }
    let (closed, initial) = closed(kind, leg, &leg.initial)?;
    let [first, ..] = closed.solutions(&initial, foot);
    sized(closed.nearest(&initial, foot).or(first)?)
}

/// Returns the joint angles (deg) within the limits that put the foot of `leg` at `foot` (mm), the
/// ones nearest to the angles `from`; `None` if there are none.
///
/// ```
/// use tip_runtime::kinematics::{Chain, inverse_from};
/// use tip_runtime::model::titan8;
///
/// // Folded as far as it goes, a leg of TITAN VIII has its foot 3 mm beyond the yaw axis.
/// let leg = &titan8::MODEL.legs[1];
/// let folded = [10.0, -60.0, 150.0];
/// let foot = Chain::new(leg, &folded).foot();
/// let near = inverse_from(titan8::MODEL.inverse, leg, &[0.0, -50.0, 145.0], foot).expect("it is there");
/// assert!(near.iter().zip(folded).all(|(a, b)| (a - b).abs() < 1e-9));
/// ```
#[must_use]
pub fn inverse_from<const J: usize>(
    kind: Inverse,
    leg: &Leg<J>,
    from: &[f64; J],
    foot: Point,
) -> Option<[f64; J]> {
    if !kind.is_closed() {
        return resolve(leg, from, LegPoint::Tip, foot, kind.axes());
    }
    let (closed, from) = closed(kind, leg, from)?;
    sized(closed.nearest(&from, foot)?)
}

/// Like [`inverse_from`] of a closed form, for the next position of a foot on its path: it skips no postures.
pub(crate) fn inverse_next<const J: usize>(
    kind: Inverse,
    leg: &Leg<J>,
    from: &[f64; J],
    foot: Point,
) -> Option<[f64; J]> {
    let (closed, from) = closed(kind, leg, from)?;
    sized(closed.next(&from, foot)?)
}

fn closed<'a, const J: usize>(
    kind: Inverse,
    leg: &'a Leg<J>,
    from: &[f64; J],
) -> Option<(ClosedFormLeg<'a>, [f64; 3])> {
    let closed = ClosedFormLeg::new(kind, leg.base, &leg.joints)?;
    Some((closed, from.as_slice().try_into().ok()?))
}

/// Converts the three angles of a closed form.
fn sized<const J: usize>(angles: [f64; 3]) -> Option<[f64; J]> {
    angles.as_slice().try_into().ok()
}
