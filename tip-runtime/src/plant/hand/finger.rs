//! A finger: a planar serial chain of rigid links (Craig, *Introduction to Robotics*, ch. 6).
//!
//! `(M(θ) + R) θ̈ + c(θ, θ̇) + b θ̇ = τ + Jᵀ F`, with the mass matrix M of uniform rods, the motors'
//! reflected inertia R, centrifugal and Coriolis terms c, viscous friction b, motors τ and contacts F.
//! The links have no weight: the fingers are counterbalanced.

use super::Vector;
use super::motor::Motor;
use crate::model::{Joint, Leg};
use crate::plant::Effort;

/// Of each motor and its gear, as the joint feels it: kg·m².
const ROTOR: f64 = 1e-4;

/// One link where it is now, and how it moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Link {
    /// Its mass: kg.
    mass: f64,
    /// +1 if a positive joint angle turns it from x to y.
    sense: f64,
    /// At angle 0: m.
    straight: Vector,
    /// From its middle to its ends: m.
    pub(super) half: f64,
    /// How far it is turned from there: its cosine and sine.
    direction: Vector,
    /// From its joint to the next one, or to the fingertip: m.
    along: Vector,
    /// Where its joint is: m.
    pub(super) start: Vector,
    /// Where the next joint is, or the fingertip: m.
    pub(super) end: Vector,
    /// Of its joint: m/s.
    velocity: Vector,
    /// Its own turn: rad/s.
    turn: f64,
    /// Of its joint if no joint's rate changed: m/s².
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

    /// Its middle: m.
    #[inline]
    pub(super) fn middle(&self) -> Vector {
        self.start + self.along / 2.0
    }

    /// How fast a point of it moves: m/s.
    #[inline]
    pub(super) fn velocity_at(&self, point: Vector) -> Vector {
        self.velocity + across(point - self.start) * self.turn
    }

    /// What a point that is `away` from its joint would accelerate by if no joint's rate changed: m/s².
    #[inline]
    fn acceleration_at(&self, away: Vector) -> Vector {
        self.acceleration - away * (self.turn * self.turn)
    }

    /// Of itself and its motor about its joint: kg·m².
    fn inertia(&self) -> f64 {
        self.mass * self.straight.norm_squared() / 3.0 + ROTOR
    }
}

/// A finger in motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Finger<const J: usize> {
    /// m.
    base: Vector,
    /// deg.
    pub(super) angles: [f64; J],
    /// rad/s.
    rates: [f64; J],
    /// In the middle of the step, as the one before it lets expect: rad/s.
    middle: [f64; J],
    pub(super) motors: [Motor; J],
    links: [Link; J],
    /// What contacts exert on the joints: N·m.
    loads: [f64; J],
}

impl<const J: usize> Finger<J> {
    /// At rest in its initial posture.
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

    /// The least mass with which a link meets what it touches with its end, while the other joints
    /// hold: kg.
    pub(super) fn lightest(&self) -> f64 {
        let masses = self
            .links
            .iter()
            .map(|link| link.inertia() / link.straight.norm_squared());
        masses.fold(f64::INFINITY, f64::min)
    }

    /// Its links from base to tip.
    pub(super) const fn links(&self) -> &[Link; J] {
        &self.links
    }

    /// The fingertip: m.
    pub(super) fn tip(&self) -> Vector {
        self.links.last().map_or(self.base, |link| link.end)
    }

    /// Turns on at its rates for `time` s, to the end of a cycle, where its links are as its angles say, to
    /// the last bit.
    pub(super) fn arrive(&mut self, time: f64) {
        for (angle, rate) in self.angles.iter_mut().zip(&self.rates) {
            *angle += (rate * time).to_degrees();
        }
        self.align();
    }

    /// Its links are where its angles say.
    fn align(&mut self) {
        let mut angle = 0.0;
        for (link, own) in self.links.iter_mut().zip(&self.angles) {
            angle += link.sense * own;
            let (sin, cos) = libm::sincos(angle.to_radians());
            link.direction = Vector::new(cos, sin);
        }
        self.place();
    }

    /// Turns on at its rates for `time` s, to the middle of a step of `dt` s; nothing pushes there yet.
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
            *middle = rate + motor.carried() * dt / 2.0;
        }
        self.place();
    }

    /// Finds out where every link is and how it moves; nothing pushes any more.
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

    /// A force (N) acts at a point (m) of link `m`, counted from 0.
    pub(super) fn push(&mut self, m: usize, point: Vector, force: Vector) {
        let joints = self.loads.iter_mut().zip(&self.links);
        for (load, link) in joints.take(m.saturating_add(1)) {
            *load += link.sense * (point - link.start).perp(&force);
        }
    }

    /// Takes the rates from the start to the end of a step of `dt` s, in whose middle it is.
    pub(super) fn kick(&mut self, dt: f64) {
        for motor in &mut self.motors {
            motor.advance(dt);
        }
        let accelerations = self.accelerations(dt);
        for (rate, acceleration) in self.rates.iter_mut().zip(&accelerations) {
            *rate += acceleration * dt;
        }
    }

    /// What the joints accelerate by (rad/s²) over the next `dt` s. A motor that would have to give
    /// more than it can gives what it can.
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

    /// The lower triangle of the mass matrix (kg·m²), which is all that is read, and what keeps the joints
    /// turning at their rates (N·m): from the tip inwards, with all that is beyond a joint as one body.
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

/// A quarter turn from x to y.
#[inline]
pub(super) fn across(vector: Vector) -> Vector {
    Vector::new(-vector.y, vector.x)
}

/// A unit vector turned by an angle (rad). Of small ones, which are all but those of frantic joints,
/// the series is exact to the last bits.
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

/// What a symmetric, positive definite matrix, of which only the lower triangle is read, turns into
/// `right`: by elimination without roots, with one division for each row (Golub and Van Loan, *Matrix
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

/// Entry `k` of both.
fn at<const J: usize>(one: &[f64; J], other: &[f64; J], k: usize) -> (f64, f64) {
    let entry = |all: &[f64; J]| all.get(k).copied().unwrap_or_default();
    (entry(one), entry(other))
}
