//! Basic blocks: runs of nodes that a run passes from the first to the last.

use crate::analysis::flow::{Flow, Next, NodeId};

/// The index of a block. Blocks come in the order of their nodes.
pub(super) type BlockId = usize;

/// Ways out of the last node of a block.
#[derive(Clone, Debug)]
pub(super) struct Block {
    /// Blocks that may follow without a call or return.
    pub(super) next: Next,
    /// The block of a subroutine that it may call, and the one where that comes back.
    pub(super) call: Option<(BlockId, BlockId)>,
    /// It ends with RETURN or SUBEND.
    pub(super) returns: bool,
}

/// The blocks of a flow.
#[derive(Clone, Debug)]
pub(super) struct Blocks {
    all: Vec<Block>,
    of_node: Vec<BlockId>,
    /// The blocks that name a block in `next` or `call`: those of block `b` are
    /// `before[before_ends[b - 1]..before_ends[b]]`.
    before: Vec<BlockId>,
    before_ends: Vec<usize>,
}

impl Blocks {
    /// Splits a flow into blocks. Takes time and memory linear in its length.
    pub(super) fn of(flow: &Flow) -> Self {
        let nodes = flow.nodes();
        let begins = beginnings(flow);
        let mut of_node = Vec::with_capacity(nodes.len());
        let mut count: BlockId = 0;
        for begins in &begins {
            count += usize::from(*begins);
            of_node.push(count - 1);
        }
        let mut all: Vec<Block> = Vec::with_capacity(count);
        for end in 1..=nodes.len() {
            if begins.get(end) == Some(&false) {
                continue;
            }
            let last = &nodes[end - 1];
            all.push(Block {
                next: last.next.iter().map(|next| of_node[*next]).collect(),
                call: last
                    .call
                    .map(|call| (of_node[call.entry], of_node[call.back])),
                returns: last.returns,
            });
        }
        let (before, before_ends) = before(&all);
        Blocks {
            all,
            of_node,
            before,
            before_ends,
        }
    }

    /// Returns the blocks in order.
    pub(super) fn all(&self) -> &[Block] {
        &self.all
    }

    /// Returns the block that a node is in.
    pub(super) fn of_node(&self, node: NodeId) -> BlockId {
        self.of_node[node]
    }

    /// Returns the blocks that lead or call to a block, or whose calls come back to it.
    pub(super) fn before(&self, block: BlockId) -> &[BlockId] {
        let start = match block.checked_sub(1) {
            Some(earlier) => self.before_ends[earlier],
            None => 0,
        };
        &self.before[start..self.before_ends[block]]
    }
}

/// Returns which nodes begin a block: all except those that only the node before them leads to.
fn beginnings(flow: &Flow) -> Vec<bool> {
    let nodes = flow.nodes();
    let mut begins = vec![false; nodes.len()];
    let mut mark = |node: NodeId| {
        if let Some(begins) = begins.get_mut(node) {
            *begins = true;
        }
    };
    flow.starts().iter().copied().for_each(&mut mark);
    for (id, node) in nodes.iter().enumerate() {
        if *node.next == [id + 1] && node.call.is_none() {
            continue;
        }
        mark(id + 1);
        node.next.iter().copied().for_each(&mut mark);
        if let Some(call) = node.call {
            mark(call.entry);
            mark(call.back);
        }
    }
    begins
}

/// Returns the blocks that a block names in `next` or `call`.
fn after(block: &Block) -> impl Iterator<Item = BlockId> {
    let called = block.call.into_iter();
    let called = called.flat_map(|(entry, back)| [entry, back]);
    block.next.iter().copied().chain(called)
}

fn before(all: &[Block]) -> (Vec<BlockId>, Vec<usize>) {
    let mut ends = vec![0; all.len()];
    for next in all.iter().flat_map(after) {
        ends[next] += 1;
    }
    let mut total = 0;
    for end in &mut ends {
        // Where the block's part begins; filling it moves this to its end.
        total += std::mem::replace(end, total);
    }
    let mut before = vec![0; total];
    for (id, block) in all.iter().enumerate() {
        for next in after(block) {
            before[ends[next]] = id;
            ends[next] += 1;
        }
    }
    (before, ends)
}
