//! One program on a simulated robot of its own, with its trace.

use std::mem;
use tip_runtime::console::Console;
use tip_runtime::machine::{Machine, Mismatch, Status};
use tip_runtime::model::titan8;
use tip_runtime::plant::SimulatedPlant;
use tip_runtime::program::Program;
use tip_runtime::record::{Ending, JsonLines};
use tipc::interp::Interpreter;

/// The control loop around a program of type `P` and a console of type `C`.
pub type Loop<P, C> = Machine<'static, P, SimulatedPlant<4, 3>, C, (), 4, 3>;

/// Puts a program on a simulated TITAN VIII.
///
/// # Errors
/// The program was checked for another robot.
pub fn on_simulated_robot<P: Program, C: Console>(
    program: P,
    console: C,
) -> Result<Loop<P, C>, Mismatch> {
    let plant = SimulatedPlant::new(&titan8::MODEL);
    Machine::new(program, &titan8::MODEL, plant, console, ())
}

/// The reference interpreter of a program's text.
///
/// # Errors
/// The text does not load: the classical message of each error, one a line.
pub fn interpreter(name: &str, text: &str) -> Result<Interpreter, String> {
    let loaded = tipc::load(name, text.as_bytes(), &tipc::Options::default());
    loaded.program.map(Interpreter::new).ok_or_else(|| {
        let lines = loaded.diagnostics.iter();
        let lines = lines.map(|one| tipc::diagnostic::render_short(&loaded.source, one));
        lines.collect::<Vec<_>>().join("\n")
    })
}

/// A control loop whose trace is collected record by record.
pub struct Engine<P, C = ()> {
    machine: Loop<P, C>,
    trace: JsonLines<String>,
}

impl<P: Program, C: Console> Engine<P, C> {
    /// `with_state` adds a hash of joint commands and measurements to each record.
    ///
    /// # Errors
    /// The program was checked for another robot.
    pub fn new(program: P, console: C, with_state: bool) -> Result<Self, Mismatch> {
        Ok(Engine {
            machine: on_simulated_robot(program, console)?,
            trace: JsonLines::new(String::new(), with_state),
        })
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
    pub fn machine(&self) -> &Loop<P, C> {
        &self.machine
    }
}
