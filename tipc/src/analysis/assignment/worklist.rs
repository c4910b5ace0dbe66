//! Nodes that are still to be looked at, in an order that looks at few of them twice.

use crate::analysis::flow::NodeId;
use std::collections::BinaryHeap;

/// Which nodes come first.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Order {
    /// Those of early steps.
    Forward,
    /// Those of late steps.
    Backward,
}

/// A queue that holds each node once.
pub(super) struct Worklist {
    order: Order,
    /// Nodes, counted so that the greatest comes first.
    heap: BinaryHeap<usize>,
    queued: Vec<bool>,
}

impl Worklist {
    /// An empty one for nodes below `nodes`.
    pub(super) fn new(nodes: usize, order: Order) -> Self {
        Worklist {
            order,
            heap: BinaryHeap::new(),
            queued: vec![false; nodes],
        }
    }

    fn rank(&self, node: NodeId) -> usize {
        match self.order {
            Order::Forward => self.queued.len() - 1 - node,
            Order::Backward => node,
        }
    }

    /// Adds a node, unless it is there.
    pub(super) fn push(&mut self, node: NodeId) {
        if !std::mem::replace(&mut self.queued[node], true) {
            self.heap.push(self.rank(node));
        }
    }

    /// Takes the first node out.
    pub(super) fn pop(&mut self) -> Option<NodeId> {
        let rank = self.heap.pop()?;
        // Counting from the other end is its own inverse.
        let node = self.rank(rank);
        self.queued[node] = false;
        Some(node)
    }
}
