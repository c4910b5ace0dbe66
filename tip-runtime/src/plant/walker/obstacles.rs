//! Blocks: a robot without mass goes through them, which is counted.

use super::Vector;
use crate::plant::cuboid::Cuboid;
use crate::scene::{BLOCKS, Block};

/// Tolerated depth of a joint below the floor, which gives way a little, and of anything inside a
/// block, mm.
pub(super) const SUNK: f64 = 1.0;

/// The blocks of a scene.
#[derive(Clone, Copy, Debug)]
pub(super) struct Obstacles(pub(super) [Option<Block>; BLOCKS]);

impl Obstacles {
    /// Iterates over the parts of the blocks that are deeper inside than the tolerance, mm.
    fn cores(&self) -> impl Iterator<Item = Cuboid> + '_ {
        let skin = Vector::repeat(SUNK);
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
    pub(super) fn stop(&self, stretch: [Vector; 2]) -> bool {
        self.cores().any(|core| core.inside(stretch).is_some())
    }

    /// Returns true if a body is in a block; `to_body` and `to_world` transform to and from its
    /// frame.
    pub(super) fn stop_body(
        &self,
        body: &Cuboid,
        to_body: impl Fn(Vector) -> Vector,
        to_world: impl Fn(Vector) -> Vector,
    ) -> bool {
        self.cores().any(|core| {
            let meets = |edge: &[Vector; 2]| body.inside(edge.map(&to_body)).is_some();
            core.edges().iter().any(meets)
        }) || (body.edges().iter()).any(|edge| self.stop(edge.map(&to_world)))
    }
}
