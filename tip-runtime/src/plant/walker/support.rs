//! The support of the body: its rest on its contacts.
//!
//! Every contact is a stiff spring. The body is where its potential energy is least: with the
//! floor as the plane `z = -(a x + b y + h)` seen from the body, that energy is convex in
//! `(a, b, h)`, so Newton's method with a line search finds the one minimum (Nocedal and Wright,
//! Numerical Optimization, 2006, ch. 3). For large tilts the frame is turned and it is done again.
//!
//! A body that loses its hold descends to that rest no faster than it falls.

use super::Vector;
use super::pose::FloorPose;
use crate::model;
use crate::plant::GRAVITY;
use nalgebra::{Cholesky, Matrix3, U3, Vector3};

/// Stiffness of a foot with its leg, and of the belly, N/mm.
pub(super) const STIFFNESS: f64 = 200.0;
/// Maximum number of rotations of the frame.
const MAX_ROTATIONS: u32 = 6;
/// Maximum number of steps of Newton's method in one frame.
const STEPS: u32 = 40;
/// Maximum number of halvings of one step.
const HALVINGS: u32 = 30;
/// The largest step: slope, slope, height in mm.
const LARGEST: [f64; 3] = [0.1, 0.1, 50.0];
/// Slopes and heights in mm below which a step changes nothing.
const SMALLEST: [f64; 3] = [1e-13, 1e-13, 1e-10];
/// Tolerance for a rise of the energy, N·mm.
const ROUNDING: f64 = 1e-8;
/// Keeps the curvature positive where fewer than three contacts carry: relative to one contact at
/// about 100 mm.
const DAMPING: f64 = 1e-6;

/// The weight of the robot.
pub(super) struct Load {
    /// The centre of mass in the robot frame: mm.
    pub(super) centre: Vector,
    /// Weight, N.
    pub(super) weight: f64,
    /// Direction of gravity in the floor's frame.
    pub(super) gravity: Vector,
}

/// The pose of the floor, seen from the body.
pub(super) struct Support {
    /// Normal of the floor in the robot frame.
    pub(super) normal: Vector,
    /// Height of the body's origin above the floor, mm.
    pub(super) height: f64,
    /// True if the rest was found; a body that tips is still moving.
    pub(super) found: bool,
}

/// Finds the rest nearest to the pose of `body`.
pub(super) fn rest<const L: usize>(
    points: &Contacts<Vector, L>,
    load: &Load,
    body: &FloorPose,
) -> Support {
    let mut support = Support {
        normal: body.normal,
        height: body.height,
        found: false,
    };
    let pull = pull(load, body.heading);
    for _ in 0..MAX_ROTATIONS {
        let levelling = FloorPose::levelling(support.normal);
        let problem = Problem {
            points: points.map(|point| levelling * point),
            centre: levelling * load.centre,
            pull,
        };
        let plane = problem.solve(support.height);
        let tilted = Vector::new(plane.x, plane.y, 1.0);
        let length = tilted.norm();
        support.normal = levelling.inverse() * (tilted / length);
        support.height = plane.z / length;
        if length <= 1.0 {
            support.found = true;
            break;
        }
    }
    support
}

/// Returns the load of each contact, N.
pub(super) fn loads<const L: usize>(
    points: &Contacts<Vector, L>,
    normal: Vector,
    height: f64,
) -> Contacts<f64, L> {
    points.map(|point| STIFFNESS * (-(normal.dot(&point) + height)).max(0.0))
}

/// Returns the weight in a frame that is level on the floor, without the body's heading, N.
fn pull(load: &Load, heading: f64) -> Vector {
    let (sin, cos) = (libm::sin(heading), libm::cos(heading));
    let gravity = load.gravity;
    Vector::new(
        cos * gravity.x + sin * gravity.y,
        cos * gravity.y - sin * gravity.x,
        gravity.z,
    ) * load.weight
}

struct Problem<const L: usize> {
    points: Contacts<Vector, L>,
    centre: Vector,
    pull: Vector,
}

/// The curvature of the energy for a set of loaded contacts.
struct Curvature<const L: usize> {
    carriers: Contacts<bool, L>,
    /// The factor; `None` where the curvature is not positive.
    factor: Option<Cholesky<f64, U3>>,
}

impl<const L: usize> Problem<L> {
    fn solve(&self, height: f64) -> Vector3<f64> {
        let mut plane = Vector3::new(0.0, 0.0, height);
        let mut heights = self.heights(&plane);
        let mut curvature = self.curvature(heights.map(carries));
        for _ in 0..STEPS {
            let carriers = heights.map(carries);
            if carriers != curvature.carriers {
                curvature = self.curvature(carriers);
            }
            let weight = self.weight(&plane);
            let step = self.newton_step(&weight, &heights, &curvature);
            (plane, heights) = self.descend(plane, &weight, heights, step);
            let small = step
                .iter()
                .zip(&SMALLEST)
                .all(|(step, smallest)| libm::fabs(*step) < *smallest);
            if small {
                break;
            }
        }
        plane
    }

    /// Returns the height of each contact above the plane; one below it carries load.
    fn heights(&self, plane: &Vector3<f64>) -> Contacts<f64, L> {
        self.points
            .map(|point| plane.x * point.x + plane.y * point.y + plane.z + point.z)
    }

    /// Returns the gradient of the weight's energy in `(a, b, h)`: on a slope the weight acts where
    /// its line meets the floor.
    fn weight(&self, plane: &Vector3<f64>) -> Vector3<f64> {
        let above = self.centre.z + plane.z;
        let lean = above / self.pull.z;
        Vector3::new(
            self.centre.x - lean * self.pull.x,
            self.centre.y - lean * self.pull.y,
            1.0,
        ) * -self.pull.z
    }

    fn curvature(&self, carriers: Contacts<bool, L>) -> Curvature<L> {
        let mut curvature =
            Matrix3::from_diagonal(&Vector3::new(1e4, 1e4, 1.0)) * (DAMPING * STIFFNESS);
        // Its lower half, which is all that the factorisation reads.
        self.points.for_each_with(&carriers, |point, carries| {
            if *carries {
                let (x, y) = (point.x, point.y);
                curvature.m11 += x * x * STIFFNESS;
                curvature.m21 += x * y * STIFFNESS;
                curvature.m22 += y * y * STIFFNESS;
                curvature.m31 += x * STIFFNESS;
                curvature.m32 += y * STIFFNESS;
                curvature.m33 += STIFFNESS;
            }
        });
        Curvature {
            carriers,
            factor: curvature.cholesky(),
        }
    }

    fn newton_step(
        &self,
        weight: &Vector3<f64>,
        heights: &Contacts<f64, L>,
        curvature: &Curvature<L>,
    ) -> Vector3<f64> {
        let mut slope = *weight;
        self.points.for_each_with(heights, |point, height| {
            if carries(*height) {
                slope -= Vector3::new(point.x, point.y, 1.0) * (STIFFNESS * -height);
            }
        });
        let step = (curvature.factor.as_ref())
            .map_or_else(Vector3::zeros, |curvature| -curvature.solve(&slope));
        let excess = step
            .iter()
            .zip(&LARGEST)
            .map(|(step, largest)| libm::fabs(*step) / largest)
            .fold(1.0, f64::max);
        step / excess
    }

    /// Descends along `step` as far as the energy falls.
    fn descend(
        &self,
        plane: Vector3<f64>,
        weight: &Vector3<f64>,
        heights: Contacts<f64, L>,
        mut step: Vector3<f64>,
    ) -> (Vector3<f64>, Contacts<f64, L>) {
        let before = energy(&plane, weight, &heights);
        for _ in 0..HALVINGS {
            let candidate = plane + step;
            let found = self.heights(&candidate);
            if energy(&candidate, weight, &found) <= before + ROUNDING {
                return (candidate, found);
            }
            step /= 2.0;
        }
        (plane, heights)
    }
}

fn carries(height: f64) -> bool {
    height < 0.0
}

fn energy<const L: usize>(
    plane: &Vector3<f64>,
    weight: &Vector3<f64>,
    heights: &Contacts<f64, L>,
) -> f64 {
    heights.iter().fold(weight.dot(plane), |energy, height| {
        let depth = (-height).max(0.0);
        energy + STIFFNESS / 2.0 * depth * depth
    })
}

/// A value for each foot and for each corner of the belly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Contacts<T, const L: usize> {
    pub(super) feet: [T; L],
    pub(super) belly: [T; 4],
}

impl<T, const L: usize> Contacts<T, L> {
    pub(super) const fn new(feet: [T; L], belly: [T; 4]) -> Self {
        Contacts { feet, belly }
    }

    /// Iterates over all contacts, feet first.
    pub(super) fn iter(&self) -> impl Iterator<Item = &T> + Clone {
        self.feet.iter().chain(&self.belly)
    }

    /// Calls `f` with both values of each contact, feet first.
    fn for_each_with<U>(&self, other: &Contacts<U, L>, mut f: impl FnMut(&T, &U)) {
        for (one, other) in self.feet.iter().zip(&other.feet) {
            f(one, other);
        }
        for (one, other) in self.belly.iter().zip(&other.belly) {
            f(one, other);
        }
    }
}

impl<T: Copy, const L: usize> Contacts<T, L> {
    pub(super) fn map<U>(&self, mut f: impl FnMut(T) -> U) -> Contacts<U, L> {
        Contacts {
            feet: self.feet.map(&mut f),
            belly: self.belly.map(&mut f),
        }
    }
}

impl<const L: usize> Contacts<Vector, L> {
    /// Returns the points that can touch the floor, in the robot frame.
    pub(super) fn of(body: &model::Body, feet: [Vector; L]) -> Self {
        let (x, y, z) = (body.x, body.y, body.z.min);
        Contacts {
            feet,
            belly: [
                Vector::new(x.min, y.min, z),
                Vector::new(x.max, y.min, z),
                Vector::new(x.max, y.max, z),
                Vector::new(x.min, y.max, z),
            ],
        }
    }
}

/// Halvings of a share or a height.
const FALL_HALVINGS: u32 = 40;

/// Greatest difference of equal heights, mm.
const EQUAL: f64 = 1e-9;

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
        for _ in 0..FALL_HALVINGS {
            let middle = (done + left) / 2.0;
            let normal = between(body.normal, rest.normal, middle);
            if carried(normal) > free(normal) + EQUAL {
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
    let [mut low, mut high] = [touching - weight / STIFFNESS, touching];
    for _ in 0..FALL_HALVINGS {
        let middle = (low + high) / 2.0;
        let load: f64 = loads(points, normal, middle).iter().sum();
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
