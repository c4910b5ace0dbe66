//! Joint angles from a foot's position.

use super::{LegPoint, search};
use crate::model::{Inverse, Joint, Leg, Point};
use nalgebra::Vector3;

const DEGREES_PER_RADIAN: f64 = 180.0 / core::f64::consts::PI;

/// How far beyond full stretch rounding alone can put a foot, as a cosine.
const STRETCH: f64 = 1e-12;

/// The joint angles (deg) that put the foot of `leg` at `foot` (mm); `None` if the links do not
/// reach it. A closed form asks nothing of the joints' limits; least squares keep within them. See [`within_limits`](super::within_limits) for the limits.
#[must_use]
pub fn inverse<const J: usize>(kind: Inverse, leg: &Leg<J>, foot: Point) -> Option<[f64; J]> {
    match kind {
        Inverse::YawPitchPitch => {
            let [yaw, thigh, knee] = leg.joints.as_slice() else {
                return None;
            };
            let solved = yaw_pitch_pitch(leg.base, [yaw, thigh, knee], foot)?;
            let mut angles = [0.0; J];
            for (angle, solved) in angles.iter_mut().zip(solved) {
                *angle = solved;
            }
            Some(angles)
        }
        Inverse::Planar | Inverse::LeastSquares => search(leg, LegPoint::Tip, foot, kind.axes()),
    }
}

/// The leg turns about the vertical until it points at the foot; what is left is a triangle of
/// thigh, shank and the line between their ends, with the knee above that line.
fn yaw_pitch_pitch(base: Point, [yaw, thigh, knee]: [&Joint; 3], foot: Point) -> Option<[f64; 3]> {
    let reach = Vector3::from(foot) - Vector3::from(base);
    let level = Vector3::new(reach.x, reach.y, 0.0);
    let (l1, l2, l3) = (length(yaw), length(thigh), length(knee));
    let outward = Vector3::from(yaw.link) / l1;
    let yaw_axis = Vector3::from(yaw.axis);
    let turn = libm::atan2(yaw_axis.dot(&outward.cross(&level)), outward.dot(&level));

    let (out, up) = (level.norm() - l1, reach.z);
    let bend = (out * out + up * up - l2 * l2 - l3 * l3) / (2.0 * l2 * l3);
    if !(-1.0 - STRETCH..=1.0 + STRETCH).contains(&bend) {
        return None;
    }
    let flexed = libm::acos(bend.clamp(-1.0, 1.0));
    let (sin, cos) = libm::sincos(flexed);
    let raised = libm::atan2(up, out) + libm::atan2(l3 * sin, l2 + l3 * cos);

    let lift = outward.cross(&Vector3::z());
    let thigh_sign = lift.dot(&Vector3::from(thigh.axis));
    let knee_sign = -lift.dot(&Vector3::from(knee.axis));
    Some([
        turn * DEGREES_PER_RADIAN,
        thigh_sign * half_turn(raised * DEGREES_PER_RADIAN),
        knee_sign * flexed * DEGREES_PER_RADIAN,
    ])
}

fn length(joint: &Joint) -> f64 {
    Vector3::from(joint.link).norm()
}

/// The same direction within −180…180 deg as `angle`, of −180…360 deg.
fn half_turn(angle: f64) -> f64 {
    if angle > 180.0 { angle - 360.0 } else { angle }
}
