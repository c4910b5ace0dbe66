//! Kinematics and inertia of a leg's links, from base to foot.

use super::Vector;
use super::servo::Servo;
use super::spatial::{Contribution, Inertia, MovingFrame, Spatial, placed, spread};
use super::terrain::GRAVITY;
use crate::model::{Joint, Leg};
use nalgebra::{Rotation3, Unit};

/// Returns a link from its joint to the next one, at angle 0, m.
#[inline]
pub(super) fn length(joint: &Joint) -> Vector {
    Vector::from(joint.link) / 1000.0
}

/// A walk along a leg from its base to its foot. Positions are from the body's origin.
pub(super) struct LinkWalk {
    /// Position of the joint or of the link's end, m.
    at: Vector,
    /// m/s.
    velocity: Vector,
    /// Acceleration at constant rates, m/s².
    acceleration: Vector,
    rotation: Rotation3<f64>,
    /// rad/s.
    rate: Vector,
    /// Angular acceleration at constant rates, rad/s².
    turning: Vector,
    /// Acceleration of gravity, m/s².
    gravity: Vector,
}

impl LinkWalk {
    pub(super) fn from<const J: usize>(frame: &MovingFrame, leg: &Leg<J>) -> Self {
        let mut walk = LinkWalk {
            at: Vector::zeros(),
            velocity: frame.velocity,
            acceleration: Vector::zeros(),
            rotation: frame.rotation,
            rate: frame.rate,
            turning: Vector::zeros(),
            gravity: Vector::new(0.0, 0.0, -GRAVITY),
        };
        walk.step(frame.rotation * (Vector::from(leg.base) / 1000.0));
        walk
    }

    /// Moves to another point of the same rigid body.
    #[inline]
    fn step(&mut self, by: Vector) {
        self.acceleration = self.acceleration_at(by);
        self.velocity += self.rate.cross(&by);
        self.at += by;
    }

    #[inline]
    fn acceleration_at(&self, by: Vector) -> Vector {
        self.acceleration + self.turning.cross(&by) + self.rate.cross(&self.rate.cross(&by))
    }

    /// Turns with the joint; returns its axis and position.
    #[inline]
    pub(super) fn turn(&mut self, joint: &Joint, servo: &Servo) -> (Vector, Vector) {
        let own = Unit::new_unchecked(Vector::from(joint.axis));
        let axis = self.rotation * own.into_inner();
        self.turning += self.rate.cross(&axis) * servo.rate;
        self.rate += axis * servo.rate;
        self.rotation *= Rotation3::from_axis_angle(&own, servo.angle);
        (axis, self.at)
    }

    /// Returns the contribution of the link after the joint: a uniform rod unless the model gives
    /// its inertia.
    #[inline]
    pub(super) fn link(&self, joint: &Joint) -> Contribution {
        let (arm, own) = match &joint.spread {
            None => {
                let link = self.rotation * length(joint);
                (link / 2.0, spread(link) * (joint.mass / 12.0))
            }
            Some(spread) => placed(spread, self.rotation),
        };
        let centre = self.at + arm;
        let force = (self.acceleration_at(arm) - self.gravity) * joint.mass;
        let moment = own * self.turning + self.rate.cross(&(own * self.rate));
        Contribution {
            inertia: Inertia::new(joint.mass, centre, own),
            force: Spatial {
                angular: moment + centre.cross(&force),
                linear: force,
            },
        }
    }

    /// Returns the link whose end has been reached, in the world, m.
    #[inline]
    pub(super) fn rod(&self, joint: &Joint, frame: &MovingFrame) -> [Vector; 2] {
        let end = frame.position + self.at;
        [end - self.rotation * length(joint), end]
    }

    /// Returns the velocity of a point of that link, m/s.
    #[inline]
    pub(super) fn velocity(&self, at: Vector) -> Vector {
        self.velocity + self.rate.cross(&(at - self.at))
    }

    /// Moves to the link's end; returns its position and velocity.
    #[inline]
    pub(super) fn end(&mut self, joint: &Joint) -> (Vector, Vector) {
        self.step(self.rotation * length(joint));
        (self.at, self.velocity)
    }
}
