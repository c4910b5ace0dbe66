//! The closed form of a joint followed by two parallel ones at right angles to it: a roll and two pitches, as at
//! the hips of most quadrupeds (an anthropomorphic arm: Siciliano et al., *Robotics*, 2009, §2.12.4).
//!
//! Along the parallel axes no joint but the first moves the foot. So it turns the foot's distance to its axis
//! into that offset and a height, which is on either side; what is left are two links in a plane.

use super::planar::TwoLinks;
use super::{NEAR_AXIS, Solutions};
use crate::model::{Joint, Point};
use nalgebra::{Vector2, Vector3};

const DEGREES_PER_RADIAN: f64 = 180.0 / core::f64::consts::PI;

/// Tolerance for a foot that rounding puts nearer to the first axis than the offset, as a share of
/// the leg's squared length.
const INSIDE: f64 = 1e-12;

/// Returns the angles (deg) that put a foot at `foot` (mm). On the first axis, where any roll is
/// possible, the roll stays at `roll_now`.
pub(super) fn solutions(base: Point, joints: [&Joint; 3], foot: Point, roll_now: f64) -> Solutions {
    let [roll, thigh, knee] = joints;
    let (along, across) = (Vector3::from(roll.axis), Vector3::from(thigh.axis));
    let frame = Frame {
        along,
        across,
        height: along.cross(&across),
    };
    let [hip, upper, lower] = [roll, thigh, knee].map(|joint| Vector3::from(joint.link));
    let size = hip.norm() + upper.norm() + lower.norm();
    let reach = Vector3::from(foot) - Vector3::from(base);
    let aside = Vector2::new(frame.across.dot(&reach), frame.height.dot(&reach));

    let offset = frame.across.dot(&(hip + upper + lower));
    let square = aside.norm_squared() - offset * offset;
    // What is not a number is not outside either.
    let is_outside = square >= -INSIDE * size * size;
    if !is_outside {
        return [None; 4];
    }
    let height = libm::sqrt(square.max(0.0));
    let links = TwoLinks {
        first: frame.plane(&upper),
        second: frame.plane(&lower),
    };
    let knee_sense = libm::copysign(1.0, across.dot(&Vector3::from(knee.axis)));
    let solution = |height: f64, side: f64| {
        let turn = libm::atan2(aside.y, aside.x) - libm::atan2(height, offset);
        let turn = if aside.norm() <= NEAR_AXIS * size {
            roll_now
        } else {
            turn * DEGREES_PER_RADIAN
        };
        let reach = Vector2::new(height, along.dot(&reach)) - frame.plane(&hip);
        let [turned, bent] = links.turns(reach, side)?;
        Some([turn, turned, knee_sense * bent])
    };
    [
        solution(-height, 1.0),
        solution(-height, -1.0),
        solution(height, 1.0),
        solution(height, -1.0),
    ]
}

/// The axes of the leg while its first joint is at 0.
struct Frame {
    /// The axis of the first joint.
    along: Vector3<f64>,
    /// The axes of the other two joints.
    across: Vector3<f64>,
    /// The normal of both.
    height: Vector3<f64>,
}

impl Frame {
    /// Projects a vector onto the plane in which the last two joints turn; a positive turn about
    /// `across` is to the left.
    fn plane(&self, vector: &Vector3<f64>) -> Vector2<f64> {
        Vector2::new(self.height.dot(vector), self.along.dot(vector))
    }
}
