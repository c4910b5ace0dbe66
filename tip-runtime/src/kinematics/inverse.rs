//! Inverse kinematics of a foot's position.

use super::closed_form::ClosedFormLeg;
use super::{LegPoint, resolve, search};
use crate::model::{Inverse, Leg, Point};

/// Returns the joint angles (deg) that put the foot of `leg` at `foot` (mm); `None` if the links do
/// not reach it. Of several solutions within the limits, a closed form takes the one nearest to the
/// initial posture; if there is none, it returns its first solution, so that the caller can name
/// the joint that would have to turn too far. Least squares keep within the limits. See
/// [`within_limits`](super::within_limits).
#[must_use]
pub fn inverse<const J: usize>(kind: Inverse, leg: &Leg<J>, foot: Point) -> Option<[f64; J]> {
    if !kind.is_closed() {
        return search(leg, LegPoint::Tip, foot, kind.axes());
    }
    let (closed, initial) = closed(kind, leg, &leg.initial)?;
    let [first, ..] = closed.solutions(&initial, foot);
    sized(closed.nearest(&initial, foot).or(first)?)
}

/// Returns the joint angles (deg) within the limits that put the foot of `leg` at `foot` (mm), the
/// ones nearest to the angles `from`; `None` if there are none.
///
/// ```
/// use tip_runtime::kinematics::{Chain, inverse_from};
/// use tip_runtime::model::titan8;
///
/// // Folded as far as it goes, a leg of TITAN VIII has its foot 3 mm beyond the yaw axis.
/// let leg = &titan8::MODEL.legs[1];
/// let folded = [10.0, -60.0, 150.0];
/// let foot = Chain::new(leg, &folded).foot();
/// let near = inverse_from(titan8::MODEL.inverse, leg, &[0.0, -50.0, 145.0], foot).expect("it is there");
/// assert!(near.iter().zip(folded).all(|(a, b)| (a - b).abs() < 1e-9));
/// ```
#[must_use]
pub fn inverse_from<const J: usize>(
    kind: Inverse,
    leg: &Leg<J>,
    from: &[f64; J],
    foot: Point,
) -> Option<[f64; J]> {
    if !kind.is_closed() {
        return resolve(leg, from, LegPoint::Tip, foot, kind.axes());
    }
    let (closed, from) = closed(kind, leg, from)?;
    sized(closed.nearest(&from, foot)?)
}

/// Like [`inverse_from`], for the next position of a foot on its path: a closed form skips no
/// postures.
pub(crate) fn inverse_next<const J: usize>(
    kind: Inverse,
    leg: &Leg<J>,
    from: &[f64; J],
    foot: Point,
) -> Option<[f64; J]> {
    if !kind.is_closed() {
        return inverse_from(kind, leg, from, foot);
    }
    let (closed, from) = closed(kind, leg, from)?;
    sized(closed.next(&from, foot)?)
}

fn closed<'a, const J: usize>(
    kind: Inverse,
    leg: &'a Leg<J>,
    from: &[f64; J],
) -> Option<(ClosedFormLeg<'a>, [f64; 3])> {
    let closed = ClosedFormLeg::new(kind, leg.base, &leg.joints)?;
    Some((closed, from.as_slice().try_into().ok()?))
}

/// Converts the three angles of a closed form.
fn sized<const J: usize>(angles: [f64; 3]) -> Option<[f64; J]> {
    angles.as_slice().try_into().ok()
}
