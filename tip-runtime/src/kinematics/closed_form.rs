//! Selection among the solutions of a closed form.

use super::chain::ChainBuilder;
use super::{ROUNDING, Solutions, roll_pitch_pitch, yaw_pitch_pitch};
use crate::model::{Inverse, Joint, Point, Range};

/// Greatest turn of a joint in one cycle where a leg passes from one branch of solutions to
/// another, deg. A greater turn skips postures in between.
const LEAP: f64 = 6.0;

/// A leg of three joints with a closed-form inverse.
#[derive(Clone, Copy)]
pub(super) struct ClosedFormLeg<'a> {
    kind: Inverse,
    base: Point,
    joints: [&'a Joint; 3],
}

impl<'a> ClosedFormLeg<'a> {
    /// Returns `None` if the leg does not have three joints.
    pub(super) fn new(kind: Inverse, base: Point, joints: &'a [Joint]) -> Option<Self> {
        let [first, second, third] = joints else {
            return None;
        };
        let joints = [first, second, third];
        Some(ClosedFormLeg { kind, base, joints })
    }

    /// Returns all solutions that put the foot at `foot` (mm), whatever the limits. A joint that
    /// does not matter stays as in `from`.
    pub(super) fn solutions(&self, from: &[f64; 3], foot: Point) -> Solutions {
        let [first, _, _] = from;
        match self.kind {
            Inverse::YawPitchPitch => {
                yaw_pitch_pitch::solutions(self.base, self.joints, foot, *first)
            }
            Inverse::RollPitchPitch => {
                roll_pitch_pitch::solutions(self.base, self.joints, foot, *first)
            }
            Inverse::Planar | Inverse::LeastSquares => [None; 4],
        }
    }

    /// Returns the solution within the limits that is nearest to `from`; the first of equally near
    /// ones.
    pub(super) fn nearest(&self, from: &[f64; 3], foot: Point) -> Option<[f64; 3]> {
        self.nearest_of(from, foot, |_| true)
    }

    /// Like [`nearest`](Self::nearest), among the solutions that the leg reaches from `from`
    /// without skipping postures.
    pub(super) fn next(&self, from: &[f64; 3], foot: Point) -> Option<[f64; 3]> {
        self.nearest_of(from, foot, |to| !self.leaps(from, to))
    }

    fn nearest_of(
        &self,
        from: &[f64; 3],
        foot: Point,
        accepts: impl Fn(&[f64; 3]) -> bool,
    ) -> Option<[f64; 3]> {
        let mut nearest: Option<(f64, [f64; 3])> = None;
        for solution in self.solutions(from, foot).into_iter().flatten() {
            let Some(angles) = self.within_limits(from, solution) else {
                continue;
            };
            let turn = largest_turn(from, &angles);
            // What differs by rounding is as near.
            let is_nearer = nearest.is_none_or(|(least, _)| turn < least - ROUNDING);
            if is_nearer && accepts(&angles) {
                nearest = Some((turn, angles));
            }
        }
        nearest.map(|(_, angles)| angles)
    }

    /// Returns equivalent angles within the limits, as near to `from` as possible.
    fn within_limits(&self, from: &[f64; 3], mut angles: [f64; 3]) -> Option<[f64; 3]> {
        for ((angle, joint), from) in angles.iter_mut().zip(self.joints).zip(from) {
            *angle = within(joint.limits, *from, *angle)?;
        }
        Some(angles)
    }

    /// Returns true if postures are skipped between two: they belong to different branches of
    /// solutions, or differ by whole turns.
    fn leaps(&self, from: &[f64; 3], to: &[f64; 3]) -> bool {
        let (before, after) = (self.branch(from), self.branch(to));
        let ([first, _, _], [first_to, _, _]) = (from, to);
        let largest = largest_turn(from, to);
        let rolls_over = before.side * after.side < 0.0 && libm::fabs(first_to - first) > LEAP;
        let bends_over = before.bend * after.bend < 0.0 && largest > LEAP;
        rolls_over || bends_over || largest > 180.0
    }

    fn branch(&self, angles: &[f64; 3]) -> Branch {
        let [first, second, third] = self.joints;
        let [roll, thigh, knee] = angles;
        let mut builder = ChainBuilder::at(self.base);
        let (hip, along) = builder.append(first, *roll);
        let (upper, across) = builder.append(second, *thigh);
        let (lower, _) = builder.append(third, *knee);
        let foot = builder.end();
        let side = along.cross(&across).dot(&(foot - hip));
        let bend = across.dot(&(lower - upper).cross(&(foot - lower)));
        let size = (lower - upper).norm() + (foot - lower).norm() + (upper - hip).norm();
        Branch {
            side: unless_tiny(side / size),
            bend: unless_tiny(bend / (size * size)),
        }
    }
}

/// The branch of a solution: the side of its first axis on which the foot is, and the side to which
/// the last joint is bent; 0 between them.
struct Branch {
    side: f64,
    bend: f64,
}

fn unless_tiny(share: f64) -> f64 {
    if libm::fabs(share) < 1e-6 { 0.0 } else { share }
}

/// Returns `angle` plus whole turns, within the limits and as near to `near` as possible, deg.
fn within(limits: Range, near: f64, angle: f64) -> Option<f64> {
    let limits = limits.widened(ROUNDING);
    let and_turns = |turns: f64| {
        if turns == 0.0 {
            angle
        } else {
            angle + 360.0 * turns
        }
    };
    let nearest = and_turns(libm::round((near - angle) / 360.0));
    let found = if nearest > limits.max {
        and_turns(libm::floor((limits.max - angle) / 360.0))
    } else if nearest < limits.min {
        and_turns(libm::ceil((limits.min - angle) / 360.0))
    } else {
        nearest
    };
    limits.contains(found).then_some(found)
}

fn largest_turn(from: &[f64; 3], to: &[f64; 3]) -> f64 {
    let turns = from.iter().zip(to).map(|(from, to)| libm::fabs(to - from));
    turns.fold(0.0, f64::max)
}
