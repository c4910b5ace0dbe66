//! The pose of the body in the world and in the floor's frame, the transformations between them, and its travel.

use super::Vector;
use crate::model::{self, Point};
use crate::plant::cuboid::Cuboid;
use crate::scene::{BLOCKS, Block, Floor};
use core::f64::consts::{PI, TAU};
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
    pub(super) fn pose(&self, body: &FloorPose) -> Pose {
        Pose::new(self.position(body), &(self.tilt() * body.rotation()))
    }

    /// Transforms a point of a body into the world.
    pub(super) fn outer(&self, body: &FloorPose, point: Vector) -> Vector {
        self.point(body.point(point)).into()
    }

    /// Transforms a point of the world into the frame of a body.
    pub(super) fn inner(&self, body: &FloorPose, point: Vector) -> Vector {
        let turned = self.tilt() * body.rotation();
        turned.inverse() * (point - Vector::from(self.position(body)))
    }

    /// Returns the position of a body's origin in the world.
    pub(super) fn position(&self, body: &FloorPose) -> Point {
        self.point(body.point(Vector::zeros()))
    }
}

/// Tolerated depth of a joint below the floor, which gives way a little, and of anything inside a
/// block, mm.
pub(super) const SINK_TOLERANCE: f64 = 1.0;

/// The blocks of a scene.
#[derive(Clone, Copy, Debug)]
pub(super) struct Obstacles(pub(super) [Option<Block>; BLOCKS]);

impl Obstacles {
    /// Iterates over the parts of the blocks that are deeper inside than the tolerance, mm.
    fn cores(&self) -> impl Iterator<Item = Cuboid> + '_ {
        let skin = Vector::repeat(SINK_TOLERANCE);
        self.0.iter().flatten().map(move |block| {
            let Cuboid { low, high } = Cuboid::of_block(block, 1.0);
            Cuboid {
                low: low + skin,
                high: high - skin,
            }
        })
    }

    pub(super) fn is_empty(&self) -> bool {
        self.0.iter().all(Option::is_none)
    }

    /// Returns true if a segment is in a block.
    pub(super) fn hits_segment(&self, segment: [Vector; 2]) -> bool {
        self.cores().any(|core| core.inside(segment).is_some())
    }

    /// Returns true if a body is in a block; `to_body` and `to_world` transform to and from its
    /// frame.
    pub(super) fn hits_body(
        &self,
        body: &Cuboid,
        to_body: impl Fn(Vector) -> Vector,
        to_world: impl Fn(Vector) -> Vector,
    ) -> bool {
        self.cores().any(|core| {
            let meets = |edge: &[Vector; 2]| body.inside(edge.map(&to_body)).is_some();
            core.edges().iter().any(meets)
        }) || (body.edges().iter()).any(|edge| self.hits_segment(edge.map(&to_world)))
    }
}

/// The travel of a body from its start.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Travel {
    /// To the right of its initial attitude, mm.
    pub x: f64,
    /// Forward: mm.
    pub y: f64,
    /// Up: mm.
    pub z: f64,
    /// Turn to the left, about the floor's normal, deg. Whole turns count.
    pub turn: f64,
}

impl Travel {
    /// Returns a travel along x, y and z (mm) with a turn to the left (deg).
    pub const fn new([x, y, z]: Point, turn: f64) -> Self {
        Travel { x, y, z, turn }
    }
}

/// The start of the body, and the number of its revolutions since.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Odometer {
    position: Point,
    /// rad.
    heading: f64,
    revolutions: f64,
}

impl Odometer {
    /// Starts at the current pose.
    pub(super) fn at(floor: &Floor, body: &FloorPose) -> Self {
        Odometer {
            position: floor.position(body),
            heading: body.heading,
            revolutions: 0.0,
        }
    }

    /// Records a change of the heading, which is kept within half a turn.
    pub(super) fn turned(&mut self, from: f64, to: f64) {
        if to - from > PI {
            self.revolutions -= 1.0;
        } else if to - from < -PI {
            self.revolutions += 1.0;
        }
    }

    /// Returns the travel from the start to the current pose.
    pub(super) fn travel(&self, floor: &Floor, body: &FloorPose) -> Travel {
        let ([x, y, z], [x0, y0, z0]) = (floor.position(body), self.position);
        let turn = body.heading - self.heading + self.revolutions * TAU;
        Travel {
            x: x - x0,
            y: y - y0,
            z: z - z0,
            turn: turn.to_degrees(),
        }
    }
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

    #[test]
    fn whole_turns_count_in_both_senses() {
        for sense in [1.0, -1.0] {
            let mut body = FloorPose::standing(None);
            let mut start = Odometer::at(&Floor::LEVEL, &body);
            // Two turns and a quarter, in steps of 30 degrees.
            for step in 1..=27 {
                let angle = sense * f64::from(step) * PI / 6.0;
                let heading = libm::atan2(libm::sin(angle), libm::cos(angle));
                start.turned(body.heading, heading);
                body.heading = heading;
            }
            let turn = start.travel(&Floor::LEVEL, &body).turn;
            assert!((turn - sense * 810.0).abs() < 1e-9, "{turn}");
        }
    }
}
