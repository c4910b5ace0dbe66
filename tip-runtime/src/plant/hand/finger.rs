//! A finger: a planar serial chain of rigid links (Craig, *Introduction to Robotics*, ch. 6).
//!
//! `(M(θ) + R) θ̈ + c(θ, θ̇) + b θ̇ = τ + Jᵀ F`, with the mass matrix M of uniform rods, the motors'
//! reflected inertia R, centrifugal and Coriolis terms c, viscous friction b, motors τ and contacts F.
//! The links have no weight: the fingers are counterbalanced.

use super::Vector;
use super::motor::Motor;
use crate::model::{Joint, Leg};
use crate::plant::Effort;

/// Inertia of each motor and its gear at the joint, kg·m².
const ROTOR: f64 = 1e-4;

/// The state of a link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Link {
    /// Mass, kg.
    mass: f64,
    /// +1 if a positive joint angle turns it from x to y.
    sense: f64,
    /// The link at angle 0, m.
    straight: Vector,
    /// Half of the length, m.
    pub(super) half: f64,
    /// Cosine and sine of its angle.
    direction: Vector,
    /// The vector from its joint to the next one, or to the fingertip, m.
    along: Vector,
    /// Position of its joint, m.
    pub(super) start: Vector,
    /// Position of the next joint or of the fingertip, m.
    pub(super) end: Vector,
    /// Velocity of its joint, m/s.
    velocity: Vector,
    /// Angular velocity, rad/s.
    turn: f64,
    /// Acceleration of its joint at constant rates, m/s².
    acceleration: Vector,
}

impl Link {
    fn new(joint: &Joint) -> Self {
        let ([x, y, _], [_, _, sense]) = (joint.link, joint.axis);
        let straight = Vector::new(x, y) / 1000.0;
        Link {
            mass: joint.mass,
            sense,
            straight,
            half: straight.norm() / 2.0,
            direction: Vector::x(),
            along: Vector::zeros(),
            start: Vector::zeros(),
            end: Vector::zeros(),
            velocity: Vector::zeros(),
            turn: 0.0,
            acceleration: Vector::zeros(),
        }
    }

    /// Returns the midpoint, m.
    #[inline]
    pub(super) fn middle(&self) -> Vector {
        self.start + self.along / 2.0
    }

    /// Returns the velocity of a point, m/s.
    #[inline]
    pub(super) fn velocity_at(&self, point: Vector) -> Vector {
        self.velocity + across(point - self.start) * self.turn
    }

    /// Returns the acceleration at constant rates of a point that is `away` from its joint, m/s².
    #[inline]
    fn acceleration_at(&self, away: Vector) -> Vector {
        self.acceleration - away * (self.turn * self.turn)
    }

    /// Returns the inertia of link and motor about its joint, kg·m².
    fn inertia(&self) -> f64 {
        self.mass * self.straight.norm_squared() / 3.0 + ROTOR
    }
}

/// The state of a finger.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Finger<const J: usize> {
    /// Place of the first joint, m.
    base: Vector,
    /// Joint angles, deg.
    pub(super) angles: [f64; J],
    /// Joint rates, rad/s.
    rates: [f64; J],
    /// Expected rates in the middle of the step, rad/s.
    middle: [f64; J],
    pub(super) motors: [Motor; J],
    links: [Link; J],
    /// Torques of contacts on the joints, N·m.
    loads: [f64; J],
}

impl<const J: usize> Finger<J> {
    /// Returns a finger at rest in its initial posture.
    pub(super) fn new(leg: &Leg<J>) -> Self {
        let [x, y, _] = leg.base;
        let mut finger = Finger {
            base: Vector::new(x, y) / 1000.0,
            angles: leg.initial,
            rates: [0.0; J],
            middle: [0.0; J],
            motors: [Motor::IDLE; J],
            links: leg.joints.each_ref().map(Link::new),
            loads: [0.0; J],
        };
        let motors = finger.motors.iter_mut().zip(&leg.joints);
        for ((motor, joint), angle) in motors.zip(leg.initial) {
            *motor = Motor::new(joint, angle);
        }
        finger.align();
        finger
    }

    /// Returns the least effective mass of a link's end while the other joints hold, kg.
    pub(super) fn lightest(&self) -> f64 {
        let masses = self
            .links
            .iter()
            .map(|link| link.inertia() / link.straight.norm_squared());
        masses.fold(f64::INFINITY, f64::min)
    }

    /// Returns the links from base to tip.
    pub(super) const fn links(&self) -> &[Link; J] {
        &self.links
    }

    /// Returns the fingertip, m.
    pub(super) fn tip(&self) -> Vector {
        self.links.last().map_or(self.base, |link| link.end)
    }

    /// Turns at its rates for `time` s, to the end of a cycle, where the links are at their angles
    /// to the last bit.
    pub(super) fn arrive(&mut self, time: f64) {
        for (angle, rate) in self.angles.iter_mut().zip(&self.rates) {
            *angle += (rate * time).to_degrees();
        }
        self.align();
    }

    /// Sets the directions of the links to their angles.
    fn align(&mut self) {
        let mut angle = 0.0;
        for (link, own) in self.links.iter_mut().zip(&self.angles) {
            angle += link.sense * own;
            let (sin, cos) = libm::sincos(angle.to_radians());
            link.direction = Vector::new(cos, sin);
        }
        self.place();
    }

    /// Turns at its rates for `time` s, to the middle of a step of `dt` s, and resets the loads.
    pub(super) fn drift(&mut self, time: f64, dt: f64) {
        let mut turned = 0.0;
        let joints = self.angles.iter_mut().zip(&self.rates).zip(&mut self.links);
        for ((angle, rate), link) in joints {
            *angle += (rate * time).to_degrees();
            turned += link.sense * rate * time;
            link.direction = rotated(link.direction, turned);
        }
        let motors = self.motors.iter().zip(&self.rates);
        for (middle, (motor, rate)) in self.middle.iter_mut().zip(motors) {
            *middle = rate + motor.carried * dt / 2.0;
        }
        self.place();
    }

    /// Updates the positions and velocities of the links, and resets the loads.
    fn place(&mut self) {
        self.loads = [0.0; J];
        let mut turn = 0.0;
        let (mut start, mut velocity, mut acceleration) =
            (self.base, Vector::zeros(), Vector::zeros());
        for (link, rate) in self.links.iter_mut().zip(&self.middle) {
            turn += link.sense * rate;
            let (straight, direction) = (link.straight, link.direction);
            link.along = Vector::new(
                direction.x * straight.x - direction.y * straight.y,
                direction.y * straight.x + direction.x * straight.y,
            );
            link.start = start;
            link.velocity = velocity;
            link.acceleration = acceleration;
            link.turn = turn;
            link.end = start + link.along;
            start = link.end;
            velocity += across(link.along) * turn;
            acceleration = link.acceleration_at(link.along);
        }
    }

    /// Applies a force (N) at a point (m) of link `m`, counted from 0.
    pub(super) fn push(&mut self, m: usize, point: Vector, force: Vector) {
        let joints = self.loads.iter_mut().zip(&self.links);
        for (load, link) in joints.take(m.saturating_add(1)) {
            *load += link.sense * (point - link.start).perp(&force);
        }
    }

    /// Integrates the loads from the start to the end of a step of `dt` s, in whose middle the
    /// finger is.
    pub(super) fn kick(&mut self, dt: f64) {
        for motor in &mut self.motors {
            motor.advance(dt);
        }
        let accelerations = self.accelerations(dt);
        for (rate, acceleration) in self.rates.iter_mut().zip(&accelerations) {
            *rate += acceleration * dt;
        }
    }

    /// Returns the accelerations of the joints (rad/s²) over the next `dt` s. A motor that would
    /// exceed its greatest torque gives that.
    fn accelerations(&mut self, dt: f64) -> [f64; J] {
        let (mass, inertial) = self.dynamics();
        let mut accelerations = [0.0; J];
        // Every turn but the last finds another motor at its limit.
        for _ in 0..=J {
            let mut matrix = mass;
            let mut torques = self.loads;
            let mut efforts = [Effort::default(); J];
            let motors = self.motors.iter().zip(self.angles.iter().zip(&self.rates));
            let rows = matrix.iter_mut().zip(&mut torques).zip(&inertial);
            let joints = motors.zip(rows).zip(&mut efforts).enumerate();
            for (m, (((motor, (angle, rate)), ((row, torque), inertial)), own)) in joints {
                *own = motor.effort(*angle, *rate, dt);
                let [friction, stop] = motor.resistance(*angle, *rate, dt);
                let all = own.plus(friction).plus(stop);
                *torque += all.torque - inertial;
                if let Some(entry) = row.get_mut(m) {
                    *entry += ROTOR + all.inertia;
                }
            }
            accelerations = solved(matrix, torques);
            let mut yields = false;
            let joints = efforts.into_iter().zip(&accelerations);
            for (motor, (own, acceleration)) in self.motors.iter_mut().zip(joints) {
                yields |= motor.settle(own, *acceleration);
            }
            if !yields {
                break;
            }
        }
        accelerations
    }

    /// Returns the lower triangle of the mass matrix (kg·m²), which is all that is read, and the
    /// bias torques (N·m): calculated from the tip inwards, with all links beyond a joint as one
    /// body.
    fn dynamics(&self) -> ([[f64; J]; J], [f64; J]) {
        let mut matrix = [[0.0; J]; J];
        let mut inertial = [0.0; J];
        let (mut mass, mut moment, mut inertia) = (0.0, Vector::zeros(), 0.0);
        let (mut force, mut torque) = (Vector::zeros(), 0.0);
        let rows = matrix.iter_mut().zip(&mut inertial).zip(&self.links);
        for (m, ((row, bias), link)) in rows.enumerate().rev() {
            let (along, half) = (link.along, link.along / 2.0);
            let square = along.norm_squared();
            inertia += 2.0 * moment.dot(&along) + (mass + link.mass / 3.0) * square;
            moment += along * mass + half * link.mass;
            mass += link.mass;
            let own = link.acceleration_at(half) * link.mass;
            torque += along.perp(&force) + half.perp(&own);
            force += own;
            *bias = link.sense * torque;
            for (entry, joint) in row.iter_mut().zip(&self.links).take(m + 1) {
                let arm = link.start - joint.start;
                *entry = link.sense * joint.sense * (inertia + moment.dot(&arm));
            }
        }
        (matrix, inertial)
    }
}

/// Returns a vector turned by a quarter turn from x to y.
#[inline]
pub(super) fn across(vector: Vector) -> Vector {
    Vector::new(-vector.y, vector.x)
}

/// Returns a unit vector rotated by an angle (rad). For small angles, which are all except those of
/// very fast joints, the series is exact to the last bits.
pub(super) fn rotated(direction: Vector, angle: f64) -> Vector {
    let square = angle * angle;
    let (sin, cos) = if square < 0.01 {
        let sin = |x: f64| x * (-1.0 / 6.0 + x * (1.0 / 120.0 + x * (-1.0 / 5040.0)));
        let cos =
            |x: f64| x * (-1.0 / 2.0 + x * (1.0 / 24.0 + x * (-1.0 / 720.0 + x * (1.0 / 40320.0))));
        (angle + angle * sin(square), 1.0 + cos(square))
    } else {
        libm::sincos(angle)
    };
    direction * cos + across(direction) * sin
}

/// Solves a symmetric, positive definite system, of which only the lower triangle is read: by
/// elimination without roots, with one division for each row (Golub and Van Loan, *Matrix
/// Computations*, ch. 4.1).
fn solved<const J: usize>(mut rows: [[f64; J]; J], mut right: [f64; J]) -> [f64; J] {
    let mut inverses = [0.0; J];
    for (k, inverse) in inverses.iter_mut().enumerate() {
        let mut column = [0.0; J];
        for (entry, row) in column.iter_mut().zip(&rows) {
            *entry = row.get(k).copied().unwrap_or_default();
        }
        let (pivot, above) = at(&column, &right, k);
        *inverse = 1.0 / pivot;
        let below = rows.iter_mut().zip(&mut right).enumerate().skip(k + 1);
        for (i, (row, right)) in below {
            let Some(factor) = row.get_mut(k) else {
                continue;
            };
            *factor *= *inverse;
            let factor = *factor;
            *right -= factor * above;
            for (entry, column) in row.iter_mut().zip(&column).take(i + 1).skip(k + 1) {
                *entry -= factor * column;
            }
        }
    }
    for (right, inverse) in right.iter_mut().zip(&inverses) {
        *right *= inverse;
    }
    for (i, row) in rows.iter().enumerate().rev() {
        let (above, below) = right.split_at_mut(i);
        let Some(known) = below.first() else {
            continue;
        };
        for (right, factor) in above.iter_mut().zip(row) {
            *right -= factor * known;
        }
    }
    right
}

/// Returns entry `k` of both.
fn at<const J: usize>(one: &[f64; J], other: &[f64; J], k: usize) -> (f64, f64) {
    let entry = |all: &[f64; J]| all.get(k).copied().unwrap_or_default();
    (entry(one), entry(other))
}
