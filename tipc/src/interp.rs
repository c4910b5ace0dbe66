//! The reference interpreter: a [`Program`](program::Program) run one step at a call.
//!
//! It says what a program means by reading it as it stands. With the emitter it shares the leaf
//! arithmetic of [`tip_runtime::ops`] and nothing else, so that comparing the two proves something.

mod evaluate;
mod step;

#[cfg(test)]
mod tests;

#[cfg(feature = "lockstep")]
use crate::analysis::spots::Place;
use crate::program;
use tip_runtime::fault::Fault;
use tip_runtime::program::{CallStack, Context, Flow, Program, Signature};

/// A program together with the state of its run.
#[derive(Clone, Debug)]
pub struct Interpreter {
    program: program::Program,
    names: Vec<String>,
    scalars: Vec<Option<f64>>,
    at: u32,
    not_taken: bool,
    calls: CallStack,
}

impl Interpreter {
    /// At step 0, with every variable unassigned.
    pub fn new(program: program::Program) -> Self {
        Interpreter {
            names: program.scalar_names().collect(),
            scalars: vec![None; program.scalar_count()],
            at: 0,
            not_taken: false,
            calls: CallStack::new(),
            program,
        }
    }

    /// Where it stands.
    #[cfg(feature = "lockstep")]
    pub(crate) fn place(&self) -> Place {
        Place {
            step: self.at,
            not_taken: self.not_taken,
        }
    }

    /// The program that it runs.
    pub fn program(&self) -> &program::Program {
        &self.program
    }
}

impl Program for Interpreter {
    fn signature(&self) -> Signature {
        self.program.signature
    }

    fn name(&self) -> &str {
        &self.program.source_name
    }

    fn title(&self) -> &str {
        &self.program.title
    }

    fn at(&self) -> u32 {
        self.at
    }

    fn step(&mut self, cx: &mut dyn Context) -> Result<Flow, Fault> {
        let outcome = self.outcome(cx)?;
        Ok(self.apply(outcome))
    }

    fn scalar(&self, i: usize) -> Option<(&str, Option<f64>)> {
        Some((self.names.get(i)?, *self.scalars.get(i)?))
    }

    fn line(&self, step: u32) -> u32 {
        let step = self.program.steps.get(step as usize);
        step.map_or(0, |step| step.line)
    }

    fn reset(&mut self) {
        self.scalars.fill(None);
        self.at = 0;
        self.not_taken = false;
        self.calls = CallStack::new();
    }
}
