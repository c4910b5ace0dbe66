//! Results of all runs.

use super::{Engines, Failed};
use crate::event::Inputs;
use crate::lockstep::{Answer, Divergence, ReachedPoints, RunEnd};
use tipc::program::Program;

/// Inputs on which the engines differ.
#[derive(Clone, Debug)]
pub struct Diverging {
    /// The inputs of the run.
    pub inputs: Inputs,
    /// The first difference.
    pub divergence: Divergence,
}

/// Result of one run.
#[derive(Clone, Debug)]
pub enum RunResult {
    /// The engines agree.
    Agreed {
        /// Number of cycles that were compared.
        cycles: u64,
        /// True if it reached something that no run before it did.
        is_new: bool,
        /// Cycles where another input may change the path.
        chances: Vec<u64>,
    },
    /// The engines differ.
    Diverged(Diverging),
}

/// Results of all runs.
#[derive(Debug)]
pub struct Coverage {
    /// The spots that they reached.
    pub reach: ReachedPoints,
    /// Cycles that were compared.
    pub cycles: u64,
    /// Runs to END or EXIT.
    pub finished: u64,
    /// Runs to the last cycle allowed.
    pub limited: u64,
    /// Runs to an emergency stop.
    pub stopped: u64,
}

impl Coverage {
    /// Creates a coverage without runs.
    pub fn new(program: &Program) -> Self {
        Coverage {
            reach: ReachedPoints::new(program),
            cycles: 0,
            finished: 0,
            limited: 0,
            stopped: 0,
        }
    }

    /// Returns the number of runs.
    pub fn runs(&self) -> u64 {
        self.finished + self.limited + self.stopped
    }

    /// Runs once and adds the result.
    ///
    /// # Errors
    /// The robot lacks an input, or the engines fail.
    pub fn run<E: Engines>(
        &mut self,
        engines: &mut E,
        inputs: &Inputs,
    ) -> Result<RunResult, Failed<E::Error>> {
        match engines.ask(inputs).map_err(Failed::Engines)? {
            Answer::Refused(reason) => Err(Failed::Refused(reason)),
            Answer::Diverged(divergence) => Ok(RunResult::Diverged(Diverging {
                inputs: inputs.clone(),
                divergence,
            })),
            Answer::Agreed {
                cycles,
                end,
                new,
                chances,
            } => {
                self.cycles += cycles;
                *match end {
                    RunEnd::Finished => &mut self.finished,
                    RunEnd::Limit => &mut self.limited,
                    RunEnd::Emergency => &mut self.stopped,
                } += 1;
                for point in &new {
                    self.reach.add(*point);
                }
                Ok(RunResult::Agreed {
                    cycles,
                    is_new: !new.is_empty(),
                    chances,
                })
            }
        }
    }
}
