//! Where things overlap. Depths are in m, normals point from the second thing to the first.

use super::Vector;
use super::body::Body;
use super::contact::Overlap;
use super::finger::{Link, across};

/// Something flat and endless that moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Surface {
    /// A point of it: m.
    pub(super) point: Vector,
    /// A unit vector out of it.
    pub(super) normal: Vector,
    /// m/s.
    pub(super) velocity: Vector,
    /// The coefficient of Coulomb friction.
    pub(super) friction: f64,
}

impl Surface {
    /// How far a point is above it: m.
    #[inline]
    pub(super) fn height(&self, point: Vector) -> f64 {
        (point - self.point).dot(&self.normal)
    }

    /// A point below it.
    #[inline]
    pub(super) fn overlap(&self, at: Vector) -> Option<Overlap> {
        overlap(at, self.normal, -self.height(at))
    }
}

/// The places where a link can touch a body: one along a disc; of a box its end, and each corner
/// that pokes through it; `None` while they are apart. The start of a link belongs to the link before
/// it, if there is one.
#[inline]
pub(super) fn of_link(link: &Link, is_first: bool, body: &Body) -> Option<[Option<Overlap>; 5]> {
    let along = link.end - link.start;
    let share = (body.centre - link.start).dot(&along) / along.norm_squared();
    let nearest = link.start + along * share.clamp(0.0, 1.0);
    let from = nearest - body.centre;
    if from.norm_squared() > body.reach * body.reach {
        return None;
    }
    if !body.is_box() {
        let (out, depth) = body.way_out(nearest);
        let own = is_first || share > 0.0;
        let touch = overlap(nearest, out, depth).filter(|_| own);
        return Some([touch, None, None, None, None]);
    }
    let (out, depth) = body.way_out(link.end);
    let [a, b, c, d] = poking(link, along, body);
    Some([overlap(link.end, out, depth), a, b, c, d])
}

/// The corners of a box that poke through a link.
fn poking(link: &Link, along: Vector, body: &Body) -> [Option<Overlap>; 4] {
    let passes = body
        .crossing(link.start, link.end)
        .is_some_and(|(enters, leaves)| enters > 0.0 && leaves < 1.0);
    if !passes {
        return [None; 4];
    }
    let normal = across(along) / along.norm();
    let centre = (body.centre - link.start).dot(&normal);
    let away = normal * -libm::copysign(1.0, centre);
    body.corners()
        .map(|corner| overlap(corner, away, (corner - link.start).dot(&away)))
}

/// The places where two bodies can touch: of boxes the corners of each, otherwise one.
pub(super) fn of_bodies(first: &Body, second: &Body) -> [Option<Overlap>; 8] {
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
