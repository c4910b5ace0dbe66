//! Overlaps of links, bodies and surfaces. Depths are in m, normals point from the second body to
//! the first.

use super::Vector;
use super::contact::Overlap;
use super::contact_history::ContactHistory;
use super::finger::{Link, across};
use super::rigid_body::RigidBody;

/// Greatest distance of a link and a body that meet, or pass each other, within a step, m. That is
/// 20 m/s in the longest step.
const SWEEP: f64 = 0.01;

/// A moving plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Surface {
    /// A point of the plane, m.
    pub(super) point: Vector,
    /// Outward normal, a unit vector.
    pub(super) normal: Vector,
    /// m/s.
    pub(super) velocity: Vector,
    /// The coefficient of Coulomb friction.
    pub(super) friction: f64,
}

impl Surface {
    /// Returns the height of a point above the plane, m.
    #[inline]
    pub(super) fn height(&self, point: Vector) -> f64 {
        (point - self.point).dot(&self.normal)
    }

    /// Returns the overlap of a point below the plane.
    #[inline]
    pub(super) fn overlap(&self, at: Vector) -> Option<Overlap> {
        overlap(at, self.normal, -self.height(at))
    }
}

/// Returns the places where a link can touch a body: one along a disc; of a box the link's end, and
/// each corner that pokes through the link; `None` while they are far apart. The start of a link
/// belongs to the link before it, if there is one. A body that has passed through the link, or a
/// link through the body, goes back to the side in the contact history.
#[inline]
pub(super) fn of_link(
    link: &Link,
    is_first: bool,
    body: &RigidBody,
    history: &mut ContactHistory,
) -> Option<[Option<Overlap>; 5]> {
    let near = body.reach + SWEEP;
    let apart = near + link.half;
    if *history == ContactHistory::UNKNOWN
        && (body.centre - link.middle()).norm_squared() > apart * apart
    {
        return None;
    }
    let along = link.end - link.start;
    let away = body.centre - link.start;
    let share = away.dot(&along) / along.norm_squared();
    let nearest = link.start + along * share.clamp(0.0, 1.0);
    let from = nearest - body.centre;
    let is_far = from.norm_squared() > near * near;
    let side = libm::copysign(1.0, along.perp(&away));
    let is_beside = share > 0.0 && share < 1.0;
    if is_far && !(is_beside && history.is_other(side)) {
        *history = ContactHistory::UNKNOWN;
        return None;
    }
    if !body.is_box() {
        let (out, depth) = body.way_out(nearest);
        let (out, depth) = match history.is_through(side, is_beside) {
            true => (-out, 2.0 * body.reach - depth),
            false => (out, depth),
        };
        let own = is_first || share > 0.0;
        let touch = overlap(nearest, out, depth).filter(|_| own);
        return Some([touch, None, None, None, None]);
    }
    let (out, depth) = body.way_back(link.end, &mut history.face);
    if depth > 0.0 {
        history.side = side;
        return Some([overlap(link.end, out, depth), None, None, None, None]);
    }
    let passes = body
        .crossing(link.start, link.end)
        .is_some_and(|(enters, leaves)| enters > 0.0 && leaves < 1.0);
    let is_through = history.is_through(side, passes || is_beside);
    if !(passes || is_through) {
        return Some([None; 5]);
    }
    let [a, b, c, d] = poking(link, along, history.side, body);
    Some([None, a, b, c, d])
}

/// Returns the corners of a box that poke through a link from a side of it: +1 is where a quarter
/// turn from the link points.
fn poking(link: &Link, along: Vector, side: f64, body: &RigidBody) -> [Option<Overlap>; 4] {
    let normal = across(along) / along.norm();
    let away = normal * -side;
    body.corners()
        .map(|corner| overlap(corner, away, (corner - link.start).dot(&away)))
}

/// Returns the places where two bodies can touch: of boxes the corners of each, otherwise one.
pub(super) fn of_bodies(first: &RigidBody, second: &RigidBody) -> [Option<Overlap>; 8] {
    let apart = first.centre - second.centre;
    let reach = first.reach + second.reach;
    let mut places = [None; 8];
    if apart.norm_squared() > reach * reach {
        return places;
    }
    if first.is_box() && second.is_box() {
        let Some(normal) = first.least_overlap(second) else {
            return places;
        };
        let of_first = first
            .corners()
            .map(|corner| overlap(corner, normal, second.depth_along(corner, normal)));
        let of_second = second
            .corners()
            .map(|corner| overlap(corner, normal, first.depth_along(corner, -normal)));
        for (place, found) in places.iter_mut().zip(of_first.into_iter().chain(of_second)) {
            *place = found;
        }
        return places;
    }
    let [place, ..] = &mut places;
    *place = if first.is_box() {
        let (out, depth) = first.way_out(second.centre);
        let at = second.centre - out * second.reach;
        overlap(at, -out, depth + second.reach)
    } else {
        let (out, depth) = second.way_out(first.centre);
        let at = first.centre - out * first.reach;
        overlap(at, out, depth + first.reach)
    };
    places
}

#[inline]
fn overlap(at: Vector, normal: Vector, depth: f64) -> Option<Overlap> {
    (depth > 0.0).then_some(Overlap { at, normal, depth })
}
