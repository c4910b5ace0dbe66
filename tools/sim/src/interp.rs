//! The reference interpreter: a [`Program`](tipc::program::Program) run one step at a call.
//!
//! It defines the meaning of a program by running it as written. With the emitter it shares the leaf
//! arithmetic of [`tip_runtime::ops`] and nothing else, so that comparing the two proves something.

mod evaluate;
mod step;

use std::sync::Arc;
use tip_lint::coverage_points::ProgramPoint;
use tip_runtime::command::{Flag, MAX, Reading};
use tip_runtime::fault::Fault;
use tip_runtime::program::{CallStack, Context, Flow, Program, Robot, Signature};
use tipc::program;

/// A program together with the state of its run. Copies share the program.
#[derive(Clone, Debug)]
pub struct Interpreter {
    program: Arc<program::Program>,
    names: Arc<[String]>,
    scalars: Vec<Option<f64>>,
    /// The position of the main program, then those of the threads in the order of the text.
    positions: Vec<Position>,
    /// The index of the position whose step runs next.
    selected: usize,
}

/// The place of the main program or of a thread, and its open calls.
#[derive(Clone, Copy, Debug)]
struct Position {
    at: u32,
    not_taken: bool,
    calls: CallStack,
}

impl Position {
    fn at(step: u32) -> Self {
        Position {
            at: step,
            not_taken: false,
            calls: CallStack::new(),
        }
    }
}

/// The inputs of a step: the robot and its timers.
pub(crate) trait Sensed {
    fn flag(&self, flag: Flag) -> bool;
    fn reading(&self, reading: Reading) -> Result<[f64; MAX], Fault>;
}

impl Sensed for &dyn Context {
    fn flag(&self, flag: Flag) -> bool {
        Robot::flag(*self, flag)
    }

    fn reading(&self, reading: Reading) -> Result<[f64; MAX], Fault> {
        Context::reading(*self, reading)
    }
}

impl Interpreter {
    /// Creates an interpreter at step 0, with every variable unassigned.
    pub fn new(program: impl Into<Arc<program::Program>>) -> Self {
        let program = program.into();
        let mut interpreter = Interpreter {
            names: program.scalar_names().collect(),
            scalars: vec![None; program.scalar_count()],
            positions: vec![Position::at(0); program.threads().len() + 1],
            selected: 0,
            program,
        };
        interpreter.reset();
        interpreter
    }

    fn position(&self) -> &Position {
        &self.positions[self.selected]
    }

    /// Returns its place in the program.
    pub fn place(&self) -> ProgramPoint {
        let position = self.position();
        ProgramPoint {
            step: position.at,
            not_taken: position.not_taken,
        }
    }

    /// Returns the return addresses of the open calls of the main program (0) or a thread, the outermost first.
    pub fn calls(&self, thread: usize) -> &[u32] {
        let position = self.positions.get(thread);
        position.map_or(&[], |position| position.calls.open())
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
        self.position().at
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
        for variable in self.program.variables() {
            if variable.special.is_some() {
                self.scalars[variable.first..variable.first + variable.size()].fill(Some(0.0));
            }
        }
        self.positions.fill(Position::at(0));
        self.selected = 0;
    }

    fn thread(&self, n: u8) -> Option<(&str, u32)> {
        let index = usize::from(n).checked_sub(1)?;
        let thread = self.program.threads().get(index)?;
        Some((&thread.name, self.positions[index + 1].at))
    }

    fn select(&mut self, thread: u8) {
        self.selected = usize::from(thread).min(self.positions.len() - 1);
    }

    fn begin(&mut self, thread: u8) {
        let index = usize::from(thread).checked_sub(1);
        if let Some(first) = index.and_then(|index| self.program.threads().get(index)) {
            self.positions[usize::from(thread)] = Position::at(first.first);
        }
    }

    fn specials(&self) -> usize {
        let shared = self.program.variables().iter();
        let shared = shared.filter(|variable| variable.special.is_some());
        shared.map(program::Variable::size).sum()
    }
}
