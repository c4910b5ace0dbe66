//! FOR loops whose number of turns is known: constants, and a body that leaves the counting alone.

use super::counters::Counters;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use tipc::analysis::flow::{Flow, NodeId};
use tipc::program::{Action, Operand, Program, StepId};

/// The most turns that are counted. At 20 ms they take more than five hours.
const TURNS: u64 = 1_000_000;

/// Maximum nesting depth of counted loops. Those inside count as loops without a bound.
const DEPTH: usize = 32;

/// A loop that turns a known number of times, unless something leaves it before.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Counted {
    /// Its body, NEXT included.
    pub(super) nodes: Range<NodeId>,
    /// NEXT, the last node of the body.
    pub(super) next: NodeId,
    /// After NEXT.
    pub(super) exit: NodeId,
    /// Number of runs of the body.
    pub(super) turns: u64,
}

/// Returns the counted loops of a program by the nodes of their FORs. Takes time O(n log n).
pub(super) fn counted(program: &Program, flow: &Flow) -> BTreeMap<NodeId, Counted> {
    let nodes = flow.nodes().iter().enumerate();
    let mut all: BTreeMap<NodeId, Counted> = nodes
        .filter_map(|(head, node)| Some((head, candidate(program, flow, node.step)?)))
        .collect();
    let entries: BTreeSet<NodeId> = flow.calls().map(|call| call.entry).collect();
    let bodies = all
        .iter()
        .map(|(head, counted)| (*head, counted.nodes.start..counted.next));
    let bodies: BTreeMap<_, _> = bodies.collect();
    let counters = Counters::new(program, flow, &bodies);
    let entered = entered(flow, &all);
    all.retain(|head, counted| {
        let is_called = entries.range(counted.nodes.clone()).next().is_some();
        !is_called && !entered.contains(head) && !counters.are_set_in(*head, &bodies[head])
    });
    let mut around: Vec<NodeId> = Vec::new();
    all.retain(|_, one| {
        while around.pop_if(|end| *end < one.nodes.end).is_some() {}
        around.push(one.nodes.end);
        around.len() <= DEPTH
    });
    all
}

/// Returns the FORs whose bodies something else leads into. Bodies nest: what leads into one leads into those around
/// it, unless it comes from there.
fn entered(flow: &Flow, all: &BTreeMap<NodeId, Counted>) -> BTreeSet<NodeId> {
    let mut entered = BTreeSet::new();
    let mut open: Vec<(NodeId, Range<NodeId>)> = Vec::new();
    let mut close = |open: &mut Vec<(NodeId, Range<NodeId>)>, id: NodeId| {
        while let Some((head, from)) = open.pop_if(|(head, _)| all[head].nodes.end <= id) {
            let nodes = &all[&head].nodes;
            if from.start < nodes.start || from.end > nodes.end {
                entered.insert(head);
            }
            if let Some((_, around)) = open.last_mut() {
                *around = around.start.min(from.start)..around.end.max(from.end);
            }
        }
    };
    for (id, before) in flow.before().iter().enumerate() {
        close(&mut open, id);
        let head = id.checked_sub(1).filter(|head| all.contains_key(head));
        if let Some(head) = head {
            open.push((head, id..id));
        }
        let Some((_, from)) = open.last_mut() else {
            continue;
        };
        for before in before.iter().filter(|before| Some(**before) != head) {
            *from = from.start.min(*before)..from.end.max(before + 1);
        }
    }
    close(&mut open, NodeId::MAX);
    entered
}

/// Returns the loop of a FOR over constants that is entered.
fn candidate(program: &Program, flow: &Flow, step: StepId) -> Option<Counted> {
    let Action::For {
        from: Operand::Constant(from),
        to: Operand::Constant(to),
        step: Operand::Constant(by),
        exit,
        ..
    } = program.steps()[step as usize].action
    else {
        return None;
    };
    Some(Counted {
        nodes: flow.first(step + 1)..flow.first(exit),
        next: flow.first(exit - 1),
        exit: flow.first(exit),
        turns: turns(from, to, by)?,
    })
}

/// Returns the number of runs of FOR's body; `None` if never, or too often to count.
fn turns(from: f64, to: f64, by: f64) -> Option<u64> {
    let goes_on = |value: f64| {
        if by > 0.0 {
            value <= to
        } else {
            by < 0.0 && value >= to
        }
    };
    if [from, to, by].iter().all(|number| is_whole(*number)) && goes_on(from) {
        let turns = ((to - from) / by).floor() + 1.0;
        return (turns <= TURNS as f64).then_some(turns as u64);
    }
    let mut value = from;
    let mut turns = 0;
    while goes_on(value) {
        value += by;
        turns += 1;
        if turns > TURNS || !value.is_finite() {
            return None;
        }
    }
    (turns > 0).then_some(turns)
}

/// Returns true if sums of a few million such numbers are exact.
fn is_whole(number: f64) -> bool {
    number.fract() == 0.0 && number.abs() < 1e9
}
