//! One turn of each loop.
//!
//! A loop that only its head leads into counts as one edge in the loops around it, so that each step is passed once
//! however deep it is nested.

use super::distance::{Edge, Place};
use super::graph::{Graph, Limits};
use super::loops::{Body, Loops};
use super::{Part, Span, Steps};
use tipc::analysis::flow::{Flow, NodeId};

/// A loop, by its head.
struct Found {
    steps: Steps,
    /// What it costs to leave it, if its head is the only way in.
    left: Option<Vec<Edge>>,
}

/// The turns in the order of their heads.
pub(super) fn turns(flow: &Flow, graph: &Graph) -> Vec<Part> {
    let mut loops = graph.loops();
    let mut found: Vec<Option<Found>> = flow.nodes().iter().map(|_| None).collect();
    let mut parts = Vec::new();
    for head in loops.heads() {
        let body = loops.body(head);
        let (one, part) = turn(flow, graph, (&loops, head, &body), &found);
        parts.extend(part);
        found[head] = Some(one);
    }
    parts.reverse();
    parts
}

fn turn(
    flow: &Flow,
    graph: &Graph,
    (loops, head, body): (&Loops, NodeId, &Body),
    found: &[Option<Found>],
) -> (Found, Option<Part>) {
    let (nodes, is_closed) = match body {
        Body::Closed(nodes) => (nodes, true),
        Body::Open(nodes) => (nodes, false),
    };
    let left = |id: NodeId| found[id].as_ref()?.left.as_deref();
    let limits = Limits {
        stops: &|id| id == head || !loops.holds(head, id),
        opens: &|counted| counted.nodes.contains(&head),
        closed: &|id| left(id).filter(|_| id != head && (is_closed || !loops.is_inside(head, id))),
    };
    let mut ends = graph.ends(head, &limits);
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
    let steps = Steps::all(own.iter().chain(inner.map(|one| &one.steps)));
    let part = turn.map(|cycles| Part {
        span: Span::Turn {
            head: flow.nodes()[head].step,
            steps: steps.clone(),
            turns: graph.turns_from(head),
        },
        cycles,
    });
    let left = is_closed.then(|| edges.collect());
    (Found { steps, left }, part)
}
