//! What joints to spare do while a point goes straight to its target.
//!
//! A leg with more joints than its point needs goes through the postures between the one that it has
//! and one in which its point is at the target. The limits of joints are intervals: between two postures
//! within them no joint is beyond its own. Resolved rate puts the point on its line and leaves the rest to
//! that posture. A line is tried out before the leg sets off, piece by piece; where a posture leads
//! into a limit, another one is tried.

use super::reach::has_few_joints;
use crate::controller::trajectory::{Goal, Limits, Track};
use crate::kinematics::{self, Point, resolve_towards};
use crate::model::{Inverse, Leg};

/// How long the return to the initial angles takes, at least: s.
const RETURN: f64 = 0.8;

/// It speeds up in the first half of that time and slows down in the second.
const PACE: Limits = Limits {
    speed: 2.0 / RETURN,
    acceleration: 4.0 / (RETURN * RETURN),
};

/// Pieces of a line are no longer than this share of it.
const LONGEST: f64 = 1.0 / 32.0;

/// Nor shorter than this.
const SHORTEST: f64 = 1.0 / 16384.0;

/// The most pieces that are tried.
const PIECES: usize = 400;

/// A joint that turns farther within a piece has left out what is between: deg.
const LEAP: f64 = 6.0;

/// How often a posture at the target is drawn nearer to the present one.
const DRAWS: usize = 8;

/// A straight line of a point: from where to where, in mm.
type Line = ([f64; 3], [f64; 3]);

/// Postures between two ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::controller) struct Guide<const J: usize> {
    from: [f64; J],
    to: [f64; J],
    /// From where the point was to its target: mm.
    length: f64,
    /// What is left of the path to the posture, where time decides as well.
    ease: Option<Track<1>>,
    /// The posture to be taken once the point is at its target, if it is not `to`.
    home: Option<[f64; J]>,
}

impl<const J: usize> Guide<J> {
    /// Postures on the path of a point along `line`, for a leg at the angles `from`; `None` if none are
    /// known that lead there, or the leg has no choice.
    pub(in crate::controller) fn to_place(
        leg: &Leg<J>,
        inverse: Inverse,
        point: Point,
        from: &[f64; J],
        line: Line,
    ) -> Option<Self> {
        if !has_choice::<J>(inverse, point) {
            return None;
        }
        let axes = inverse.axes();
        let starts = core::iter::once(*from).chain(kinematics::starts(leg));
        let ends = starts.filter_map(|start| {
            let mut end = kinematics::resolve(leg, &start, point, line.1, axes)?;
            for _ in 0..DRAWS {
                end = resolve_towards(leg, &end, point, line.1, axes, from)?;
            }
            Some(end)
        });
        let mut guides = ends.map(|to| Guide::between(*from, to, line));
        guides.find(|guide| guide.leads(leg, inverse, point, line))
    }

    /// Postures on the path of the foot along `line` to the initial posture, for a leg at the angles
    /// `from`; `None` if the leg has no choice.
    pub(in crate::controller) fn to_initial(
        leg: &Leg<J>,
        inverse: Inverse,
        from: &[f64; J],
        line: Line,
    ) -> Option<Self> {
        if !has_choice::<J>(inverse, Point::Tip) {
            return None;
        }
        let straight = Guide::between(*from, leg.initial, line).eased();
        if straight.leads(leg, inverse, Point::Tip, line) {
            return Some(straight);
        }
        let detour = Guide::to_place(leg, inverse, Point::Tip, from, line);
        let detour = detour.map(|detour| Guide {
            home: Some(leg.initial),
            ..detour
        });
        Some(detour.unwrap_or(straight))
    }

    fn between(from: [f64; J], to: [f64; J], line: Line) -> Self {
        Guide {
            from,
            to,
            length: distance(line.0, line.1),
            ease: None,
            home: None,
        }
    }

    /// The same, but no faster than in [`RETURN`].
    fn eased(self) -> Self {
        let ease = Track::resting([1.0]).towards(Goal::Point {
            target: [0.0],
            hs: false,
        });
        Guide {
            ease: Some(ease),
            ..self
        }
    }

    /// Moves on by `dt` seconds, with `line` left for the point; what is held waits.
    pub(super) fn advance(&mut self, line: Line, dt: f64, held: bool) {
        if let Some(ease) = &mut self.ease {
            ease.advance(PACE, dt, held);
        }
        if line.0 == line.1
            && let Some(home) = self.home
        {
            *self = Guide::between(self.to, home, line).eased();
        }
    }

    pub(super) fn is_at_rest(&self) -> bool {
        self.ease.as_ref().is_none_or(Track::is_at_rest)
    }

    /// The posture for a point that is at `place` and goes to `target`.
    pub(super) fn posture(&self, place: [f64; 3], target: [f64; 3]) -> [f64; J] {
        let line = if self.length > 0.0 {
            (distance(place, target) / self.length).min(1.0)
        } else {
            0.0
        };
        let time = self.ease.map_or(0.0, |ease| ease.position().iter().sum());
        self.with_left(line.max(time))
    }

    /// The posture with a share `left` of the way to go.
    fn with_left(&self, left: f64) -> [f64; J] {
        let mut posture = self.to;
        for (angle, from) in posture.iter_mut().zip(self.from) {
            *angle += left * (from - *angle);
        }
        posture
    }

    /// Whether a point that follows these postures gets to the target without a leap.
    fn leads(&self, leg: &Leg<J>, inverse: Inverse, point: Point, (place, target): Line) -> bool {
        let (mut angles, mut gone, mut piece) = (self.from, 0.0, LONGEST);
        for _ in 0..PIECES {
            let next: f64 = (gone + piece).min(1.0);
            let posture = self.with_left(1.0 - next);
            let mut at = target;
            for (at, place) in at.iter_mut().zip(place) {
                *at += (1.0 - next) * (place - *at);
            }
            let turned = resolve_towards(leg, &angles, point, at, inverse.axes(), &posture)
                .filter(|turned| !leaps(&angles, turned));
            match turned {
                Some(_) if next >= 1.0 => return true,
                Some(turned) => {
                    (angles, gone, piece) = (turned, next, (piece * 2.0).min(LONGEST));
                }
                None => piece /= 2.0,
            }
            if piece < SHORTEST {
                return false;
            }
        }
        false
    }
}

/// Whether enough joints move a point for every direction, and a closed form does not decide.
fn has_choice<const J: usize>(inverse: Inverse, point: Point) -> bool {
    inverse != Inverse::YawPitchPitch && !has_few_joints::<J>(inverse, point)
}

fn leaps<const J: usize>(from: &[f64; J], to: &[f64; J]) -> bool {
    let mut joints = from.iter().zip(to);
    joints.any(|(from, to)| libm::fabs(to - from) > LEAP)
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    let squares = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b));
    libm::sqrt(squares.sum())
}
