//! What all runs came to.

use super::{Engines, Failed};
use crate::event::Inputs;
use crate::lockstep::{Answer, Divergence, Reach, RunEnd};
use tipc::program::Program;

/// Inputs on which the engines differ.
#[derive(Clone, Debug)]
pub struct Diverging {
    /// What happened.
    pub inputs: Inputs,
    /// Where they differ.
    pub divergence: Divergence,
}

/// What one run came to.
#[derive(Clone, Debug)]
pub enum Came {
    /// The engines agree.
    Agreed {
        /// How many cycles were compared.
        cycles: u64,
        /// It reached something that no run before it did.
        is_new: bool,
        /// Cycles where another input may change the path.
        chances: Vec<u64>,
    },
    /// They differ.
    Diverged(Diverging),
}

/// What all runs came to.
#[derive(Debug)]
pub struct Coverage {
    /// What they reached.
    pub reach: Reach,
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
    /// No runs yet.
    pub fn new(program: &Program) -> Self {
        Coverage {
            reach: Reach::new(program),
            cycles: 0,
            finished: 0,
            limited: 0,
            stopped: 0,
        }
    }

    /// How many runs there were.
    pub fn runs(&self) -> u64 {
        self.finished + self.limited + self.stopped
    }

    /// One run more.
    ///
    /// # Errors
    /// The robot lacks an input, or the engines fail.
    pub fn run<E: Engines>(
        &mut self,
        engines: &mut E,
        inputs: &Inputs,
    ) -> Result<Came, Failed<E::Error>> {
        match engines.ask(inputs).map_err(Failed::Engines)? {
            Answer::Refused(reason) => Err(Failed::Refused(reason)),
            Answer::Diverged(divergence) => Ok(Came::Diverged(Diverging {
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
                Ok(Came::Agreed {
                    cycles,
                    is_new: !new.is_empty(),
                    chances,
                })
            }
        }
    }
}
