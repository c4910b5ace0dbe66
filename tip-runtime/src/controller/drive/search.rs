//! The search for postures that lead a point along a line, a few pieces of it in each cycle.
//!
//! It begins at the target with the posture nearest to the present one. Where that leads into a limit,
//! it goes on from postures that are spread over the limits.

use super::bend::{Bend, Bending, Bent};
use super::guide::{Guide, Line};
use super::trial::{PointOfLeg, Shown, Trial};
use crate::kinematics::{self, resolve_piece};

/// The pieces of a line that are tried in one cycle, at most: enough for the nearest posture and for as
/// many pieces as lines mostly have, so that most legs set off at once.
const A_CYCLE: usize = 48;

/// How many pieces take as many turns as a posture that is started from anywhere.
const START: usize = 6;

/// How many postures a leg that has bent starts from.
const STARTS_OF_BENT: usize = 4;

/// How often a posture at the target is drawn nearer to the present one.
const DRAWS: u8 = 8;

/// How far the search has come.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::controller) struct Search<const J: usize> {
    from: [f64; J],
    line: Line,
    /// Where the joints return to, if they do.
    home: Option<[f64; J]>,
    /// Whether `from` is the posture to which a nearly straight leg may bend first.
    is_bent: bool,
    /// The number of the next posture to start from: 0 of the present one.
    next: usize,
    stage: Stage<J>,
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
    /// How many pieces its next step is worth.
    const fn pieces(&self) -> usize {
        match self {
            Stage::Starting => START,
            Stage::Drawing(..) | Stage::Trying(_) | Stage::Bending(_) | Stage::Exhausted => 1,
        }
    }
}

/// What a search came to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Outcome<const J: usize> {
    Found(Guide<J>),
    /// Once the leg has bent.
    Bends(Bend<J>),
    /// No postures are known that lead there.
    Nothing,
}

impl<const J: usize> Search<J> {
    /// For a leg at the angles `from`, whose joints return to the angles `home`, if there are any.
    pub(super) fn new(from: [f64; J], line: Line, home: Option<[f64; J]>) -> Self {
        let stage = match home {
            Some(home) => Stage::Trying(Trial::new(straight(from, home, line), from)),
            None => Stage::Starting,
        };
        Search {
            from,
            line,
            home,
            is_bent: false,
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
            *self = Search::new(*from, (place, self.line.1), self.home);
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
                Shown::SoFar(trial) => Stage::Trying(trial),
                Shown::Leads(guide) if self.is_bent => {
                    let bend = Bend::new(point, self.from, guide.with_left(0.0), self.line);
                    return Some(Outcome::Bends(bend));
                }
                Shown::Leads(guide) => return Some(Outcome::Found(guide)),
                Shown::Fails => Stage::Starting,
            },
            Stage::Bending(bending) => match bending.bend(point, self.line.0) {
                Bent::SoFar(bending) => Stage::Bending(bending),
                Bent::To(angles) => {
                    (self.from, self.next, self.is_bent) = (angles, 0, true);
                    Stage::Starting
                }
                Bent::Fails => return Some(Outcome::Nothing),
            },
            Stage::Exhausted if self.home.is_none() && !self.is_bent => {
                Stage::Bending(Bending::new(self.from))
            }
            Stage::Exhausted => {
                let direct = self.home.map(|home| straight(self.from, home, self.line));
                return Some(direct.map_or(Outcome::Nothing, Outcome::Found));
            }
        };
        None
    }

    fn start(&mut self, point: &PointOfLeg<'_, J>) -> Stage<J> {
        let mut starts = core::iter::once(self.from).chain(kinematics::starts(point.leg));
        let is_last = self.is_bent && self.next >= STARTS_OF_BENT;
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
                let guide = Guide::between(self.from, end, self.line).and_home(self.home);
                Stage::Trying(Trial::new(guide, self.from))
            }
        }
    }
}

/// Postures straight to the initial one.
fn straight<const J: usize>(from: [f64; J], home: [f64; J], line: Line) -> Guide<J> {
    Guide::between(from, home, line).eased()
}

#[cfg(test)]
mod tests;
