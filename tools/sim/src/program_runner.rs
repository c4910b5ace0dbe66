//! One type for all programs, so that the control loop is compiled once.

use crate::interp::Interpreter;
use std::any::Any;
use std::fmt;
use std::sync::Arc;
use tip_lint::coverage_points::ProgramPoint;
use tip_runtime::fault::Fault;
use tip_runtime::program::{Context, Flow, Program, Signature};

/// A program of any engine, compiled or interpreted, that can be copied in the middle of its run.
pub struct ProgramRunner {
    program: Box<dyn AnyProgram>,
    replacements: Arc<[Replacement]>,
    /// The steps of the present cycle, if they are recorded.
    trail: Option<Vec<StepTaken>>,
}

/// A step that ran to its end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StepTaken {
    /// The point at which it ran.
    pub from: ProgramPoint,
    /// The point that it led to, which is itself if it waits; `None` at the end of the program or thread.
    pub to: Option<ProgramPoint>,
}

/// A value that a scalar gets in place of the constant that some steps of the program assign to it.
#[derive(Clone, Debug, PartialEq)]
pub struct Replacement {
    /// The scalar, by its place in the order of declaration.
    pub scalar: usize,
    /// The value; it is finite.
    pub value: f64,
    /// The steps, in ascending order.
    pub steps: Vec<u32>,
}

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
    /// Wraps a program.
    pub fn new(program: impl Program + Clone + Send + 'static) -> Self {
        ProgramRunner {
            program: Box::new(program),
            replacements: Arc::default(),
            trail: None,
        }
    }

    /// Replaces constants that steps of the program assign.
    #[must_use]
    pub fn with_replacements(mut self, replacements: impl Into<Arc<[Replacement]>>) -> Self {
        self.replacements = replacements.into();
        self
    }

    /// Begins the trail of a cycle, if its steps are followed.
    pub(crate) fn begin_trail(&mut self) {
        self.trail.iter_mut().for_each(Vec::clear);
    }

    /// Records the steps from now on.
    pub(crate) fn follow(&mut self) {
        self.trail.get_or_insert_default();
    }

    /// Returns the steps of the present cycle; none unless they are followed.
    pub(crate) fn trail(&self) -> &[StepTaken] {
        self.trail.as_deref().unwrap_or_default()
    }

    /// Returns the point before the next step. Compiled code does not tell how it came to an ELSEIF or ELSE.
    fn point(&self) -> ProgramPoint {
        match self.get::<Interpreter>() {
            Some(interpreter) => interpreter.place(),
            None => ProgramPoint {
                step: self.program.at(),
                not_taken: false,
            },
        }
    }

    /// Returns the program, if it is one of type `P`.
    pub fn get<P: Program + 'static>(&self) -> Option<&P> {
        let program: &dyn Any = self.program.as_ref();
        program.downcast_ref()
    }
}

impl Clone for ProgramRunner {
    fn clone(&self) -> Self {
        ProgramRunner {
            program: self.program.boxed(),
            replacements: Arc::clone(&self.replacements),
            trail: self.trail.clone(),
        }
    }
}

impl fmt::Debug for ProgramRunner {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} at {}", self.program.name(), self.program.at())
    }
}

impl Program for ProgramRunner {
    fn signature(&self) -> Signature {
        self.program.signature()
    }

    fn name(&self) -> &str {
        self.program.name()
    }

    fn title(&self) -> &str {
        self.program.title()
    }

    fn at(&self) -> u32 {
        self.program.at()
    }

    fn step(&mut self, cx: &mut dyn Context) -> Result<Flow, Fault> {
        let step = self.program.at();
        let from = self.trail.is_some().then(|| self.point());
        let flow = self.program.step(cx)?;
        if let Some(from) = from {
            let goes_on = matches!(flow, Flow::Next | Flow::Wait);
            let to = goes_on.then(|| self.point());
            self.trail
                .iter_mut()
                .for_each(|trail| trail.push(StepTaken { from, to }));
        }
        for replacement in self.replacements.iter() {
            if replacement.steps.binary_search(&step).is_ok() {
                let Replacement { scalar, value, .. } = *replacement;
                self.program.set_scalar(scalar, value);
            }
        }
        Ok(flow)
    }

    fn scalar(&self, i: usize) -> Option<(&str, Option<f64>)> {
        self.program.scalar(i)
    }

    fn set_scalar(&mut self, i: usize, value: f64) {
        self.program.set_scalar(i, value);
    }

    fn line(&self, step: u32) -> u32 {
        self.program.line(step)
    }

    fn reset(&mut self) {
        self.program.reset();
    }

    fn thread(&self, n: u8) -> Option<(&str, u32)> {
        self.program.thread(n)
    }

    fn select(&mut self, thread: u8) {
        self.program.select(thread);
    }

    fn begin(&mut self, thread: u8) {
        self.program.begin(thread);
    }

    fn specials(&self) -> usize {
        self.program.specials()
    }
}
