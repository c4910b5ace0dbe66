//! The least and the most cycles from one node of a graph to others.

use super::count::Count;
use crate::analysis::flow::NodeId;
use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet, BinaryHeap};

/// Where a path leads.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Place {
    /// To a node, and on from there.
    Pass(NodeId),
    /// To a node where it ends.
    Stop(NodeId),
    /// To the return of the call.
    Return,
    /// To the end of the program.
    End,
}

/// A step of a path: what it costs to be at the next place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    pub(super) to: Place,
    pub(super) cost: Count,
}

/// The nodes that a path from some node can pass, with the edges that leave each.
type Graph = BTreeMap<NodeId, Vec<Edge>>;

/// The cycles from `from` to every place that a path reaches.
pub(super) fn distances(
    from: NodeId,
    edges: impl Fn(NodeId) -> Vec<Edge>,
) -> BTreeMap<Place, Count> {
    let graph = reachable(from, edges);
    let least = least(from, &graph);
    let most = most(from, &graph);
    let waiting = waiting(from, &graph);
    let counts = least.into_iter().map(|(place, min)| {
        let count = Count {
            min,
            max: most.get(&place).copied().flatten(),
            waits: waiting.get(&place).copied().unwrap_or(false),
        };
        (place, count)
    });
    counts.collect()
}

fn reachable(from: NodeId, edges: impl Fn(NodeId) -> Vec<Edge>) -> Graph {
    let mut graph = Graph::new();
    let mut open = vec![from];
    while let Some(id) = open.pop() {
        if graph.contains_key(&id) {
            continue;
        }
        let behind = edges(id);
        open.extend(behind.iter().filter_map(|edge| passed(edge.to)));
        graph.insert(id, behind);
    }
    graph
}

fn passed(place: Place) -> Option<NodeId> {
    match place {
        Place::Pass(id) => Some(id),
        _ => None,
    }
}

/// The least cycles to each place (Dijkstra).
fn least(from: NodeId, graph: &Graph) -> BTreeMap<Place, u64> {
    let mut least: BTreeMap<Place, u64> = BTreeMap::new();
    let mut open = BinaryHeap::from([Reverse((0_u64, Place::Pass(from)))]);
    let mut done = BTreeSet::new();
    while let Some(Reverse((cycles, place))) = open.pop() {
        if !done.insert(place) {
            continue;
        }
        for edge in passed(place).map_or(&[][..], |id| &graph[&id]) {
            let there = cycles.saturating_add(edge.cost.min);
            let known = least.entry(edge.to).or_insert(u64::MAX);
            if there < *known || *known == u64::MAX {
                *known = there;
                open.push(Reverse((there, edge.to)));
            }
        }
    }
    least
}

/// The most cycles to each place, in the order of all paths (Kahn). What a path can circle through
/// before is never in order: it is absent, or `None`.
fn most(from: NodeId, graph: &Graph) -> BTreeMap<Place, Option<u64>> {
    let mut ways_in: BTreeMap<Place, usize> = BTreeMap::new();
    for edge in graph.values().flatten() {
        *ways_in.entry(edge.to).or_default() += 1;
    }
    let mut most: BTreeMap<Place, Option<u64>> = BTreeMap::new();
    if ways_in.contains_key(&Place::Pass(from)) {
        return most;
    }
    let mut open = vec![(from, Some(0))];
    let mut so_far: BTreeMap<Place, Option<u64>> = BTreeMap::new();
    while let Some((id, cycles)) = open.pop() {
        for edge in &graph[&id] {
            let there = cycles
                .zip(edge.cost.max)
                .map(|(a, b): (u64, u64)| a.saturating_add(b));
            let known = so_far.entry(edge.to).or_insert(Some(0));
            *known = known.zip(there).map(|(a, b)| a.max(b));
            let left = ways_in.entry(edge.to).or_default();
            *left -= 1;
            if *left == 0 {
                most.insert(edge.to, *known);
                open.extend(passed(edge.to).map(|id| (id, *known)));
            }
        }
    }
    most
}

/// Whether some path to each place waits.
fn waiting(from: NodeId, graph: &Graph) -> BTreeMap<Place, bool> {
    let mut waiting: BTreeMap<Place, bool> = BTreeMap::new();
    let mut open = vec![(from, false)];
    while let Some((id, waits)) = open.pop() {
        for edge in &graph[&id] {
            let waits = waits || edge.cost.waits;
            let known = waiting.get(&edge.to).copied();
            if known.is_none() || (waits && known == Some(false)) {
                waiting.insert(edge.to, waits);
                open.extend(passed(edge.to).map(|id| (id, waits)));
            }
        }
    }
    waiting
}
