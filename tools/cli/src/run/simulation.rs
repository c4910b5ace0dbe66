//! The run itself: cycle after cycle until something ends it.

use super::super::error::Error;
use super::interrupt;
use super::screen::Screen;
use super::trace::Trace;
use tip_runtime::console::Scripted;
use tip_runtime::machine::{Machine, Status};
use tip_runtime::model::Model;
use tip_runtime::plant::Plant;
use tip_runtime::record::Ending;
use tip_runtime::special::Special;
use tipc::interp::Interpreter;
use tipc::lockstep::Inputs;
use tipc::lockstep::inputs::Due;

/// The keys of the command line in front of the screen.
type Console = Scripted<Screen>;

/// A robot that is simulated, and the native commands that it knows.
pub(super) struct Simulated<'m, P, S, const L: usize, const J: usize> {
    pub(super) model: &'m Model<L, J>,
    pub(super) plant: P,
    pub(super) special: S,
}

/// A program on the simulated robot.
pub(super) struct Simulation<'m, P, S, const L: usize, const J: usize> {
    machine: Machine<'m, Interpreter, P, Console, S, L, J>,
    /// What the inputs are going to read.
    due: Due,
}

impl<'m, P: Plant<L, J>, S: Special, const L: usize, const J: usize> Simulation<'m, P, S, L, J> {
    /// Puts the program on the robot.
    pub(super) fn new(
        program: Interpreter,
        robot: Simulated<'m, P, S, L, J>,
        screen: Screen,
        inputs: &Inputs,
    ) -> Result<Self, Error> {
        let Simulated {
            model,
            plant,
            special,
        } = robot;
        let machine = Machine::new(program, model, plant, inputs.console(screen), special)
            .map_err(|mismatch| Error::Usage(mismatch.to_string()))?;
        let due = Due::new(&inputs.sensors);
        Ok(Simulation { machine, due })
    }

    /// Runs until the program ends, `limit` cycles are used up, or the run is interrupted.
    pub(super) fn run(&mut self, limit: Option<u64>, mut trace: Option<&mut Trace>) -> Ending {
        loop {
            let cycle = self.machine.cycles();
            if limit.is_some_and(|limit| cycle >= limit) {
                return Ending::Limit;
            }
            if interrupt::is_requested() {
                return Ending::Interrupted;
            }
            self.set_sensors(cycle);
            let status = match &mut trace {
                Some(trace) => self.machine.cycle_traced(trace.sink()),
                None => self.machine.cycle(),
            };
            if let Some(ending) = self.ending(status) {
                return ending;
            }
            if trace.as_ref().is_some_and(|trace| !trace.is_open()) {
                interrupt::request();
            }
            self.screen().at(cycle);
        }
    }

    fn ending(&self, status: Status) -> Option<Ending> {
        match status {
            Status::Running => None,
            Status::Finished(end) => Some(Ending::Program(end)),
            Status::Emergency => self.machine.emergency().copied().map(Ending::Emergency),
        }
    }

    fn set_sensors(&mut self, cycle: u64) {
        while let Some(sensor) = self.due.next(cycle) {
            self.machine
                .hardware_mut()
                .set_sensor(sensor.port, sensor.volts);
        }
    }

    /// Control cycles whose step ran without a fault.
    pub(super) fn cycles(&self) -> u64 {
        self.machine.cycles()
    }

    /// The program as the run left it.
    pub(super) fn program(&self) -> &Interpreter {
        self.machine.program()
    }

    /// Gives the terminal back and completes the log files.
    pub(super) fn close(&mut self) -> Result<(), Error> {
        self.screen().close()
    }

    fn screen(&mut self) -> &mut Screen {
        self.machine.console_mut().inner_mut()
    }
}
