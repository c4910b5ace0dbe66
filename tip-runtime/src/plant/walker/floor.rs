//! The floor as a walking robot meets it.

use super::Vector;
use super::body::{Body, Pose, turn};
use crate::model::Point;
use crate::scene::Floor;
use nalgebra::Rotation3;

impl Floor {
    /// Turns the floor's frame (z along its normal) into the world's.
    fn tilt(&self) -> Rotation3<f64> {
        let [x, y] = self.slope;
        let normal = Vector::new(-x, -y, 1.0);
        turn(Vector::z(), normal / normal.norm())
    }

    /// The direction of gravity in the floor's frame.
    pub(super) fn gravity(&self) -> Vector {
        self.tilt().inverse() * -Vector::z()
    }

    /// A point of the floor's frame, in the world.
    pub(super) fn point(&self, point: Vector) -> Point {
        let point = self.tilt() * point;
        [point.x, point.y, point.z + self.height]
    }

    /// A body of the floor's frame, in the world.
    pub(super) fn pose(&self, body: &Body) -> Pose {
        Pose::new(self.position(body), &(self.tilt() * body.rotation()))
    }

    /// A point of a body that is in the floor's frame, in the world.
    pub(super) fn outer(&self, body: &Body, point: Vector) -> Vector {
        self.point(body.point(point)).into()
    }

    /// A point of the world, in the frame of a body that is in the floor's.
    pub(super) fn inner(&self, body: &Body, point: Vector) -> Vector {
        let turned = self.tilt() * body.rotation();
        turned.inverse() * (point - Vector::from(self.position(body)))
    }

    /// Where the origin of a body of the floor's frame is, in the world.
    pub(super) fn position(&self, body: &Body) -> Point {
        self.point(body.point(Vector::zeros()))
    }
}
