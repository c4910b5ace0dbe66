//! The closed form of two joints that turn about z, and put the third one of a planar leg.
//!
//! A triangle of two links and the line between their ends (Craig, *Introduction to Robotics*, ch. 4.4).
//! Joint 2 stays bent to the side to which it is bent.

use super::ROUNDING;
use super::chain::RADIANS_PER_DEGREE;
use crate::model::{Joint, Leg, Point, Range};
use nalgebra::Vector2;

/// A second joint that is bent less than this is straight, and may bend to either side: deg.
const STRAIGHT: f64 = 0.01;

/// How far beyond full stretch rounding alone can put a place, as a cosine.
const STRETCH: f64 = 1e-12;

/// The joint angles (deg) that put the third joint of `leg`, which is at `from`, at `place` (mm); `None`
/// if the links do not reach it, or a joint cannot turn so far. A straight leg bends to the side of
/// `posture`.
pub(super) fn two_joints<const J: usize>(
    leg: &Leg<J>,
    from: &[f64; J],
    [x, y, _]: Point,
    posture: &[f64; J],
) -> Option<[f64; J]> {
    let [first, second, ..] = leg.joints.as_slice() else {
        return None;
    };
    let [base_x, base_y, _] = leg.base;
    let reach = Vector2::new(x - base_x, y - base_y);
    let (a, b) = (flat(first), flat(second));
    let unbent = libm::atan2(a.perp(&b), a.dot(&b)) / RADIANS_PER_DEGREE;
    let bend = |angles: &[f64; J]| {
        let angle = angles.get(1).copied().unwrap_or_default();
        half_turn(sense(second) * angle + unbent)
    };
    let side = match bend(from) {
        straight if libm::fabs(straight) < STRAIGHT => bend(posture),
        bent => bent,
    };
    let (long, short) = (a.norm(), b.norm());
    let cosine = (reach.norm_squared() - long * long - short * short) / (2.0 * long * short);
    if !(-1.0 - STRETCH..=1.0 + STRETCH).contains(&cosine) {
        return None;
    }
    let bent = libm::copysign(libm::acos(cosine.clamp(-1.0, 1.0)), side);
    // In the frame of the first link, the second one goes on in its direction but for the bend.
    let (sin, cos) = libm::sincos(bent);
    let ahead = libm::atan2(short * sin, long + short * cos);
    let turned = libm::atan2(reach.y, reach.x) - libm::atan2(a.y, a.x) - ahead;
    let solved = [
        sense(first) * half_turn(turned / RADIANS_PER_DEGREE),
        sense(second) * half_turn(bent / RADIANS_PER_DEGREE - unbent),
    ];
    let mut angles = *from;
    let joints = angles.iter_mut().zip(&leg.joints);
    for ((angle, joint), solved) in joints.zip(solved) {
        // A joint that is beyond its limits already may come back.
        let free = Range::new(joint.limits.min.min(*angle), joint.limits.max.max(*angle));
        if !free.widened(ROUNDING).contains(solved) {
            return None;
        }
        *angle = free.nearest(solved);
    }
    Some(angles)
}

/// The link after a joint, in the plane.
fn flat(joint: &Joint) -> Vector2<f64> {
    let [x, y, _] = joint.link;
    Vector2::new(x, y)
}

/// Whether a joint turns to the left (1) or to the right (−1).
fn sense(joint: &Joint) -> f64 {
    let [_, _, z] = joint.axis;
    libm::copysign(1.0, z)
}

/// The same direction within −180…180 deg.
fn half_turn(angle: f64) -> f64 {
    angle - 360.0 * libm::round(angle / 360.0)
}
