//! What the steps of a program cost, and where they lead: calls and counted loops as one edge.

use super::Sampling;
use super::count::Count;
use super::counted::{Counted, counted};
use super::distance::{Edge, Place, distances};
use super::loops::Loops;
use crate::analysis::flow::{Call, Flow, NodeId};
use crate::language::commands;
use crate::program::{Action, Op, Operand, Program};
use std::collections::{BTreeMap, BTreeSet};

/// The flow of a program with its costs.
pub(super) struct Graph<'a> {
    program: &'a Program,
    flow: &'a Flow,
    /// What a node costs by itself.
    costs: Vec<Count>,
    counted: BTreeMap<NodeId, Counted>,
    /// What a call costs from its entry to its return; `None` if it never comes back.
    routines: BTreeMap<NodeId, Option<Count>>,
}

/// Where paths end, apart from the end of their frame.
struct Limits<'a> {
    /// A node that is not passed.
    stops: &'a dyn Fn(NodeId) -> bool,
    /// A counted loop that cannot count as one edge, because paths end inside.
    opens: &'a dyn Fn(&Counted) -> bool,
}

impl<'a> Graph<'a> {
    pub(super) fn new(program: &'a Program, flow: &'a Flow, sampling: Sampling) -> Self {
        let longest = longest_sampling(program, sampling);
        let actions = flow.nodes().iter().map(|node| action(program, node.step));
        let mut graph = Graph {
            program,
            flow,
            costs: actions.map(|action| cost(action, longest)).collect(),
            counted: counted(program, flow),
            routines: flow.calls().map(|call| (call.entry, None)).collect(),
        };
        graph.count_routines();
        graph
    }

    /// Every entry of a call with what it costs.
    pub(super) fn routines(&self) -> impl Iterator<Item = (NodeId, Option<Count>)> {
        self.routines
            .iter()
            .map(|(entry, cycles)| (*entry, *cycles))
    }

    /// The loops, calls passed in one.
    pub(super) fn loops(&self) -> Loops {
        let comes_back = |call: &Call| self.routines[&call.entry].is_some();
        let next = self.flow.nodes().iter().map(|node| {
            let back = node.call.filter(comes_back).map(|call| call.back);
            node.next.iter().copied().chain(back).collect()
        });
        Loops::new(next.collect())
    }

    /// How often a counted loop runs its body that begins here.
    pub(super) fn turns_from(&self, body: NodeId) -> Option<u64> {
        let head = body.checked_sub(1)?;
        self.counted.get(&head).map(|counted| counted.turns)
    }

    /// One turn of the loop `inside`, from `head` until it is reached again.
    pub(super) fn turn(&self, head: NodeId, inside: &BTreeSet<NodeId>) -> Option<Count> {
        let limits = Limits {
            stops: &|id| id == head || !inside.contains(&id),
            opens: &|counted| counted.nodes.contains(&head),
        };
        let found = distances(head, |id| self.edges(id, &limits));
        found.get(&Place::Stop(head)).copied()
    }

    /// From a node to the next ones among `labels`, to the return and to the end.
    pub(super) fn stretches(
        &self,
        from: NodeId,
        labels: &BTreeSet<NodeId>,
    ) -> BTreeMap<Place, Count> {
        let limits = Limits {
            stops: &|id| labels.contains(&id),
            opens: &|counted| labels.range(counted.nodes.clone()).next().is_some(),
        };
        distances(from, |id| self.edges(id, &limits))
    }

    /// Counts the calls, those inside first, until nothing changes.
    fn count_routines(&mut self) {
        let calls = self.calls_of_routines();
        let order = inner_first(&calls);
        let is_recursive = |entry: NodeId| reaches(&calls, entry).contains(&entry);
        let recursive: BTreeSet<NodeId> = order
            .iter()
            .copied()
            .filter(|entry| is_recursive(*entry))
            .collect();
        loop {
            let mut changed = false;
            for entry in &order {
                let mut cycles = self.routine(*entry);
                if recursive.contains(entry) {
                    cycles = cycles.map(Count::unbounded);
                }
                changed |= self.routines.insert(*entry, cycles) != Some(cycles);
            }
            if !changed {
                return;
            }
        }
    }

    fn routine(&self, entry: NodeId) -> Option<Count> {
        let limits = Limits {
            stops: &|_| false,
            opens: &|_| false,
        };
        let found = distances(entry, |id| self.edges(id, &limits));
        found.get(&Place::Return).copied()
    }

    /// The entries that each subroutine calls itself.
    fn calls_of_routines(&self) -> BTreeMap<NodeId, BTreeSet<NodeId>> {
        let of_routine = |entry: &NodeId| {
            let mut called = BTreeSet::new();
            let mut seen = BTreeSet::new();
            let mut open = vec![*entry];
            while let Some(id) = open.pop() {
                if !seen.insert(id) {
                    continue;
                }
                let node = &self.flow.nodes()[id];
                open.extend(node.next.iter());
                open.extend(node.call.map(|call| call.back));
                called.extend(node.call.map(|call| call.entry));
            }
            (*entry, called)
        };
        self.routines.keys().map(of_routine).collect()
    }

    fn edges(&self, id: NodeId, limits: &Limits) -> Vec<Edge> {
        if let Some(counted) = self.counted.get(&id)
            && !(limits.opens)(counted)
        {
            return self.past(id, counted, limits);
        }
        let node = &self.flow.nodes()[id];
        let cost = self.costs[id];
        let mut edges: Vec<Edge> = node
            .next
            .iter()
            .map(|next| Edge {
                to: arrival(*next, limits),
                cost,
            })
            .collect();
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
        if matches!(action(self.program, node.step), Action::Finish(_)) {
            edges.push(Edge {
                to: Place::End,
                cost,
            });
        }
        edges
    }

    /// A counted loop from FOR to where it is left: past NEXT after all its turns, elsewhere in any turn.
    fn past(&self, head: NodeId, counted: &Counted, limits: &Limits) -> Vec<Edge> {
        let inner = Limits {
            stops: &|id| id == counted.next || !counted.nodes.contains(&id),
            opens: &|_| false,
        };
        let body = counted.nodes.start;
        let mut found = match body == counted.next {
            true => BTreeMap::from([(Place::Stop(body), Count::exactly(0))]),
            false => distances(body, |id| self.edges(id, &inner)),
        };
        let to_next = found.remove(&Place::Stop(counted.next));
        let turn = to_next.map(|to_next| to_next.then(self.costs[counted.next]));
        let before = self.costs[head];
        let mut edges = Vec::new();
        if let Some(turn) = turn {
            edges.push(Edge {
                to: arrival(counted.exit, limits),
                cost: before.then(turn.times(counted.turns)),
            });
        }
        let earlier = turn.map_or(Count::exactly(0), |turn| turn.at_most(counted.turns - 1));
        for (place, cycles) in found {
            let to = match place {
                Place::Stop(outside) => arrival(outside, limits),
                Place::Return | Place::End => place,
                Place::Pass(_) => continue,
            };
            edges.push(Edge {
                to,
                cost: before.then(earlier).then(cycles),
            });
        }
        edges
    }
}

fn arrival(id: NodeId, limits: &Limits) -> Place {
    match (limits.stops)(id) {
        true => Place::Stop(id),
        false => Place::Pass(id),
    }
}

/// Every subroutine after those that it calls, as far as they do not call each other.
fn inner_first(calls: &BTreeMap<NodeId, BTreeSet<NodeId>>) -> Vec<NodeId> {
    let mut order = Vec::new();
    let mut seen = BTreeSet::new();
    for entry in calls.keys() {
        let mut open = vec![(*entry, false)];
        while let Some((entry, is_done)) = open.pop() {
            if is_done {
                order.push(entry);
            } else if seen.insert(entry) {
                open.push((entry, true));
                open.extend(calls[&entry].iter().map(|called| (*called, false)));
            }
        }
    }
    order
}

/// The subroutines that one calls, at any depth.
fn reaches(calls: &BTreeMap<NodeId, BTreeSet<NodeId>>, entry: NodeId) -> BTreeSet<NodeId> {
    let mut reached = BTreeSet::new();
    let mut open = vec![entry];
    while let Some(entry) = open.pop() {
        for called in &calls[&entry] {
            if reached.insert(*called) {
                open.push(*called);
            }
        }
    }
    reached
}

fn action(program: &Program, step: u32) -> &Action {
    &program.steps()[step as usize].action
}

/// What a step costs by itself: one cycle, or the least of a step that waits.
fn cost(action: &Action, longest_sampling: f64) -> Count {
    let least = match action {
        Action::KeyIn { .. } => 1,
        Action::Command { op, arguments, .. } if commands::waits(*op) => {
            match (op, arguments.first().map(|argument| argument.operand)) {
                (Op::Sleep, Some(Operand::Constant(ms))) => slept(ms, longest_sampling),
                _ => 1,
            }
        }
        Action::Command { .. }
        | Action::Nothing
        | Action::SetScalar { .. }
        | Action::SetStruct { .. }
        | Action::If { .. }
        | Action::ElseIf { .. }
        | Action::Else { .. }
        | Action::While { .. }
        | Action::Goto { .. }
        | Action::Until { .. }
        | Action::For { .. }
        | Action::Next { .. }
        | Action::IfGoto { .. }
        | Action::Gosub { .. }
        | Action::IfGosub { .. }
        | Action::Return
        | Action::Finish(_)
        | Action::TeachStruct { .. }
        | Action::TeachScalar { .. }
        | Action::AdIn { .. }
        | Action::Message { .. } => return Count::exactly(1),
    };
    Count {
        waits: true,
        ..Count::exactly(least)
    }
}

/// The cycles of SLEEP (clause 2.19).
fn slept(ms: f64, sampling: f64) -> u64 {
    // Out of range saturates; a negative time fails when it runs.
    ((ms / sampling - 1e-9).ceil() as u64).max(1)
}

/// The longest sampling time that may be in force.
fn longest_sampling(program: &Program, sampling: Sampling) -> f64 {
    let set = program
        .steps()
        .iter()
        .filter_map(|step| match &step.action {
            Action::Command {
                op: op @ (Op::SetSamplingTime | Op::SetSamplingFreq),
                arguments,
                ..
            } => Some((*op, arguments.first()?.operand)),
            _ => None,
        });
    let times = set.map(|(op, operand)| match (op, operand) {
        (Op::SetSamplingTime, Operand::Constant(ms)) => ms,
        (Op::SetSamplingFreq, Operand::Constant(hz)) if hz > 0.0 => 1000.0 / hz,
        _ => sampling.longest,
    });
    times
        .fold(sampling.standard, f64::max)
        .min(sampling.longest)
}
