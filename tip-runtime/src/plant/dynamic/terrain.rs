//! What is around the robot.

use super::Vector;
use super::contact::Touch;
use crate::plant::cuboid::{Cuboid, middle};
use crate::scene::{BLOCKS, Block, Scene};
use nalgebra::Rotation3;

/// Higher than all blocks: m.
const SKY: f64 = 1e4;

/// A floor and what stands on it, in m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Terrain {
    /// Above the world's origin.
    height: f64,
    /// Up from the floor: a unit vector.
    pub(super) normal: Vector,
    friction: f64,
    blocks: [Option<Block>; BLOCKS],
}

impl Terrain {
    pub(super) fn of(scene: &Scene) -> Self {
        let [x, y] = scene.floor.slope;
        let normal = Vector::new(-x, -y, 1.0);
        Terrain {
            height: scene.floor.height / 1000.0,
            normal: normal / normal.norm(),
            friction: scene.friction,
            blocks: scene.blocks,
        }
    }

    /// Turns the floor's frame (z along its normal) into the world's.
    pub(super) fn tilt(&self) -> Rotation3<f64> {
        Rotation3::rotation_between(&Vector::z(), &self.normal).unwrap_or_else(Rotation3::identity)
    }

    /// Where the floor is under the world's origin, or above it.
    pub(super) fn origin(&self) -> Vector {
        Vector::new(0.0, 0.0, self.height)
    }

    /// Where a point of the world is inside of something.
    #[inline]
    pub(super) fn touch(&self, point: Vector) -> Option<Touch> {
        self.block(point).or_else(|| self.floor(point))
    }

    /// Whether anything stands on the floor.
    #[inline]
    pub(super) fn has_blocks(&self) -> bool {
        self.blocks.iter().any(Option::is_some)
    }

    /// What stands on the floor.
    #[inline]
    pub(super) fn blocks(&self) -> impl Iterator<Item = Cuboid> + '_ {
        let blocks = self.blocks.iter().flatten();
        blocks.map(|block| Cuboid::of_block(block, 1000.0))
    }

    /// Where it is inside of a block: it leaves by the nearest side.
    fn block(&self, point: Vector) -> Option<Touch> {
        let (depth, normal) = self.blocks().find_map(|block| block.depth(point))?;
        Some(self.touching(depth, normal))
    }

    /// A touch on a side that faces so.
    #[inline]
    pub(super) fn touching(&self, depth: f64, normal: Vector) -> Touch {
        Touch {
            depth,
            normal,
            friction: self.friction,
        }
    }

    /// Where a rod goes through a block between its ends, which pushes it off at right angles: its middle in there.
    pub(super) fn bars(&self, rod: [Vector; 2]) -> impl Iterator<Item = (Vector, Touch)> + '_ {
        self.blocks().filter_map(move |block| {
            let middle = middle(rod, block.through(rod)?);
            let (depth, side) = block.depth(middle)?;
            let along = (rod[1] - rod[0]).normalize();
            let off = side - along * along.dot(&side);
            let part = off.norm();
            (part > 0.0).then(|| (middle, self.touching(depth * part, off / part)))
        })
    }

    /// By how much a stretch has to rise to be nowhere below the top of a block: m.
    pub(super) fn rise(&self, stretch: [Vector; 2]) -> f64 {
        let rises = self.blocks().filter_map(|mut block| {
            let top = block.high.z;
            block.high.z = SKY;
            let over = block.inside(stretch)?;
            let [start, end] = stretch;
            let lowest = over.map(|part| start.z + (end.z - start.z) * part);
            Some(top - lowest[0].min(lowest[1]))
        });
        rises.fold(0.0, f64::max)
    }

    /// Where it is in the floor.
    #[inline]
    fn floor(&self, point: Vector) -> Option<Touch> {
        let above = self.normal.dot(&point) - self.height * self.normal.z;
        (above < 0.0).then_some(Touch {
            depth: -above,
            normal: self.normal,
            friction: self.friction,
        })
    }
}
