//! Searches in graphs: the minimum and maximum number of cycles from a node to the ends of its paths, and strongly
//! connected components.

use super::Count;
use std::cell::Cell;
use std::cmp::Reverse;
use std::collections::{BTreeMap, BinaryHeap, HashMap, VecDeque};
use tipc::analysis::flow::NodeId;

/// Target of a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) enum Place {
    /// To a node, and on from there.
    Pass(NodeId),
    /// To a node where it ends.
    Stop(NodeId),
    /// To the return of the call.
    Return,
    /// To the end of the program.
    End,
    /// THREADEND.
    ThreadEnd,
}

/// An edge of a path, with the cost to reach its target.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Edge {
    pub(super) to: Place,
    pub(super) cost: Count,
}

/// The work that is left: nodes and edges that may still be passed. Once it is used up, nothing more is counted.
#[derive(Debug)]
pub(super) struct Work(Cell<usize>);

impl Work {
    /// Work that every program may take. Real programs need much less.
    const MIN_WORK: usize = 100_000;

    /// Work for each of its nodes.
    const FOR_NODE: usize = 32;

    /// Returns the work that a program of so many nodes may take.
    pub(super) fn of(nodes: usize) -> Self {
        Work::new(Work::MIN_WORK, nodes)
    }

    /// Returns the work of every program, and that for each of its nodes.
    pub(super) fn new(least: usize, nodes: usize) -> Self {
        Work(Cell::new(least + Work::FOR_NODE * nodes))
    }

    /// Takes some work; `None` if less is left, and then nothing is.
    pub(super) fn take(&self, work: usize) -> Option<()> {
        let left = self.0.get().checked_sub(work);
        self.0.set(left.unwrap_or_default());
        left.map(|_| ())
    }
}

/// Returns the cycles from `from` to every place where a path ends. `edges` returns those that leave a node. `None`
/// if that is more work than is left.
pub(super) fn ends(
    from: NodeId,
    work: &Work,
    edges: impl Fn(NodeId) -> Option<Vec<Edge>>,
) -> Option<BTreeMap<Place, Count>> {
    let found = Paths::from(from, work, edges)?;
    let (least, most, waiting) = (found.least(), found.most(), found.waiting());
    let ends = found.places.iter().enumerate();
    let ends = ends.filter(|(_, place)| !matches!(place, Place::Pass(_)));
    let counts = ends.map(|(number, place)| {
        let count = Count {
            min: least[number].unwrap_or_default(),
            max: most[number].flatten(),
            waits: waiting[number],
        };
        (*place, count)
    });
    Some(counts.collect())
}

/// The places that paths from one node reach. Each has a number; that node has 0.
#[derive(Debug)]
struct Paths {
    places: Vec<Place>,
    /// The edges that leave each place.
    leaving: Vec<Vec<(usize, Count)>>,
}

impl Paths {
    fn from(
        from: NodeId,
        work: &Work,
        edges: impl Fn(NodeId) -> Option<Vec<Edge>>,
    ) -> Option<Self> {
        let mut places = vec![Place::Pass(from)];
        let mut numbers = HashMap::from([(Place::Pass(from), 0)]);
        let mut leaving = Vec::new();
        while let Some(place) = places.get(leaving.len()) {
            let found = match *place {
                Place::Pass(id) => edges(id)?,
                _ => Vec::new(),
            };
            work.take(1 + found.len())?;
            let numbered = found.into_iter().map(|edge| {
                let number = *numbers.entry(edge.to).or_insert_with(|| {
                    places.push(edge.to);
                    places.len() - 1
                });
                (number, edge.cost)
            });
            leaving.push(numbered.collect());
        }
        Some(Paths { places, leaving })
    }

    /// Returns the minimum number of cycles to each place (Dijkstra).
    fn least(&self) -> Vec<Option<u64>> {
        let mut least = vec![None; self.places.len()];
        let mut is_done = vec![false; self.places.len()];
        let mut open = BinaryHeap::from([Reverse((0_u64, 0))]);
        while let Some(Reverse((cycles, number))) = open.pop() {
            if std::mem::replace(&mut is_done[number], true) {
                continue;
            }
            for (to, cost) in &self.leaving[number] {
                let there = cycles.saturating_add(cost.min);
                if least[*to].is_none_or(|known| there < known) {
                    least[*to] = Some(there);
                    open.push(Reverse((there, *to)));
                }
            }
        }
        least
    }

    /// Returns the maximum number of cycles to each place, in topological order (Kahn). A place behind a cycle of edges
    /// has no maximum: `Some(None)` or `None`.
    fn most(&self) -> Vec<Option<Option<u64>>> {
        let mut ways_in = vec![0_usize; self.places.len()];
        for (to, _) in self.leaving.iter().flatten() {
            ways_in[*to] += 1;
        }
        let mut most = vec![None; self.places.len()];
        if ways_in[0] > 0 {
            return most;
        }
        let mut so_far = vec![Some(0); self.places.len()];
        let mut open = vec![0];
        while let Some(number) = open.pop() {
            for (to, cost) in &self.leaving[number] {
                let there = so_far[number]
                    .zip(cost.max)
                    .map(|(a, b): (u64, u64)| a.saturating_add(b));
                so_far[*to] = so_far[*to].zip(there).map(|(a, b)| a.max(b));
                ways_in[*to] -= 1;
                if ways_in[*to] == 0 {
                    most[*to] = Some(so_far[*to]);
                    open.push(*to);
                }
            }
        }
        most
    }

    /// Returns true for each place to which some path waits.
    fn waiting(&self) -> Vec<bool> {
        let mut known = vec![None; self.places.len()];
        let mut open = VecDeque::from([(0, false)]);
        while let Some((number, waits)) = open.pop_front() {
            for (to, cost) in &self.leaving[number] {
                let waits = waits || cost.waits;
                if known[*to].is_none() || (waits && known[*to] == Some(false)) {
                    known[*to] = Some(waits);
                    open.push_back((*to, waits));
                }
            }
        }
        known.into_iter().map(|waits| waits == Some(true)).collect()
    }
}

/// Returns the predecessors of each node.
pub(super) fn reversed(next: &[Vec<usize>]) -> Vec<Vec<usize>> {
    let mut before = vec![Vec::new(); next.len()];
    for (id, next) in next.iter().enumerate() {
        for next in next {
            before[*next].push(id);
        }
    }
    before
}

/// Returns the number of the strongly connected component of each node (Kosaraju and Sharir). A component has a lower
/// number than those that it leads to. `before` is the reverse of `next`.
pub(super) fn components(next: &[Vec<usize>], before: &[Vec<usize>]) -> Vec<usize> {
    let mut components = vec![usize::MAX; next.len()];
    for (component, id) in last_first(next).into_iter().enumerate() {
        let mut open = vec![id];
        while let Some(id) = open.pop() {
            if components[id] == usize::MAX {
                components[id] = component;
                open.extend(&before[id]);
            }
        }
    }
    components
}

/// Returns the nodes in reverse postorder of a depth-first search.
fn last_first(next: &[Vec<usize>]) -> Vec<usize> {
    let mut order = Vec::new();
    let mut seen = vec![false; next.len()];
    for id in 0..next.len() {
        let mut open = vec![(id, false)];
        while let Some((id, is_done)) = open.pop() {
            if is_done {
                order.push(id);
            } else if !std::mem::replace(&mut seen[id], true) {
                open.push((id, true));
                open.extend(next[id].iter().map(|next| (*next, false)));
            }
        }
    }
    order.reverse();
    order
}
