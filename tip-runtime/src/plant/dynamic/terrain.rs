//! What is around the robot.

use super::Vector;
use super::contact::Touch;
use crate::scene::{BLOCKS, Block, Scene};
use nalgebra::Rotation3;

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

    /// Where it is inside of a block: it leaves by the nearest side.
    pub(super) fn block(&self, point: Vector) -> Option<Touch> {
        let inside = |block: &Block| {
            let [x, y, z] = (point * 1000.0).into();
            let sides = [
                (block.height - z, Vector::z()),
                (x - block.x[0], -Vector::x()),
                (block.x[1] - x, Vector::x()),
                (y - block.y[0], -Vector::y()),
                (block.y[1] - y, Vector::y()),
            ];
            let nearest = |best: (f64, Vector), side: (f64, Vector)| match side.0 < best.0 {
                true => side,
                false => best,
            };
            let (depth, normal) = sides
                .into_iter()
                .fold((f64::INFINITY, Vector::z()), nearest);
            (depth > 0.0).then_some(Touch {
                depth: depth / 1000.0,
                normal,
                friction: self.friction,
            })
        };
        self.blocks.iter().flatten().find_map(inside)
    }

    /// How far a point is below the top of the block that it is in: m; 0 outside.
    pub(super) fn rise(&self, point: Vector) -> f64 {
        let [x, y, z] = (point * 1000.0).into();
        let over = |block: &&Block| {
            (block.x[0]..block.x[1]).contains(&x) && (block.y[0]..block.y[1]).contains(&y)
        };
        let tops = self.blocks.iter().flatten().filter(over);
        tops.fold(0.0, |rise, block| {
            f64::max(rise, (block.height - z) / 1000.0)
        })
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
