//! The floor of a walking robot without mass: transformations between the frames of floor, body and
//! world.

use super::Vector;
use super::pose::{FloorPose, Pose, turn};
use crate::model::Point;
use crate::plant::cuboid::Cuboid;
use crate::scene::{BLOCKS, Block, Floor};
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
