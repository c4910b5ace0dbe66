//! Joint angles of a finger from the position of one of its points, found by resolved rate.
//!
//! Joints turn by `J# e`, the least turn that closes the gap `e` (Whitney, *Resolved Motion Rate
//! Control of Manipulators and Human Prostheses*, 1969), again and again until it is closed. A
//! damping in proportion to the gap keeps turns finite in singular postures and vanishes at the
//! target (Sugihara, *Solvability-Unconcerned Inverse Kinematics by the Levenberg–Marquardt
//! Method*, 2011). A joint that meets its limit stays there; the others go on.

use super::Chain;
use super::chain::RADIANS_PER_DEGREE;
use crate::model::{Joint, Leg, Range};
use nalgebra::{Matrix3, Vector3};

/// A point of a leg that can be put somewhere.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Point {
    /// The foot or fingertip.
    Tip,
    /// The place of a joint, counted from 0; only the joints before it move it.
    Joint(usize),
}

/// A gap that counts as closed: mm.
const CLOSED: f64 = 1e-9;

/// A gap that is left over by rounding where a finger is stretched out: mm.
const LEFT_OVER: f64 = 1e-6;

/// The most turns that are tried.
const TURNS: usize = 60;

/// The farthest that one turn goes: deg.
const FARTHEST: f64 = 15.0;

/// The damping that is left when the gap is closed: mm².
const LEAST_DAMPING: f64 = 1e-9;

/// The joint angles (deg) near `from` that put `point` of `leg` at x and y of `target` (mm); `None`
/// if no angles within the limits are found. A joint that is beyond its limits already may stay
/// there.
#[must_use]
pub fn resolve<const J: usize>(
    leg: &Leg<J>,
    from: &[f64; J],
    point: Point,
    target: [f64; 3],
) -> Option<[f64; J]> {
    let mut angles = *from;
    for _ in 0..TURNS {
        let chain = Chain::new(leg, &angles);
        let gap = gap(&chain, point, target)?;
        if gap.norm() <= CLOSED {
            return Some(angles);
        }
        let turns =
            turns_within_limits(leg, from, &angles, |free| turns(&chain, point, free, gap))?;
        turn(&mut angles, &turns);
        clamp(leg, from, &mut angles);
    }
    let left = gap(&Chain::new(leg, &angles), point, target)?;
    (left.norm() <= LEFT_OVER).then_some(angles)
}

fn gap<const J: usize>(
    chain: &Chain<J>,
    point: Point,
    [x, y, _]: [f64; 3],
) -> Option<Vector3<f64>> {
    let [at_x, at_y, _] = chain.point(point)?;
    Some(Vector3::new(x - at_x, y - at_y, 0.0))
}

/// `Jᵀ (J Jᵀ + λ²)⁻¹ e` of the joints that are free: deg.
fn turns<const J: usize>(
    chain: &Chain<J>,
    point: Point,
    free: &[bool; J],
    gap: Vector3<f64>,
) -> Option<[f64; J]> {
    let mut jacobian = chain.point_jacobian(point)?;
    for (mut column, free) in jacobian.column_iter_mut().zip(free) {
        for (axis, entry) in column.iter_mut().enumerate() {
            if !free || axis == 2 {
                *entry = 0.0;
            }
        }
    }
    let damping = gap.norm_squared() + LEAST_DAMPING;
    let gram = jacobian * jacobian.transpose() + Matrix3::identity() * damping;
    let turns = jacobian.transpose() * (gram.try_inverse()? * gap) / RADIANS_PER_DEGREE;
    let turns: [f64; J] = turns.into();
    turns.iter().all(|turn| turn.is_finite()).then_some(turns)
}

/// Adds the turns, all shortened alike if one goes too far.
fn turn<const J: usize>(angles: &mut [f64; J], turns: &[f64; J]) {
    let largest = turns
        .iter()
        .fold(0.0_f64, |most, t| most.max(libm::fabs(*t)));
    let share = if largest > FARTHEST {
        FARTHEST / largest
    } else {
        1.0
    };
    for (angle, turn) in angles.iter_mut().zip(turns) {
        *angle += share * turn;
    }
}

/// The turns of the joints that are not at their limits, or turn away from them.
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
        let mut stuck = false;
        for (free, ((joint, from), (angle, turn))) in free.iter_mut().zip(joints) {
            let limits = limits(joint, *from);
            let outward =
                (*turn > 0.0 && *angle >= limits.max) || (*turn < 0.0 && *angle <= limits.min);
            stuck |= *free && outward;
            *free &= !outward;
        }
        if !stuck {
            break;
        }
        found = turns(&free)?;
    }
    Some(found)
}

fn clamp<const J: usize>(leg: &Leg<J>, from: &[f64; J], angles: &mut [f64; J]) {
    for (angle, (joint, from)) in angles.iter_mut().zip(leg.joints.iter().zip(from)) {
        let limits = limits(joint, *from);
        *angle = angle.max(limits.min).min(limits.max);
    }
}

/// How far a joint that stands at `from` may go.
fn limits(joint: &Joint, from: f64) -> Range {
    Range::new(joint.limits.min.min(from), joint.limits.max.max(from))
}
