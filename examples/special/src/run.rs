//! A program on the simulated robot with the commands of its owner, and what came of it.

use crate::native::Native;
use tip_runtime::console::Console;
use tip_runtime::machine::{Machine, Mismatch, Status};
use tip_runtime::model::titan8;
use tip_runtime::plant::SimulatedPlant;
use tip_runtime::program::Program;
use tip_runtime::record::{Ending, JsonLines};
use tip_sim::Interpreter;

/// The simulated TITAN VIII.
pub type Plant = SimulatedPlant<4, 3>;

/// What came of a run.
#[derive(Clone, Debug)]
pub struct Run {
    /// How it ended.
    pub ending: Ending,
    /// Its trace, with a hash of the robot's state in each record.
    pub trace: String,
    /// Where the body was after each cycle, to the right and forward of its start: mm.
    pub path: Vec<[f64; 2]>,
    /// The robot at its end.
    pub plant: Plant,
}

impl Run {
    /// How far the body ever was from its start: mm.
    pub fn excursion(&self) -> f64 {
        self.path.iter().copied().map(length).fold(0.0, f64::max)
    }

    /// How far it was from there in the end: mm.
    pub fn rest(&self) -> f64 {
        self.path.last().copied().map_or(0.0, length)
    }
}

fn length([x, y]: [f64; 2]) -> f64 {
    x.hypot(y)
}

/// Runs a program to its end.
///
/// # Errors
/// The program was checked for another robot.
pub fn run<P: Program, C: Console>(program: P, console: C, plant: Plant) -> Result<Run, Mismatch> {
    let native = Native::default();
    let mut machine = Machine::new(program, &titan8::MODEL, plant, console, native)?;
    let mut trace = JsonLines::new(String::new(), true);
    let mut path = Vec::new();
    let ending = loop {
        let status = machine.cycle_traced(&mut trace);
        let body = machine.hardware().body();
        path.push([body.x, body.y]);
        match (status, machine.emergency()) {
            (Status::Finished(end), _) => break Ending::Program(end),
            (_, Some(emergency)) => break Ending::Emergency(*emergency),
            _ => {}
        }
    };
    trace.end(ending, machine.cycles());
    Ok(Run {
        ending,
        trace: trace.into_inner(),
        path,
        plant: machine.hardware().clone(),
    })
}

/// The reference interpreter of a program's text; `None` if it has errors.
pub fn interpreter(name: &str, text: &str) -> Option<Interpreter> {
    let loaded = tipc::load(name, text.as_bytes(), &tipc::Options::default());
    loaded.program.map(Interpreter::new)
}
