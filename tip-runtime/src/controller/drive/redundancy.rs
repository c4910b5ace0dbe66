//! Motion of redundant joints while a point goes straight to its target.
//!
//! A leg with more joints than its point needs goes through the postures between the one that it has
//! and one in which its point is at the target. Resolved rate puts the point on its line and leaves the
//! rest to that posture. The line is tried out before the leg sets off; where a posture leads into a
//! limit, another one is tried. If that takes more than one cycle, the leg waits, or brakes first.

use super::reach::has_few_joints;
use super::search::{Bend, Line, Outcome, PointOfLeg, PosturePath, Search};
use crate::controller::trajectory::{Limits, Track};
use crate::kinematics::{self, LegPoint};
use crate::model::{Inverse, Leg};

/// The rule that redundant joints follow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::controller) enum Redundancy<const J: usize> {
    /// Nobody: there are none, or no postures lead to the target.
    None,
    /// Every joint for itself, braking from these rates, deg/s, before the point sets off.
    Brakes([f64; J]),
    /// Postures that are yet to be found.
    Sought(Search<J>),
    /// The leg bends, and follows its line then.
    Bends(Bend<J>),
    /// Postures that lead to the target.
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

    /// Goes on with a search for postures, for a leg at the angles `from`. If its point moves, and would
    /// swing too far to the side of its line, the leg brakes first.
    pub(super) fn look(
        &mut self,
        point: &PointOfLeg<'_, J>,
        from: &[f64; J],
        track: &Track<3>,
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

    /// Moves on by `dt` seconds, with `line` left for the point; what is held waits.
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
