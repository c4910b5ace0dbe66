//! Inverse kinematics of any chain and any of its points by resolved rate.
//!
//! Joints turn by `J# e`, the least turn that closes the gap `e` (Whitney, *Resolved Motion Rate
//! Control of Manipulators and Human Prostheses*, 1969), again and again until it is closed. A
//! damping in proportion to the gap keeps turns finite in singular postures and vanishes at the
//! target (Sugihara, *Solvability-Unconcerned Inverse Kinematics by the Levenberg–Marquardt
//! Method*, 2011; damped least squares: Nakamura and Hanafusa, *Inverse Kinematic Solutions with
//! Singularity Robustness for Robot Manipulator Control*, 1986). A joint that meets its limit stays
//! there; the others go on.
//!
//! Joints to spare turn towards a posture `p`, by the part of `p − q` that leaves the point where it
//! is: `J# e + (1 − J# J) (p − q)` (Liégeois, *Automatic Supervisory Control of the Configuration and
//! Behavior of Multibody Mechanisms*, 1977). In a singular posture, where a joint may bend to either
//! side, `p` decides to which.
//!
//! Damped least squares go downhill: within the limits of the joints they may end in a local
//! minimum from which the target cannot be reached. A search starts again, from postures
//! that are spread evenly over the limits (multiples of the square roots of primes, modulo 1:
//! Richtmyer, *The Evaluation of Definite Integrals, and a Quasi-Monte-Carlo Method*, 1951).

use super::Chain;
use super::chain::{is_singular, least_norm, rows_that_count};
use super::closed_form::two_joints;
use crate::command::MAX;
use crate::model::{Axes, Leg, Point};
use crate::ops::RADIANS_PER_DEGREE;
use nalgebra::{SMatrix, SVector, Vector3};

/// A point of a leg that can be placed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LegPoint {
    /// The foot or fingertip.
    Tip,
    /// The place of a joint, counted from 0; only the joints before it move it.
    Joint(usize),
}

impl LegPoint {
    /// Returns the number of joints of a leg of `joints`, counted from its base, that move the
    /// point.
    #[must_use]
    pub const fn moved_by(self, joints: usize) -> usize {
        match self {
            LegPoint::Tip => joints,
            LegPoint::Joint(m) => m,
        }
    }
}

/// The axes that count where every joint turns about z.
const PLANE: Axes = [true, true, false];

/// The greatest gap that counts as closed, mm.
const CLOSED: f64 = 1e-9;

/// The gap that rounding leaves where a leg is stretched out, mm.
const LEFT_OVER: f64 = 1e-6;

/// Maximum number of iterations.
const MAX_ITERATIONS: usize = 60;

/// Maximum number of iterations for a piece of a path.
const TURNS_OF_PIECE: usize = 10;

/// Maximum turn of one iteration, deg.
const FARTHEST: f64 = 15.0;

/// The ratio of Gram determinants, against that of a sphere of the same trace, below which a leg
/// counts as straight.
const STRAIGHT: f64 = 1e-5;

/// Minimum bend of the joints of a straight leg towards the side of their posture, deg. The gap
/// itself bends them to neither side, or to either.
const LEAST_BEND: f64 = 0.5;

/// The share of the way to its posture that a leg with redundant joints takes in one iteration.
const LEANING: f64 = 0.5;

/// Returns the joint angles (deg) near `from` that put `point` of `leg` at `target` (mm) along the
/// axes that count; `None` if no angles within the limits are found. A joint that is already beyond
/// its limits may stay there.
#[must_use]
pub fn resolve<const J: usize>(
    leg: &Leg<J>,
    from: &[f64; J],
    point: LegPoint,
    target: Point,
    axes: Axes,
) -> Option<[f64; J]> {
    let (angles, left) = approach(leg, from, point, target, axes, None, MAX_ITERATIONS)?;
    (left <= LEFT_OVER).then_some(angles)
}

/// Like [`resolve`], with redundant joints turning towards `posture` (deg). The third joint of a
/// planar leg is not redundant; a closed form keeps the side to which joint 2 is bent.
#[must_use]
pub fn resolve_towards<const J: usize>(
    leg: &Leg<J>,
    from: &[f64; J],
    point: LegPoint,
    target: Point,
    axes: Axes,
    posture: &[f64; J],
) -> Option<[f64; J]> {
    lean_within(MAX_ITERATIONS, leg, from, point, target, axes, posture)
}

/// Like [`resolve_towards`], for a target so near that few iterations are enough.
pub(crate) fn resolve_piece<const J: usize>(
    leg: &Leg<J>,
    from: &[f64; J],
    point: LegPoint,
    target: Point,
    axes: Axes,
    posture: &[f64; J],
) -> Option<[f64; J]> {
    lean_within(TURNS_OF_PIECE, leg, from, point, target, axes, posture)
}

fn lean_within<const J: usize>(
    most: usize,
    leg: &Leg<J>,
    from: &[f64; J],
    point: LegPoint,
    target: Point,
    axes: Axes,
    posture: &[f64; J],
) -> Option<[f64; J]> {
    if point == LegPoint::Joint(2) && axes == PLANE {
        return two_joints(leg, from, target, posture);
    }
    let (angles, left) = approach(leg, from, point, target, axes, Some(posture), most)?;
    (left <= LEFT_OVER).then_some(angles)
}

/// Like [`resolve`], but returns the nearest approach if the target is out of reach.
#[must_use]
pub fn nearest<const J: usize>(
    leg: &Leg<J>,
    from: &[f64; J],
    point: LegPoint,
    target: Point,
    axes: Axes,
) -> Option<[f64; J]> {
    approach(leg, from, point, target, axes, None, MAX_ITERATIONS).map(|(angles, _)| angles)
}

/// Returns true if a leg is straight, or nearly so, and has redundant joints for its point: its
/// posture does not show then to which side it bends.
pub(crate) fn is_straight<const J: usize>(
    leg: &Leg<J>,
    angles: &[f64; J],
    point: LegPoint,
    axes: Axes,
) -> bool {
    let directions = axes.iter().filter(|counts| **counts).count();
    let jacobian = Chain::new(leg, angles).jacobian_of(point);
    let spare = jacobian.filter(|_| point.moved_by(J) > directions);
    spare.is_some_and(|jacobian| is_singular(&rows_that_count(jacobian, axes), axes, STRAIGHT))
}

/// Returns the angles (deg) that put a point as near to its target as possible, and the remaining
/// gap (mm). The first of at most `most` iterations leans towards a posture, if there is one.
fn approach<const J: usize>(
    leg: &Leg<J>,
    from: &[f64; J],
    point: LegPoint,
    target: Point,
    axes: Axes,
    mut posture: Option<&[f64; J]>,
    most: usize,
) -> Option<([f64; J], f64)> {
    let mut angles = *from;
    for _ in 0..most {
        let chain = Chain::new(leg, &angles);
        let gap = gap(&chain, point, target, axes)?;
        let posture = posture.take();
        if gap.norm() <= CLOSED && posture.is_none() {
            return Some((angles, gap.norm()));
        }
        let jacobian = rows_that_count(chain.jacobian_of(point)?, axes);
        let mut lean = posture.map_or([0.0; J], |posture| lean(&angles, posture));
        if gap.norm() > CLOSED && is_singular(&jacobian, axes, STRAIGHT) {
            bend(&mut lean);
        }
        let turns = turns_within_limits(leg, from, &angles, |free| {
            turns(&jacobian, free, &gap, &lean)
        })?;
        turn(&mut angles, &turns);
        clamp(leg, from, &mut angles);
    }
    let left = gap(&Chain::new(leg, &angles), point, target, axes)?;
    Some((angles, left.norm()))
}

/// Returns the turns of the joints towards a posture, deg.
fn lean<const J: usize>(angles: &[f64; J], posture: &[f64; J]) -> [f64; J] {
    let mut lean = *posture;
    for (lean, angle) in lean.iter_mut().zip(angles) {
        *lean = (*lean - angle) * LEANING;
    }
    lean
}

fn gap<const J: usize>(
    chain: &Chain<J>,
    point: LegPoint,
    target: Point,
    axes: Axes,
) -> Option<Vector3<f64>> {
    let mut gap = Vector3::from(target) - Vector3::from(chain.point(point)?);
    for (gap, counts) in gap.iter_mut().zip(axes) {
        if !counts {
            *gap = 0.0;
        }
    }
    Some(gap)
}

/// Scales the largest part up to [`LEAST_BEND`], unless all are zero.
fn bend<const J: usize>(lean: &mut [f64; J]) {
    let largest = largest(lean);
    if largest > 0.0 && largest < LEAST_BEND {
        for lean in lean {
            *lean *= LEAST_BEND / largest;
        }
    }
}

fn largest<const J: usize>(turns: &[f64; J]) -> f64 {
    turns
        .iter()
        .fold(0.0_f64, |most, t| most.max(libm::fabs(*t)))
}

/// Returns `n + Jᵀ (J Jᵀ + λ)⁻¹ (e − J n)` of the joints that are free, with the lean `n`, deg.
fn turns<const J: usize>(
    jacobian: &SMatrix<f64, 3, J>,
    free: &[bool; J],
    gap: &Vector3<f64>,
    lean: &[f64; J],
) -> Option<[f64; J]> {
    let mut jacobian = *jacobian;
    let mut lean = SVector::<f64, J>::from(*lean) * RADIANS_PER_DEGREE;
    let joints = jacobian.column_iter_mut().zip(&mut lean);
    for ((mut column, lean), free) in joints.zip(free) {
        if !free {
            column.iter_mut().for_each(|entry| *entry = 0.0);
            *lean = 0.0;
        }
    }
    let rest = gap - jacobian * lean;
    let turns = lean + least_norm(&jacobian, &rest, gap.norm_squared())?;
    let turns: [f64; J] = (turns / RADIANS_PER_DEGREE).into();
    turns.iter().all(|turn| turn.is_finite()).then_some(turns)
}

/// Adds the turns to the angles, all shortened alike if one is too long.
fn turn<const J: usize>(angles: &mut [f64; J], turns: &[f64; J]) {
    let largest = largest(turns);
    let share = (FARTHEST / largest).min(1.0);
    for (angle, turn) in angles.iter_mut().zip(turns) {
        *angle += share * turn;
    }
}

/// Returns the turns of the joints that are not at their limits, or turn away from them.
fn turns_within_limits<const J: usize>(
    leg: &Leg<J>,
    from: &[f64; J],
    angles: &[f64; J],
    turns: impl Fn(&[bool; J]) -> Option<[f64; J]>,
) -> Option<[f64; J]> {
    let mut free = [true; J];
    let mut found = turns(&free)?;
    for _ in 0..J {
        let joints = leg.joints.iter().zip(from).zip(angles.iter().zip(&found));
        let before = free;
        for (free, ((joint, from), (angle, turn))) in free.iter_mut().zip(joints) {
            let limits = joint.limits.including(*from);
            let outward =
                (*turn > 0.0 && *angle >= limits.max) || (*turn < 0.0 && *angle <= limits.min);
            *free &= !outward;
        }
        if free == before {
            break;
        }
        found = turns(&free)?;
    }
    Some(found)
}

fn clamp<const J: usize>(leg: &Leg<J>, from: &[f64; J], angles: &mut [f64; J]) {
    for (angle, (joint, from)) in angles.iter_mut().zip(leg.joints.iter().zip(from)) {
        *angle = joint.limits.including(*from).nearest(*angle);
    }
}

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
    use super::*;
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
