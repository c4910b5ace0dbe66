//! A program on a simulated robot, whatever the robot's size.

use crate::desk::Desk;
use crate::engine::Engine;
use crate::native::Native;
use crate::rig::Rig;
use std::any::Any;
use tip_runtime::command::Port;
use tip_runtime::hardware::JointCommand;
use tip_runtime::machine::{Emergency, Machine, Status};
use tip_runtime::plant::{Motion, Plant as _};
use tip_runtime::record::Sink;

/// The machine of a robot of some size. Each size has its own; logic stands outside.
pub(crate) trait Shell {
    fn boxed(&self) -> Box<dyn Shell>;
    fn cycle(&mut self, sink: Option<&mut dyn Sink>) -> Status;
    fn clocks(&self) -> Clocks;
    fn emergency(&self) -> Option<Emergency>;
    fn engine(&self) -> &Engine;
    fn engine_mut(&mut self) -> &mut Engine;
    fn desk(&self) -> &Desk;
    fn desk_mut(&mut self) -> &mut Desk;
    fn plant(&self) -> &dyn Any;
    fn motion(&self) -> Option<Motion>;
    /// What each joint was sent, and its angle as measured (deg), leg by leg.
    fn joints(&self) -> (&[JointCommand], &[f64]);
    fn lamps(&self) -> [u32; 8];
    fn has_input(&self, port: Port) -> bool;
    fn set_sensor(&mut self, port: Port, volts: f64);
    fn touch(&mut self, on: bool);
    fn fail_to_read(&mut self);
    fn fail_to_write(&mut self);
    fn pause(&mut self, on: bool);
}

/// How far a run has come.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Clocks {
    pub(crate) cycles: u64,
    /// ms.
    pub(crate) time: f64,
    /// ms.
    pub(crate) period: f64,
}

pub(crate) type Sized<const L: usize, const J: usize> =
    Machine<'static, Engine, Rig<L, J>, Desk, Native, L, J>;

impl<const L: usize, const J: usize> Shell for Sized<L, J> {
    fn boxed(&self) -> Box<dyn Shell> {
        Box::new(self.clone())
    }

    fn cycle(&mut self, sink: Option<&mut dyn Sink>) -> Status {
        match sink {
            Some(sink) => self.cycle_traced(sink),
            None => Machine::cycle(self),
        }
    }

    fn clocks(&self) -> Clocks {
        Clocks {
            cycles: self.cycles(),
            time: self.time(),
            period: self.period(),
        }
    }

    fn emergency(&self) -> Option<Emergency> {
        Machine::emergency(self).copied()
    }

    fn engine(&self) -> &Engine {
        self.program()
    }

    fn engine_mut(&mut self) -> &mut Engine {
        self.program_mut()
    }

    fn desk(&self) -> &Desk {
        self.console()
    }

    fn desk_mut(&mut self) -> &mut Desk {
        self.console_mut()
    }

    fn plant(&self) -> &dyn Any {
        self.hardware().plant()
    }

    fn motion(&self) -> Option<Motion> {
        self.hardware().motion()
    }

    fn joints(&self) -> (&[JointCommand], &[f64]) {
        let commands = self.outputs().joints.as_flattened();
        (commands, self.sensors().angles.as_flattened())
    }

    fn lamps(&self) -> [u32; 8] {
        self.outputs().lamps
    }

    fn has_input(&self, port: Port) -> bool {
        self.hardware().clone().set_sensor(port, 0.0)
    }

    fn set_sensor(&mut self, port: Port, volts: f64) {
        self.hardware_mut().set_sensor(port, volts);
    }

    fn touch(&mut self, on: bool) {
        self.hardware_mut().touch(on);
    }

    fn fail_to_read(&mut self) {
        self.hardware_mut().fail_to_read();
    }

    fn fail_to_write(&mut self) {
        self.hardware_mut().fail_to_write();
    }

    fn pause(&mut self, on: bool) {
        match on {
            true => Machine::pause(self),
            false => self.resume(),
        }
    }
}
