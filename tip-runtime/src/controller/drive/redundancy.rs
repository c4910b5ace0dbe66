//! Motion of redundant joints while a point goes straight to its target.
//!
//! A leg with more joints than its point needs goes through the postures between the one that it has
//! and one in which its point is at the target. Resolved rate puts the point on its line and leaves the
//! rest to that posture. The line is tried out before the leg sets off; where a posture leads into a
//! limit, another one is tried. If that takes more than one cycle, the leg waits, or brakes first.
//!
//! The search first tries the posture at the target that is nearest to the present one, then postures that are
//! spread over the limits. It tries a few pieces of the line in each cycle. The limits of joints are intervals: between
//! two postures within them no joint is beyond its own.
//!
//! The postures of a straight leg's point are few, and those on its one side may end at a limit immediately. A nearly
//! straight leg bends first, with its point in place: it turns through the postures of that place until it is bent
//! towards the middle of its limits.

use super::distance;
use super::reach::has_few_joints;
use crate::controller::trajectory::{Goal, Limits, SetPoint};
use crate::kinematics::{self, LegPoint, is_straight, largest_turn, resolve_piece};
use crate::model::{Axes, Inverse, Leg};

/// The rule that redundant joints follow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::controller) enum Redundancy<const J: usize> {
    /// No rule: there are no redundant joints, or no postures lead to the target.
    None,
    /// Every joint brakes by itself from these rates, deg/s, before the point sets off.
    Brakes([f64; J]),
    /// The search for postures is not finished.
    Sought(Search<J>),
    /// The leg bends before it follows its line.
    Bends(Bend<J>),
    /// Redundant joints follow postures that lead to the target.
    Found(PosturePath<J>),
}

impl<const J: usize> Redundancy<J> {
    /// Starts a motion on the path of a point along `line`, for a leg at the angles `from`, whose joints return to the
    /// angles `home`, if there are any.
    pub(in crate::controller) fn seek(
        inverse: Inverse,
        leg: &Leg<J>,
        point: LegPoint,
        from: &[f64; J],
        line: Line,
        home: Option<[f64; J]>,
    ) -> Self {
        if !has_choice::<J>(inverse, point) {
            return Redundancy::None;
        }
        let axes = inverse.axes();
        let point = PointOfLeg { leg, point, axes };
        Redundancy::Sought(Search::new(&point, *from, line, home))
    }

    /// Continues a search for postures, for a leg at the angles `from`. If its point moves and would swing too far to
    /// the side of its line, the leg brakes first.
    #[inline]
    pub(super) fn look(
        &mut self,
        point: &PointOfLeg<'_, J>,
        from: &[f64; J],
        track: &SetPoint<3>,
        limits: Limits,
    ) {
        if let Redundancy::Bends(bend) = self
            && let Some(guide) = bend.done(from)
        {
            *self = Redundancy::Found(guide);
        }
        let Redundancy::Sought(search) = self else {
            return;
        };
        let reaches =
            |at| kinematics::resolve(point.leg, from, point.point, at, point.axes).is_some();
        if !track.is_at_rest() && !reaches(track.swing(limits)) {
            return;
        }
        match search.advance(point, from, track.position()) {
            None => {}
            Some(Outcome::Nothing) => *self = Redundancy::None,
            Some(Outcome::Found(guide)) => *self = Redundancy::Found(guide),
            Some(Outcome::Bends(bend)) => *self = Redundancy::Bends(bend),
        }
    }

    /// Returns true if the point has to wait.
    pub(super) fn waits(&self) -> bool {
        matches!(self, Redundancy::Sought(_) | Redundancy::Bends(_))
    }

    pub(super) fn is_none(&self) -> bool {
        matches!(self, Redundancy::None)
    }

    /// Advances by `dt` seconds, with `line` left for the point. Under a hold it waits.
    #[inline]
    pub(super) fn advance(&mut self, line: Line, dt: f64, held: bool) {
        match self {
            Redundancy::None | Redundancy::Brakes(_) | Redundancy::Sought(_) => {}
            Redundancy::Bends(bend) => bend.advance(dt, held),
            Redundancy::Found(guide) => guide.advance(line, dt, held),
        }
    }

    pub(super) fn is_at_rest(&self) -> bool {
        match self {
            Redundancy::None | Redundancy::Sought(_) => true,
            Redundancy::Brakes(_) | Redundancy::Bends(_) => false,
            Redundancy::Found(guide) => guide.is_at_rest(),
        }
    }

    /// Returns the posture that the joints at `angles` turn towards, for a point on `line`.
    #[inline]
    pub(super) fn posture(&self, angles: &[f64; J], line: Line) -> Option<[f64; J]> {
        match self {
            Redundancy::None | Redundancy::Brakes(_) => None,
            Redundancy::Sought(_) => Some(*angles),
            Redundancy::Bends(bend) => Some(bend.posture(angles)),
            Redundancy::Found(guide) => Some(guide.posture(line.0, line.1)),
        }
    }
}

/// Returns true if enough joints move a point for every direction, and no closed form decides.
pub(super) fn has_choice<const J: usize>(inverse: Inverse, point: LegPoint) -> bool {
    !inverse.is_closed() && !has_few_joints::<J>(inverse, point)
}

/// Maximum number of pieces of a line that are tried in one cycle: enough for the nearest posture and for the pieces of
/// most lines, so that most legs set off immediately.
const A_CYCLE: usize = 48;

/// Number of pieces that cost as many iterations as the solution for a new start posture.
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
    /// The number of the next start posture; 0 is the present one.
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
    /// Another start posture is solved next.
    Starting,
    /// A posture at the target is drawn nearer to the present one; the number counts how often that was done.
    Drawing([f64; J], u8),
    /// Postures are tried along the line.
    Trying(Trial<J>),
    /// The leg is bent to the other side.
    Bending(Bending<J>),
    /// No start posture is left.
    Exhausted,
}

impl<const J: usize> Stage<J> {
    /// Returns the cost of its next step, in pieces.
    const fn pieces(&self) -> usize {
        match self {
            Stage::Starting => START,
            Stage::Drawing(..) | Stage::Trying(_) | Stage::Bending(_) | Stage::Exhausted => 1,
        }
    }
}

/// Result of a search.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Outcome<const J: usize> {
    Found(PosturePath<J>),
    /// Postures that lead to the target, once the leg has bent.
    Bends(Bend<J>),
    /// No postures lead to the target.
    Nothing,
}

impl<const J: usize> Search<J> {
    /// Creates a search for a leg at the angles `from`, whose joints return to the angles `home`,
    /// if there are any.
    fn new(point: &PointOfLeg<'_, J>, from: [f64; J], line: Line, home: Option<[f64; J]>) -> Self {
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

    /// Continues for one cycle. It starts again if the point is not at `place` any more.
    // Out of line, since most cycles have no search.
    #[inline(never)]
    fn advance(
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

    /// Executes one step of the search.
    fn step(&mut self, point: &PointOfLeg<'_, J>) -> Option<Outcome<J>> {
        self.stage = match self.stage {
            Stage::Starting => self.start(point),
            Stage::Drawing(end, draws) => self.draw(point, end, draws),
            Stage::Trying(trial) => match trial.try_piece(point, self.line) {
                TrialResult::SoFar(trial) => Stage::Trying(trial),
                TrialResult::Leads(guide) if self.attempt == Attempt::Bent => {
                    let bend = Bend {
                        aim: middle(point.leg),
                        to: self.from,
                        end: guide.with_left(0.0),
                        line: self.line,
                        step: 0.0,
                        left: BEND_TIME,
                    };
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
                (None, Attempt::Direct | Attempt::Bowed) => Stage::Bending(Bending {
                    from: self.from,
                    angles: self.from,
                    steps: 0,
                }),
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
                let guide = PosturePath {
                    home: self.home,
                    bow,
                    ..PosturePath::between(self.from, end, self.line)
                };
                Stage::Trying(Trial::new(guide, self.from))
            }
        }
    }
}

/// Returns the postures from `from` straight to the initial one.
fn straight<const J: usize>(from: [f64; J], home: [f64; J], line: Line) -> PosturePath<J> {
    PosturePath::between(from, home, line).eased()
}

/// Shortest time of the return to the initial angles, s.
const RETURN: f64 = 0.8;

/// Limits of the speed of the return, which accelerates in the first half of that time and brakes in the second.
const PACE: Limits = Limits {
    speed: 2.0 / RETURN,
    acceleration: 4.0 / (RETURN * RETURN),
};

/// The share of the way to the intermediate posture that a leg on a bowed path goes halfway.
const MOST_BOW: f64 = 0.75;

/// A straight line of a point: its start and its end, mm.
type Line = ([f64; 3], [f64; 3]);

/// Postures between two ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::controller) struct PosturePath<const J: usize> {
    from: [f64; J],
    to: [f64; J],
    /// Distance of the point from its target at the start, mm.
    length: f64,
    /// The set point of the remaining share of the path, if its speed is limited.
    ease: Option<SetPoint<1>>,
    /// The posture to take after the point has reached its target, if it is not `to`.
    home: Option<[f64; J]>,
    /// The intermediate posture of a bowed path, which the leg passes halfway.
    bow: Option<[f64; J]>,
}

impl<const J: usize> PosturePath<J> {
    /// Creates the postures between `from` and `to`, for a point on `line`.
    fn between(from: [f64; J], to: [f64; J], line: Line) -> Self {
        PosturePath {
            from,
            to,
            length: distance(line.0, line.1),
            ease: None,
            home: None,
            bow: None,
        }
    }

    /// Limits the motion to the speed that [`RETURN`] allows.
    fn eased(self) -> Self {
        let ease = SetPoint::resting([1.0]).towards(Goal::Point {
            target: [0.0],
            hs: false,
        });
        PosturePath {
            ease: Some(ease),
            ..self
        }
    }

    /// Advances by `dt` seconds, with `line` left for the point. Under a hold it waits.
    fn advance(&mut self, line: Line, dt: f64, held: bool) {
        if let Some(ease) = &mut self.ease {
            ease.advance(PACE, dt, held);
        }
        if line.0 == line.1
            && let Some(home) = self.home
        {
            *self = PosturePath::between(self.to, home, line).eased();
        }
    }

    fn is_at_rest(&self) -> bool {
        self.ease.as_ref().is_none_or(SetPoint::is_at_rest)
    }

    /// Returns the posture for a point that is at `place` and goes to `target`.
    fn posture(&self, place: [f64; 3], target: [f64; 3]) -> [f64; J] {
        let line = if self.length > 0.0 {
            (distance(place, target) / self.length).min(1.0)
        } else {
            0.0
        };
        let time = self.ease.map_or(0.0, |ease| ease.position().iter().sum());
        self.with_left(line.max(time))
    }

    /// Returns the posture with a share `left` of the way to go.
    fn with_left(&self, left: f64) -> [f64; J] {
        let mut posture = self.to;
        for (angle, from) in posture.iter_mut().zip(self.from) {
            *angle += left * (from - *angle);
        }
        for (angle, bow) in posture.iter_mut().zip(self.bow.into_iter().flatten()) {
            *angle += MOST_BOW * 4.0 * left * (1.0 - left) * (bow - *angle);
        }
        posture
    }
}

/// Maximum length of a piece, as a share of its line.
const MAX_PIECE: f64 = 1.0 / 32.0;

/// Minimum length of a piece, as a share of its line.
const SHORTEST: f64 = 1.0 / 16384.0;

/// Maximum number of pieces that are tried.
const PIECES: u16 = 400;

/// Turn of a joint above which a piece has skipped postures, deg.
const LEAP: f64 = 6.0;

/// A point of a leg to be placed, and the axes that count.
#[derive(Clone, Copy)]
pub(super) struct PointOfLeg<'a, const J: usize> {
    pub(super) leg: &'a Leg<J>,
    pub(super) point: LegPoint,
    pub(super) axes: Axes,
}

/// A trial of postures along a line, as far as it has come.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Trial<const J: usize> {
    guide: PosturePath<J>,
    angles: [f64; J],
    gone: f64,
    piece: f64,
    pieces: u16,
}

/// Result of one piece.
#[derive(Clone, Copy, Debug, PartialEq)]
enum TrialResult<const J: usize> {
    /// The trial has further pieces.
    SoFar(Trial<J>),
    /// The postures lead to the target.
    Leads(PosturePath<J>),
    /// The postures do not lead to the target.
    Fails,
}

impl<const J: usize> Trial<J> {
    fn new(guide: PosturePath<J>, from: [f64; J]) -> Self {
        Trial {
            guide,
            angles: from,
            gone: 0.0,
            piece: MAX_PIECE,
            pieces: 0,
        }
    }

    /// Tries one piece. If a joint turns too far in it, half of it is tried next.
    fn try_piece(mut self, point: &PointOfLeg<'_, J>, line: Line) -> TrialResult<J> {
        let next = (self.gone + self.piece).min(1.0);
        let posture = self.guide.with_left(1.0 - next);
        let at = on_line(line, next);
        let turned = resolve_piece(
            point.leg,
            &self.angles,
            point.point,
            at,
            point.axes,
            &posture,
        )
        .filter(|turned| largest_turn(&self.angles, turned) <= LEAP);
        self.pieces += 1;
        match turned {
            Some(_) if next >= 1.0 => return TrialResult::Leads(self.guide),
            Some(turned) => {
                (self.angles, self.gone) = (turned, next);
                self.piece = (self.piece * 2.0).min(MAX_PIECE);
            }
            None => self.piece /= 2.0,
        }
        if self.piece < SHORTEST || self.pieces >= PIECES {
            return TrialResult::Fails;
        }
        TrialResult::SoFar(self)
    }
}

/// Returns the place at a share `gone` of a line.
fn on_line((place, target): Line, gone: f64) -> [f64; 3] {
    let mut at = target;
    for (at, place) in at.iter_mut().zip(place) {
        *at += (1.0 - gone) * (place - *at);
    }
    at
}

/// Joint speed of a leg that bends, deg/s.
const BEND_RATE: f64 = 30.0;

/// Turn of the joints in one step of the search for a bend, deg.
const BEND_STEP: f64 = 0.5;

/// Maximum number of steps of that search.
const BEND_STEPS: u8 = 60;

/// Largest turn for which a leg is nearly straight, deg.
const BEND_FARTHEST: f64 = 25.0;

/// Joints that turn less than this share of a step have arrived.
const AT_REST: f64 = 0.05;

/// Longest time that a leg bends, s.
const BEND_TIME: f64 = 3.0;

/// Distance from the posture at which joints have taken it, deg.
const TAKEN: f64 = 0.2;

/// A leg that bends, and the postures that follow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::controller) struct Bend<const J: usize> {
    aim: [f64; J],
    to: [f64; J],
    /// The posture at the end of the line that follows.
    end: [f64; J],
    line: Line,
    /// Turn of the joints in this cycle, deg.
    step: f64,
    /// Remaining time for the bend, s.
    left: f64,
}

impl<const J: usize> Bend<J> {
    /// Advances by `dt` seconds. Under a hold it waits.
    fn advance(&mut self, dt: f64, held: bool) {
        let dt = if held { 0.0 } else { dt };
        self.step = BEND_RATE * dt;
        self.left -= dt;
    }

    /// Returns the postures to follow once the leg at `angles` is bent.
    fn done(&self, angles: &[f64; J]) -> Option<PosturePath<J>> {
        let is_near = largest_turn(angles, &self.to) <= TAKEN;
        (is_near || self.left <= 0.0).then(|| PosturePath::between(*angles, self.end, self.line))
    }

    /// Returns the posture that the joints at `angles` turn towards.
    fn posture(&self, angles: &[f64; J]) -> [f64; J] {
        towards(angles, &self.aim, self.step)
    }
}

/// The search for a posture with the leg bent to the other side.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Bending<const J: usize> {
    from: [f64; J],
    angles: [f64; J],
    steps: u8,
}

/// Result of one step of the search.
#[derive(Clone, Copy, Debug, PartialEq)]
enum BendResult<const J: usize> {
    SoFar(Bending<J>),
    /// The leg is bent.
    To([f64; J]),
    /// The leg does not bend.
    Fails,
}

impl<const J: usize> Bending<J> {
    /// Turns the joints by one step, with the point at `place`.
    fn bend(mut self, point: &PointOfLeg<'_, J>, place: [f64; 3]) -> BendResult<J> {
        let before = self.angles;
        let posture = towards(&before, &middle(point.leg), BEND_STEP);
        let turned = resolve_piece(point.leg, &before, point.point, place, point.axes, &posture);
        let Some(angles) = turned else {
            return BendResult::Fails;
        };
        if largest_turn(&angles, &before) <= AT_REST * BEND_STEP {
            return match largest_turn(&angles, &self.from) > TAKEN {
                true => BendResult::To(angles),
                false => BendResult::Fails,
            };
        }
        (self.angles, self.steps) = (angles, self.steps + 1);
        if self.steps >= BEND_STEPS || largest_turn(&angles, &self.from) > BEND_FARTHEST {
            return BendResult::Fails;
        }
        BendResult::SoFar(self)
    }
}

/// Returns the middle of the limits.
fn middle<const J: usize>(leg: &Leg<J>) -> [f64; J] {
    kinematics::starts(leg).nth(1).unwrap_or([0.0; J])
}

/// Returns the posture that joints lean to in order to turn by about `step` towards `aim`; the
/// first joint only turns the leg.
fn towards<const J: usize>(angles: &[f64; J], aim: &[f64; J], step: f64) -> [f64; J] {
    let mut posture = *angles;
    let share = 2.0 * step / largest_turn(angles, aim).max(step);
    for (posture, aim) in posture.iter_mut().zip(aim).skip(1) {
        *posture += share * (aim - *posture);
    }
    posture
}

#[cfg(test)]
mod tests {
    use crate::controller::drive::redundancy::{A_CYCLE, Outcome, PointOfLeg, Search, Stage};
    use crate::kinematics::{Chain, LegPoint};
    use crate::model::{Inverse, hand};
    use crate::random::Random;

    /// Cycles that a search takes at most: 18 postures, 60 steps of bending, twice 4 postures more; a line of
    /// 400 pieces each, 9 solutions before.
    const MAX_CYCLES: usize = (18 * 414 + 60 + 2 * 4 * 414) / A_CYCLE + 1;

    /// Returns the result of a search and its number of cycles; each is compared with as many steps.
    fn searched(
        point: LegPoint,
        start: [f64; 3],
        to: [f64; 3],
        home: Option<[f64; 3]>,
    ) -> (bool, usize) {
        let leg = &hand::MODEL.legs[0];
        let place = Chain::new(leg, &start).point(point).expect("a point");
        let point = PointOfLeg {
            leg,
            point,
            axes: Inverse::Planar.axes(),
        };
        let mut search = Search::new(&point, start, (place, to), home);
        for cycle in 1..=MAX_CYCLES {
            let mut stepped = search;
            let (mut pieces, mut steps) = (0, None);
            while pieces < A_CYCLE && steps.is_none() {
                pieces += if stepped.stage == Stage::Starting {
                    6
                } else {
                    1
                };
                steps = stepped.step(&point);
            }
            assert!(pieces < 48 + 6, "{pieces}");
            let found = search.advance(&point, &start, place);
            assert_eq!((search, found), (stepped, steps), "{cycle}");
            if let Some(outcome) = found {
                return (outcome != Outcome::Nothing, cycle);
            }
        }
        panic!("{start:?} {to:?}: no end");
    }

    #[test]
    fn no_cycle_solves_a_leg_more_often_than_the_bound() {
        let mut random = Random::new(0x2545_F491_4F6C_DD1D);
        let (mut at_once, mut later, mut in_vain) = (0, 0, 0);
        for number in 0..600 {
            let start = [(-90.0, 90.0), (-10.0, 110.0), (-10.0, 110.0)];
            let start = start.map(|(min, max)| random.within(min, max));
            let [x, y] =
                [(-200.0, 80.0), (-150.0, 100.0)].map(|(min, max)| random.within(min, max));
            let point = if number % 2 == 0 {
                LegPoint::Tip
            } else {
                LegPoint::Joint(2)
            };
            match searched(point, start, [x, y, 0.0], None) {
                (true, 1) => at_once += 1,
                (true, _) => later += 1,
                (false, _) => in_vain += 1,
            }
        }
        assert!(
            at_once > 50 && later > 5 && in_vain > 50,
            "{at_once} {later} {in_vain}"
        );
    }
}
