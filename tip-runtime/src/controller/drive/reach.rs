//! The places that a leg can reach.

use crate::command::Target;
use crate::controller::targets::number;
use crate::controller::trajectory::SetPoint;
use crate::fault::Fault;
use crate::kinematics::{self, Chain, LegPoint};
use crate::model::{Inverse, Leg, Point};

/// Returns the name that the language has for a point of leg `n`.
pub(in crate::controller) fn name(point: LegPoint, n: u8) -> Target {
    match point {
        LegPoint::Tip => Target::Foot(n),
        LegPoint::Joint(m) => Target::Joint(n, number(m)),
    }
}

/// Returns the joint angles nearest to `from` (deg) that put a point of leg `n` at `position`, mm.
///
/// # Errors
/// `OutOfReach` if the links do not reach it, `JointLimit` if a joint cannot turn so far.
pub(in crate::controller) fn reach<const J: usize>(
    inverse: Inverse,
    leg: &Leg<J>,
    (point, n): (LegPoint, u8),
    from: &[f64; J],
    position: Point,
) -> Result<[f64; J], Fault> {
    let angles = match point {
        LegPoint::Tip => kinematics::inverse_from(inverse, leg, from, position),
        LegPoint::Joint(_) => kinematics::resolve(leg, from, point, position, inverse.axes()),
    };
    let angles = angles.ok_or_else(|| refused(inverse, leg, (point, n), position))?;
    Ok(within_rounding(inverse, leg, angles))
}

/// Returns angles of a closed form, which may be beyond a limit by rounding, within the limits.
fn within_rounding<const J: usize>(inverse: Inverse, leg: &Leg<J>, angles: [f64; J]) -> [f64; J] {
    if inverse.is_closed() {
        leg.within_limits(&angles)
    } else {
        angles
    }
}

/// Returns the reason why no angles put a point of leg `n` at `position`.
fn refused<const J: usize>(
    inverse: Inverse,
    leg: &Leg<J>,
    (point, n): (LegPoint, u8),
    position: Point,
) -> Fault {
    let too_far = || {
        let angles = kinematics::inverse(inverse, leg, position)?;
        kinematics::first_beyond_limits(leg, &angles)
    };
    let joint = (point == LegPoint::Tip && inverse.is_closed()).then(too_far);
    match joint.flatten() {
        Some(m) => Fault::JointLimit(n, number(m)),
        None => Fault::OutOfReach(name(point, n)),
    }
}

/// Returns the joint angles (deg) that put a point of leg `n` at its set point. A point with too few joints for every
/// direction moves along its line or surface: as near to a set point on its path as possible, and all the way to the
/// target. Redundant joints turn towards `posture`. A closed form skips no postures between two cycles.
///
/// # Errors
/// The errors of [`reach`].
pub(super) fn follow<const J: usize>(
    inverse: Inverse,
    leg: &Leg<J>,
    (point, n): (LegPoint, u8),
    from: &[f64; J],
    (track, posture): (&SetPoint<3>, Option<[f64; J]>),
) -> Result<[f64; J], Fault> {
    let at = track.position();
    let on_its_way = track.goal().target().is_some_and(|target| target != at);
    if on_its_way && has_few_joints::<J>(inverse, point) {
        let nearest = kinematics::nearest(leg, from, point, at, inverse.axes());
        return nearest.ok_or(Fault::OutOfReach(name(point, n)));
    }
    if let Some(posture) = posture {
        let axes = inverse.axes();
        let angles = kinematics::resolve_towards(leg, from, point, at, axes, &posture);
        return angles.ok_or(Fault::OutOfReach(name(point, n)));
    }
    if point == LegPoint::Tip && inverse.is_closed() {
        let angles = kinematics::inverse_next(inverse, leg, from, at);
        let angles = angles.ok_or_else(|| refused(inverse, leg, (point, n), at))?;
        return Ok(within_rounding(inverse, leg, angles));
    }
    reach(inverse, leg, (point, n), from, at)
}

/// Returns the joint angles that put a point of leg `n` at `position` without a path to it.
///
/// # Errors
/// The errors of [`reach`].
#[cold]
pub(super) fn leap<const J: usize>(
    inverse: Inverse,
    leg: &Leg<J>,
    (point, n): (LegPoint, u8),
    from: &[f64; J],
    position: Point,
) -> Result<[f64; J], Fault> {
    reach(inverse, leg, (point, n), from, position).or_else(|fault| {
        let elsewhere = || kinematics::search(leg, point, position, inverse.axes());
        let found = (!inverse.is_closed()).then(elsewhere);
        found.flatten().ok_or(fault)
    })
}

/// Returns the place nearest to `position` (mm) that a point with too few joints can reach; `position` itself for any
/// other point.
pub(in crate::controller) fn nearest_place<const J: usize>(
    inverse: Inverse,
    leg: &Leg<J>,
    point: LegPoint,
    from: &[f64; J],
    position: Point,
) -> Point {
    if !has_few_joints::<J>(inverse, point) {
        return position;
    }
    let angles = kinematics::nearest(leg, from, point, position, inverse.axes());
    let place = angles.and_then(|angles| Chain::new(leg, &angles).point(point));
    place.map_or(position, |place| inverse.flat(place))
}

/// Returns true if too few joints move a point for every direction that counts.
pub(super) fn has_few_joints<const J: usize>(inverse: Inverse, point: LegPoint) -> bool {
    let directions = inverse.axes().iter().filter(|counts| **counts).count();
    point.moved_by(J) < directions
}
