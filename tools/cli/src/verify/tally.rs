//! What all runs came to.

use super::super::error::Error;
use super::engines::Engines;
use tipc::lockstep::{Answer, Divergence, Inputs, Reach, RunEnd};
use tipc::program::Program;

/// Inputs on which the engines differ.
#[derive(Clone, Debug)]
pub(super) struct Diverging {
    pub(super) inputs: Inputs,
    pub(super) divergence: Divergence,
}

/// What one run came to.
pub(super) enum Came {
    /// The engines agree.
    Agreed {
        cycles: u64,
        /// It came by something that no run before it did.
        is_new: bool,
        /// Cycles where another input may change the way.
        chances: Vec<u64>,
    },
    /// They differ.
    Diverged(Diverging),
}

/// What all runs came to.
#[derive(Debug)]
pub(super) struct Tally {
    pub(super) reach: Reach,
    pub(super) cycles: u64,
    /// Runs by how they ended.
    pub(super) finished: u64,
    pub(super) limited: u64,
    pub(super) stopped: u64,
}

impl Tally {
    pub(super) fn new(program: &Program) -> Self {
        Tally {
            reach: Reach::new(program),
            cycles: 0,
            finished: 0,
            limited: 0,
            stopped: 0,
        }
    }

    /// How many runs there were.
    pub(super) fn runs(&self) -> u64 {
        self.finished + self.limited + self.stopped
    }

    /// One run more.
    pub(super) fn run(&mut self, engines: &mut Engines, inputs: &Inputs) -> Result<Came, Error> {
        match engines.ask(inputs)? {
            Answer::Refused(reason) => Err(Error::Usage(reason)),
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
                for spot in &new {
                    self.reach.add(*spot);
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
