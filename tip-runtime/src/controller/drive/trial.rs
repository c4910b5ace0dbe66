//! A line that is tried out before a leg sets off, piece by piece.

use super::posture_path::{Line, PosturePath};
use crate::kinematics::{LegPoint, resolve_piece};
use crate::model::{Axes, Leg};

/// Pieces of a line are no longer than this share of it.
const LONGEST: f64 = 1.0 / 32.0;

/// Nor shorter than this.
const SHORTEST: f64 = 1.0 / 16384.0;

/// The most pieces that are tried.
const PIECES: u16 = 400;

/// Turn of a joint beyond which a piece has left out what is between, deg.
const LEAP: f64 = 6.0;

/// A point of a leg that is to be put somewhere, and the axes that count.
#[derive(Clone, Copy)]
pub(super) struct PointOfLeg<'a, const J: usize> {
    pub(super) leg: &'a Leg<J>,
    pub(super) point: LegPoint,
    pub(super) axes: Axes,
}

/// A trial of the postures that lead a point along a line, as far as it has come.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Trial<const J: usize> {
    guide: PosturePath<J>,
    angles: [f64; J],
    gone: f64,
    piece: f64,
    pieces: u16,
}

/// Result of one piece.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum TrialResult<const J: usize> {
    /// The line has to be tried farther.
    SoFar(Trial<J>),
    /// The postures lead to the target.
    Leads(PosturePath<J>),
    /// The postures do not lead to the target.
    Fails,
}

impl<const J: usize> Trial<J> {
    pub(super) fn new(guide: PosturePath<J>, from: [f64; J]) -> Self {
        Trial {
            guide,
            angles: from,
            gone: 0.0,
            piece: LONGEST,
            pieces: 0,
        }
    }

    /// Tries one piece, and half of it next if the point does not get over it without a leap.
    pub(super) fn try_piece(mut self, point: &PointOfLeg<'_, J>, line: Line) -> TrialResult<J> {
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
        .filter(|turned| !leaps(&self.angles, turned));
        self.pieces += 1;
        match turned {
            Some(_) if next >= 1.0 => return TrialResult::Leads(self.guide),
            Some(turned) => {
                (self.angles, self.gone) = (turned, next);
                self.piece = (self.piece * 2.0).min(LONGEST);
            }
            None => self.piece /= 2.0,
        }
        if self.piece < SHORTEST || self.pieces >= PIECES {
            return TrialResult::Fails;
        }
        TrialResult::SoFar(self)
    }
}

/// Returns the place with a share `gone` of a line left behind.
fn on_line((place, target): Line, gone: f64) -> [f64; 3] {
    let mut at = target;
    for (at, place) in at.iter_mut().zip(place) {
        *at += (1.0 - gone) * (place - *at);
    }
    at
}

fn leaps<const J: usize>(from: &[f64; J], to: &[f64; J]) -> bool {
    let mut joints = from.iter().zip(to);
    joints.any(|(from, to)| libm::fabs(to - from) > LEAP)
}
