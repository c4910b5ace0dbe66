//! The floor of a walking robot without mass: transformations between the frames of floor, body and
//! world.

use super::Vector;
use super::body::{Body, Pose, turn};
use crate::model::Point;
use crate::scene::Floor;
use nalgebra::Rotation3;

impl Floor {
    /// Returns the rotation from the floor's frame (z along its normal) to the world's.
    fn tilt(&self) -> Rotation3<f64> {
        let [x, y] = self.slope;
        let normal = Vector::new(-x, -y, 1.0);
        turn(Vector::z(), normal / normal.norm())
    }

    /// Returns the direction of gravity in the floor's frame.
    pub(super) fn gravity(&self) -> Vector {
        self.tilt().inverse() * -Vector::z()
    }

    /// Transforms a point of the floor's frame into the world.
    pub(super) fn point(&self, point: Vector) -> Point {
        let point = self.tilt() * point;
        [point.x, point.y, point.z + self.height]
    }

    /// Returns the pose of a body in the world.
    pub(super) fn pose(&self, body: &Body) -> Pose {
        Pose::new(self.position(body), &(self.tilt() * body.rotation()))
    }

    /// Transforms a point of a body into the world.
    pub(super) fn outer(&self, body: &Body, point: Vector) -> Vector {
        self.point(body.point(point)).into()
    }

    /// Transforms a point of the world into the frame of a body.
    pub(super) fn inner(&self, body: &Body, point: Vector) -> Vector {
        let turned = self.tilt() * body.rotation();
        turned.inverse() * (point - Vector::from(self.position(body)))
    }

    /// Returns the position of a body's origin in the world.
    pub(super) fn position(&self, body: &Body) -> Point {
        self.point(body.point(Vector::zeros()))
    }
}
