//! The floor: a plane.

use super::Point;
use super::body::{Body, Pose, turn};
use nalgebra::Rotation3;

/// A plane on which the robot stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Floor {
    /// Above the world's origin: mm.
    pub height: f64,
    /// Rise for each mm along x and along y.
    pub slope: [f64; 2],
}

impl Floor {
    /// Level, at height 0.
    pub const LEVEL: Self = Floor {
        height: 0.0,
        slope: [0.0, 0.0],
    };

    /// Turns the floor's frame (z along its normal) into the world's.
    fn tilt(&self) -> Rotation3<f64> {
        let [x, y] = self.slope;
        let normal = Point::new(-x, -y, 1.0);
        turn(Point::z(), normal / normal.norm())
    }

    /// The direction of gravity in the floor's frame.
    pub(super) fn gravity(&self) -> Point {
        self.tilt().inverse() * -Point::z()
    }

    /// A point of the floor's frame, in the world.
    pub(super) fn point(&self, point: Point) -> [f64; 3] {
        let point = self.tilt() * point;
        [point.x, point.y, point.z + self.height]
    }

    /// A body of the floor's frame, in the world.
    pub(super) fn pose(&self, body: &Body) -> Pose {
        let position = self.point(body.point(Point::zeros()));
        Pose::new(position, &(self.tilt() * body.rotation()))
    }
}
