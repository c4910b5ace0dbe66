//! The least and the most cycles from one node of a graph to where paths end.

use super::count::Count;
use std::cell::Cell;
use std::cmp::Reverse;
use std::collections::{BTreeMap, BinaryHeap, VecDeque};
use std::ops::Range;
use tipc::analysis::flow::NodeId;

/// Target of a path.
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
    /// THREADEND.
    ThreadEnd,
}

/// A step of a path: what it costs to be at the next place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Edge {
    pub(super) to: Place,
    pub(super) cost: Count,
}

/// The work that is left: nodes and edges that may still be passed. Once it is used up, nothing more is counted.
#[derive(Debug)]
pub(super) struct Work(Cell<usize>);

impl Work {
    /// Work that every program may take. What honest programs take is far below.
    const LEAST: usize = 1_000_000;

    /// Work for each of its nodes.
    const FOR_NODE: usize = 32;

    /// Returns the work that a program of so many nodes may take.
    pub(super) fn of(nodes: usize) -> Self {
        Work(Cell::new(Work::LEAST + Work::FOR_NODE * nodes))
    }

    /// Takes some of it; `None` if there is not so much left, and nothing then is.
    pub(super) fn take(&self, work: usize) -> Option<()> {
        let left = self.0.get().checked_sub(work);
        self.0.set(left.unwrap_or_default());
        left.map(|_| ())
    }
}

/// The places that paths from one node come to, by numbers of their own: it is 0. One search after the other
/// uses the same memory, and takes no longer than what it comes to.
#[derive(Debug, Default)]
pub(super) struct Search {
    places: Vec<Place>,
    /// The edges that leave each passed place.
    leaving: Vec<Range<usize>>,
    edges: Vec<(usize, Count)>,
    /// The number of each place, and the search that gave it.
    numbers: Vec<(usize, u64)>,
    turn: u64,
}

impl Search {
    /// Returns the cycles from `from` to every place where a path ends. `edges` adds those that leave a node. `None`
    /// if that is more work than is left.
    pub(super) fn ends(
        &mut self,
        from: NodeId,
        work: &Work,
        edges: impl Fn(NodeId, &mut Vec<Edge>) -> Option<()>,
    ) -> Option<BTreeMap<Place, Count>> {
        self.reach(from, work, edges)?;
        let (least, most, waiting) = (self.least(), self.most(), self.waiting());
        let ends = self.places.iter().enumerate();
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

    fn reach(
        &mut self,
        from: NodeId,
        work: &Work,
        edges: impl Fn(NodeId, &mut Vec<Edge>) -> Option<()>,
    ) -> Option<()> {
        self.turn += 1;
        self.places.clear();
        self.leaving.clear();
        self.edges.clear();
        self.number(Place::Pass(from));
        let mut found = Vec::new();
        let mut at = 0;
        while let Some(place) = self.places.get(at) {
            if let Place::Pass(id) = *place {
                edges(id, &mut found)?;
            }
            work.take(1 + found.len())?;
            let first = self.edges.len();
            for edge in found.drain(..) {
                let to = self.number(edge.to);
                self.edges.push((to, edge.cost));
            }
            self.leaving.push(first..self.edges.len());
            at += 1;
        }
        Some(())
    }

    fn number(&mut self, place: Place) -> usize {
        let key = match place {
            Place::Return => 0,
            Place::End => 1,
            Place::ThreadEnd => 2,
            Place::Pass(id) => 3 + 2 * id,
            Place::Stop(id) => 4 + 2 * id,
        };
        if self.numbers.len() <= key {
            self.numbers.resize(key + 1, (0, 0));
        }
        let (number, turn) = &mut self.numbers[key];
        if *turn != self.turn {
            (*number, *turn) = (self.places.len(), self.turn);
            self.places.push(place);
        }
        *number
    }

    fn leaving(&self, number: usize) -> &[(usize, Count)] {
        &self.edges[self.leaving[number].clone()]
    }

    /// Returns the least cycles to each place (Dijkstra).
    fn least(&self) -> Vec<Option<u64>> {
        let mut least = vec![None; self.places.len()];
        let mut is_done = vec![false; self.places.len()];
        let mut open = BinaryHeap::from([Reverse((0_u64, 0))]);
        while let Some(Reverse((cycles, number))) = open.pop() {
            if std::mem::replace(&mut is_done[number], true) {
                continue;
            }
            for (to, cost) in self.leaving(number) {
                let there = cycles.saturating_add(cost.min);
                if least[*to].is_none_or(|known| there < known) {
                    least[*to] = Some(there);
                    open.push(Reverse((there, *to)));
                }
            }
        }
        least
    }

    /// Returns the most cycles to each place, in the order of all paths (Kahn). What a path can circle through
    /// before is never in order: it is absent, or `None`.
    fn most(&self) -> Vec<Option<Option<u64>>> {
        let mut ways_in = vec![0_usize; self.places.len()];
        for (to, _) in &self.edges {
            ways_in[*to] += 1;
        }
        let mut most = vec![None; self.places.len()];
        if ways_in[0] > 0 {
            return most;
        }
        let mut so_far = vec![Some(0); self.places.len()];
        let mut open = vec![0];
        while let Some(number) = open.pop() {
            for (to, cost) in self.leaving(number) {
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

    /// Returns for each place whether some path to it waits.
    fn waiting(&self) -> Vec<bool> {
        let mut known = vec![None; self.places.len()];
        let mut open = VecDeque::from([(0, false)]);
        while let Some((number, waits)) = open.pop_front() {
            for (to, cost) in self.leaving(number) {
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
