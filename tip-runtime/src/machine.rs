//! The control loop: sample sensors, run one step, advance the trajectories, write to the robot.

mod context;
mod devices;
mod graphs;
mod keyboard;
mod mismatch;
mod sampling;
mod view;

pub use crate::emergency::{Emergency, Report};
pub use mismatch::Mismatch;

use crate::console::Console;
use crate::fault::Fault;
use crate::hardware::{Hardware, HardwareFault, Outputs};
use crate::model::{Family, Model};
use crate::program::{End, Flow, Program};
use crate::record::{self, Dump, Sample, Sink};
use crate::special::Special;
use context::StepContext;
use devices::Devices;

/// The software emergency stop.
const RETURN_KEY: u8 = 0x0D;
/// The halt request.
const ESCAPE_KEY: u8 = 0x1B;
/// The most bytes taken from the console in one cycle, so that an endless source cannot stall it.
const KEYS_PER_CYCLE: usize = 256;

/// What became of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// It runs, or is paused.
    Running,
    /// It ended itself; the servo loop goes on.
    Finished(End),
    /// The robot is in emergency stop.
    Emergency,
}

impl Status {
    /// The program has not ended yet.
    pub const fn is_running(self) -> bool {
        matches!(self, Status::Running)
    }
}

/// A program on a robot.
///
/// Each call of [`cycle`](Self::cycle) is one control cycle (T.I.P. 3.1 §3-2) and runs one step. It
/// neither allocates nor blocks; pacing it is the caller's affair. It may be called after the
/// program's end, and should be: the robot has to come to rest and to be held, or to be stopped
/// again and again.
#[derive(Clone, Debug)]
pub struct Machine<'m, P, H, C, S, const L: usize, const J: usize> {
    program: P,
    hardware: H,
    console: C,
    special: S,
    devices: Devices<'m, L, J>,
    status: Status,
    emergency: Option<Emergency>,
    /// What went wrong behind the last step, to be found in the next cycle.
    pending: Option<Fault>,
    /// The last step waits, so that the next cycle continues it.
    waiting: bool,
    paused: bool,
    stop_requested: bool,
    cycles: u64,
    /// Since the start: ms.
    time: f64,
    /// When the sensors were sampled.
    sampled_at: f64,
}

impl<'m, P, H, C, S, const L: usize, const J: usize> Machine<'m, P, H, C, S, L, J>
where
    P: Program,
    H: Hardware<L, J>,
    C: Console,
    S: Special,
{
    /// Puts a program on a robot.
    ///
    /// # Errors
    /// The program was checked for another robot.
    pub fn new(
        program: P,
        model: &'m Model<L, J>,
        hardware: H,
        console: C,
        special: S,
    ) -> Result<Self, Mismatch> {
        Mismatch::check(program.signature(), model.signature())?;
        Ok(Machine {
            program,
            hardware,
            console,
            special,
            devices: Devices::new(model),
            status: Status::Running,
            emergency: None,
            pending: None,
            waiting: false,
            paused: false,
            stop_requested: false,
            cycles: 0,
            time: 0.0,
            sampled_at: 0.0,
        })
    }

    /// Runs one control cycle.
    pub fn cycle(&mut self) -> Status {
        self.control(None)
    }

    /// Runs one control cycle and tells `sink` about it.
    pub fn cycle_traced(&mut self, sink: &mut dyn Sink) -> Status {
        self.control(Some(sink))
    }

    fn control(&mut self, sink: Option<&mut dyn Sink>) -> Status {
        if let Some(emergency) = &self.emergency {
            self.hardware.stop(&emergency.fault);
        } else if let Err(fault) = self.sample().and_then(|()| self.act(sink)) {
            self.stop(fault);
        }
        self.status
    }

    /// Phase 1: every sensor, the keyboard, and what the controller makes of it.
    fn sample(&mut self) -> Result<(), Fault> {
        if let Some(fault) = self.pending.take() {
            return Err(fault);
        }
        self.sampled_at = self.time;
        self.hardware
            .read(&mut self.devices.sensors)
            .map_err(hardware_fault)?;
        self.take_keys();
        if core::mem::take(&mut self.stop_requested) {
            return Err(Fault::EmergencyKey);
        }
        self.devices.controller.sense(&self.devices.sensors)
    }

    fn take_keys(&mut self) {
        for _ in 0..KEYS_PER_CYCLE {
            match self.console.key(self.cycles) {
                Some(byte) => self.key(byte),
                None => break,
            }
        }
    }

    /// Phases 2 and 3: one step, unless there is none to run, then the robot.
    fn act(&mut self, mut sink: Option<&mut dyn Sink>) -> Result<(), Fault> {
        if !self.status.is_running() || self.paused {
            self.drive();
            return Ok(());
        }
        let step = self.program.at();
        let flow = self.step(sink.as_mut().map(|sink| &mut **sink as &mut dyn Sink))?;
        self.serve_console(step);
        if !matches!(flow, Flow::Finished(_)) {
            self.pending = self.special.cycle(&mut self.devices).err();
        }
        self.drive();
        self.log();
        let next = match flow {
            Flow::Next | Flow::Wait => Some(self.program.at()),
            Flow::Finished(_) => None,
        };
        if let Some(sink) = sink {
            self.record(sink, step, next);
        }
        self.cycles += 1;
        if let Flow::Finished(end) = flow {
            self.status = Status::Finished(end);
            self.console.ended();
        }
        Ok(())
    }

    /// Phase 2.
    fn step(&mut self, mut sink: Option<&mut dyn Sink>) -> Result<Flow, Fault> {
        if let Some(sink) = &mut sink {
            sink.begin(&self.program);
        }
        let flow = self.program.step(&mut StepContext {
            devices: &mut self.devices,
            special: &mut self.special,
            console: &mut self.console,
            sink: sink.map(|sink| sink as &mut dyn Sink),
            first: !self.waiting,
        })?;
        self.waiting = flow == Flow::Wait;
        if let Flow::Finished(_) = flow {
            self.devices.controller.finish();
        }
        Ok(flow)
    }

    /// What the step asked of the console and could not reach itself.
    fn serve_console(&mut self, step: u32) {
        if let Some(on) = self.devices.silence.take() {
            self.console.silent(on);
        }
        let devices = &mut self.devices;
        let torques = &devices.sensors.torques;
        let console = &mut self.console;
        devices
            .graphs
            .show(self.sampled_at, torques, &devices.controller, console);
        if core::mem::take(&mut self.devices.dump_requested) {
            self.console.variables(&Dump {
                program: &self.program,
                cycle: self.cycles,
                step,
            });
        }
    }

    /// Phase 3: trajectories, servo and plant advance by one sampling time.
    fn drive(&mut self) {
        let period = self.period();
        let devices = &mut self.devices;
        devices.controller.advance();
        devices.outputs = Outputs {
            joints: devices.controller.outputs(),
            slider: devices.controller.slider(),
            lamps: devices.lamps,
            period,
        };
        devices.release_after_dump();
        if let Err(fault) = self.hardware.write(&self.devices.outputs) {
            self.pending.get_or_insert(hardware_fault(fault));
        }
        self.time += period;
    }

    /// Hands a row of TITAN.LOG to the console if this cycle is to be sampled.
    fn log(&mut self) {
        if !self.devices.sampling.take() {
            return;
        }
        let Devices {
            model,
            sensors,
            outputs,
            ..
        } = &self.devices;
        let senses_torque = !matches!(model.family, Family::Titan);
        self.console.sample(&Sample {
            cycle: self.cycles,
            time: self.sampled_at,
            joints_per_leg: J,
            angles: sensors.angles.as_flattened(),
            commands: outputs.joints.as_flattened(),
            torques: if senses_torque {
                sensors.torques.as_flattened()
            } else {
                &[]
            },
            paws: &sensors.paws,
            knobs: &sensors.knobs,
            antenna: sensors.antenna,
        });
    }

    fn record(&self, sink: &mut dyn Sink, step: u32, next: Option<u32>) {
        sink.cycle(&record::Cycle {
            number: self.cycles,
            step,
            next,
            program: &self.program,
            commands: self.devices.outputs.joints.as_flattened(),
            angles: self.devices.sensors.angles.as_flattened(),
        });
    }

    /// Emergency stop: the robot freezes where it is.
    fn stop(&mut self, fault: Fault) {
        let emergency = Emergency {
            fault,
            step: self.program.at(),
            cycle: self.cycles,
        };
        let was_running = self.status.is_running();
        self.emergency = Some(emergency);
        self.status = Status::Emergency;
        self.devices.controller.emergency();
        self.hardware.stop(&fault);
        self.console.emergency(&Report {
            emergency,
            program: &self.program,
        });
        if was_running {
            self.console.ended();
        }
    }

    /// A byte was typed: RETURN stops the robot in the next cycle, ESC requests a halt, any other
    /// goes to the keyboard buffer, which keeps 64.
    pub fn key(&mut self, byte: u8) {
        match byte {
            RETURN_KEY => self.stop_requested = true,
            ESCAPE_KEY => self.devices.halt_requested = true,
            _ => self.devices.keyboard.push(byte),
        }
    }

    /// Asks the program to stop at its next good moment: `HALT_REQUEST` is true from now on.
    pub fn request_halt(&mut self) {
        self.devices.halt_requested = true;
    }

    /// Stops the robot in the next cycle, as the RETURN key does.
    pub fn emergency_stop(&mut self) {
        self.stop_requested = true;
    }

    /// Runs no step and holds the robot until [`resume`](Self::resume), as `ALL_STOP` does. Paused
    /// cycles do not count.
    pub fn pause(&mut self) {
        if !self.paused {
            self.paused = true;
            self.devices.hold_for_pause();
        }
    }

    /// Goes on after [`pause`](Self::pause).
    pub fn resume(&mut self) {
        if self.paused {
            self.paused = false;
            self.devices.release_after_pause();
        }
    }
}

fn hardware_fault(HardwareFault(what): HardwareFault) -> Fault {
    Fault::Hardware(what)
}

#[cfg(all(test, feature = "std"))]
mod tests;
