//! Definite assignment: which reads always, sometimes or never find a value (T.I.P. 3.1 §5-1).
//!
//! A data flow over the steps. For each scalar it holds whether a run can come to a step with the
//! scalar unassigned, and whether with it assigned. A read that finds nothing ends the run, so a run
//! that goes on has a value there. A call continues only with what some path through the
//! subroutine leaves: calls and returns match, at any depth. A scalar that each basic block
//! assigns before it reads it needs no data flow; up to 63 others are a machine word for each block.
//! The time is O(steps + blocks · such scalars / 63) times the nesting of loops, up to a bound on the
//! product; the memory O(steps + scalars).
//!
//! Threads run from their THREAD. What another thread assigns proves nothing; how an edition judges it is in `ways`.

mod batch;
mod ways;

pub use ways::{NoValue, Ways};

use super::flow::{Flow, NodeId};
use crate::program::{Program, StepId, VariableId};
use batch::{Batch, Blocks, Found, Sorted, Start, Touches};
use std::collections::{BTreeMap, VecDeque};

/// For how many batches of scalars every program is followed.
const LEAST: usize = 16;

/// The most batches times blocks that are followed in a longer program. Reads of the remaining scalars are not judged.
const WORK: usize = 1_000_000;

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
        Assignment::new(reads.collect())
    }

    fn new(mut reads: Vec<Read>) -> Self {
        // Batches and certain reads are each nearly in order, which the stable sort makes use of.
        reads.sort();
        reads.dedup();
        Assignment { reads }
    }

    /// Returns the reads, by step, then by scalar; a scalar that a step reads twice is one. Some are left out of a
    /// long program in which blocks read thousands of scalars that others assign.
    pub fn reads(&self) -> &[Read] {
        &self.reads
    }

    /// Returns true if every run that comes to a step has a value in the scalar there.
    pub fn is_always(&self, step: StepId, scalar: usize) -> bool {
        self.reads
            .binary_search_by_key(&(step, scalar), |read| (read.step, read.scalar))
            .is_ok_and(|place| self.reads[place].assigned == Assigned::Always)
    }
}

/// Returns which scalars have a value at the start: those that are shared with native code.
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

/// Reads along a flow.
struct Judged {
    reads: Vec<NodeRead>,
    /// For each node, true if a run can come to it.
    reached: Vec<bool>,
    /// For each node, true if a call of it can come back.
    comes_back: Vec<bool>,
}

/// Judges the reads along a flow, for runs from these nodes that begin with these scalars assigned.
fn judged(program: &Program, flow: &Flow, starts: &[NodeId], given: &[bool]) -> Judged {
    let blocks = Blocks::of(flow);
    let (batches, certain) = Touches::of(program, flow).sorted(program.scalar_count(), &blocks);
    let mut judged = Judged {
        reads: Vec::new(),
        reached: Vec::new(),
        comes_back: Vec::new(),
    };
    let mut is_reached = Vec::new();
    let few = LEAST.max(WORK / blocks.all().len().max(1));
    for (index, Sorted { scalars, touches }) in batches.iter().take(few).enumerate() {
        let bits = scalars
            .iter()
            .zip(0..)
            .filter(|(scalar, _)| given[**scalar]);
        let start = Start {
            nodes: starts,
            given: bits.fold(0, |bits, (_, place)| bits | 1 << place),
        };
        let batch = Batch::new(&blocks, touches, start);
        let (found, reached) = batch.found();
        for read in found {
            judge(read, scalars, &mut judged.reads);
        }
        is_reached = reached;
        if index == 0 {
            let comes_back = batch.comes_back();
            judged.comes_back = (0..flow.nodes().len()).map(comes_back).collect();
        }
    }
    for (node, scalar) in certain {
        if is_reached[blocks.of_node(node)] {
            judged.reads.push(NodeRead {
                node,
                scalar,
                assigned: Assigned::Always,
            });
        }
    }
    let nodes = 0..flow.nodes().len();
    judged.reached = nodes.map(|node| is_reached[blocks.of_node(node)]).collect();
    judged
}

/// Records the reads of one node, of those scalars that a run can come there with.
fn judge(found: Found, scalars: &[usize], reads: &mut Vec<NodeRead>) {
    let mut left = found.unassigned | found.assigned;
    while left != 0 {
        let bit = left & left.wrapping_neg();
        left ^= bit;
        let assigned = match (found.assigned & bit != 0, found.unassigned & bit != 0) {
            (true, false) => Assigned::Always,
            (true, true) => Assigned::Sometimes,
            (false, _) => Assigned::Never,
        };
        reads.push(NodeRead {
            node: found.node,
            scalar: scalars[bit.trailing_zeros() as usize],
            assigned,
        });
    }
}

/// For how many gaps a path is searched. Each search takes time linear in the length of the program.
const WAYS: usize = 100;

/// A variable that is read without a value: the first step in the source that does.
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
    /// The steps of a shortest run from step 0, or from the start of a thread, to `step` on which the first of `scalars` gets no value;
    /// of a subroutine that is left again, its call alone. Empty after the first hundred gaps.
    pub way: Vec<StepId>,
}

/// Returns the gaps of a program, by variable: one for the reads that some run finds no value at, and one for
/// those that every run does.
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
            way: Vec::new(),
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
    let (blocks, touches) = (Blocks::of(&flow), Touches::of(program, &flow));
    for gap in gaps.iter_mut().take(WAYS) {
        let touches = touches.of_scalar(gap.scalars[0]);
        let start = Start {
            nodes: flow.starts(),
            given: 0,
        };
        gap.way = way(&flow, &Batch::new(&blocks, &touches, start), gap.step);
    }
    gaps
}

/// Returns the steps of a shortest run to `step` on which nothing before it reads or assigns the scalar of a batch.
fn way(flow: &Flow, batch: &Batch<'_>, step: StepId) -> Vec<StepId> {
    let is_untouched = |id: NodeId| batch.is_untouched(id);
    let passes = batch.passes();
    let mut from: Vec<Option<NodeId>> = vec![None; flow.nodes().len()];
    let mut queue: VecDeque<NodeId> = flow.starts().iter().copied().collect();
    while let Some(id) = queue.pop_front() {
        let node = &flow.nodes()[id];
        if node.step == step && !is_untouched(id) {
            return walked(flow, &from, id);
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
fn walked(flow: &Flow, from: &[Option<NodeId>], id: NodeId) -> Vec<StepId> {
    let nodes = std::iter::successors(Some(id), |id| from[*id]);
    let mut steps: Vec<StepId> = nodes.map(|id| flow.nodes()[id].step).collect();
    steps.reverse();
    steps
}

#[cfg(test)]
mod tests;
