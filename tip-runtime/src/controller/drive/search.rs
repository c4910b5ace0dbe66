//! The search for postures that lead a point along a line, a few pieces of it in each cycle.
//!
//! It begins at the target with the posture nearest to the present one. Where that leads into a limit,
//! it goes on from postures that are spread over the limits.

use super::bend::{Bend, BendResult, Bending, middle};
use super::posture_path::{Line, PosturePath};
use super::trial::{PointOfLeg, Trial, TrialResult};
use crate::kinematics::{self, is_straight, resolve_piece};

/// The pieces of a line that are tried in one cycle, at most: enough for the nearest posture and for as
/// many pieces as lines mostly have, so that most legs set off immediately.
const A_CYCLE: usize = 48;

/// Number of pieces that take as many turns as a posture that is started from anywhere.
const START: usize = 6;

/// Number of postures to start from for a leg that goes past the middle of its limits, or has bent.
const STARTS_AGAIN: usize = 4;

/// Number of times that a posture at the target is drawn nearer to the present one.
const DRAWS: u8 = 8;

/// State of a search.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::controller) struct Search<const J: usize> {
    from: [f64; J],
    line: Line,
    /// Angles to return to, if the joints do.
    home: Option<[f64; J]>,
    attempt: Attempt,
    /// True if the leg was straight when the search began.
    is_straight: bool,
    /// The number of the next posture to start from: 0 of the present one.
    next: usize,
    stage: Stage<J>,
}

/// One attempt of several in order; a straight leg, whose posture does not show to which side it
/// bends, tries the second first.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Attempt {
    /// Directly from posture to posture.
    Direct,
    /// Past the middle of the limits.
    Bowed,
    /// From the posture to which a nearly straight leg may bend first.
    Bent,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Stage<const J: usize> {
    /// Another posture is to be started from.
    Starting,
    /// A posture at the target is drawn nearer, and was so often before.
    Drawing([f64; J], u8),
    /// Postures are tried out.
    Trying(Trial<J>),
    /// The leg is bent to the other side.
    Bending(Bending<J>),
    /// None is left.
    Exhausted,
}

impl<const J: usize> Stage<J> {
    /// Returns the number of pieces that its next step is worth.
    const fn pieces(&self) -> usize {
        match self {
            Stage::Starting => START,
            Stage::Drawing(..) | Stage::Trying(_) | Stage::Bending(_) | Stage::Exhausted => 1,
        }
    }
}

/// Result of a search.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Outcome<const J: usize> {
    Found(PosturePath<J>),
    /// Once the leg has bent.
    Bends(Bend<J>),
    /// No postures are known that lead there.
    Nothing,
}

impl<const J: usize> Search<J> {
    /// Creates a search for a leg at the angles `from`, whose joints return to the angles `home`,
    /// if there are any.
    pub(super) fn new(
        point: &PointOfLeg<'_, J>,
        from: [f64; J],
        line: Line,
        home: Option<[f64; J]>,
    ) -> Self {
        let is_straight = home.is_none() && is_straight(point.leg, &from, point.point, point.axes);
        let stage = match home {
            Some(home) => Stage::Trying(Trial::new(straight(from, home, line), from)),
            None => Stage::Starting,
        };
        Search {
            from,
            line,
            home,
            attempt: if is_straight {
                Attempt::Bowed
            } else {
                Attempt::Direct
            },
            is_straight,
            next: 0,
            stage,
        }
    }

    /// Goes on for one cycle, anew if the point is not at `place` any more.
    pub(super) fn advance(
        &mut self,
        point: &PointOfLeg<'_, J>,
        from: &[f64; J],
        place: [f64; 3],
    ) -> Option<Outcome<J>> {
        if self.line.0 != place {
            *self = Search::new(point, *from, (place, self.line.1), self.home);
        }
        let mut pieces = 0;
        while pieces < A_CYCLE {
            pieces += self.stage.pieces();
            if let Some(outcome) = self.step(point) {
                return Some(outcome);
            }
        }
        None
    }

    /// Solves the leg once, in as many turns as its stage is worth.
    fn step(&mut self, point: &PointOfLeg<'_, J>) -> Option<Outcome<J>> {
        self.stage = match self.stage {
            Stage::Starting => self.start(point),
            Stage::Drawing(end, draws) => self.draw(point, end, draws),
            Stage::Trying(trial) => match trial.try_piece(point, self.line) {
                TrialResult::SoFar(trial) => Stage::Trying(trial),
                TrialResult::Leads(guide) if self.attempt == Attempt::Bent => {
                    let bend = Bend::new(point, self.from, guide.with_left(0.0), self.line);
                    return Some(Outcome::Bends(bend));
                }
                TrialResult::Leads(guide) => return Some(Outcome::Found(guide)),
                TrialResult::Fails => Stage::Starting,
            },
            Stage::Bending(bending) => match bending.bend(point, self.line.0) {
                BendResult::SoFar(bending) => Stage::Bending(bending),
                BendResult::To(angles) => {
                    self.from = angles;
                    self.again(Attempt::Bent)
                }
                BendResult::Fails => return Some(Outcome::Nothing),
            },
            Stage::Exhausted => match (self.home, self.attempt) {
                (Some(home), _) => {
                    return Some(Outcome::Found(straight(self.from, home, self.line)));
                }
                (None, Attempt::Direct) if !self.is_straight => self.again(Attempt::Bowed),
                (None, Attempt::Bowed) if self.is_straight => self.again(Attempt::Direct),
                (None, Attempt::Direct | Attempt::Bowed) => Stage::Bending(Bending::new(self.from)),
                (None, Attempt::Bent) => return Some(Outcome::Nothing),
            },
        };
        None
    }

    fn again(&mut self, attempt: Attempt) -> Stage<J> {
        (self.next, self.attempt) = (0, attempt);
        Stage::Starting
    }

    fn start(&mut self, point: &PointOfLeg<'_, J>) -> Stage<J> {
        let mut starts = core::iter::once(self.from).chain(kinematics::starts(point.leg));
        let is_last = self.attempt != Attempt::Direct && self.next >= STARTS_AGAIN;
        let Some(start) = starts.nth(self.next).filter(|_| !is_last) else {
            return Stage::Exhausted;
        };
        self.next += 1;
        kinematics::resolve(point.leg, &start, point.point, self.line.1, point.axes)
            .map_or(Stage::Starting, |end| Stage::Drawing(end, 0))
    }

    fn draw(&self, point: &PointOfLeg<'_, J>, end: [f64; J], draws: u8) -> Stage<J> {
        let (target, axes) = (self.line.1, point.axes);
        match resolve_piece(point.leg, &end, point.point, target, axes, &self.from) {
            Some(end) if draws + 1 < DRAWS => Stage::Drawing(end, draws + 1),
            nearest => {
                let end = nearest.unwrap_or(end);
                let bow = (self.attempt == Attempt::Bowed).then(|| middle(point.leg));
                let guide = PosturePath::between(self.from, end, self.line)
                    .and_home(self.home)
                    .bowed(bow);
                Stage::Trying(Trial::new(guide, self.from))
            }
        }
    }
}

/// Postures straight to the initial one.
fn straight<const J: usize>(from: [f64; J], home: [f64; J], line: Line) -> PosturePath<J> {
    PosturePath::between(from, home, line).eased()
}

#[cfg(test)]
mod tests;
