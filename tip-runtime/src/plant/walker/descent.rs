//! The descent of a body that loses its hold: no faster than free fall.

use super::Vector;
use super::links::GRAVITY;
use super::pose::FloorPose;
use super::support::Contacts;
use super::support::{self, Support};

/// Halvings of a share or a height.
const HALVINGS: u32 = 40;

/// Greatest difference of equal heights, mm.
const ROUNDING: f64 = 1e-9;

/// The descent of the body: the speed of its fastest point, mm/s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Descent {
    speed: f64,
    /// True if nothing but gravity determines the speed.
    pub(super) is_free: bool,
}

impl Descent {
    /// At rest.
    pub(super) const NONE: Self = Descent {
        speed: 0.0,
        is_free: false,
    };

    /// Returns the rest, or as much of the way to it as the middle and the corners of `body` fall
    /// in `dt` s; all of it if no time passes. `weight` is in N.
    pub(super) fn towards<const L: usize>(
        &mut self,
        rest: Support,
        points: &Contacts<Vector, L>,
        weight: f64,
        body: &FloorPose,
        dt: f64,
    ) -> Support {
        if dt <= 0.0 {
            return rest;
        }
        let falls = GRAVITY * 1000.0 * dt;
        let farthest = (self.speed + falls / 2.0) * dt;
        let sunk = sunk(points, body, &rest);
        self.is_free = sunk > farthest;
        if !self.is_free {
            self.speed = (sunk / dt).max(0.0);
            return rest;
        }
        self.speed += falls;
        // Above the floor, or pressed on it by no more than the weight.
        let free = |normal| fallen(points, body, normal, farthest);
        let carried = |normal| carried(points, normal, weight);
        let [mut done, mut left] = [0.0, 1.0];
        for _ in 0..HALVINGS {
            let middle = (done + left) / 2.0;
            let normal = between(body.normal, rest.normal, middle);
            if carried(normal) > free(normal) + ROUNDING {
                done = middle;
            } else {
                left = middle;
            }
        }
        let normal = between(body.normal, rest.normal, done);
        Support {
            normal,
            height: carried(normal).max(free(normal)),
            found: false,
        }
    }
}

/// Iterates over the middle and the lower corners of the body, in the robot frame.
fn places<const L: usize>(points: &Contacts<Vector, L>) -> impl Iterator<Item = &Vector> {
    const MIDDLE: Vector = Vector::new(0.0, 0.0, 0.0);
    points.belly.iter().chain(core::iter::once(&MIDDLE))
}

/// Returns the greatest descent of a point of the body to a rest, mm.
fn sunk<const L: usize>(points: &Contacts<Vector, L>, body: &FloorPose, rest: &Support) -> f64 {
    places(points).fold(f64::NEG_INFINITY, |most, place| {
        let before = body.normal.dot(place) + body.height;
        most.max(before - rest.normal.dot(place) - rest.height)
    })
}

/// Returns the least height of a body in an attitude, if no point of it has sunk by more than
/// `farthest`, mm.
fn fallen<const L: usize>(
    points: &Contacts<Vector, L>,
    body: &FloorPose,
    normal: Vector,
    farthest: f64,
) -> f64 {
    places(points).fold(f64::NEG_INFINITY, |most, place| {
        let least = body.normal.dot(place) + body.height - farthest;
        most.max(least - normal.dot(place))
    })
}

/// Returns the height of a body in an attitude whose contacts carry `weight` (N), mm.
fn carried<const L: usize>(points: &Contacts<Vector, L>, normal: Vector, weight: f64) -> f64 {
    let lowest = points.iter().map(|point| normal.dot(point));
    let touching = -lowest.fold(f64::INFINITY, f64::min);
    let [mut low, mut high] = [touching - weight / support::STIFFNESS, touching];
    for _ in 0..HALVINGS {
        let middle = (low + high) / 2.0;
        let load: f64 = support::loads(points, normal, middle).iter().sum();
        if load > weight {
            low = middle;
        } else {
            high = middle;
        }
    }
    high
}

/// Returns a direction between two others.
fn between(from: Vector, to: Vector, share: f64) -> Vector {
    let mixed = from + (to - from) * share;
    mixed / mixed.norm()
}
