//! The closed form of a yaw followed by a thigh and a knee.
//!
//! The leg turns about the vertical until it points at the foot, or away from it; the remaining
//! triangle is made of thigh, shank and the line between their ends, with the knee above or below
//! that line.

use super::{NEAR_AXIS, Solutions};
use crate::model::{Joint, Point};
use nalgebra::Vector3;

const DEGREES_PER_RADIAN: f64 = 180.0 / core::f64::consts::PI;

/// Tolerance for a foot that rounding puts beyond full stretch, as a cosine.
const STRETCH: f64 = 1e-12;

/// Returns the angles (deg) that put a foot at `foot` (mm): first those of a leg that points at it
/// with its knee up. On the yaw axis, where any yaw is possible, the yaw stays at `yaw_now`.
pub(super) fn solutions(base: Point, joints: [&Joint; 3], foot: Point, yaw_now: f64) -> Solutions {
    let [yaw, thigh, knee] = joints;
    let reach = Vector3::from(foot) - Vector3::from(base);
    let level = Vector3::new(reach.x, reach.y, 0.0);
    let (l1, l2, l3) = (length(yaw), length(thigh), length(knee));
    let outward = Vector3::from(yaw.link) / l1;
    let yaw_axis = Vector3::from(yaw.axis);
    let turn = libm::atan2(yaw_axis.dot(&outward.cross(&level)), outward.dot(&level));
    let turn = turn * DEGREES_PER_RADIAN;
    let turns = if level.norm() <= NEAR_AXIS * (l1 + l2 + l3) {
        [yaw_now; 2]
    } else {
        [turn, turn - libm::copysign(180.0, turn)]
    };

    let lift = outward.cross(&Vector3::z());
    let thigh_sign = lift.dot(&Vector3::from(thigh.axis));
    let knee_sign = -lift.dot(&Vector3::from(knee.axis));
    let solution = |[turn, out]: [f64; 2], side: f64| {
        let [raised, flexed] = triangle([l2, l3], [out, reach.z], side)?;
        Some([turn, thigh_sign * raised, knee_sign * flexed])
    };
    let [towards, away] = turns;
    let towards = [towards, level.norm() - l1];
    let away = [away, -level.norm() - l1];
    [
        solution(towards, 1.0),
        solution(towards, -1.0),
        solution(away, 1.0),
        solution(away, -1.0),
    ]
}

/// Returns the raise of the thigh and the flexion of the knee, to the side of `side`, for a foot at
/// a distance and height, deg.
fn triangle([l2, l3]: [f64; 2], [out, up]: [f64; 2], side: f64) -> Option<[f64; 2]> {
    let bend = (out * out + up * up - l2 * l2 - l3 * l3) / (2.0 * l2 * l3);
    if !(-1.0 - STRETCH..=1.0 + STRETCH).contains(&bend) {
        return None;
    }
    let flexed = libm::copysign(libm::acos(bend.clamp(-1.0, 1.0)), side);
    let (sin, cos) = libm::sincos(flexed);
    let raised = libm::atan2(up, out) + libm::atan2(l3 * sin, l2 + l3 * cos);
    Some([
        half_turn(raised * DEGREES_PER_RADIAN),
        flexed * DEGREES_PER_RADIAN,
    ])
}

fn length(joint: &Joint) -> f64 {
    Vector3::from(joint.link).norm()
}

/// Returns the equivalent of an angle of −360…360 deg within −180…180 deg.
fn half_turn(angle: f64) -> f64 {
    if angle > 180.0 {
        angle - 360.0
    } else if angle < -180.0 {
        angle + 360.0
    } else {
        angle
    }
}
