//! The loops of a program, whatever statements they are made of.

use super::components::components;
use super::distance::Work;
use tipc::analysis::flow::NodeId;

/// Edges of nodes in their own frame, and nodes that a run can come back to.
pub(super) struct Loops {
    next: Vec<Vec<NodeId>>,
    before: Vec<Vec<NodeId>>,
    /// Nodes with paths to each other have the same number.
    components: Vec<usize>,
    /// Runs come here from outside of all nodes.
    is_entry: Vec<bool>,
    /// The closed loop that a node stands for is in this one, or is the node itself.
    around: Vec<NodeId>,
    /// A shortcut along `around`.
    outermost: Vec<NodeId>,
    /// The last search that found a node in a loop, and the last that found paths from it back to the head.
    held_by: Vec<usize>,
    leads_back: Vec<usize>,
    search: usize,
}

/// The nodes of a loop.
pub(super) enum Body {
    /// Its head is the only way in. A closed loop in it is given by its head alone.
    Closed(Vec<NodeId>),
    /// There are other ways in.
    Open(Vec<NodeId>),
}

impl Loops {
    /// Creates the loops of nodes that lead so; runs begin at the `entries`. Takes linear time.
    pub(super) fn new(next: Vec<Vec<NodeId>>, entries: impl Iterator<Item = NodeId>) -> Self {
        let mut before = vec![Vec::new(); next.len()];
        for (id, next) in next.iter().enumerate() {
            for next in next {
                before[*next].push(id);
            }
        }
        let mut is_entry = vec![false; next.len()];
        entries.for_each(|id| is_entry[id] = true);
        Loops {
            components: components(&next, &before),
            is_entry,
            around: (0..next.len()).collect(),
            outermost: (0..next.len()).collect(),
            held_by: vec![0; next.len()],
            leads_back: vec![0; next.len()],
            search: 0,
            next,
            before,
        }
    }

    /// Returns the nodes where loops begin, the last first: something in the loop leads back to them.
    pub(super) fn heads(&self) -> Vec<NodeId> {
        let is_head = |head: &NodeId| self.backwards_to(*head).next().is_some();
        (0..self.next.len()).rev().filter(is_head).collect()
    }

    /// Returns the nodes on the paths from a head back to it, over a jump backwards. Of heads asked for in their order
    /// each closed loop is passed once by those around it; an open one takes as long as its component. `None` if that is
    /// more work than is left.
    pub(super) fn body(&mut self, head: NodeId, work: &Work) -> Option<Body> {
        match self.closed(head, work) {
            Some(nodes) => Some(Body::Closed(nodes)),
            None => Some(Body::Open(self.open(head, work)?)),
        }
    }

    /// Returns true if the node is in the loop that [`body`](Self::body) found last.
    pub(super) fn holds(&self, id: NodeId) -> bool {
        self.held_by[id] == self.search
    }

    /// Returns true if a closed loop holds a node besides its head.
    pub(super) fn is_inside(&self, id: NodeId, closed: NodeId) -> bool {
        let mut at = id;
        while self.around[at] != at {
            at = self.around[at];
            if at == closed {
                return true;
            }
        }
        false
    }

    /// Returns the nodes from which paths lead back to the head, if all of them begin at it.
    fn closed(&mut self, head: NodeId, work: &Work) -> Option<Vec<NodeId>> {
        if self.outermost(head) != head {
            return None;
        }
        self.search += 1;
        self.held_by[head] = self.search;
        let mut nodes = vec![head];
        let mut open: Vec<NodeId> = self.backwards_to(head).collect();
        while let Some(id) = open.pop() {
            let id = self.outermost(id);
            if self.holds(id) {
                continue;
            }
            let before = &self.before[id];
            work.take(1 + before.len())?;
            let is_entered = before
                .iter()
                .any(|from| self.components[*from] != self.components[head]);
            if is_entered || self.is_entry[id] {
                return None;
            }
            self.held_by[id] = self.search;
            nodes.push(id);
            open.extend(before);
        }
        for id in &nodes[1..] {
            self.around[*id] = head;
            self.outermost[*id] = head;
        }
        Some(nodes)
    }

    fn open(&mut self, head: NodeId, work: &Work) -> Option<Vec<NodeId>> {
        // What an attempt at a closed loop found is none of it.
        self.search += 1;
        self.leads_back[head] = self.search;
        let mut open: Vec<NodeId> = self.backwards_to(head).collect();
        while let Some(id) = open.pop() {
            if std::mem::replace(&mut self.leads_back[id], self.search) != self.search {
                work.take(1 + self.before[id].len())?;
                open.extend(self.on_ring_of(head, &self.before[id]));
            }
        }
        let mut nodes = Vec::new();
        let mut open = vec![head];
        while let Some(id) = open.pop() {
            if !self.holds(id) {
                self.held_by[id] = self.search;
                nodes.push(id);
                let next = self.next[id].iter().copied();
                open.extend(next.filter(|next| self.leads_back[*next] == self.search));
            }
        }
        Some(nodes)
    }

    /// Returns the head of the closed loop that is around all others around a node; the node itself if there is none.
    fn outermost(&mut self, id: NodeId) -> NodeId {
        let mut found = id;
        while self.outermost[found] != found {
            found = self.outermost[found];
        }
        let mut at = id;
        while at != found {
            at = std::mem::replace(&mut self.outermost[at], found);
        }
        found
    }

    /// Returns the nodes that lead back to a node, from after it or from itself.
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
        nodes.filter(move |id| self.components[*id] == self.components[head])
    }
}
