//! A trait for machines of any size, without logic of its own: the machine is that of tip-runtime.

use crate::event_console::EventConsole;
use crate::program_runner::ProgramRunner;
use crate::sim_hardware::SimHardware;
use tip_runtime::command::{Flag, MAX, Poll, Reading, Target};
use tip_runtime::controller::Setpoint;
use tip_runtime::fault::Fault;
use tip_runtime::hardware::JointCommand;
use tip_runtime::machine::{Emergency, Machine, Status};
use tip_runtime::model::Range;
use tip_runtime::program::Robot;
use tip_runtime::record::Sink;
use tip_runtime::special::{Call, Special};

/// A program on a simulated robot of any size.
pub(crate) trait DynMachine: Send {
    fn boxed(&self) -> Box<dyn DynMachine>;
    fn cycle(&mut self, sink: Option<&mut dyn Sink>) -> Status;
    fn pause(&mut self, on: bool);
    fn program(&self) -> &ProgramRunner;
    fn program_mut(&mut self) -> &mut ProgramRunner;
    fn console(&self) -> &EventConsole;
    fn console_mut(&mut self) -> &mut EventConsole;
    fn hardware(&self) -> &SimHardware;
    fn hardware_mut(&mut self) -> &mut SimHardware;
    fn emergency(&self) -> Option<&Emergency>;
    fn cycles(&self) -> u64;
    /// Returns the time on the robot, ms.
    fn time(&self) -> f64;
    /// Returns the sampling time, ms.
    fn period(&self) -> f64;
    fn flag(&self, flag: Flag) -> bool;
    /// Returns the members of a special variable, from the readings of the last cycle.
    fn reading(&self, reading: Reading) -> Result<[f64; MAX], Fault>;
    fn setpoints(&self) -> Vec<Setpoint>;
    /// Returns the locked joints.
    fn locked(&self) -> Vec<Target>;
    /// Returns the working limits in force, leg by leg, deg.
    fn limits(&self) -> Vec<Range>;
    fn thread_runs(&self, thread: u8) -> bool;
    /// Returns the time of a timer, ms.
    fn timer(&self, n: u8) -> f64;
    /// Returns the last command of each joint, leg by leg.
    fn commands(&self) -> &[JointCommand];
    /// Returns the measured angle of each joint, leg by leg, deg.
    fn angles(&self) -> &[f64];
    fn lamps(&self) -> &[u32; 8];
}

impl<const L: usize, const J: usize> DynMachine
    for Machine<ProgramRunner, SimHardware, L, J, EventConsole, Box<dyn NativeCommands>>
{
    fn boxed(&self) -> Box<dyn DynMachine> {
        Box::new(self.clone())
    }

    fn cycle(&mut self, sink: Option<&mut dyn Sink>) -> Status {
        match sink {
            Some(sink) => self.cycle_traced(sink),
            None => self.cycle(),
        }
    }

    fn pause(&mut self, on: bool) {
        match on {
            true => self.pause(),
            false => self.resume(),
        }
    }

    fn program(&self) -> &ProgramRunner {
        self.program()
    }

    fn program_mut(&mut self) -> &mut ProgramRunner {
        self.program_mut()
    }

    fn console(&self) -> &EventConsole {
        self.console()
    }

    fn console_mut(&mut self) -> &mut EventConsole {
        self.console_mut()
    }

    fn hardware(&self) -> &SimHardware {
        self.hardware()
    }

    fn hardware_mut(&mut self) -> &mut SimHardware {
        self.hardware_mut()
    }

    fn emergency(&self) -> Option<&Emergency> {
        self.emergency()
    }

    fn cycles(&self) -> u64 {
        self.cycles()
    }

    fn time(&self) -> f64 {
        self.time()
    }

    fn period(&self) -> f64 {
        self.period()
    }

    fn flag(&self, flag: Flag) -> bool {
        self.flag(flag)
    }

    fn reading(&self, reading: Reading) -> Result<[f64; MAX], Fault> {
        match reading {
            Reading::Timer(n) => {
                let mut members = [0.0; MAX];
                members[0] = self.timer(n);
                Ok(members)
            }
            Reading::Measured(what, target) => self.controller().teach(what, target),
        }
    }

    fn setpoints(&self) -> Vec<Setpoint> {
        self.controller().setpoints().collect()
    }

    fn locked(&self) -> Vec<Target> {
        self.controller().locked().collect()
    }

    fn limits(&self) -> Vec<Range> {
        self.controller().limits().collect()
    }

    fn thread_runs(&self, thread: u8) -> bool {
        self.thread_runs(thread)
    }

    fn timer(&self, n: u8) -> f64 {
        self.timer(n)
    }

    fn commands(&self) -> &[JointCommand] {
        self.outputs().joints.as_flattened()
    }

    fn angles(&self) -> &[f64] {
        self.sensors().angles.as_flattened()
    }

    fn lamps(&self) -> &[u32; 8] {
        &self.outputs().lamps
    }
}

/// The native code of SPECIAL, which can be copied in the middle of a run.
pub(crate) trait NativeCommands: Special + Send {
    fn boxed(&self) -> Box<dyn NativeCommands>;
}

impl<S: Special + Clone + Send + 'static> NativeCommands for S {
    fn boxed(&self) -> Box<dyn NativeCommands> {
        Box::new(self.clone())
    }
}

impl Clone for Box<dyn NativeCommands> {
    fn clone(&self) -> Self {
        self.as_ref().boxed()
    }
}

impl Special for Box<dyn NativeCommands> {
    fn poll(&mut self, call: Call, robot: &mut dyn Robot) -> Result<Poll, Fault> {
        self.as_mut().poll(call, robot)
    }

    fn cycle(&mut self, robot: &mut dyn Robot) -> Result<(), Fault> {
        self.as_mut().cycle(robot)
    }
}
