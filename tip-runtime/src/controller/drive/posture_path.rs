//! Postures between two ends, through which a leg with joints to spare goes.
//!
//! The limits of joints are intervals: between two postures within them no joint is beyond its own.

use crate::controller::trajectory::{Goal, Limits, Track};

/// Shortest time of the return to the initial angles, s.
const RETURN: f64 = 0.8;

/// Limits of the pace, which speeds up in the first half of that time and slows down in the second.
const PACE: Limits = Limits {
    speed: 2.0 / RETURN,
    acceleration: 4.0 / (RETURN * RETURN),
};

/// The share of the way to the posture past which it goes that a bowed leg takes halfway.
const MOST_BOW: f64 = 0.75;

/// A straight line of a point: from where to where, in mm.
pub(super) type Line = ([f64; 3], [f64; 3]);

/// Postures between two ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::controller) struct PosturePath<const J: usize> {
    from: [f64; J],
    to: [f64; J],
    /// Distance of the point from its target at the start, mm.
    length: f64,
    /// Rest of the path to the posture, where time decides as well.
    ease: Option<Track<1>>,
    /// The posture to be taken once the point is at its target, if it is not `to`.
    home: Option<[f64; J]>,
    /// The posture past which the leg goes halfway, if it does not go straight.
    bow: Option<[f64; J]>,
}

impl<const J: usize> PosturePath<J> {
    /// Postures for a point on `line`, in step with it.
    pub(super) fn between(from: [f64; J], to: [f64; J], line: Line) -> Self {
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
    pub(super) fn eased(self) -> Self {
        let ease = Track::resting([1.0]).towards(Goal::Point {
            target: [0.0],
            hs: false,
        });
        PosturePath {
            ease: Some(ease),
            ..self
        }
    }

    /// Adds a motion to a posture afterwards, with the point at its target.
    pub(super) fn and_home(self, home: Option<[f64; J]>) -> Self {
        PosturePath { home, ..self }
    }

    /// Bows the path towards a posture within the limits.
    pub(super) fn bowed(self, bow: Option<[f64; J]>) -> Self {
        PosturePath { bow, ..self }
    }

    /// Moves on by `dt` seconds, with `line` left for the point; what is held waits.
    pub(super) fn advance(&mut self, line: Line, dt: f64, held: bool) {
        if let Some(ease) = &mut self.ease {
            ease.advance(PACE, dt, held);
        }
        if line.0 == line.1
            && let Some(home) = self.home
        {
            *self = PosturePath::between(self.to, home, line).eased();
        }
    }

    pub(super) fn is_at_rest(&self) -> bool {
        self.ease.as_ref().is_none_or(Track::is_at_rest)
    }

    /// Returns the posture for a point that is at `place` and goes to `target`.
    pub(super) fn posture(&self, place: [f64; 3], target: [f64; 3]) -> [f64; J] {
        let line = if self.length > 0.0 {
            (distance(place, target) / self.length).min(1.0)
        } else {
            0.0
        };
        let time = self.ease.map_or(0.0, |ease| ease.position().iter().sum());
        self.with_left(line.max(time))
    }

    /// Returns the posture with a share `left` of the way to go.
    pub(super) fn with_left(&self, left: f64) -> [f64; J] {
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

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    let squares = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b));
    libm::sqrt(squares.sum())
}
