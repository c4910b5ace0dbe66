//! Where the links are, how they move, and what they weigh.

use super::Vector;
use super::frame::Frame;
use super::servo::Servo;
use super::spatial::{Inertia, Spatial, placed, spread};
use super::world::{GRAVITY, Share};
use crate::model::{Joint, Leg};
use nalgebra::{Rotation3, Unit};

/// A link from its joint to the next one, at angle 0: m.
#[inline]
pub(super) fn length(joint: &Joint) -> Vector {
    Vector::from(joint.link) / 1000.0
}

/// Goes along a leg from its base to its foot. Places are from the body's origin.
pub(super) struct Walk {
    /// The joint, or the end of the link: m.
    at: Vector,
    /// m/s.
    velocity: Vector,
    /// If no rate changed: m/s².
    acceleration: Vector,
    rotation: Rotation3<f64>,
    /// rad/s.
    rate: Vector,
    /// If no rate changed: rad/s².
    turning: Vector,
    /// What everything falls by: m/s².
    gravity: Vector,
}

impl Walk {
    pub(super) fn from<const J: usize>(frame: &Frame, leg: &Leg<J>) -> Self {
        let mut walk = Walk {
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

    /// Goes to another point of the same rigid body.
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

    /// Turns with the joint: its axis, and where it is.
    #[inline]
    pub(super) fn turn(&mut self, joint: &Joint, servo: &Servo) -> (Vector, Vector) {
        let own = Unit::new_unchecked(Vector::from(joint.axis));
        let axis = self.rotation * own.into_inner();
        self.turning += self.rate.cross(&axis) * servo.rate;
        self.rate += axis * servo.rate;
        self.rotation *= Rotation3::from_axis_angle(&own, servo.angle);
        (axis, self.at)
    }

    /// The link after the joint, a uniform rod unless the model says how its mass is spread.
    #[inline]
    pub(super) fn link(&self, joint: &Joint) -> Share {
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
        Share {
            inertia: Inertia::new(joint.mass, centre, own),
            force: Spatial {
                angular: moment + centre.cross(&force),
                linear: force,
            },
        }
    }

    /// The link whose end has been reached, in the world: m.
    #[inline]
    pub(super) fn rod(&self, joint: &Joint, frame: &Frame) -> [Vector; 2] {
        let end = frame.position + self.at;
        [end - self.rotation * length(joint), end]
    }

    /// How fast a place of that link moves: m/s.
    #[inline]
    pub(super) fn velocity(&self, at: Vector) -> Vector {
        self.velocity + self.rate.cross(&(at - self.at))
    }

    /// Goes to the link's end: where it is, and how fast it moves.
    #[inline]
    pub(super) fn end(&mut self, joint: &Joint) -> (Vector, Vector) {
        self.step(self.rotation * length(joint));
        (self.at, self.velocity)
    }
}
