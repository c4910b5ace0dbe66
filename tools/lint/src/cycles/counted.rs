//! FOR loops with a known number of turns: over constants, with a body that does not change the counter.

use super::search::Work;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use tipc::analysis::access;
use tipc::analysis::flow::{Flow, NodeId};
use tipc::program::{Action, Operand, Program, StepId};

/// Maximum number of turns that are counted. At 20 ms they take more than five hours.
const MAX_TURNS: u64 = 1_000_000;

/// Maximum nesting depth of counted loops. Those inside count as loops without a bound.
const DEPTH: usize = 32;

/// A loop with a known number of turns, unless a jump leaves it earlier.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Counted {
    /// Its body, whose last node is NEXT.
    pub(super) nodes: Range<NodeId>,
    /// Number of runs of the body.
    pub(super) turns: u64,
}

impl Counted {
    /// Returns NEXT.
    pub(super) fn next(&self) -> NodeId {
        self.nodes.end - 1
    }
}

/// Returns the counted loops of a program by the nodes of their FORs. Some of very many nested loops may be missing,
/// since the work is bounded.
pub(super) fn counted(program: &Program, flow: &Flow) -> BTreeMap<NodeId, Counted> {
    let work = Work::of(flow.nodes().len());
    let additions = Work::new(MAX_TURNS as usize, flow.nodes().len());
    let before = flow.before();
    let entries: BTreeSet<NodeId> = flow.calls().map(|call| call.entry).collect();
    // A jump or call from elsewhere leads into the body.
    let is_entered = |head: NodeId, body: &Range<NodeId>| {
        let is_outside = |from: &NodeId| *from != head && !body.contains(from);
        let is_called = entries.range(body.clone()).next().is_some();
        is_called || before[body.clone()].iter().flatten().any(is_outside)
    };
    let mut assignments = Assignments {
        program,
        flow,
        called: BTreeMap::new(),
        shared: BTreeSet::new(),
    };
    assignments.find_shared();
    let mut all = BTreeMap::new();
    for (head, node) in flow.nodes().iter().enumerate() {
        if let Some(one) = candidate(program, flow, node.step, &additions)
            && work.take(one.nodes.len()).is_some()
            && !is_entered(head, &one.nodes)
            && !assignments.set_counter(head, &one, &work)
        {
            all.insert(head, one);
        }
    }
    let mut around: Vec<NodeId> = Vec::new();
    all.retain(|_, one: &mut Counted| {
        while around.pop_if(|end| *end < one.nodes.end).is_some() {}
        around.push(one.nodes.end);
        around.len() <= DEPTH
    });
    all
}

/// Returns the loop of a FOR over constants that is entered.
fn candidate(program: &Program, flow: &Flow, step: StepId, additions: &Work) -> Option<Counted> {
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
        turns: turns([from, to, by], additions)?,
    })
}

/// Returns the number of turns of a FOR; `None` if there is none, or too many to count. Fractions are added one by one,
/// so that the sums are rounded as in the running loop.
fn turns([from, to, by]: [f64; 3], additions: &Work) -> Option<u64> {
    let goes_on = |value: f64| {
        if by > 0.0 {
            value <= to
        } else {
            by < 0.0 && value >= to
        }
    };
    if [from, to, by].iter().all(|number| is_whole(*number)) && goes_on(from) {
        let turns = ((to - from) / by).floor() + 1.0;
        return (turns <= MAX_TURNS as f64).then_some(turns as u64);
    }
    let mut value = from;
    let mut turns = 0;
    while goes_on(value) {
        additions.take(1)?;
        value += by;
        turns += 1;
        if turns > MAX_TURNS || !value.is_finite() {
            return None;
        }
    }
    (turns > 0).then_some(turns)
}

/// Returns true if sums of a few million such numbers are exact.
fn is_whole(number: f64) -> bool {
    number.fract() == 0.0 && number.abs() < 1e9
}

/// Assignments of scalars, direct or in what is called.
struct Assignments<'a> {
    program: &'a Program,
    flow: &'a Flow,
    /// The scalars that a call of a routine may assign; `None` if that was more work than was left.
    called: BTreeMap<NodeId, Option<BTreeSet<usize>>>,
    /// The scalars that more than one of the main program and the threads may assign.
    shared: BTreeSet<usize>,
}

impl Assignments<'_> {
    /// Finds the scalars that are shared. Their number is small, and so is that of threads.
    fn find_shared(&mut self) {
        let mut own = BTreeSet::new();
        let starts = self.flow.starts().iter();
        for start in starts.filter(|_| self.flow.starts().len() > 1) {
            let work = Work::of(self.flow.nodes().len());
            let assigned = self.assigned_in(*start, &work).unwrap_or_default();
            let again = assigned.into_iter().filter(|scalar| !own.insert(*scalar));
            self.shared.extend(again);
        }
    }

    /// Returns true if the body of a loop, what it calls, or another thread may assign the counter.
    fn set_counter(&mut self, head: NodeId, one: &Counted, work: &Work) -> bool {
        let counter = self.assigned(head).start;
        if self.shared.contains(&counter) {
            return true;
        }
        (one.nodes.start..one.next()).any(|id| {
            let call = self.flow.nodes()[id].call;
            self.assigned(id).contains(&counter)
                || call.is_some_and(|call| self.call_sets(call.entry, counter, work))
        })
    }

    fn call_sets(&mut self, entry: NodeId, scalar: usize, work: &Work) -> bool {
        if !self.called.contains_key(&entry) {
            let assigned = self.assigned_in(entry, work);
            self.called.insert(entry, assigned);
        }
        let assigned = self.called[&entry].as_ref();
        assigned.is_none_or(|assigned| assigned.contains(&scalar))
    }

    fn assigned_in(&self, entry: NodeId, work: &Work) -> Option<BTreeSet<usize>> {
        let mut assigned = BTreeSet::new();
        let mut seen = BTreeSet::new();
        let mut open = vec![entry];
        while let Some(id) = open.pop() {
            if seen.insert(id) {
                work.take(1)?;
                assigned.extend(self.assigned(id));
                let node = &self.flow.nodes()[id];
                let called = node.call.iter().flat_map(|call| [call.entry, call.back]);
                open.extend(node.next.iter().copied().chain(called));
            }
        }
        Some(assigned)
    }

    fn assigned(&self, id: NodeId) -> Range<usize> {
        let step = self.flow.nodes()[id].step;
        access::assigns(self.program, &self.program.steps()[step as usize].action)
    }
}
