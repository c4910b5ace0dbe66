//! Where a program reads and assigns its scalars, sorted into batches that fit a machine word.

use super::blocks::{BlockId, Blocks};
use crate::analysis::access;
use crate::analysis::flow::{Flow, NodeId};
use crate::program::Program;

/// A set of the scalars of a batch, one bit each.
pub(super) type Scalars = u64;

/// The bit of a scalar that nothing touches: wherever a run comes, it comes there unassigned.
pub(super) const UNTOUCHED: Scalars = 1 << 63;
/// How many others a batch has room for.
const ROOM: usize = 63;

/// What a node does with the scalars of a batch.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Touch {
    /// The node.
    pub(super) node: NodeId,
    /// The scalars that it reads, before it assigns any.
    pub(super) read: Scalars,
    /// The scalars that it assigns.
    pub(super) set: Scalars,
}

/// A scalar at a node.
#[derive(Clone, Copy)]
struct Access {
    node: NodeId,
    scalar: usize,
    assigns: bool,
}

/// Every read and assignment of a program, in the order of a run through each node.
pub(super) struct Touches {
    all: Vec<Access>,
}

/// Some scalars, and what the nodes do with them.
#[derive(Default)]
pub(super) struct Sorted {
    /// The scalars, by their bits.
    pub(super) scalars: Vec<usize>,
    /// In the order of the nodes.
    pub(super) touches: Vec<Touch>,
}

impl Touches {
    /// What the nodes of a program's flow read and assign.
    pub(super) fn of(program: &Program, flow: &Flow) -> Self {
        let mut all = Vec::with_capacity(2 * flow.nodes().len());
        for (node, content) in flow.nodes().iter().enumerate() {
            let action = &program.steps()[content.step as usize].action;
            if !content.is_passed {
                access::reads(program, action, |scalar| {
                    all.push(Access {
                        node,
                        scalar,
                        assigns: false,
                    });
                });
            }
            all.extend(access::assigns(program, action).map(|scalar| Access {
                node,
                scalar,
                assigns: true,
            }));
        }
        Touches { all }
    }

    /// The touches of one scalar, at bit 0.
    pub(super) fn of_scalar(&self, scalar: usize) -> Vec<Touch> {
        let mut sorted = Sorted::default();
        for access in self.all.iter().filter(|access| access.scalar == scalar) {
            sorted.add(*access, 1);
        }
        sorted.touches
    }

    /// The scalars that a block reads before it assigns them, in batches of 63, with all their touches; one batch at
    /// least. And the reads of all others, which find a value wherever a run comes.
    pub(super) fn sorted(
        &self,
        scalars: usize,
        blocks: &Blocks,
    ) -> (Vec<Sorted>, Vec<(NodeId, usize)>) {
        let places = self.exposed(scalars, blocks);
        let mut batches = vec![Sorted::default()];
        let mut certain = Vec::new();
        for access in &self.all {
            match places[access.scalar] {
                Some(place) => {
                    batches.resize_with(batches.len().max(place / ROOM + 1), Sorted::default);
                    batches[place / ROOM].add(*access, 1 << (place % ROOM));
                }
                None if access.assigns => {}
                None => certain.push((access.node, access.scalar)),
            }
        }
        for (scalar, place) in places.iter().enumerate() {
            if let Some(place) = place {
                let names = &mut batches[place / ROOM].scalars;
                names.resize(names.len().max(place % ROOM + 1), 0);
                names[place % ROOM] = scalar;
            }
        }
        (batches, certain)
    }

    /// Numbers those scalars that some block reads before it assigns them.
    fn exposed(&self, scalars: usize, blocks: &Blocks) -> Vec<Option<usize>> {
        let mut places: Vec<Option<usize>> = vec![None; scalars];
        let mut touched_in: Vec<Option<BlockId>> = vec![None; scalars];
        let mut count = 0;
        for access in &self.all {
            let block = Some(blocks.of_node(access.node));
            let was_touched = std::mem::replace(&mut touched_in[access.scalar], block) == block;
            if !access.assigns && !was_touched && places[access.scalar].is_none() {
                places[access.scalar] = Some(count);
                count += 1;
            }
        }
        places
    }
}

impl Sorted {
    fn add(&mut self, access: Access, bit: Scalars) {
        if self
            .touches
            .last()
            .is_none_or(|last| last.node != access.node)
        {
            self.touches.push(Touch {
                node: access.node,
                ..Touch::default()
            });
        }
        if let Some(touch) = self.touches.last_mut() {
            match access.assigns {
                true => touch.set |= bit,
                false => touch.read |= bit,
            }
        }
    }
}
