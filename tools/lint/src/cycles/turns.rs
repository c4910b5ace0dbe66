//! One turn of each loop.
//!
//! A loop that only its head leads into counts as one edge in the loops around it, so that each step is passed once
//! however deep it is nested.

use super::distance::{Edge, Place, Work};
use super::graph::{Graph, Limits};
use super::loops::{Body, Loops};
use super::{Part, Span, Steps};
use tipc::analysis::flow::{Flow, NodeId};

/// A loop, by its head.
struct Found {
    steps: Steps,
    /// Cost to leave it, if its head is the only way in.
    left: Option<Vec<Edge>>,
}

/// Returns the turns in the order of their heads, and true if those are all.
pub(super) fn turns(flow: &Flow, graph: &Graph) -> (Vec<Part>, bool) {
    let work = Work::of(flow.nodes().len());
    let mut loops = graph.loops();
    let mut found: Vec<Option<Found>> = flow.nodes().iter().map(|_| None).collect();
    let mut parts = Vec::new();
    let mut are_all = true;
    for head in loops.heads() {
        let one = loops.body(head, &work);
        let one = one.and_then(|body| turn(flow, graph, (&loops, head, &body), &found, &work));
        are_all &= one.is_some();
        if let Some((one, part)) = one {
            parts.extend(part);
            found[head] = Some(one);
        }
    }
    parts.reverse();
    (parts, are_all)
}

/// Returns one loop; `None` if that is more work than is left.
fn turn(
    flow: &Flow,
    graph: &Graph,
    (loops, head, body): (&Loops, NodeId, &Body),
    found: &[Option<Found>],
    work: &Work,
) -> Option<(Found, Option<Part>)> {
    let (nodes, is_closed) = match body {
        Body::Closed(nodes) => (nodes, true),
        Body::Open(nodes) => (nodes, false),
    };
    let left = |id: NodeId| found[id].as_ref()?.left.as_deref();
    let limits = Limits {
        stops: &|id| id == head || !loops.holds(id),
        opens: &|counted| counted.nodes.contains(&head),
        closed: &|id| left(id).filter(|_| id != head && (is_closed || !loops.is_inside(head, id))),
    };
    let mut ends = graph.ends(head, &limits, work)?;
    let turn = ends.remove(&Place::Stop(head));
    let edges = ends.into_iter().map(|(to, mut cost)| {
        if let Some(turn) = turn {
            cost.max = None;
            cost.waits |= turn.waits;
        }
        Edge { to, cost }
    });
    let own: Vec<Steps> = nodes
        .iter()
        .map(|id| Steps::one(flow.nodes()[*id].step))
        .collect();
    let inner = nodes.iter().filter(|id| is_closed && **id != head);
    let inner = inner.filter_map(|id| found[*id].as_ref().filter(|one| one.left.is_some()));
    let inner: Vec<&Steps> = inner.map(|one| &one.steps).collect();
    // Steps that lie apart are held for each loop around them.
    work.take(inner.iter().map(|steps| steps.pieces()).sum())?;
    let steps = Steps::all(own.iter().chain(inner));
    let part = turn.map(|cycles| Part {
        span: Span::Turn {
            head: flow.nodes()[head].step,
            steps: steps.clone(),
            turns: graph.turns_from(head),
        },
        cycles,
    });
    let left = is_closed.then(|| edges.collect());
    Some((Found { steps, left }, part))
}
