//! Bending of a nearly straight leg to the side on which its line goes on, with its point in place.
//!
//! The postures of a straight leg's point are few, and those on its one side may end at a limit immediately.
//! The leg turns through the postures of that one place until it is bent towards the middle of its limits.

use super::posture_path::{Line, PosturePath};
use super::trial::PointOfLeg;
use crate::kinematics::{self, resolve_piece};
use crate::model::Leg;

/// Joint speed meanwhile, deg/s.
const RATE: f64 = 30.0;

/// Turn of the joints in one step of the search, deg.
const STEP: f64 = 0.5;

/// The most steps of the search.
const STEPS: u8 = 60;

/// Largest turn for which a leg is nearly straight, deg.
const FARTHEST: f64 = 25.0;

/// Joints that turn less than this share of a step have arrived.
const AT_REST: f64 = 0.05;

/// Longest time that a leg bends, s.
const LONGEST: f64 = 3.0;

/// Distance from the posture at which joints have taken it, deg.
const TAKEN: f64 = 0.2;

/// A leg that bends, and what it does then.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::controller) struct Bend<const J: usize> {
    aim: [f64; J],
    to: [f64; J],
    /// The posture at the end of the line that follows.
    end: [f64; J],
    line: Line,
    /// Turn of the joints in this cycle, deg.
    step: f64,
    /// Time that the leg may still take, s.
    left: f64,
}

impl<const J: usize> Bend<J> {
    /// Creates a bend to the posture `to`, and from there along `line` to the posture `end`.
    pub(super) fn new(point: &PointOfLeg<'_, J>, to: [f64; J], end: [f64; J], line: Line) -> Self {
        Bend {
            aim: middle(point.leg),
            to,
            end,
            line,
            step: 0.0,
            left: LONGEST,
        }
    }

    /// Moves on by `dt` seconds; what is held waits.
    pub(super) fn advance(&mut self, dt: f64, held: bool) {
        let dt = if held { 0.0 } else { dt };
        self.step = RATE * dt;
        self.left -= dt;
    }

    /// Returns the postures to follow once the leg at `angles` is bent.
    pub(super) fn done(&self, angles: &[f64; J]) -> Option<PosturePath<J>> {
        let is_near = farthest(angles, &self.to) <= TAKEN;
        (is_near || self.left <= 0.0).then(|| PosturePath::between(*angles, self.end, self.line))
    }

    /// Returns the posture that the joints at `angles` turn towards.
    pub(super) fn posture(&self, angles: &[f64; J]) -> [f64; J] {
        towards(angles, &self.aim, self.step)
    }
}

/// The search for a posture with the leg bent to the other side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Bending<const J: usize> {
    from: [f64; J],
    angles: [f64; J],
    steps: u8,
}

/// Result of one step of the search.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum BendResult<const J: usize> {
    SoFar(Bending<J>),
    /// The leg is bent.
    To([f64; J]),
    /// The leg does not bend.
    Fails,
}

impl<const J: usize> Bending<J> {
    pub(super) fn new(from: [f64; J]) -> Self {
        Bending {
            from,
            angles: from,
            steps: 0,
        }
    }

    /// Turns the joints by one step, with the point at `place`.
    pub(super) fn bend(mut self, point: &PointOfLeg<'_, J>, place: [f64; 3]) -> BendResult<J> {
        let before = self.angles;
        let posture = towards(&before, &middle(point.leg), STEP);
        let turned = resolve_piece(point.leg, &before, point.point, place, point.axes, &posture);
        let Some(angles) = turned else {
            return BendResult::Fails;
        };
        if farthest(&angles, &before) <= AT_REST * STEP {
            return match farthest(&angles, &self.from) > TAKEN {
                true => BendResult::To(angles),
                false => BendResult::Fails,
            };
        }
        (self.angles, self.steps) = (angles, self.steps + 1);
        if self.steps >= STEPS || farthest(&angles, &self.from) > FARTHEST {
            return BendResult::Fails;
        }
        BendResult::SoFar(self)
    }
}

/// Returns the middle of the limits.
pub(super) fn middle<const J: usize>(leg: &Leg<J>) -> [f64; J] {
    kinematics::starts(leg).nth(1).unwrap_or([0.0; J])
}

/// Returns the posture that joints lean to in order to turn by about `step` towards `aim`; the
/// first joint only turns the leg.
fn towards<const J: usize>(angles: &[f64; J], aim: &[f64; J], step: f64) -> [f64; J] {
    let mut posture = *angles;
    let share = 2.0 * step / farthest(angles, aim).max(step);
    for (posture, aim) in posture.iter_mut().zip(aim).skip(1) {
        *posture += share * (aim - *posture);
    }
    posture
}

/// Returns the most that a joint turns from one posture to another, deg.
fn farthest<const J: usize>(from: &[f64; J], to: &[f64; J]) -> f64 {
    let turns = from.iter().zip(to).map(|(from, to)| libm::fabs(to - from));
    turns.fold(0.0, f64::max)
}
