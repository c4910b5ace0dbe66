//! The pose of the body, in the world and in the floor's frame.

use super::Vector;
use crate::model::{self, Point};
use nalgebra::{Matrix3, Rotation3, Unit};

/// Position and attitude of the robot frame in the world: mm and deg.
///
/// The attitude turns by yaw about z first, then by pitch about x (to the right: + raises the
/// front), then by roll about y (forward: + lowers the right side).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// The origin of the robot frame in the world: x to the right at the start, y forward at the start, z up.
    pub position: Point,
    /// Angle about the body's y axis.
    pub roll: f64,
    /// Angle about the body's x axis.
    pub pitch: f64,
    /// Angle about the world's z axis.
    pub yaw: f64,
}

impl Pose {
    pub(in crate::plant) fn new(position: Point, rotation: &Rotation3<f64>) -> Self {
        let (right, forward, up) = (
            rotation * Vector::x(),
            rotation * Vector::y(),
            rotation * Vector::z(),
        );
        Pose {
            position,
            roll: libm::atan2(-right.z, up.z).to_degrees(),
            pitch: libm::asin(forward.z.clamp(-1.0, 1.0)).to_degrees(),
            yaw: libm::atan2(-forward.x, forward.y).to_degrees(),
        }
    }
}

/// The pose of the body in the floor's frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct FloorPose {
    /// The floor's normal in the robot frame.
    pub(super) normal: Vector,
    /// Height of the origin above the floor, mm.
    pub(super) height: f64,
    /// Position of the origin along the floor, mm.
    pub(super) x: f64,
    pub(super) y: f64,
    /// Turn about the floor's normal, after the tilt: rad.
    pub(super) heading: f64,
}

impl FloorPose {
    /// Returns a level body over the floor's origin: with its belly on the floor, or bolted down
    /// there.
    pub(super) fn standing(body: Option<&model::Body>) -> Self {
        FloorPose {
            normal: Vector::z(),
            height: body.map_or(0.0, |body| -body.z.min),
            x: 0.0,
            y: 0.0,
            heading: 0.0,
        }
    }

    /// Sets tilt and height of the body, keeping place and heading.
    pub(super) fn rest(&mut self, normal: Vector, height: f64) {
        self.normal = normal;
        self.height = height;
    }

    /// Returns the shortest rotation that turns the floor's normal upright.
    pub(super) fn levelling(normal: Vector) -> Rotation3<f64> {
        turn(normal, Vector::z())
    }

    /// Returns the rotation from the robot frame to the floor's.
    pub(super) fn rotation(&self) -> Rotation3<f64> {
        self.headed(&Self::levelling(self.normal))
    }

    /// Returns [`rotation`](Self::rotation) for a given rotation that levels the body.
    pub(super) fn headed(&self, levelling: &Rotation3<f64>) -> Rotation3<f64> {
        let up = Unit::new_unchecked(Vector::z());
        Rotation3::from_axis_angle(&up, self.heading) * levelling
    }

    /// Transforms a point of the robot frame into the floor's.
    pub(super) fn point(&self, point: Vector) -> Vector {
        self.rotation() * point + Vector::new(self.x, self.y, self.height)
    }
}

/// Returns the shortest rotation from one unit vector to another that does not point the other way
/// (Rodrigues' formula without an angle, which would lose small ones).
pub(super) fn turn(from: Vector, to: Vector) -> Rotation3<f64> {
    let cross = from.cross(&to).cross_matrix();
    let matrix = Matrix3::identity() + cross + cross * cross / (1.0 + from.dot(&to));
    Rotation3::from_matrix_unchecked(matrix)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_shortest_turn_keeps_lengths_and_the_smallest_angles() {
        for lean in [0.0, 1e-12, 1e-3, 1.0] {
            let from = Vector::new(libm::sin(lean), 0.0, libm::cos(lean));
            let turn = turn(from, Vector::z());
            assert!((turn * from - Vector::z()).norm() < 1e-15);
            assert!((turn * Vector::y() - Vector::y()).norm() < 1e-15);
            assert!((turn.matrix().determinant() - 1.0).abs() < 1e-15);
        }
    }

    #[test]
    fn angles_of_a_pose_have_the_documented_senses() {
        let turned = |axis: Vector, degrees: f64| {
            let angle = degrees.to_radians();
            let rotation = Rotation3::from_axis_angle(&Unit::new_unchecked(axis), angle);
            let pose = Pose::new([1.0, 2.0, 3.0], &rotation);
            [pose.roll, pose.pitch, pose.yaw].map(libm::round)
        };
        assert_eq!(turned(Vector::y(), 20.0), [20.0, 0.0, 0.0]);
        assert_eq!(turned(Vector::x(), 20.0), [0.0, 20.0, 0.0]);
        assert_eq!(turned(Vector::z(), 20.0), [0.0, 0.0, 20.0]);
    }
}
