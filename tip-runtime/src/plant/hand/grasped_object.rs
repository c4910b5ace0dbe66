//! A grasped object: a body with its contacts, and the overlaps of links, bodies and surfaces that make them. Depths are
//! in m, normals point from the second body to the first.

use super::Vector;
use super::contact::{Bristle, ContactHistory, Overlap, Push};
use super::finger::{Finger, Link, across};
use super::rigid_body::RigidBody;
use crate::model::{Point, Range};
use crate::scene::{OBJECTS, Object};

/// The coefficient of Coulomb friction of the palm; the object's counts if it is smaller.
const PALM: f64 = 0.5;

/// Thickness of the palm, upwards, m.
const THICKNESS: f64 = 0.02;

/// The contacts of a link with a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct LinkContact {
    /// Friction of the possible places of contact.
    bristles: [Bristle; 5],
    history: ContactHistory,
}

impl LinkContact {
    /// The contacts of a pair that has not been near each other.
    pub(super) const NONE: Self = LinkContact {
        bristles: [Bristle::NONE; 5],
        history: ContactHistory::UNKNOWN,
    };
}

/// A body with the friction of its contacts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct GraspedObject {
    pub(super) body: RigidBody,
    floor: [Bristle; 4],
    palm: [Bristle; 4],
    /// Contacts with the objects after it in the scene.
    others: [[Bristle; 8]; OBJECTS],
    pub(super) on_floor: bool,
    pub(super) at_palm: bool,
    /// The greatest height of the lowest point above the floor, m.
    pub(super) highest: f64,
}

impl GraspedObject {
    /// Returns an object at rest. One without a position of its own stands on the floor.
    pub(super) fn new(object: &Object, floor: &Surface) -> Self {
        let mut body = RigidBody::new(object);
        if object.y.is_none() {
            let low = |low: f64, point: &Vector| low.min(floor.height(*point));
            let lowest = body.feelers(-floor.normal);
            let lowest = lowest.iter().flatten().fold(f64::INFINITY, low);
            body.centre.y -= lowest / floor.normal.y;
        }
        let mut object = GraspedObject {
            body,
            floor: [Bristle::default(); 4],
            palm: [Bristle::default(); 4],
            others: [[Bristle::default(); 8]; OBJECTS],
            on_floor: false,
            at_palm: false,
            highest: 0.0,
        };
        object.highest = object.clearance(floor);
        object
    }

    /// Returns the height of the lowest point above the floor, m.
    pub(super) fn clearance(&self, floor: &Surface) -> f64 {
        let feelers = self.body.feelers(-floor.normal);
        let heights = feelers.iter().flatten().map(|point| floor.height(*point));
        heights.fold(f64::INFINITY, f64::min)
    }

    /// Applies the contact with the floor.
    pub(super) fn press_floor(&mut self, floor: &Surface, dt: f64) {
        self.on_floor = press(&mut self.body, &mut self.floor, floor, |_| true, dt);
    }

    /// Applies the contact with the palm.
    pub(super) fn press_palm(&mut self, palm: &Palm, dt: f64) {
        let is_there = |point| palm.is_at(point);
        self.at_palm = press(&mut self.body, &mut self.palm, &palm.surface, is_there, dt);
    }

    /// Applies the contacts with a finger, which are `joins`; returns the force on the finger's
    /// last link, N.
    pub(super) fn press_finger<const J: usize>(
        &mut self,
        contacts: &mut [LinkContact; J],
        finger: &mut Finger<J>,
        dt: f64,
    ) -> Vector {
        let RigidBody {
            friction,
            law_with_fingers: law,
            ..
        } = self.body;
        let mut on_last = Vector::zeros();
        for (m, LinkContact { bristles, history }) in contacts.iter_mut().enumerate() {
            let Some(link) = finger.links().get(m) else {
                continue;
            };
            let Some(places) = of_link(link, m == 0, &self.body, history) else {
                *bristles = [Bristle::default(); 5];
                continue;
            };
            let link = *link;
            for (bristle, place) in bristles.iter_mut().zip(places) {
                let body = &self.body;
                let velocity = |at| link.velocity_at(at) - body.velocity_at(at);
                let push = bristle.press(place, velocity, law, friction, dt);
                if let Some(Push { at, force }) = push {
                    finger.push(m, at, force);
                    self.body.push(at, -force);
                    if m + 1 == J {
                        on_last += force;
                    }
                }
            }
        }
        on_last
    }

    /// Applies the contact with another object, the `n`th after it.
    pub(super) fn press_object(&mut self, n: usize, other: &mut Self, dt: f64) {
        let friction = self.body.friction.min(other.body.friction);
        let law = self.body.law_with(&other.body);
        let places = of_bodies(&self.body, &other.body);
        let bristles = self.others.get_mut(n).into_iter().flatten();
        for (bristle, place) in bristles.zip(places) {
            let (own, its) = (&self.body, &other.body);
            let velocity = |at| own.velocity_at(at) - its.velocity_at(at);
            if let Some(Push { at, force }) = bristle.press(place, velocity, law, friction, dt) {
                self.body.push(at, force);
                other.body.push(at, -force);
            }
        }
    }
}

/// The lower side of the palm, which spans the bases of the fingers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Palm {
    surface: Surface,
    /// m.
    x: Range,
    /// m.
    y: Range,
}

impl Palm {
    /// Returns the palm between fingers with these bases (mm); `None` if there are none.
    pub(super) fn between(bases: impl Iterator<Item = Point>) -> Option<Self> {
        let around = |at: f64| Range::new(at / 1000.0, at / 1000.0);
        let join = |a: Range, b: Range| Range::new(a.min.min(b.min), a.max.max(b.max));
        let (x, y) = bases
            .map(|[x, y, _]| (around(x), around(y)))
            .reduce(|a, b| (join(a.0, b.0), join(a.1, b.1)))?;
        let surface = Surface {
            point: Vector::new(0.0, y.min),
            normal: -Vector::y(),
            velocity: Vector::zeros(),
            friction: PALM,
        };
        let y = Range::new(y.min, y.min + THICKNESS);
        Some(Palm { surface, x, y })
    }

    fn is_at(&self, point: Vector) -> bool {
        self.x.contains(point.x) && self.y.contains(point.y)
    }
}

/// Applies the contact of a body with a surface where `is_there` is true; returns true if they
/// touch.
fn press(
    body: &mut RigidBody,
    bristles: &mut [Bristle; 4],
    surface: &Surface,
    is_there: impl Fn(Vector) -> bool,
    dt: f64,
) -> bool {
    if surface.height(body.centre) > body.reach {
        *bristles = [Bristle::NONE; 4];
        return false;
    }
    let (friction, law) = (body.friction.min(surface.friction), body.law);
    let mut touches = false;
    let feelers = body.feelers(-surface.normal);
    for (bristle, feeler) in bristles.iter_mut().zip(feelers) {
        let feeler = feeler.filter(|point| is_there(*point));
        let place = feeler.and_then(|point| surface.overlap(point));
        let own = &*body;
        let velocity = |at| own.velocity_at(at) - surface.velocity;
        if let Some(Push { at, force }) = bristle.press(place, velocity, law, friction, dt) {
            body.push(at, force);
            touches = true;
        }
    }
    touches
}

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
fn of_link(
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
fn of_bodies(first: &RigidBody, second: &RigidBody) -> [Option<Overlap>; 8] {
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
