//! One turn of each loop, for loops of any statements.

use super::graph::{Graph, Limits};
use super::search::{Place, Work, components, reversed};
use super::{Part, Span};
use tipc::analysis::flow::{Flow, NodeId};

/// Edges of nodes in their own routine, and the state of the search.
struct Loops {
    next: Vec<Vec<NodeId>>,
    before: Vec<Vec<NodeId>>,
    /// Nodes with paths to each other have the same number.
    components: Vec<usize>,
    /// The last head that a path from each node was found to.
    leads_to: Vec<NodeId>,
    /// The head of the last loop that each node was found in.
    held_by: Vec<NodeId>,
}

/// Returns the turns in the order of their heads, and true if none is left out. A head is a node to which a later node
/// of its loop, or the node itself, leads back.
pub(super) fn turns(flow: &Flow, graph: &Graph) -> (Vec<Part>, bool) {
    let work = Work::of(flow.nodes().len());
    let next = graph.next();
    let before = reversed(&next);
    let mut loops = Loops {
        components: components(&next, &before),
        leads_to: vec![NodeId::MAX; next.len()],
        held_by: vec![NodeId::MAX; next.len()],
        next,
        before,
    };
    let mut parts = Vec::new();
    let mut are_all = true;
    for head in (0..flow.nodes().len()).rev() {
        let back = loops.on_ring_before(head, head);
        let back: Vec<NodeId> = back.filter(|from| *from >= head).collect();
        if !back.is_empty() {
            let found = turn(flow, graph, &mut loops, (head, back), &work);
            are_all &= found.is_some();
            parts.extend(found.flatten());
        }
    }
    parts.reverse();
    (parts, are_all)
}

/// Returns one turn, if there is a path; `None` if that is more work than is left.
fn turn(
    flow: &Flow,
    graph: &Graph,
    loops: &mut Loops,
    (head, back): (NodeId, Vec<NodeId>),
    work: &Work,
) -> Option<Option<Part>> {
    let nodes = loops.body(head, back, work)?;
    let limits = Limits {
        stops: &|id| id == head || loops.held_by[id] != head,
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

impl Loops {
    /// Returns the predecessors of a node that are on a cycle with the head.
    fn on_ring_before(&self, head: NodeId, to: NodeId) -> impl Iterator<Item = NodeId> {
        let before = self.before[to].iter().copied();
        before.filter(move |from| self.components[*from] == self.components[head])
    }

    /// Returns the nodes on the paths from a head over those that lead `back` to it; `None` if that is more work than
    /// is left.
    fn body(&mut self, head: NodeId, back: Vec<NodeId>, work: &Work) -> Option<Vec<NodeId>> {
        self.leads_to[head] = head;
        let mut open = back;
        while let Some(id) = open.pop() {
            if std::mem::replace(&mut self.leads_to[id], head) != head {
                work.take(1 + self.before[id].len())?;
                open.extend(self.on_ring_before(head, id));
            }
        }
        let mut nodes = Vec::new();
        let mut open = vec![head];
        while let Some(id) = open.pop() {
            if std::mem::replace(&mut self.held_by[id], head) != head {
                nodes.push(id);
                let next = self.next[id].iter();
                open.extend(next.filter(|next| self.leads_to[**next] == head));
            }
        }
        Some(nodes)
    }
}
