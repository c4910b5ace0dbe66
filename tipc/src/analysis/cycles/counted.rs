//! FOR loops whose number of turns is known: constants, and a body that leaves the counting alone.

use crate::analysis::access;
use crate::analysis::flow::{Flow, NodeId};
use crate::program::{Action, Operand, Program, StepId};
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

/// The most turns that are counted. At 20 ms they take more than five hours.
const TURNS: u64 = 1_000_000;

/// How deep counted loops nest. Those inside count as loops without a bound.
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
    /// How often the body runs.
    pub(super) turns: u64,
}

/// The counted loops of a program by the nodes of their FORs.
pub(super) fn counted(program: &Program, flow: &Flow) -> BTreeMap<NodeId, Counted> {
    let before = flow.before();
    let entries: BTreeSet<NodeId> = flow.calls().map(|call| call.entry).collect();
    let nodes = flow.nodes().iter().enumerate();
    let mut all: BTreeMap<NodeId, Counted> = nodes
        .filter_map(|(head, node)| {
            let counted = candidate(program, flow, node.step)?;
            let is_entered = counted.nodes.clone().any(|id| {
                let outside = |from: &NodeId| !counted.nodes.contains(from) && *from != head;
                before[id].iter().any(outside)
            });
            let is_called = entries.range(counted.nodes.clone()).next().is_some();
            let meddles = sets_counter(program, flow, head, &counted);
            (!is_entered && !is_called && !meddles).then_some((head, counted))
        })
        .collect();
    let mut around: Vec<NodeId> = Vec::new();
    all.retain(|_, one| {
        around.retain(|end| *end >= one.nodes.end);
        around.push(one.nodes.end);
        around.len() <= DEPTH
    });
    all
}

/// A FOR over constants that is entered.
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

/// How often FOR's body runs; `None` if never, or too often to count.
fn turns(from: f64, to: f64, by: f64) -> Option<u64> {
    let goes_on = |value: f64| {
        if by > 0.0 {
            value <= to
        } else {
            by < 0.0 && value >= to
        }
    };
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

/// Whether the body, or what it calls, assigns the loop's variable.
fn sets_counter(program: &Program, flow: &Flow, head: NodeId, counted: &Counted) -> bool {
    let assigned = |id: NodeId| {
        let step = flow.nodes()[id].step;
        access::assigns(program, &program.steps()[step as usize].action)
    };
    let counter = assigned(head);
    let mut seen = BTreeSet::new();
    let mut open: Vec<NodeId> = Vec::new();
    for id in counted.nodes.clone() {
        if id != counted.next && assigned(id).any(|scalar| counter.contains(&scalar)) {
            return true;
        }
        open.extend(flow.nodes()[id].call.map(|call| call.entry));
    }
    while let Some(id) = open.pop() {
        if !seen.insert(id) {
            continue;
        }
        if assigned(id).any(|scalar| counter.contains(&scalar)) {
            return true;
        }
        let node = &flow.nodes()[id];
        open.extend(node.next.iter().copied());
        open.extend(node.call.iter().flat_map(|call| [call.entry, call.back]));
    }
    false
}
