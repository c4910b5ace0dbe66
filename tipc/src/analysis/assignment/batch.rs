//! The data flow for as many variables as one machine word has room for.

use super::worklist::{Order, Worklist};
use super::{Assigned, Read};
use crate::analysis::access;
use crate::analysis::flow::{Flow, NodeId};
use crate::program::{Program, Variable};
use std::ops::Range;

/// A set of the scalars of a batch, one bit each.
type Scalars = u64;

/// The scalars of a program in runs that fit a word; a variable is in one run.
pub(super) fn all(program: &Program) -> impl Iterator<Item = Range<usize>> {
    let mut variables = program.variables().iter().peekable();
    std::iter::from_fn(move || {
        let first = variables.peek()?.first;
        let fits = |variable: &&Variable| variable.first + variable.size() - first <= 64;
        let mut end = first;
        while let Some(variable) = variables.next_if(fits) {
            end = variable.first + variable.size();
        }
        Some(first..end)
    })
}

/// What the nodes of a flow do with some scalars.
pub(super) struct Batch<'a> {
    flow: &'a Flow,
    scalars: Range<usize>,
    /// What each node reads.
    read: Vec<Scalars>,
    /// What each node assigns.
    set: Vec<Scalars>,
}

/// What becomes of an unassigned scalar on the ways from a node to the return of the call that it is in.
#[derive(Clone, Copy, Default, PartialEq)]
pub(super) struct Passage {
    /// There is such a way.
    returns: bool,
    /// The scalars that some way neither reads nor assigns.
    pub(super) untouched: Scalars,
    /// The scalars that some way assigns before it reads them.
    set: Scalars,
}

/// How runs can come to a node. A scalar that may be neither way is one that no run comes there with.
#[derive(Clone, Copy, Default, PartialEq)]
struct State {
    /// The scalars that may be unassigned.
    unassigned: Scalars,
    /// The scalars that may be assigned.
    assigned: Scalars,
}

impl State {
    /// Behind what leaves the scalars `untouched` as they are and assigns `set` to unassigned ones.
    /// An unassigned scalar that is in neither was read: that run is over.
    fn behind(self, untouched: Scalars, set: Scalars) -> State {
        State {
            unassigned: self.unassigned & untouched,
            assigned: self.assigned | (self.unassigned & set),
        }
    }

    fn or(self, other: State) -> State {
        State {
            unassigned: self.unassigned | other.unassigned,
            assigned: self.assigned | other.assigned,
        }
    }
}

impl<'a> Batch<'a> {
    /// The reads and assignments of the scalars in a range of 64 at most.
    pub(super) fn new(program: &Program, flow: &'a Flow, scalars: Range<usize>) -> Self {
        let bit = |scalar: usize| match scalars.contains(&scalar) {
            true => 1 << (scalar - scalars.start),
            false => 0,
        };
        let mut read = Vec::with_capacity(flow.nodes().len());
        let mut set = Vec::with_capacity(flow.nodes().len());
        for node in flow.nodes() {
            let action = &program.steps()[node.step as usize].action;
            let reads = match node.is_passed {
                true => Vec::new(),
                false => access::reads(program, action),
            };
            read.push(reads.into_iter().map(bit).fold(0, |a, b| a | b));
            let assigns = access::assigns(program, action);
            set.push(assigns.map(bit).fold(0, |a, b| a | b));
        }
        Batch {
            flow,
            scalars,
            read,
            set,
        }
    }

    /// The scalars that a node leaves alone, and those that it assigns without reading them.
    pub(super) fn effect(&self, node: NodeId) -> (Scalars, Scalars) {
        let (read, set) = (self.read[node], self.set[node]);
        (!(read | set), set & !read)
    }

    /// Every read of these scalars that a run can come to.
    pub(super) fn reads(&self) -> Vec<Read> {
        let states = self.states();
        let mut reads = Vec::new();
        for (id, node) in self.flow.nodes().iter().enumerate() {
            let mut left = self.read[id];
            while left != 0 {
                let bit = left & left.wrapping_neg();
                left ^= bit;
                let State {
                    unassigned,
                    assigned,
                } = states[id];
                let assigned = match (assigned & bit != 0, unassigned & bit != 0) {
                    (true, false) => Assigned::Always,
                    (true, true) => Assigned::Sometimes,
                    (false, true) => Assigned::Never,
                    (false, false) => continue,
                };
                reads.push(Read {
                    step: node.step,
                    scalar: self.scalars.start + bit.trailing_zeros() as usize,
                    assigned,
                });
            }
        }
        reads
    }

    /// For each node, how runs come to it.
    fn states(&self) -> Vec<State> {
        let nodes = self.flow.nodes();
        let passages = self.passages();
        let mut states = vec![State::default(); nodes.len()];
        let mut work = Worklist::new(nodes.len(), Order::Forward);
        if let Some(first) = states.first_mut() {
            first.unassigned = Scalars::MAX;
            work.push(0);
        }
        while let Some(id) = work.pop() {
            let (untouched, set) = self.effect(id);
            let after = states[id].behind(untouched, set);
            let mut flow_to = |to: NodeId, state: State| {
                let joined = states[to].or(state);
                if joined != states[to] {
                    states[to] = joined;
                    work.push(to);
                }
            };
            for next in &nodes[id].next {
                flow_to(*next, after);
            }
            if let Some(call) = nodes[id].call {
                flow_to(call.entry, after);
                let passage = passages[call.entry];
                if passage.returns {
                    flow_to(call.back, after.behind(passage.untouched, passage.set));
                }
            }
        }
        states
    }

    /// For each node, the ways to the return of the call that it is in.
    pub(super) fn passages(&self) -> Vec<Passage> {
        let nodes = self.flow.nodes();
        let mut passages = vec![Passage::default(); nodes.len()];
        let before = self.flow.before();
        let mut work = Worklist::new(nodes.len(), Order::Backward);
        for (id, _) in nodes.iter().enumerate().filter(|(_, node)| node.returns) {
            work.push(id);
        }
        while let Some(id) = work.pop() {
            let passage = self.passage(id, &passages);
            if passage != passages[id] {
                passages[id] = passage;
                for before in &before[id] {
                    work.push(*before);
                }
            }
        }
        passages
    }

    /// What a node adds to the ways behind it.
    fn passage(&self, id: NodeId, passages: &[Passage]) -> Passage {
        let node = &self.flow.nodes()[id];
        let mut ways = Passage::default();
        if node.returns {
            ways.returns = true;
            ways.untouched = Scalars::MAX;
        }
        for next in node.next.iter().map(|next| passages[*next]) {
            ways.returns |= next.returns;
            ways.untouched |= next.untouched;
            ways.set |= next.set;
        }
        if let Some(call) = node.call {
            let (inner, back) = (passages[call.entry], passages[call.back]);
            if inner.returns && back.returns {
                ways.returns = true;
                ways.untouched |= inner.untouched & back.untouched;
                ways.set |= inner.set | (inner.untouched & back.set);
            }
        }
        if ways.returns {
            let (untouched, set) = self.effect(id);
            ways.untouched &= untouched;
            ways.set = set | (untouched & ways.set);
        }
        ways
    }
}
