//! One turn of each loop, whatever statements it is made of.

use super::graph::{Graph, Limits};
use super::search::{Place, Work, components, reversed};
use super::{Part, Span};
use std::collections::BTreeSet;
use tipc::analysis::flow::{Flow, NodeId};

/// Edges of nodes in their own frame.
struct Edges {
    next: Vec<Vec<NodeId>>,
    before: Vec<Vec<NodeId>>,
    /// Nodes with paths to each other have the same number.
    components: Vec<usize>,
}

/// Returns the turns in the order of their heads, and true if those are all. A head is a node that something in the
/// loop, after it or itself, leads back to.
pub(super) fn turns(flow: &Flow, graph: &Graph) -> (Vec<Part>, bool) {
    let work = Work::of(flow.nodes().len());
    let next = graph.next();
    let before = reversed(&next);
    let edges = Edges {
        components: components(&next, &before),
        next,
        before,
    };
    let mut parts = Vec::new();
    let mut are_all = true;
    for head in (0..edges.next.len()).rev() {
        let mut back = edges.in_loop_with(head, head);
        back.retain(|from| *from >= head);
        if !back.is_empty() {
            let found = turn(flow, graph, &edges, (head, back), &work);
            are_all &= found.is_some();
            parts.extend(found.flatten());
        }
    }
    parts.reverse();
    (parts, are_all)
}

/// Returns one turn, if there is a way; `None` if that is more work than is left.
fn turn(
    flow: &Flow,
    graph: &Graph,
    edges: &Edges,
    (head, back): (NodeId, Vec<NodeId>),
    work: &Work,
) -> Option<Option<Part>> {
    let nodes = edges.body(head, back, work)?;
    let limits = Limits {
        stops: &|id| id == head || !nodes.contains(&id),
        opens: &|counted| counted.nodes.contains(&head),
    };
    let mut ends = graph.ends(head, &limits, work)?;
    let cycles = ends.remove(&Place::Stop(head));
    let steps = nodes.iter().map(|id| flow.nodes()[*id].step);
    Some(cycles.map(|cycles| Part {
        span: Span::Turn {
            head: flow.nodes()[head].step,
            steps: steps.collect(),
            turns: graph.turns_from(head),
        },
        cycles,
    }))
}

impl Edges {
    /// Returns the nodes that lead to a node and are on a ring with the head.
    fn in_loop_with(&self, head: NodeId, to: NodeId) -> Vec<NodeId> {
        let before = self.before[to].iter().copied();
        before
            .filter(|from| self.components[*from] == self.components[head])
            .collect()
    }

    /// Returns the nodes on the paths from a head over those that lead `back` to it; `None` if that is more work than
    /// is left.
    fn body(&self, head: NodeId, back: Vec<NodeId>, work: &Work) -> Option<BTreeSet<NodeId>> {
        let mut leads_back = BTreeSet::from([head]);
        let mut open = back;
        while let Some(id) = open.pop() {
            if leads_back.insert(id) {
                work.take(1 + self.before[id].len())?;
                open.extend(self.in_loop_with(head, id));
            }
        }
        let mut nodes = BTreeSet::new();
        let mut open = vec![head];
        while let Some(id) = open.pop() {
            if nodes.insert(id) {
                let next = self.next[id].iter();
                open.extend(next.filter(|next| leads_back.contains(next)));
            }
        }
        Some(nodes)
    }
}
