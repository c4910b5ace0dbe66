//! Two links in a plane: the triangle of the links and the line between their ends (Craig,
//! *Introduction to Robotics*, ch. 4.4), and the closed form of two joints that turn about z and put
//! the third joint of a planar leg.

use super::ROUNDING;
use super::chain::RADIANS_PER_DEGREE;
use crate::model::{Joint, Leg, Point, Range};
use nalgebra::Vector2;

/// Bend of a second joint below which it counts as straight and may bend to either side, deg.
const STRAIGHT: f64 = 0.01;

/// Tolerance for a place that rounding puts beyond full stretch, as a cosine.
const STRETCH: f64 = 1e-12;

/// Two links at angle 0, mm.
#[derive(Clone, Copy)]
pub(super) struct TwoLinks {
    pub(super) first: Vector2<f64>,
    pub(super) second: Vector2<f64>,
}

impl TwoLinks {
    /// Returns the bend of the second link to the left of the first one at angle 0, deg.
    pub(super) fn unbent(&self) -> f64 {
        let (a, b) = (self.first, self.second);
        libm::atan2(a.perp(&b), a.dot(&b)) / RADIANS_PER_DEGREE
    }

    /// Returns the turns of the links to the left (deg) that lead to `reach` (mm), with the second
    /// one bent to the side of `side`; `None` if the links do not reach it.
    pub(super) fn turns(&self, reach: Vector2<f64>, side: f64) -> Option<[f64; 2]> {
        let (a, b) = (self.first, self.second);
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
        Some([
            turned / RADIANS_PER_DEGREE,
            bent / RADIANS_PER_DEGREE - self.unbent(),
        ])
    }
}

/// Returns the joint angles (deg) that put the third joint of `leg`, which is at `from`, at `place`
/// (mm); `None` if the links do not reach it, or a joint cannot turn so far. A straight leg bends
/// to the side of `posture`. Joint 2 keeps the side to which it is bent.
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
    let links = TwoLinks {
        first: flat(first),
        second: flat(second),
    };
    let unbent = links.unbent();
    let bend = |angles: &[f64; J]| {
        let angle = angles.get(1).copied().unwrap_or_default();
        half_turn(sense(second) * angle + unbent)
    };
    let side = match bend(from) {
        straight if libm::fabs(straight) < STRAIGHT => bend(posture),
        bent => bent,
    };
    let [turned, bent] = links.turns(Vector2::new(x - base_x, y - base_y), side)?;
    let solved = [
        sense(first) * half_turn(turned),
        sense(second) * half_turn(bent),
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

/// Returns the link after a joint, in the plane.
fn flat(joint: &Joint) -> Vector2<f64> {
    let [x, y, _] = joint.link;
    Vector2::new(x, y)
}

/// Returns 1 if a joint turns to the left, −1 if it turns to the right.
fn sense(joint: &Joint) -> f64 {
    let [_, _, z] = joint.axis;
    libm::copysign(1.0, z)
}

/// Returns the equivalent angle within −180…180 deg.
fn half_turn(angle: f64) -> f64 {
    angle - 360.0 * libm::round(angle / 360.0)
}
