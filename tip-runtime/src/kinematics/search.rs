//! Global search for joint angles, independent of the current posture.
//!
//! Damped least squares go downhill: within the limits of the joints they may end in a local
//! minimum from which the target cannot be reached. The search then starts again, from postures
//! that are spread evenly over the limits (multiples of the square roots of primes, modulo 1:
//! Richtmyer, *The Evaluation of Definite Integrals, and a Quasi-Monte-Carlo Method*, 1951).

use super::{LegPoint, resolve};
use crate::command::MAX;
use crate::model::{Axes, Leg, Point};

/// Number of start postures besides the initial one. They are enough for 99.9 % of the reachable
/// targets of random chains.
const STARTS: u8 = 15;

/// One prime for each joint.
const PRIMES: [f64; MAX] = [2.0, 3.0, 5.0, 7.0, 11.0, 13.0, 17.0, 19.0, 23.0];

/// Returns the joint angles (deg) that put `point` of `leg` at `target` (mm) along the axes that
/// count, within the limits; `None` if none are found. The initial posture is tried first.
#[must_use]
pub fn search<const J: usize>(
    leg: &Leg<J>,
    point: LegPoint,
    target: Point,
    axes: Axes,
) -> Option<[f64; J]> {
    starts(leg).find_map(|from| resolve(leg, &from, point, target, axes))
}

/// Iterates over start postures that are spread over the limits, the initial one first.
pub(crate) fn starts<const J: usize>(leg: &Leg<J>) -> impl Iterator<Item = [f64; J]> + '_ {
    let spread = (0..STARTS).map(|number| start(leg, number));
    core::iter::once(leg.initial).chain(spread)
}

/// Returns the start posture of a number; 0 is the middle of the limits.
fn start<const J: usize>(leg: &Leg<J>, number: u8) -> [f64; J] {
    let mut angles = leg.initial;
    let joints = leg.joints.iter().zip(PRIMES);
    for (angle, (joint, prime)) in angles.iter_mut().zip(joints) {
        let share = libm::modf(0.5 + f64::from(number) * libm::sqrt(prime)).0;
        *angle = joint.limits.min + (joint.limits.max - joint.limits.min) * share;
    }
    angles
}

#[cfg(test)]
mod tests {
    use super::start;
    use crate::model::{Joint, Leg};

    #[test]
    fn starts_are_spread_from_the_middle_of_the_limits() {
        let hinge = Joint::revolute([0.0, 0.0, 1.0], [100.0, 0.0, 0.0]).limits(-100.0, 100.0);
        let leg = Leg::at([0.0; 3], [hinge; 2]);
        // ½ + n √2 and ½ + n √3, without their whole parts, are the shares of 200 deg.
        let expected = [[0.0, 0.0], [82.8427, -53.5898], [-34.3146, 92.8203]];
        for (number, expected) in (0..).zip(expected) {
            let found = start(&leg, number);
            for (found, expected) in found.iter().zip(expected) {
                assert!((found - expected).abs() < 1e-3, "{number}: {found}");
            }
        }
    }
}
