//! Any engine under one type, so that the control loop is compiled once.

use std::fmt;
use tip_runtime::fault::Fault;
use tip_runtime::program::{Context, Flow, Program, Signature};

/// A program of whatever engine.
pub struct Boxed(pub Box<dyn Program>);

impl fmt::Debug for Boxed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} at {}", self.0.name(), self.0.at())
    }
}

impl Program for Boxed {
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

    fn line(&self, step: u32) -> u32 {
        self.0.line(step)
    }

    fn reset(&mut self) {
        self.0.reset();
    }
}
