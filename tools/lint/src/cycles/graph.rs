//! Costs of a program's steps, and edges between them: calls and loops inside as one edge.

use super::Sampling;
use super::costs::{cost, longest_sampling};
use super::count::Count;
use super::counted::{Counted, counted};
use super::distance::{Edge, Place, Search, Work};
use super::loops::Loops;
use super::routines::Calls;
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use tipc::analysis::flow::{Call, Flow, NodeId};
use tipc::program::{Action, Program};

/// The flow of a program with its costs.
pub(super) struct Graph<'a> {
    program: &'a Program,
    flow: &'a Flow,
    /// Cost of each node by itself.
    costs: Vec<Count>,
    counted: BTreeMap<NodeId, Counted>,
    /// Cost of a call from its entry to its return; `None` if it never comes back.
    routines: BTreeMap<NodeId, Option<Count>>,
    /// Cost of a counted loop from its FOR to where it is left, once all calls are counted.
    passed: RefCell<BTreeMap<NodeId, Vec<Edge>>>,
    searches: RefCell<Vec<Search>>,
}

/// Ends of paths, besides the end of their frame, and parts that count as one edge.
pub(super) struct Limits<'a> {
    /// A node that is not passed.
    pub(super) stops: &'a dyn Fn(NodeId) -> bool,
    /// A counted loop that cannot count as one edge, because paths end inside.
    pub(super) opens: &'a dyn Fn(&Counted) -> bool,
    /// Returns the cost to leave the loop that begins at a node, if that counts as one edge.
    pub(super) closed: &'a dyn Fn(NodeId) -> Option<&'a [Edge]>,
}

impl<'a> Graph<'a> {
    /// Returns the graph of a program; `None` if its calls are too entangled to be counted.
    pub(super) fn new(program: &'a Program, flow: &'a Flow, sampling: Sampling) -> Option<Self> {
        let longest = longest_sampling(program, sampling);
        let actions = flow.nodes().iter().map(|node| action(program, node.step));
        let mut graph = Graph {
            program,
            flow,
            costs: actions.map(|action| cost(action, longest)).collect(),
            counted: counted(program, flow),
            routines: flow.calls().map(|call| (call.entry, None)).collect(),
            passed: RefCell::default(),
            searches: RefCell::default(),
        };
        graph.count_routines(&Work::of(flow.nodes().len()))?;
        Some(graph)
    }

    /// Returns every entry of a call with what it costs.
    pub(super) fn routines(&self) -> impl Iterator<Item = (NodeId, Option<Count>)> {
        self.routines
            .iter()
            .map(|(entry, cycles)| (*entry, *cycles))
    }

    /// Returns the loops, calls passed in one.
    pub(super) fn loops(&self) -> Loops {
        let comes_back = |call: &Call| self.routines[&call.entry].is_some();
        let next = self.flow.nodes().iter().map(|node| {
            let back = node.call.filter(comes_back).map(|call| call.back);
            node.next.iter().copied().chain(back).collect()
        });
        let entries = self.routines.keys().copied();
        Loops::new(
            next.collect(),
            entries.chain(self.flow.starts().iter().copied()),
        )
    }

    /// Returns the number of runs of the body, which begins here, of a counted loop.
    pub(super) fn turns_from(&self, body: NodeId) -> Option<u64> {
        let head = body.checked_sub(1)?;
        self.counted.get(&head).map(|counted| counted.turns)
    }

    /// Returns the paths from a node to where paths end; `None` if that is more work than is left.
    pub(super) fn ends(
        &self,
        from: NodeId,
        limits: &Limits,
        work: &Work,
    ) -> Option<BTreeMap<Place, Count>> {
        let mut search = self.searches.borrow_mut().pop().unwrap_or_default();
        let found = search.ends(from, work, |id, edges| self.edges(id, limits, work, edges));
        self.searches.borrow_mut().push(search);
        found
    }

    /// Returns the stretches from a node to the next ones among `labels`, to the return and to the end; `None` if that
    /// is more work than is left.
    pub(super) fn stretches(
        &self,
        from: NodeId,
        labels: &BTreeSet<NodeId>,
        work: &Work,
    ) -> Option<BTreeMap<Place, Count>> {
        let limits = Limits {
            stops: &|id| labels.contains(&id),
            opens: &|counted| labels.range(counted.nodes.clone()).next().is_some(),
            closed: &|_| None,
        };
        self.ends(from, &limits, work)
    }

    /// Counts the calls, those inside first, and those again that something changes for.
    fn count_routines(&mut self, work: &Work) -> Option<()> {
        let calls = Calls::new(self.flow, work)?;
        let mut open: BTreeSet<usize> = (0..calls.count()).collect();
        while let Some(place) = open.pop_first() {
            let entry = calls.entry(place);
            let mut cycles = self.routine(entry, work)?;
            if calls.is_recursive(place) {
                cycles = cycles.map(Count::unbounded);
            }
            self.passed.borrow_mut().clear();
            if self.routines.insert(entry, cycles) != Some(cycles) {
                open.extend(calls.callers(place));
            }
        }
        Some(())
    }

    fn routine(&self, entry: NodeId, work: &Work) -> Option<Option<Count>> {
        let limits = Limits {
            stops: &|_| false,
            opens: &|_| false,
            closed: &|_| None,
        };
        let ends = self.ends(entry, &limits, work)?;
        Some(ends.get(&Place::Return).copied())
    }

    fn edges(&self, id: NodeId, limits: &Limits, work: &Work, edges: &mut Vec<Edge>) -> Option<()> {
        let onward = |edge: &Edge| Edge {
            to: match edge.to {
                Place::Stop(outside) => arrival(outside, limits),
                place => place,
            },
            ..*edge
        };
        if let Some(left) = (limits.closed)(id) {
            edges.extend(left.iter().map(onward));
            return Some(());
        }
        if let Some(counted) = self.counted.get(&id)
            && !(limits.opens)(counted)
        {
            if !self.passed.borrow().contains_key(&id) {
                let left = self.past(id, counted, work)?;
                self.passed.borrow_mut().insert(id, left);
            }
            edges.extend(self.passed.borrow()[&id].iter().map(onward));
            return Some(());
        }
        let node = &self.flow.nodes()[id];
        let cost = self.costs[id];
        edges.extend(node.next.iter().map(|next| Edge {
            to: arrival(*next, limits),
            cost,
        }));
        if let Some(call) = node.call
            && let Some(inner) = self.routines[&call.entry]
        {
            edges.push(Edge {
                to: arrival(call.back, limits),
                cost: cost.then(inner),
            });
        }
        if node.returns {
            edges.push(Edge {
                to: Place::Return,
                cost,
            });
        }
        let end = match action(self.program, node.step) {
            Action::Finish(_) => Some(Place::End),
            Action::ThreadEnd => Some(Place::ThreadEnd),
            _ => None,
        };
        edges.extend(end.map(|to| Edge { to, cost }));
        Some(())
    }

    /// Returns a counted loop from FOR to where it is left: past NEXT after all its turns, elsewhere in any turn.
    fn past(&self, head: NodeId, counted: &Counted, work: &Work) -> Option<Vec<Edge>> {
        let inner = Limits {
            stops: &|id| id == counted.next || !counted.nodes.contains(&id),
            opens: &|_| false,
            closed: &|_| None,
        };
        let body = counted.nodes.start;
        let mut found = match body == counted.next {
            true => BTreeMap::from([(Place::Stop(body), Count::exactly(0))]),
            false => self.ends(body, &inner, work)?,
        };
        let to_next = found.remove(&Place::Stop(counted.next));
        let turn = to_next.map(|to_next| to_next.then(self.costs[counted.next]));
        let before = self.costs[head];
        let mut edges = Vec::new();
        if let Some(turn) = turn {
            edges.push(Edge {
                to: Place::Stop(counted.exit),
                cost: before.then(turn.times(counted.turns)),
            });
        }
        let earlier = turn.map_or(Count::exactly(0), |turn| turn.at_most(counted.turns - 1));
        edges.extend(found.into_iter().map(|(to, cycles)| Edge {
            to,
            cost: before.then(earlier).then(cycles),
        }));
        Some(edges)
    }
}

fn arrival(id: NodeId, limits: &Limits) -> Place {
    match (limits.stops)(id) {
        true => Place::Stop(id),
        false => Place::Pass(id),
    }
}

fn action(program: &Program, step: u32) -> &Action {
    &program.steps()[step as usize].action
}
