//! Compiled code against the reference interpreter, cycle by cycle, each on a simulated robot of its own.
//!
//! `tip verify` does this for programs on the robots that have a name. With commands or a robot of your own it takes a
//! few lines, in a test of your own; the front page of this crate has an example.
//!
//! In this example the compiled code comes from a text with another MESSAGE, and the engines differ in the cycle of
//! that step:
//!
//! ```
//! use tip_sim::lockstep::Lockstep;
//! use tip_sim::{Inputs, Robot, load};
//!
//! tip_macros::tip!(Greet, "3.1\nGreet\nLAMP_ON 1\nMESSAGE hello\nEND");
//!
//! let robot = Robot::named("titan8")?;
//! let program = load("Greet", "3.1\nGreet\nLAMP_ON 1\nMESSAGE Hello\nEND", &robot)?.program().clone();
//! let lockstep = Lockstep::new(program, Greet::new(), &robot)?;
//! assert_eq!(lockstep.unlike(), None, "name, title, lines and variables are the same");
//!
//! let compared = lockstep.run(&Inputs::default(), &mut ())?;
//! let divergence = compared.divergence.expect("they differ");
//! assert_eq!((divergence.cycle, divergence.step), (1, 1));
//! assert!(divergence.interpreted.contains(r#""say":"Hello""#));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod answer;
mod side;

pub use answer::{Answer, ReachedPoints, RunEnd, Session, serve};

use crate::event::{Inputs, Refused};
use crate::interp::Interpreter;
use crate::program_runner::StepTaken;
use crate::robot::Robot;
use crate::run::Run;
use serde::{Deserialize, Serialize};
use side::Side;
use std::sync::Arc;
use tip_runtime::machine::Mismatch;
use tip_runtime::program::Program;
use tip_runtime::record::{Ending, Sink};
use tipc::program::{self, StepId};

/// Maximum number of cycles of a run without a limit of its own: a program may run forever.
pub const LIMIT: u64 = 10_000;

/// The part of each cycle that is compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Evidence {
    /// The record of the trace, to the byte: every assignment, message, lamp and command, and a hash over the bits of
    /// all joints.
    Records,
    /// A running hash of the records, of every variable and of all console output. It is fast. If it differs, the run
    /// is repeated, and both sides write that cycle in words.
    Hashes,
}

/// Observes the interpreter while both engines agree.
pub trait LockstepObserver {
    /// Called after each cycle for each step that ran to its end in it.
    fn went(&mut self, cycle: u64, step: StepTaken) {
        let _ = (cycle, step);
    }

    /// Returns the sink that records the interpreter's cycle, if there is one.
    fn sink(&mut self) -> Option<&mut dyn Sink> {
        None
    }

    /// Called after each cycle of both engines; the last one may have ended them.
    fn after(&mut self, interpreted: &Run) {
        let _ = interpreted;
    }
}

impl LockstepObserver for () {}

/// The result for a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Compared {
    /// Number of cycles that were compared; one that stops the robot is not counted.
    pub cycles: u64,
    /// End of both engines; `None` if they diverged.
    pub ending: Option<Ending>,
    /// The point at which they diverged.
    pub divergence: Option<Divergence>,
    /// A hash of everything that both did, if hashes were compared.
    pub hash: u64,
}

/// The first difference between the engines.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, Serialize)]
pub struct Divergence {
    /// The cycle.
    pub cycle: u64,
    /// The step that the interpreter ran; the first one of the cycle if hashes were compared.
    pub step: StepId,
    /// The interpreter's cycle: its record, or words.
    pub interpreted: String,
    /// The compiled code's cycle.
    pub compiled: String,
}

/// A program in both forms on two robots, each before its first cycle.
#[derive(Clone, Debug)]
pub struct Lockstep {
    program: Arc<program::Program>,
    interpreted: Run,
    compiled: Run,
    evidence: Evidence,
}

impl Lockstep {
    /// Creates a comparison of the records of a program and its compiled code, each on a robot of its own.
    ///
    /// # Errors
    /// One of them is for another robot.
    pub fn new(
        program: impl Into<Arc<program::Program>>,
        compiled: impl Program + Clone + Send + 'static,
        robot: &Robot,
    ) -> Result<Self, Mismatch> {
        Self::comparing(Evidence::Records, program, compiled, robot)
    }

    /// Creates a comparison of records or hashes.
    ///
    /// # Errors
    /// One of them is for another robot.
    pub fn comparing(
        evidence: Evidence,
        program: impl Into<Arc<program::Program>>,
        compiled: impl Program + Clone + Send + 'static,
        robot: &Robot,
    ) -> Result<Self, Mismatch> {
        let program = program.into();
        Ok(Lockstep {
            interpreted: Run::new(Interpreter::new(program.clone()), robot.clone())?.followed(),
            compiled: Run::new(compiled, robot.clone())?,
            program,
            evidence,
        })
    }

    /// Returns the program.
    pub fn program(&self) -> &Arc<program::Program> {
        &self.program
    }

    /// Returns the first difference between the engines' data about the program: robot, name, title, source lines of
    /// the steps, names of the variables.
    pub fn unlike(&self) -> Option<Divergence> {
        let facts = |run: &Run| {
            let program = run.program();
            let lines = (0..).map(|step| program.line(step));
            let lines: Vec<u32> = lines.take_while(|line| *line > 0).collect();
            let names = (0..).map_while(|n| program.scalar(n).map(|(name, _)| name.to_owned()));
            let names: Vec<String> = names.collect();
            let named = (program.name(), program.title());
            format!("{:?} {named:?} {lines:?} {names:?}", program.signature())
        };
        let (interpreted, compiled) = (facts(&self.interpreted), facts(&self.compiled));
        (interpreted != compiled).then_some(Divergence {
            cycle: 0,
            step: 0,
            interpreted,
            compiled,
        })
    }

    /// Runs both until they end, `inputs.cycles` (else [`LIMIT`]) are used up, or they differ.
    ///
    /// # Errors
    /// The robot lacks an input.
    pub fn run(
        &self,
        inputs: &Inputs,
        scout: &mut dyn LockstepObserver,
    ) -> Result<Compared, Refused> {
        let limit = inputs.cycles.unwrap_or(LIMIT);
        let [mut interpreted, mut compiled] = self.sides(inputs)?;
        let mut compared = Compared {
            cycles: 0,
            ending: None,
            divergence: None,
            hash: 0,
        };
        while compared.ending.is_none() {
            let cycle = compared.cycles;
            let ending = interpreted.cycle(limit, scout.sink());
            compiled.cycle(limit, None);
            if !interpreted.equals(&compiled) {
                let (record, [reported, other]) = match self.evidence {
                    Evidence::Records => side::first_difference(&interpreted, &compiled),
                    Evidence::Hashes => (0, self.in_words(inputs, cycle)?),
                };
                compared.divergence = Some(Divergence {
                    cycle,
                    step: interpreted.step(record),
                    interpreted: reported,
                    compiled: other,
                });
                break;
            }
            compared.ending = ending;
            compared.cycles = interpreted.cycles();
            if ending != Some(Ending::Limit) {
                let steps = interpreted.run().steps().iter();
                steps.for_each(|step| scout.went(cycle, *step));
                scout.after(interpreted.run());
            }
        }
        compared.hash = interpreted.hash();
        Ok(compared)
    }

    fn sides(&self, inputs: &Inputs) -> Result<[Side; 2], Refused> {
        let side = |run: &Run| -> Result<Side, Refused> {
            let run = run.clone().with_events(&inputs.events)?;
            Ok(Side::new(run, self.evidence))
        };
        Ok([side(&self.interpreted)?, side(&self.compiled)?])
    }

    /// Describes the cycle of both sides.
    fn in_words(&self, inputs: &Inputs, cycle: u64) -> Result<[String; 2], Refused> {
        let limit = inputs.cycles.unwrap_or(LIMIT);
        let sides = self.sides(inputs)?;
        Ok(sides.map(|mut side| {
            (0..cycle).for_each(|_| {
                side.cycle(limit, None);
            });
            side.in_words(limit)
        }))
    }
}
