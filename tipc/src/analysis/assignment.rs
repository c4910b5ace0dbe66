//! Definite assignment: which reads always, sometimes or never find a value (T.I.P. 3.1 §5-1).
//!
//! A forward data-flow analysis over the steps. It keeps two bits for each scalar: a run can reach the step with the
//! scalar unassigned, and a run can reach it with the scalar assigned. A read of an unassigned scalar ends the run, so
//! in a run that goes on behind a read the scalar is assigned. A call is followed by the states that the paths through
//! its subroutine leave: calls and returns match, at any depth.
//!
//! A scalar that no basic block reads before assigning it needs no data flow. Each block has a row of bits for the
//! others. The rows of all blocks together have at most [`MAX_WORDS`] words: reads of further scalars are not judged,
//! and [`Assignment::is_complete`] returns false.
//!
//! A thread starts at its THREAD. An assignment by another thread proves nothing; `paths` has the rules of edition 3.2
//! for it.

mod blocks;
mod paths;

pub use paths::{NoValue, Paths};

use super::flow::{Flow, NodeId};
use crate::program::{Program, StepId, VariableId};
use blocks::{Access, Analysis, Blocks, Places, State, accesses};
use std::collections::{BTreeMap, VecDeque};

/// Maximum number of words of 64 scalars in the rows of all blocks.
pub const MAX_WORDS: usize = 2_000_000;

/// Knowledge of whether a read finds a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Assigned {
    /// On every path to it.
    Always,
    /// On some path, but not on every one.
    Sometimes,
    /// On no path of its thread.
    Never,
}

/// A step that reads a scalar, and that a run can come to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Read {
    /// The step.
    pub step: StepId,
    /// The scalar's index among all scalars.
    pub scalar: usize,
    /// Knowledge of whether it has a value.
    pub assigned: Assigned,
}

/// The reads of a program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Assignment {
    reads: Vec<Read>,
    is_complete: bool,
}

impl Assignment {
    /// Judges the reads of a program.
    pub fn of(program: &Program) -> Self {
        Assignment::along(program, &Flow::of(program))
    }

    /// Analyses a program whose flow is known.
    pub fn along(program: &Program, flow: &Flow) -> Self {
        let judged = judged(program, flow, flow.starts(), &predeclared(program));
        let step = |node: NodeId| flow.nodes()[node].step;
        let reads = judged.reads.into_iter().map(|read| Read {
            step: step(read.node),
            scalar: read.scalar,
            assigned: read.assigned,
        });
        Assignment::new(reads.collect(), judged.is_complete)
    }

    fn new(mut reads: Vec<Read>, is_complete: bool) -> Self {
        reads.sort();
        reads.dedup();
        Assignment { reads, is_complete }
    }

    /// Returns the reads in the order of steps, then of scalars. A scalar that a step reads twice counts once.
    pub fn reads(&self) -> &[Read] {
        &self.reads
    }

    /// Returns false if the reads of some scalars were not judged, because the rows would have more than [`MAX_WORDS`]
    /// words.
    pub fn is_complete(&self) -> bool {
        self.is_complete
    }

    /// Returns true if every run that comes to a step has a value in the scalar there.
    pub fn is_always(&self, step: StepId, scalar: usize) -> bool {
        self.reads
            .binary_search_by_key(&(step, scalar), |read| (read.step, read.scalar))
            .is_ok_and(|place| self.reads[place].assigned == Assigned::Always)
    }
}

/// Returns true for each scalar that has a value at the start, since it is shared with native code.
fn predeclared(program: &Program) -> Vec<bool> {
    let mut given = vec![false; program.scalar_count()];
    for variable in program.variables().iter().filter(|it| it.special.is_some()) {
        given[variable.first..variable.first + variable.size()].fill(true);
    }
    given
}

/// A node that reads a scalar, and that a run can come to.
struct NodeRead {
    node: NodeId,
    scalar: usize,
    assigned: Assigned,
}

/// The judged reads of a flow.
struct Judged {
    reads: Vec<NodeRead>,
    /// False if reads were not judged.
    is_complete: bool,
    /// For each node, true if a run can come to it.
    reached: Vec<bool>,
    /// For each node, true if a call of the subroutine at it can return.
    comes_back: Vec<bool>,
}

/// Judges the reads along a flow, for runs from these nodes that begin with these scalars assigned.
fn judged(program: &Program, flow: &Flow, starts: &[NodeId], given: &[bool]) -> Judged {
    let blocks = Blocks::of(flow);
    let accesses = accesses(program, flow);
    let exposed = Places::exposed(&accesses, program.scalar_count(), &blocks);
    let mut places = exposed.clone();
    let is_complete = places.keep(64 * (MAX_WORDS / blocks.count().max(1))) == 0;
    let analysis = Analysis::new(&blocks, &accesses, &places);
    let given: Vec<usize> = (0..given.len())
        .filter(|scalar| given[*scalar])
        .filter_map(|scalar| places.of(scalar))
        .collect();
    let states = analysis.states(starts, &given);
    let mut reads = Vec::new();
    for in_block in
        accesses.chunk_by(|one, next| blocks.of_node(one.node) == blocks.of_node(next.node))
    {
        let Some(mut state) = states[blocks.of_node(in_block[0].node)].clone() else {
            continue;
        };
        for of_node in in_block.chunk_by(|one, next| one.node == next.node) {
            let read = of_node.iter().filter(|access| !access.assigns);
            reads.extend(read.filter_map(|access| {
                let assigned = match (places.of(access.scalar), exposed.of(access.scalar)) {
                    (Some(place), _) => found(&state, place)?,
                    // Its block assigns it first.
                    (None, None) => Assigned::Always,
                    (None, Some(_)) => return None,
                };
                Some(NodeRead {
                    node: access.node,
                    scalar: access.scalar,
                    assigned,
                })
            }));
            for Access {
                scalar, assigns, ..
            } in of_node
            {
                if let Some(place) = places.of(*scalar) {
                    state.pass(place, *assigns);
                }
            }
        }
    }
    let nodes = 0..flow.nodes().len();
    Judged {
        reads,
        is_complete,
        reached: nodes
            .clone()
            .map(|node| states[blocks.of_node(node)].is_some())
            .collect(),
        comes_back: nodes.map(|node| analysis.call(node).is_some()).collect(),
    }
}

/// Judges a read of the scalar at a place; `None` if no run gets there.
fn found(state: &State, place: usize) -> Option<Assigned> {
    match (state.may_be_assigned(place), state.may_be_unassigned(place)) {
        (true, false) => Some(Assigned::Always),
        (true, true) => Some(Assigned::Sometimes),
        (false, true) => Some(Assigned::Never),
        (false, false) => None,
    }
}

/// Maximum number of gaps for which a path is searched. Each search takes time linear in the length of the program.
const MAX_PATHS: usize = 100;

/// The first step in the source that may read a variable without a value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Gap {
    /// The variable.
    pub variable: VariableId,
    /// The scalars of it that the step reads and that may lack a value.
    pub scalars: Vec<usize>,
    /// `Sometimes` or `Never`.
    pub assigned: Assigned,
    /// The step that reads it.
    pub step: StepId,
    /// The steps of a shortest path from step 0, or from the start of a thread, to `step` on which the first of
    /// `scalars` gets no value. The steps of a subroutine that returns are left out, except its call. Empty after the
    /// first hundred gaps.
    pub path: Vec<StepId>,
}

/// Returns the gaps of a program, by variable. A variable has at most two: one for the reads that fail on some path,
/// and one for those that fail on every path.
pub fn gaps(program: &Program, assignment: &Assignment) -> Vec<Gap> {
    let lacking = assignment
        .reads()
        .iter()
        .filter(|read| read.assigned != Assigned::Always);
    let mut gaps: BTreeMap<(VariableId, Assigned), Gap> = BTreeMap::new();
    for read in lacking {
        let variable = program.variable_of(read.scalar);
        let gap = gaps.entry((variable, read.assigned)).or_insert(Gap {
            variable,
            scalars: Vec::new(),
            assigned: read.assigned,
            step: read.step,
            path: Vec::new(),
        });
        if gap.step == read.step {
            gap.scalars.push(read.scalar);
        }
    }
    let mut gaps: Vec<Gap> = gaps.into_values().collect();
    if gaps.is_empty() {
        return gaps;
    }
    let flow = Flow::of(program);
    let blocks = Blocks::of(&flow);
    let accesses = accesses(program, &flow);
    for gap in gaps.iter_mut().take(MAX_PATHS) {
        let scalar = gap.scalars[0];
        let places = Places::only(scalar, program.scalar_count());
        let analysis = Analysis::new(&blocks, &accesses, &places);
        let of_scalar = accesses.iter().filter(|access| access.scalar == scalar);
        let touching: Vec<NodeId> = of_scalar.map(|access| access.node).collect();
        gap.path = shortest_path(&flow, &analysis, &touching, gap.step);
    }
    gaps
}

/// Returns the steps of a shortest path to `step` with no earlier access to the only scalar of the analysis. `touching`
/// has the nodes that access it, in order.
fn shortest_path(
    flow: &Flow,
    analysis: &Analysis<'_>,
    touching: &[NodeId],
    step: StepId,
) -> Vec<StepId> {
    let is_untouched = |id: NodeId| touching.binary_search(&id).is_err();
    let passes = |entry| {
        analysis
            .call(entry)
            .is_some_and(|after| after.may_be_unassigned(0))
    };
    let mut from: Vec<Option<NodeId>> = vec![None; flow.nodes().len()];
    let mut queue: VecDeque<NodeId> = flow.starts().iter().copied().collect();
    while let Some(id) = queue.pop_front() {
        let node = &flow.nodes()[id];
        if node.step == step && !is_untouched(id) {
            return steps_to(flow, &from, id);
        }
        if !is_untouched(id) {
            continue;
        }
        let call = node
            .call
            .iter()
            .flat_map(|call| [Some(call.entry), passes(call.entry).then_some(call.back)]);
        for next in node.next.iter().copied().chain(call.flatten()) {
            if !flow.starts().contains(&next) && from[next].is_none() {
                from[next] = Some(id);
                queue.push_back(next);
            }
        }
    }
    Vec::new()
}

/// Returns the steps on the path from a start to `id`.
fn steps_to(flow: &Flow, from: &[Option<NodeId>], id: NodeId) -> Vec<StepId> {
    let nodes = std::iter::successors(Some(id), |id| from[*id]);
    let mut steps: Vec<StepId> = nodes.map(|id| flow.nodes()[id].step).collect();
    steps.reverse();
    steps
}

#[cfg(test)]
mod tests;
