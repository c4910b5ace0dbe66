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
mod blocks;
mod gap;
mod ways;

#[cfg(test)]
mod tests;

pub use gap::{Gap, gaps};
pub use ways::{NoValue, Ways};

use super::flow::{Flow, NodeId};
use crate::program::{Program, StepId};
use batch::{Batch, Found, Sorted, Start, Touches};
use blocks::Blocks;

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
