//! A rigid body in the plane: the motion of an object.

use super::Vector;
use super::contact::{Face, HEAVY};
use super::finger::{across, rotated};
use crate::plant::{ContactLaw, GRAVITY};
use crate::scene::{Object, Shape};

/// The outline, m.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Outline {
    /// Radius.
    Disc(f64),
    /// Half of the width and height.
    Box(Vector),
}

/// A rigid body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct RigidBody {
    outline: Outline,
    /// Greatest distance of a point from the centre, m.
    pub(super) reach: f64,
    /// Mass, kg.
    mass: f64,
    /// Inertia about the centre, kg·m².
    inertia: f64,
    /// The coefficient of Coulomb friction of the surface.
    pub(super) friction: f64,
    /// Contact law with floor and palm.
    pub(super) law: ContactLaw,
    /// Contact law with fingers.
    pub(super) law_with_fingers: ContactLaw,
    /// Centre, m.
    pub(super) centre: Vector,
    /// rad.
    pub(super) angle: f64,
    /// m/s.
    pub(super) velocity: Vector,
    /// rad/s.
    pub(super) spin: f64,
    /// Expected velocity in the middle of the step, m/s.
    middle: Vector,
    /// Expected angular velocity in the middle of the step, rad/s.
    middle_spin: f64,
    /// Unit vector along the width.
    right: Vector,
    /// Acceleration in the last step, m/s².
    acceleration: Vector,
    /// Angular acceleration in the last step, rad/s².
    spin_up: f64,
    /// Sum of forces, N.
    force: Vector,
    /// Sum of torques, N·m.
    torque: f64,
}

impl RigidBody {
    /// Returns a body at rest, with its centre at y = 0 if it has no position of its own.
    pub(super) fn new(object: &Object) -> Self {
        let mass = object.mass;
        let (outline, reach, inertia) = match object.shape {
            Shape::Disc { radius } => {
                let radius = radius / 1000.0;
                (Outline::Disc(radius), radius, mass * radius * radius / 2.0)
            }
            Shape::Box { width, height } => {
                let half = Vector::new(width, height) / 2000.0;
                let inertia = mass * half.norm_squared() / 3.0;
                (Outline::Box(half), half.norm(), inertia)
            }
        };
        let mut body = RigidBody {
            outline,
            reach,
            mass,
            inertia,
            friction: object.friction,
            law: ContactLaw::of_body(mass),
            law_with_fingers: ContactLaw::of_body(mass.min(HEAVY)),
            centre: Vector::new(object.x, object.y.unwrap_or(0.0)) / 1000.0,
            angle: object.angle.to_radians(),
            velocity: Vector::zeros(),
            spin: 0.0,
            middle: Vector::zeros(),
            middle_spin: 0.0,
            right: Vector::x(),
            acceleration: Vector::zeros(),
            spin_up: 0.0,
            force: Vector::zeros(),
            torque: 0.0,
        };
        body.align();
        body
    }

    /// Moves at the velocity for `time` s, to the end of a cycle, where the orientation is that of
    /// the angle to the last bit.
    pub(super) fn arrive(&mut self, time: f64) {
        self.centre += self.velocity * time;
        self.angle += self.spin * time;
        self.align();
    }

    /// Sets the orientation to that of the angle.
    fn align(&mut self) {
        let (sin, cos) = libm::sincos(self.angle);
        self.right = Vector::new(cos, sin);
    }

    /// Moves at the velocity for `time` s, to the middle of a step of `dt` s, and resets the forces
    /// to its weight.
    pub(super) fn drift(&mut self, time: f64, dt: f64) {
        self.centre += self.velocity * time;
        self.angle += self.spin * time;
        self.right = rotated(self.right, self.spin * time);
        self.middle = self.velocity + self.acceleration * (dt / 2.0);
        self.middle_spin = self.spin + self.spin_up * (dt / 2.0);
        self.force = Vector::new(0.0, -GRAVITY * self.mass);
        self.torque = 0.0;
    }

    /// Applies a force (N) at a point (m).
    #[inline]
    pub(super) fn push(&mut self, point: Vector, force: Vector) {
        self.force += force;
        self.torque += (point - self.centre).perp(&force);
    }

    /// Integrates the forces from the start to the end of a step of `dt` s, in whose middle the
    /// body is.
    pub(super) fn kick(&mut self, dt: f64) {
        self.acceleration = self.force / self.mass;
        self.spin_up = self.torque / self.inertia;
        self.velocity += self.acceleration * dt;
        self.spin += self.spin_up * dt;
    }

    /// Returns the velocity of a point in the middle of the step, m/s.
    #[inline]
    pub(super) fn velocity_at(&self, point: Vector) -> Vector {
        self.middle + across(point - self.centre) * self.middle_spin
    }

    /// Returns the contact law with another body: that of the lighter one.
    pub(super) fn law_with(&self, other: &Self) -> ContactLaw {
        let lighter = if self.mass < other.mass { self } else { other };
        lighter.law
    }

    /// Returns the greatest frequency of oscillation on its contacts, rad/s.
    pub(super) fn frequency(&self) -> f64 {
        self.law.frequency(self.mass)
    }

    /// Returns the points of the outline that meet a plane in the `direction` (a unit vector).
    #[inline]
    pub(super) fn feelers(&self, direction: Vector) -> [Option<Vector>; 4] {
        match self.outline {
            Outline::Disc(radius) => [Some(self.centre + direction * radius), None, None, None],
            Outline::Box(_) => self.corners().map(Some),
        }
    }

    /// Returns the corners of a box in order, or the centre of a disc.
    #[inline]
    pub(super) fn corners(&self) -> [Vector; 4] {
        let half = match self.outline {
            Outline::Disc(_) => Vector::zeros(),
            Outline::Box(half) => half,
        };
        let (along, up) = (self.right * half.x, across(self.right) * half.y);
        [-along - up, along - up, along + up, up - along].map(|corner| self.centre + corner)
    }

    /// Returns true if the outline has corners.
    pub(super) const fn is_box(&self) -> bool {
        matches!(self.outline, Outline::Box(_))
    }

    /// Returns the shortest path out for a point: a unit vector and a distance, negative from
    /// outside.
    #[inline]
    pub(super) fn way_out(&self, point: Vector) -> (Vector, f64) {
        let from = point - self.centre;
        match self.outline {
            Outline::Disc(radius) => {
                let distance = from.norm();
                let out = if distance > 0.0 {
                    from / distance
                } else {
                    Vector::y()
                };
                (out, radius - distance)
            }
            Outline::Box(half) => {
                let up = across(self.right);
                let (x, y) = (from.dot(&self.right), from.dot(&up));
                let (beside, above) = (libm::fabs(x) - half.x, libm::fabs(y) - half.y);
                let (right, up) = (
                    self.right * libm::copysign(1.0, x),
                    up * libm::copysign(1.0, y),
                );
                if beside > 0.0 && above > 0.0 {
                    let corner = right * beside + up * above;
                    let distance = corner.norm();
                    (corner / distance, -distance)
                } else if beside > above {
                    (right, -beside)
                } else {
                    (up, -above)
                }
            }
        }
    }

    /// Returns the path out of a box for a point that came in through a face: a unit vector and a
    /// distance, not positive from outside. It is the shortest path, or the next one if that leads
    /// out of the opposite face. `face` becomes the one to leave by; from outside it becomes the
    /// nearest.
    #[inline]
    pub(super) fn way_back(&self, point: Vector, face: &mut Option<Face>) -> (Vector, f64) {
        let from = point - self.centre;
        let [wide, high] = self.axes();
        let (x, y) = (from.dot(&wide.0), from.dot(&high.0));
        let (beside, above) = (libm::fabs(x) - wide.1, libm::fabs(y) - high.1);
        let (side, end) = (
            Face::Side(libm::copysign(1.0, x)),
            Face::End(libm::copysign(1.0, y)),
        );
        let (nearest, next) = if beside > above {
            (side, end)
        } else {
            (end, side)
        };
        let depth = |face| match face {
            Face::Side(sign) => wide.1 - x * sign,
            Face::End(sign) => high.1 - y * sign,
        };
        let known = face.unwrap_or(nearest);
        let is_inside = beside < 0.0 && above < 0.0;
        let is_between = match known {
            Face::Side(_) => above < 0.0,
            Face::End(_) => beside < 0.0,
        };
        let way = match nearest == known.opposite() {
            true if is_inside && depth(next) < depth(known) => next,
            true if is_between => known,
            _ => nearest,
        };
        *face = Some(way);
        let out = match way {
            Face::Side(sign) => wide.0 * sign,
            Face::End(sign) => high.0 * sign,
        };
        (out, depth(way))
    }

    /// Returns the axes of a box and its half extents along them, m.
    fn axes(&self) -> [(Vector, f64); 2] {
        let half = match self.outline {
            Outline::Disc(radius) => Vector::new(radius, radius),
            Outline::Box(half) => half,
        };
        [(self.right, half.x), (across(self.right), half.y)]
    }

    /// Returns the distance that a point of a box has to go in a `direction` to leave it, m; not
    /// positive from outside.
    pub(super) fn depth_along(&self, point: Vector, direction: Vector) -> f64 {
        let from = point - self.centre;
        let mut depth = f64::INFINITY;
        for (axis, half) in self.axes() {
            let (at, speed) = (from.dot(&axis), direction.dot(&axis));
            if libm::fabs(at) > half {
                return 0.0;
            }
            if speed != 0.0 {
                let left = half - at * libm::copysign(1.0, speed);
                depth = depth.min(left / libm::fabs(speed));
            }
        }
        depth
    }

    /// Returns the direction, away from `other`, in which two boxes overlap least; `None` if some
    /// line separates them (Ericson, *Real-Time Collision Detection*, 2005, ch. 4.4: separating
    /// axes).
    pub(super) fn least_overlap(&self, other: &Self) -> Option<Vector> {
        let apart = self.centre - other.centre;
        let mut least = (f64::INFINITY, Vector::zeros());
        for (axis, _) in self.axes().into_iter().chain(other.axes()) {
            let extent = |body: &Self| {
                let shadow = |(own, half): (Vector, f64)| half * libm::fabs(own.dot(&axis));
                body.axes().into_iter().map(shadow).sum::<f64>()
            };
            let distance = apart.dot(&axis);
            let overlap = extent(self) + extent(other) - libm::fabs(distance);
            if overlap <= 0.0 {
                return None;
            }
            if overlap < least.0 {
                least = (overlap, axis * libm::copysign(1.0, distance));
            }
        }
        Some(least.1)
    }

    /// Returns where the line from `start` to `end` enters and leaves a box, as shares of its
    /// length; `None` if it misses (Liang and Barsky, ACM Trans. Graph. 3, 1984).
    pub(super) fn crossing(&self, start: Vector, end: Vector) -> Option<(f64, f64)> {
        if !self.is_box() {
            return None;
        }
        let (from, along) = (start - self.centre, end - start);
        let (mut enters, mut leaves) = (f64::NEG_INFINITY, f64::INFINITY);
        for (axis, half) in self.axes() {
            let (at, speed) = (from.dot(&axis), along.dot(&axis));
            if speed == 0.0 {
                if libm::fabs(at) >= half {
                    return None;
                }
                continue;
            }
            let (a, b) = ((-half - at) / speed, (half - at) / speed);
            enters = enters.max(a.min(b));
            leaves = leaves.min(a.max(b));
        }
        (enters < leaves).then_some((enters, leaves))
    }
}
