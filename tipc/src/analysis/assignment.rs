//! Definite assignment: which reads always, sometimes or never find a value (T.I.P. 3.1 §5-1).
//!
//! A data flow over the steps. For each scalar it holds whether a run can come to a step with the
//! scalar unassigned, and whether with it assigned. A read that finds nothing ends the run, so a run
//! that goes on has a value there. A call goes on behind it only with what some way through the
//! subroutine leaves behind: calls and returns match, at any depth. Up to 64 scalars are a machine
//! word for each step; the time is O(steps · scalars / 64) times the nesting of loops, the memory
//! O(steps + reads).

mod batch;
mod gap;
mod worklist;

#[cfg(test)]
mod tests;

pub use gap::{Gap, gaps};

use super::flow::Flow;
use crate::program::{Program, StepId};
use batch::Batch;

/// Whether a read finds a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Assigned {
    /// On every way to it.
    Always,
    /// On some way, but not on every one.
    Sometimes,
    /// On no way.
    Never,
}

/// A step that reads a scalar, and that a run can come to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Read {
    /// The step.
    pub step: StepId,
    /// The scalar's place among all scalars.
    pub scalar: usize,
    /// Whether it has a value.
    pub assigned: Assigned,
}

/// The reads of a program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Assignment {
    reads: Vec<Read>,
}

impl Assignment {
    /// Judges every read of a program.
    pub fn of(program: &Program) -> Self {
        let flow = Flow::of(program);
        let mut reads: Vec<Read> = batch::all(program)
            .flat_map(|variables| Batch::new(program, &flow, variables).reads())
            .collect();
        reads.sort_unstable();
        Assignment { reads }
    }

    /// Every read, by step, then by scalar; a scalar that a step reads twice is one.
    pub fn reads(&self) -> &[Read] {
        &self.reads
    }

    /// Whether every run that comes to a step has a value in the scalar there.
    pub fn is_always(&self, step: StepId, scalar: usize) -> bool {
        self.reads
            .binary_search_by_key(&(step, scalar), |read| (read.step, read.scalar))
            .is_ok_and(|place| self.reads[place].assigned == Assigned::Always)
    }
}
