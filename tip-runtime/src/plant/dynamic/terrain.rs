//! The surroundings of a robot with mass: the floor and the blocks on it.

use super::Vector;
use super::contact::Penetration;
use super::servo::{Drives, TimeStep};
use super::spatial::MovingFrame;
use crate::plant::ContactLaw;
use crate::plant::cuboid::{Cuboid, middle};
use crate::scene::{BLOCKS, Block, Scene};
use nalgebra::Rotation3;

/// A height above all blocks, m.
const SKY: f64 = 1e4;

/// A floor and its blocks, in m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Terrain {
    /// Height above the world's origin.
    height: f64,
    /// Normal of the floor, a unit vector.
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

    /// Returns the rotation from the floor's frame (z along its normal) to the world's.
    pub(super) fn tilt(&self) -> Rotation3<f64> {
        Rotation3::rotation_between(&Vector::z(), &self.normal).unwrap_or_else(Rotation3::identity)
    }

    /// Returns the point of the floor below or above the world's origin.
    pub(super) fn origin(&self) -> Vector {
        Vector::new(0.0, 0.0, self.height)
    }

    /// Returns the touch of a point of the world that is inside an obstacle.
    #[inline]
    pub(super) fn touch(&self, point: Vector) -> Option<Penetration> {
        self.block(point).or_else(|| self.floor(point))
    }

    /// Returns true if there are blocks.
    #[inline]
    pub(super) fn has_blocks(&self) -> bool {
        self.blocks.iter().any(Option::is_some)
    }

    /// Iterates over the blocks.
    #[inline]
    pub(super) fn blocks(&self) -> impl Iterator<Item = Cuboid> + '_ {
        let blocks = self.blocks.iter().flatten();
        blocks.map(|block| Cuboid::of_block(block, 1000.0))
    }

    /// Returns the touch of a point inside a block: it leaves by the nearest side.
    fn block(&self, point: Vector) -> Option<Penetration> {
        let (depth, normal) = self.blocks().find_map(|block| block.depth(point))?;
        Some(self.touching(depth, normal))
    }

    /// Returns a touch on a side with a normal.
    #[inline]
    pub(super) fn touching(&self, depth: f64, normal: Vector) -> Penetration {
        Penetration {
            depth,
            normal,
            friction: self.friction,
        }
    }

    /// Iterates over the blocks that a rod passes through between its ends: the midpoint of the
    /// part inside, and a touch at right angles to the rod.
    pub(super) fn bars(
        &self,
        rod: [Vector; 2],
    ) -> impl Iterator<Item = (Vector, Penetration)> + '_ {
        self.blocks().filter_map(move |block| {
            let middle = middle(rod, block.through(rod)?);
            let (depth, side) = block.depth(middle)?;
            let along = (rod[1] - rod[0]).normalize();
            let off = side - along * along.dot(&side);
            let part = off.norm();
            (part > 0.0).then(|| (middle, self.touching(depth * part, off / part)))
        })
    }

    /// Returns the rise of a segment that clears the top of every block, m.
    pub(super) fn rise(&self, segment: [Vector; 2]) -> f64 {
        let rises = self.blocks().filter_map(|mut block| {
            let top = block.high.z;
            block.high.z = SKY;
            let over = block.inside(segment)?;
            let [start, end] = segment;
            let lowest = over.map(|part| start.z + (end.z - start.z) * part);
            Some(top - lowest[0].min(lowest[1]))
        });
        rises.fold(0.0, f64::max)
    }

    /// Returns the touch of a point in the floor.
    #[inline]
    fn floor(&self, point: Vector) -> Option<Penetration> {
        let above = self.normal.dot(&point) - self.height * self.normal.z;
        (above < 0.0).then(|| self.touching(-above, self.normal))
    }
}

/// The frame of the body, its surroundings, the motors, and the time step.
#[derive(Clone, Copy, Debug)]
pub(super) struct StepContext<'a> {
    pub(super) frame: &'a MovingFrame,
    pub(super) drives: &'a Drives,
    pub(super) law: &'a ContactLaw,
    /// The terrain; `None` around a robot that is bolted down.
    pub(super) terrain: Option<&'a Terrain>,
    pub(super) step: &'a TimeStep,
}
