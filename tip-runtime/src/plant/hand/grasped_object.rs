//! A grasped object: a body with its contacts.

use super::Vector;
use super::contact::{Bristle, Push};
use super::contact_history::ContactHistory;
use super::finger::Finger;
use super::overlap::{Surface, of_bodies, of_link};
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
