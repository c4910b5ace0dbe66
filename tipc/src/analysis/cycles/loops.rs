//! The loops of a program, whatever statements they are made of.

use super::rings::rings;
use crate::analysis::flow::NodeId;
use std::collections::BTreeSet;

/// Where nodes lead in their own frame, and which of them a run can come back to.
pub(super) struct Loops {
    next: Vec<Vec<NodeId>>,
    before: Vec<Vec<NodeId>>,
    /// Nodes with paths to each other have the same number.
    rings: Vec<usize>,
}

impl Loops {
    /// The loops of nodes that lead so. Takes linear time.
    pub(super) fn new(next: Vec<Vec<NodeId>>) -> Self {
        let mut before = vec![Vec::new(); next.len()];
        for (id, next) in next.iter().enumerate() {
            for next in next {
                before[*next].push(id);
            }
        }
        Loops {
            rings: rings(&next, &before),
            next,
            before,
        }
    }

    /// The nodes where loops begin: something in the loop leads back to them.
    pub(super) fn heads(&self) -> BTreeSet<NodeId> {
        let is_head = |head: &NodeId| self.backwards_to(*head).next().is_some();
        (0..self.next.len()).filter(is_head).collect()
    }

    /// The nodes on the paths from a head back to it, over a jump backwards.
    pub(super) fn nodes(&self, head: NodeId) -> BTreeSet<NodeId> {
        let mut leads_back = BTreeSet::from([head]);
        let mut open: Vec<NodeId> = self.backwards_to(head).collect();
        while let Some(id) = open.pop() {
            if leads_back.insert(id) {
                open.extend(self.on_ring_of(head, &self.before[id]));
            }
        }
        let mut nodes = BTreeSet::new();
        let mut open = vec![head];
        while let Some(id) = open.pop() {
            if nodes.insert(id) {
                let next = self.next[id].iter().copied();
                open.extend(next.filter(|next| leads_back.contains(next)));
            }
        }
        nodes
    }

    /// The nodes that lead back to a node, from after it or from itself.
    fn backwards_to(&self, head: NodeId) -> impl Iterator<Item = NodeId> {
        let before = self.on_ring_of(head, &self.before[head]);
        before.filter(move |from| *from >= head)
    }

    fn on_ring_of<'a>(
        &'a self,
        head: NodeId,
        nodes: &'a [NodeId],
    ) -> impl Iterator<Item = NodeId> + 'a {
        let nodes = nodes.iter().copied();
        nodes.filter(move |id| self.rings[*id] == self.rings[head])
    }
}
