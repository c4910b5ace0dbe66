//! What a machine shows of itself.

use super::{Emergency, Machine, Status};
use crate::command::Flag;
use crate::controller::Controller;
use crate::hardware::{Outputs, Sensors};

impl<'m, P, H, C, S, const L: usize, const J: usize> Machine<'m, P, H, C, S, L, J> {
    /// What became of the program.
    pub fn status(&self) -> Status {
        self.crew.state.status
    }

    /// Why and where the robot stopped.
    pub fn emergency(&self) -> Option<&Emergency> {
        self.crew.state.emergency.as_ref()
    }

    /// The program.
    pub fn program(&self) -> &P {
        &self.crew.program
    }

    /// The program.
    pub fn program_mut(&mut self) -> &mut P {
        &mut self.crew.program
    }

    /// The robot.
    pub fn hardware(&self) -> &H {
        &self.body.hardware
    }

    /// The robot.
    pub fn hardware_mut(&mut self) -> &mut H {
        &mut self.body.hardware
    }

    /// The console.
    pub fn console(&self) -> &C {
        &self.crew.console
    }

    /// The console.
    pub fn console_mut(&mut self) -> &mut C {
        &mut self.crew.console
    }

    /// The controller.
    pub fn controller(&self) -> &Controller<'m, L, J> {
        &self.body.controller
    }

    /// Whether a flag of conditions (T.I.P. 3.1 §6-2) is up.
    pub fn flag(&self, flag: Flag) -> bool {
        match flag {
            Flag::Inpos(target) => self.body.controller.inpos(target),
            Flag::Near(target) => self.body.controller.near(target),
            flag => self.crew.state.board.flag(flag, &self.body.sensors.inputs),
        }
    }

    /// What was measured in the last cycle.
    pub fn sensors(&self) -> &Sensors<L, J> {
        &self.body.sensors
    }

    /// What was sent in the last cycle.
    pub fn outputs(&self) -> &Outputs<L, J> {
        &self.body.outputs
    }

    /// Cycles whose step ran without a fault.
    pub fn cycles(&self) -> u64 {
        self.crew.state.cycles
    }

    /// Time on the robot since the start, up to the end of the last cycle: ms.
    pub fn time(&self) -> f64 {
        self.crew.state.time
    }

    /// The sampling time: ms.
    pub fn period(&self) -> f64 {
        self.body.controller.period()
    }
}
