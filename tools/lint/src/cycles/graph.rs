//! Costs of a program's steps, and edges between them. A call or a counted loop is one edge.

use super::counted::{Counted, counted};
use super::search::{Edge, Place, Work, components, ends, reversed};
use super::{Count, Sampling};
use std::cell::RefCell;
use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};
use tipc::analysis::flow::{Call, Flow, NodeId};
use tipc::language::commands;
use tipc::program::{Action, Op, Operand, Program};

/// The flow of a program with its costs.
pub(super) struct Graph<'a> {
    program: &'a Program,
    flow: &'a Flow,
    /// Cost of each node by itself.
    costs: Vec<Count>,
    counted: BTreeMap<NodeId, Counted>,
    /// Cost of a call from its entry to its return; `None` if it never comes back.
    routines: BTreeMap<NodeId, Option<Count>>,
    /// The edges of each counted loop from its FOR to its exits. They are known once all calls are counted.
    passed: RefCell<BTreeMap<NodeId, Vec<Edge>>>,
}

/// Conditions that end paths, besides the end of their routine.
pub(super) struct Limits<'a> {
    /// Returns true for a node at which paths end.
    pub(super) stops: &'a dyn Fn(NodeId) -> bool,
    /// Returns true for a counted loop that cannot be one edge, because paths end inside.
    pub(super) opens: &'a dyn Fn(&Counted) -> bool,
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
        };
        graph.count_routines(&Work::of(flow.nodes().len()))?;
        Some(graph)
    }

    pub(super) fn routines(&self) -> impl Iterator<Item = (NodeId, Option<Count>)> {
        self.routines
            .iter()
            .map(|(entry, cycles)| (*entry, *cycles))
    }

    /// Returns the successors of each node in its own routine. A call is followed by the node to which it returns.
    pub(super) fn next(&self) -> Vec<Vec<NodeId>> {
        let comes_back = |call: &Call| self.routines[&call.entry].is_some();
        let next = self.flow.nodes().iter().map(|node| {
            let back = node.call.filter(comes_back).map(|call| call.back);
            node.next.iter().copied().chain(back).collect()
        });
        next.collect()
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
        ends(from, work, |id| self.edges(id, limits, work))
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
        };
        self.ends(from, &limits, work)
    }

    /// Counts the calls, inner ones first, and repeats those whose inner calls have changed.
    fn count_routines(&mut self, work: &Work) -> Option<()> {
        let entries: Vec<NodeId> = self.routines.keys().copied().collect();
        let called = called(self.flow, &entries, work)?;
        let callers = reversed(&called);
        let components = components(&called, &callers);
        let place = |routine: usize| (Reverse(components[routine]), routine);
        let mut open: BTreeSet<_> = (0..entries.len()).map(place).collect();
        while let Some((_, routine)) = open.pop_first() {
            let entry = entries[routine];
            let mut cycles = self.routine(entry, work)?;
            let mut calls = called[routine].iter();
            if calls.any(|inner| components[*inner] == components[routine]) {
                cycles = cycles.map(Count::unbounded);
            }
            self.passed.borrow_mut().clear();
            if self.routines.insert(entry, cycles) != Some(cycles) {
                open.extend(callers[routine].iter().map(|caller| place(*caller)));
            }
        }
        Some(())
    }

    fn routine(&self, entry: NodeId, work: &Work) -> Option<Option<Count>> {
        let limits = Limits {
            stops: &|_| false,
            opens: &|_| false,
        };
        let ends = self.ends(entry, &limits, work)?;
        Some(ends.get(&Place::Return).copied())
    }

    /// Returns the edges that leave a node; `None` if that is more work than is left.
    fn edges(&self, id: NodeId, limits: &Limits, work: &Work) -> Option<Vec<Edge>> {
        let arrival = |id: NodeId| match (limits.stops)(id) {
            true => Place::Stop(id),
            false => Place::Pass(id),
        };
        if let Some(counted) = self.counted.get(&id)
            && !(limits.opens)(counted)
        {
            if !self.passed.borrow().contains_key(&id) {
                let left = self.past(id, counted, work)?;
                self.passed.borrow_mut().insert(id, left);
            }
            let onward = |edge: &Edge| Edge {
                to: match edge.to {
                    Place::Stop(outside) => arrival(outside),
                    place => place,
                },
                ..*edge
            };
            return Some(self.passed.borrow()[&id].iter().map(onward).collect());
        }
        let node = &self.flow.nodes()[id];
        let cost = self.costs[id];
        let next = node.next.iter().map(|next| Edge {
            to: arrival(*next),
            cost,
        });
        let call = node.call.and_then(|call| {
            let inner = self.routines[&call.entry]?;
            Some(Edge {
                to: arrival(call.back),
                cost: cost.then(inner),
            })
        });
        let end = match action(self.program, node.step) {
            Action::Return => Some(Place::Return),
            Action::Finish(_) => Some(Place::End),
            Action::ThreadEnd => Some(Place::ThreadEnd),
            _ => None,
        };
        let end = end.map(|to| Edge { to, cost });
        Some(next.chain(call).chain(end).collect())
    }

    /// Returns the edges of a counted loop from its FOR to its exits: past NEXT after all turns, elsewhere in any turn.
    fn past(&self, head: NodeId, counted: &Counted, work: &Work) -> Option<Vec<Edge>> {
        let (body, next) = (counted.nodes.start, counted.next());
        let inner = Limits {
            stops: &|id| id == next || !counted.nodes.contains(&id),
            opens: &|_| false,
        };
        let mut found = match body == next {
            true => BTreeMap::from([(Place::Stop(body), Count::exactly(0))]),
            false => self.ends(body, &inner, work)?,
        };
        let to_next = found.remove(&Place::Stop(next));
        let turn = to_next.map(|to_next| to_next.then(self.costs[next]));
        let before = self.costs[head];
        let mut edges = Vec::new();
        if let Some(turn) = turn {
            edges.push(Edge {
                to: Place::Stop(counted.nodes.end),
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

fn action(program: &Program, step: u32) -> &Action {
    &program.steps()[step as usize].action
}

/// Returns for each routine the indices of those that it calls itself; `None` if they share more steps than there is
/// work left for.
fn called(flow: &Flow, entries: &[NodeId], work: &Work) -> Option<Vec<Vec<usize>>> {
    let mut seen = vec![NodeId::MAX; flow.nodes().len()];
    let called = entries.iter().map(|entry| {
        let mut called = BTreeSet::new();
        let mut open = vec![*entry];
        while let Some(id) = open.pop() {
            if std::mem::replace(&mut seen[id], *entry) == *entry {
                continue;
            }
            work.take(1)?;
            let node = &flow.nodes()[id];
            open.extend(node.next.iter());
            open.extend(node.call.map(|call| call.back));
            called.extend(
                node.call
                    .and_then(|call| entries.binary_search(&call.entry).ok()),
            );
        }
        Some(called.into_iter().collect())
    });
    called.collect()
}

/// Returns the cost of a single step: one cycle, or the least of a step that waits.
fn cost(action: &Action, longest_sampling: f64) -> Count {
    let least = match action {
        Action::KeyIn { .. } | Action::WaitThread { .. } => 1,
        Action::Command { op, arguments, .. } if commands::waits(*op) => {
            match (op, arguments.first().map(|argument| argument.operand)) {
                (Op::Sleep, Some(Operand::Constant(ms))) => slept(ms, longest_sampling),
                _ => 1,
            }
        }
        _ => return Count::exactly(1),
    };
    Count {
        waits: true,
        ..Count::exactly(least)
    }
}

/// Returns the cycles of SLEEP (clause 2.19).
fn slept(ms: f64, sampling: f64) -> u64 {
    // The conversion saturates. A negative time fails at runtime.
    ((ms / sampling - 1e-9).ceil() as u64).max(1)
}

fn longest_sampling(program: &Program, sampling: Sampling) -> f64 {
    let times = program.steps().iter().filter_map(|step| {
        let Action::Command { op, arguments, .. } = &step.action else {
            return None;
        };
        let operand = arguments.first().map(|argument| argument.operand);
        match (op, operand?) {
            (Op::SetSamplingTime, Operand::Constant(ms)) => Some(ms),
            (Op::SetSamplingFreq, Operand::Constant(hz)) if hz > 0.0 => Some(1000.0 / hz),
            (Op::SetSamplingTime | Op::SetSamplingFreq, _) => Some(sampling.longest),
            _ => None,
        }
    });
    times
        .fold(sampling.standard, f64::max)
        .min(sampling.longest)
}
