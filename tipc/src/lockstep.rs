//! Compiled code against the reference interpreter, cycle by cycle, each on a simulated robot of its own.
//!
//! `tipc verify` does this for programs on the robots that it knows. With commands or a robot of your own it takes a
//! few lines, in a test of your own:
//!
//! ```no_run
//! # type Walk = tipc::interp::Interpreter;
//! # let walk = || -> Walk { unimplemented!() };
//! use tip_runtime::{model::titan8, plant::SimulatedPlant};
//! use tipc::lockstep::{Reach, Rig};
//!
//! let source = b"3.1\nthe text of walk.prg\nEND\n";
//! let loaded = tipc::load("walk.prg", source, &tipc::Options::default());
//! let rig = Rig {
//!     program: loaded.program.expect("it loads"),
//!     compiled: walk(), // Walk::new()
//!     model: &titan8::MODEL,
//!     plant: SimulatedPlant::new(&titan8::MODEL),
//!     special: (), // your commands
//! };
//! let mut reach = Reach::new(&rig.program);
//! for inputs in ["--cycles 5000", "--keys 300:F,900:S --halt 2000"] {
//!     let run = rig.run(&inputs.parse().unwrap(), &mut reach).unwrap();
//!     assert_eq!(run.divergence, None);
//! }
//! ```

mod answer;
pub mod inputs;
mod reach;
mod side;

pub use answer::{Answer, RunEnd, serve};
pub use inputs::Inputs;
pub use reach::Reach;

#[cfg(test)]
mod tests;

use crate::interp::Interpreter;
use crate::program::{self, StepId};
use side::Side;
use std::fmt;
use tip_runtime::machine::Mismatch;
use tip_runtime::model::Model;
use tip_runtime::plant::Plant;
use tip_runtime::program::Program;
use tip_runtime::record::Ending;
use tip_runtime::special::Special;

/// The most cycles of a run that is told no limit: a program may run forever.
pub const LIMIT: u64 = 10_000;

/// A program in both forms, and the robot that each run begins with.
#[derive(Clone, Debug)]
pub struct Rig<'m, P, H, S, const L: usize, const J: usize> {
    /// For the interpreter.
    pub program: program::Program,
    /// The generated code.
    pub compiled: P,
    /// The robot.
    pub model: &'m Model<L, J>,
    /// The robot, simulated.
    pub plant: H,
    /// Its special commands.
    pub special: S,
}

/// What came of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// How many cycles were compared.
    pub cycles: u64,
    /// How both engines ended; `None` if they diverged.
    pub ending: Option<Ending>,
    /// Where they diverged.
    pub divergence: Option<Divergence>,
    /// The spots that no run before came by, by their places in [`Spots::all`](crate::analysis::spots::Spots::all).
    pub new: Vec<usize>,
    /// Some cycles whose step had an edge that no run went along yet: where another input may change the way.
    pub chances: Vec<u64>,
}

/// The first difference between the engines.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Divergence {
    /// The cycle.
    pub cycle: u64,
    /// The step that the interpreter ran.
    pub step: StepId,
    /// The interpreter's record of it.
    pub interpreted: String,
    /// That of the generated code.
    pub compiled: String,
}

/// Why there was no run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refused {
    /// The program is for another robot.
    Mismatch(Mismatch),
    /// The robot has no input of that name.
    NoInput(String),
}

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Refused::Mismatch(mismatch) => mismatch.fmt(f),
            Refused::NoInput(name) => write!(f, "the robot has no input {name}"),
        }
    }
}

impl std::error::Error for Refused {}

impl<P, H, S, const L: usize, const J: usize> Rig<'_, P, H, S, L, J>
where
    P: Program + Clone,
    H: Plant<L, J> + Clone,
    S: Special + Clone,
{
    /// Runs both until they end, `inputs.cycles` (else [`LIMIT`]) are used up, or their records differ in a byte:
    /// these show every assignment, message, lamp and command, and a hash over the bits of all joints.
    ///
    /// # Errors
    /// The inputs or the program are for another robot.
    pub fn run(&self, inputs: &Inputs, reach: &mut Reach) -> Result<Run, Refused> {
        self.check(inputs)?;
        let limit = inputs.cycles.unwrap_or(LIMIT);
        let interpreter = Interpreter::new(self.program.clone());
        let mut interpreted = Side::new(interpreter, self, inputs)?;
        let mut compiled = Side::new(self.compiled.clone(), self, inputs)?;
        let mut run = Run {
            cycles: 0,
            ending: None,
            divergence: None,
            new: Vec::new(),
            chances: Vec::new(),
        };
        while run.ending.is_none() {
            let cycle = run.cycles;
            let from = interpreted.program().place();
            run.ending = interpreted.cycle(limit);
            compiled.cycle(limit);
            if interpreted.record() != compiled.record() {
                run.ending = None;
                run.divergence = Some(divergence(
                    cycle,
                    from.step,
                    interpreted.record(),
                    compiled.record(),
                ));
                break;
            }
            run.cycles = interpreted.cycles();
            if run.cycles > cycle {
                let to = run.ending.is_none().then(|| interpreted.program().place());
                run.new.extend(reach.note(from, to));
                reach.chance(cycle, from, &mut run.chances);
            }
        }
        Ok(run)
    }

    /// Refuses inputs that the robot lacks.
    fn check(&self, inputs: &Inputs) -> Result<(), Refused> {
        let mut plant = self.plant.clone();
        let mut sensors = inputs.sensors.iter();
        let missing = sensors.find(|sensor| !plant.set_sensor(sensor.port, sensor.volts));
        missing.map_or(Ok(()), |sensor| {
            Err(Refused::NoInput(sensor.port.to_string()))
        })
    }
}

/// The first records that differ; the last cycle has two.
fn divergence(cycle: u64, step: StepId, interpreted: &str, compiled: &str) -> Divergence {
    let nothing = "(no record)";
    let lines = |text: &str| -> Vec<String> { text.lines().map(str::to_owned).collect() };
    let (left, right) = (lines(interpreted), lines(compiled));
    let same = left.iter().zip(&right).take_while(|(a, b)| a == b).count();
    let at = |lines: &[String]| lines.get(same).map_or(nothing, String::as_str).to_owned();
    Divergence {
        cycle,
        step,
        interpreted: at(&left),
        compiled: at(&right),
    }
}
