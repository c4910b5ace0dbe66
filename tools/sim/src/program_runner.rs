//! Any program under one type, so that the control loop around it is compiled once.

use std::any::Any;
use std::fmt;
use tip_runtime::fault::Fault;
use tip_runtime::program::{Context, Flow, Program, Signature};

/// A program of any engine, compiled or interpreted, that can be copied in the middle of its run.
pub struct ProgramRunner(Box<dyn AnyProgram>);

/// A program of any type that can be copied.
trait AnyProgram: Program + Any + Send {
    fn boxed(&self) -> Box<dyn AnyProgram>;
}

impl<P: Program + Clone + Send + 'static> AnyProgram for P {
    fn boxed(&self) -> Box<dyn AnyProgram> {
        Box::new(self.clone())
    }
}

impl ProgramRunner {
    /// Takes a program as it is.
    pub fn new(program: impl Program + Clone + Send + 'static) -> Self {
        ProgramRunner(Box::new(program))
    }

    /// Returns the program, if it is one of type `P`.
    pub fn get<P: Program + 'static>(&self) -> Option<&P> {
        let program: &dyn Any = self.0.as_ref();
        program.downcast_ref()
    }
}

impl Clone for ProgramRunner {
    fn clone(&self) -> Self {
        ProgramRunner(self.0.boxed())
    }
}

impl fmt::Debug for ProgramRunner {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} at {}", self.0.name(), self.0.at())
    }
}

impl Program for ProgramRunner {
    fn signature(&self) -> Signature {
        self.0.signature()
    }

    fn name(&self) -> &str {
        self.0.name()
    }

    fn title(&self) -> &str {
        self.0.title()
    }

    fn at(&self) -> u32 {
        self.0.at()
    }

    fn step(&mut self, cx: &mut dyn Context) -> Result<Flow, Fault> {
        self.0.step(cx)
    }

    fn scalar(&self, i: usize) -> Option<(&str, Option<f64>)> {
        self.0.scalar(i)
    }

    fn set_scalar(&mut self, i: usize, value: f64) {
        self.0.set_scalar(i, value);
    }

    fn line(&self, step: u32) -> u32 {
        self.0.line(step)
    }

    fn reset(&mut self) {
        self.0.reset();
    }

    fn thread(&self, n: u8) -> Option<(&str, u32)> {
        self.0.thread(n)
    }

    fn select(&mut self, thread: u8) {
        self.0.select(thread);
    }

    fn begin(&mut self, thread: u8) {
        self.0.begin(thread);
    }

    fn specials(&self) -> usize {
        self.0.specials()
    }
}
