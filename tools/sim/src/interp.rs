//! The reference interpreter: a [`Program`](tipc::program::Program) run one step at a call.
//!
//! It defines the meaning of a program by running it as written. With the emitter it shares the leaf
//! arithmetic of [`tip_runtime::ops`] and nothing else, so that comparing the two proves something.

mod evaluate;
mod step;

use std::sync::Arc;
use tip_lint::coverage_points::ProgramPoint;
use tip_runtime::fault::Fault;
use tip_runtime::program::{CallStack, Context, Flow, Program, Signature};
use tipc::program;

/// A program together with the state of its run. Copies share the program.
#[derive(Clone, Debug)]
pub struct Interpreter {
    program: Arc<program::Program>,
    names: Arc<[String]>,
    scalars: Vec<Option<f64>>,
    at: u32,
    not_taken: bool,
    calls: CallStack,
}

impl Interpreter {
    /// Creates an interpreter at step 0, with every variable unassigned.
    pub fn new(program: impl Into<Arc<program::Program>>) -> Self {
        let program = program.into();
        Interpreter {
            names: program.scalar_names().collect(),
            scalars: vec![None; program.scalar_count()],
            at: 0,
            not_taken: false,
            calls: CallStack::new(),
            program,
        }
    }

    /// Returns its place in the program.
    pub fn place(&self) -> ProgramPoint {
        ProgramPoint {
            step: self.at,
            not_taken: self.not_taken,
        }
    }

    /// Returns the return addresses of the open calls, the outermost first.
    pub fn calls(&self) -> &[u32] {
        self.calls.open()
    }

    /// Returns the program that it runs, which copies of the interpreter share.
    pub fn program(&self) -> &Arc<program::Program> {
        &self.program
    }
}

impl Program for Interpreter {
    fn signature(&self) -> Signature {
        self.program.signature()
    }

    fn name(&self) -> &str {
        self.program.source_name()
    }

    fn title(&self) -> &str {
        self.program.title()
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

    fn set_scalar(&mut self, i: usize, value: f64) {
        if let Some(scalar) = self.scalars.get_mut(i) {
            *scalar = Some(value);
        }
    }

    fn line(&self, step: u32) -> u32 {
        let step = self.program.steps().get(step as usize);
        step.map_or(0, |step| step.line)
    }

    fn reset(&mut self) {
        self.scalars.fill(None);
        self.at = 0;
        self.not_taken = false;
        self.calls = CallStack::new();
    }
}
