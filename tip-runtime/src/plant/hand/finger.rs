//! A finger: a planar serial chain of rigid links (Craig, *Introduction to Robotics*, ch. 6).
//!
//! `(M(θ) + R) θ̈ + c(θ, θ̇) + b θ̇ = τ + Jᵀ F`, with the mass matrix M of uniform rods, the motors'
//! reflected inertia R, centrifugal and Coriolis terms c, viscous friction b, motors τ and contacts F.
//! The links have no weight: the fingers are counterbalanced.

use super::Vector;
use super::motor::{Effort, Motor};
use crate::model::{Joint, Leg};
use nalgebra::{SMatrix, SVector, Vector3};

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
        Link {
            mass: joint.mass,
            sense,
            straight: Vector::new(x, y) / 1000.0,
            start: Vector::zeros(),
            end: Vector::zeros(),
            velocity: Vector::zeros(),
            turn: 0.0,
            acceleration: Vector::zeros(),
        }
    }

    /// How fast a point of it moves: m/s.
    #[inline]
    pub(super) fn velocity_at(&self, point: Vector) -> Vector {
        self.velocity + across(point - self.start) * self.turn
    }

    /// What a point of it would accelerate by if no joint's rate changed: m/s².
    #[inline]
    fn acceleration_at(&self, point: Vector) -> Vector {
        self.acceleration - (point - self.start) * (self.turn * self.turn)
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
            motors: [Motor::IDLE; J],
            links: leg.joints.each_ref().map(Link::new),
            loads: [0.0; J],
        };
        let motors = finger.motors.iter_mut().zip(&leg.joints);
        for ((motor, joint), angle) in motors.zip(leg.initial) {
            *motor = Motor::new(joint, angle);
        }
        finger.place();
        finger
    }

    /// Its links from base to tip.
    pub(super) const fn links(&self) -> &[Link; J] {
        &self.links
    }

    /// The fingertip: m.
    pub(super) fn tip(&self) -> Vector {
        self.links.last().map_or(self.base, |link| link.end)
    }

    /// Finds out where every link is; nothing pushes any more.
    fn place(&mut self) {
        self.loads = [0.0; J];
        let (mut angle, mut turn) = (0.0, 0.0);
        let (mut start, mut velocity, mut acceleration) =
            (self.base, Vector::zeros(), Vector::zeros());
        let joints = self.angles.iter().zip(&self.rates);
        for (link, (own_angle, own_rate)) in self.links.iter_mut().zip(joints) {
            angle += link.sense * own_angle;
            turn += link.sense * own_rate;
            let (sin, cos) = libm::sincos(angle.to_radians());
            let straight = link.straight;
            link.start = start;
            link.velocity = velocity;
            link.acceleration = acceleration;
            link.turn = turn;
            link.end = start
                + Vector::new(
                    cos * straight.x - sin * straight.y,
                    sin * straight.x + cos * straight.y,
                );
            start = link.end;
            velocity = link.velocity_at(link.end);
            acceleration = link.acceleration_at(link.end);
        }
    }

    /// A force (N) acts at a point (m) of link `m`, counted from 0.
    pub(super) fn push(&mut self, m: usize, point: Vector, force: Vector) {
        let joints = self.loads.iter_mut().zip(&self.links);
        for (load, link) in joints.take(m.saturating_add(1)) {
            *load += link.sense * (point - link.start).perp(&force);
        }
    }

    /// Moves on by `dt` s; then nothing pushes any more.
    pub(super) fn advance(&mut self, dt: f64) {
        for motor in &mut self.motors {
            motor.advance(dt);
        }
        let accelerations = self.accelerations(dt);
        let joints = self.angles.iter_mut().zip(&mut self.rates);
        for ((angle, rate), acceleration) in joints.zip(&accelerations) {
            *rate += acceleration * dt;
            *angle += (*rate * dt).to_degrees();
        }
        self.place();
    }

    /// What the joints accelerate by (rad/s²) over the next `dt` s. A motor that would have to give
    /// more than it can gives what it can.
    fn accelerations(&mut self, dt: f64) -> SVector<f64, J> {
        let (mass, inertial) = self.dynamics();
        let mut accelerations = SVector::<f64, J>::zeros();
        // Every turn but the last finds another motor at its limit.
        for _ in 0..=J {
            let mut matrix = mass;
            let mut torques = -inertial;
            let mut efforts = [Effort::default(); J];
            let joints = self.motors.iter().zip(&self.angles).zip(&self.rates);
            for (m, (((motor, angle), rate), own)) in joints.zip(&mut efforts).enumerate() {
                *own = motor.effort(*angle, *rate, dt);
                let [friction, stop] = motor.resistance(*angle, *rate, dt);
                let Effort { torque, inertia } = own.plus(friction).plus(stop);
                add(matrix.get_mut((m, m)), ROTOR + inertia);
                add(torques.get_mut(m), torque);
            }
            for (torque, load) in torques.iter_mut().zip(self.loads) {
                *torque += load;
            }
            accelerations = matrix
                .cholesky()
                .map_or_else(SVector::zeros, |matrix| matrix.solve(&torques));
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

    /// The lower triangle of the mass matrix (kg·m²), which is all that Cholesky's method reads, and
    /// what keeps the joints turning at their rates (N·m).
    fn dynamics(&self) -> (SMatrix<f64, J, J>, SVector<f64, J>) {
        let mut mass = SMatrix::<f64, J, J>::zeros();
        let mut inertial = SVector::<f64, J>::zeros();
        for (m, link) in self.links.iter().enumerate() {
            let centre = (link.start + link.end) / 2.0;
            let length = link.straight.norm_squared();
            // Turn and velocity of this link for each joint's rate.
            let mut moves = [Vector3::zeros(); J];
            for (moves, joint) in moves.iter_mut().zip(&self.links).take(m + 1) {
                let velocity = across(centre - joint.start) * joint.sense;
                *moves = Vector3::new(joint.sense, velocity.x, velocity.y);
            }
            let own = Vector3::new(link.mass * length / 12.0, link.mass, link.mass);
            let acceleration = link.acceleration_at(centre);
            let acceleration = Vector3::new(0.0, acceleration.x, acceleration.y);
            for (row, moved) in moves.iter().enumerate().take(m + 1) {
                let weighted = moved.component_mul(&own);
                add(inertial.get_mut(row), weighted.dot(&acceleration));
                for (column, moved) in moves.iter().enumerate().take(row + 1) {
                    add(mass.get_mut((row, column)), weighted.dot(moved));
                }
            }
        }
        (mass, inertial)
    }
}

/// A quarter turn from x to y.
#[inline]
pub(super) fn across(vector: Vector) -> Vector {
    Vector::new(-vector.y, vector.x)
}

#[inline]
fn add(entry: Option<&mut f64>, value: f64) {
    if let Some(entry) = entry {
        *entry += value;
    }
}
