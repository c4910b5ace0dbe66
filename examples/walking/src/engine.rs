//! One program on a simulated robot of its own, with its trace.

use std::mem;
use tip_runtime::console::Console;
use tip_runtime::machine::{Machine, Mismatch, Status};
use tip_runtime::model::Model;
use tip_runtime::plant::SimulatedPlant;
use tip_runtime::program::Program;
use tip_runtime::record::{Ending, JsonLines};
use tip_sim::Interpreter;

/// The control loop around a program of type `P` and a console of type `C`.
pub type Loop<P, C, const L: usize, const J: usize> =
    Machine<'static, P, SimulatedPlant<L, J>, C, (), L, J>;

/// Puts a program on a simulated robot.
///
/// # Errors
/// The program was checked for another robot.
pub fn on_simulated_robot<P: Program, C: Console, const L: usize, const J: usize>(
    program: P,
    model: &'static Model<L, J>,
    console: C,
) -> Result<Loop<P, C, L, J>, Mismatch> {
    Machine::new(program, model, SimulatedPlant::new(model), console, ())
}

/// The reference interpreter of a program's text.
///
/// # Errors
/// The text does not load: the classical message of each error, one a line.
pub fn interpreter(name: &str, text: &str, options: &tipc::Options) -> Result<Interpreter, String> {
    let loaded = tipc::load(name, text.as_bytes(), options);
    loaded.program.map(Interpreter::new).ok_or_else(|| {
        let lines = loaded.diagnostics.iter();
        let lines = lines.map(|one| tipc::render::short(&loaded.source, one));
        lines.collect::<Vec<_>>().join("\n")
    })
}

/// A control loop whose trace is collected record by record.
pub struct Engine<P, C, const L: usize, const J: usize> {
    machine: Loop<P, C, L, J>,
    trace: JsonLines<String>,
}

impl<P: Program, C: Console, const L: usize, const J: usize> Engine<P, C, L, J> {
    /// `with_state` adds a hash of joint commands and measurements to each record.
    pub fn new(machine: Loop<P, C, L, J>, with_state: bool) -> Self {
        Engine {
            machine,
            trace: JsonLines::new(String::new(), with_state),
        }
    }

    /// Runs one control cycle.
    pub fn cycle(&mut self) -> Status {
        self.machine.cycle_traced(&mut self.trace)
    }

    /// Writes the last record.
    pub fn end(&mut self, ending: Ending) {
        self.trace.end(ending, self.machine.cycles());
    }

    /// The records since the last call.
    pub fn take_records(&mut self) -> String {
        mem::take(self.trace.get_mut())
    }

    /// The control loop.
    pub fn machine(&self) -> &Loop<P, C, L, J> {
        &self.machine
    }
}
