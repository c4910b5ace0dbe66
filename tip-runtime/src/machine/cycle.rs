//! One control cycle, whatever the number of legs, the program and the hardware.

use super::context::StepContext;
use super::devices::Devices;
use super::dyn_hardware::DynHardware;
use super::state::{State, Status};
use crate::command::Port;
use crate::console::Console;
use crate::controller::ControllerView;
use crate::emergency::{Emergency, Report};
use crate::fault::Fault;
use crate::hardware::HardwareFault;
use crate::model::Family;
use crate::program::{Flow, Program};
use crate::record::{self, Dump, Sample, Sink};
use crate::special::Special;

/// The most bytes taken from the console in one cycle, so that an endless source cannot stall it.
const KEYS_PER_CYCLE: usize = 256;

/// All parts of a machine, for one cycle.
pub(super) struct ControlCycle<'a, 'm, const J: usize> {
    pub(super) program: &'a mut dyn Program,
    pub(super) robot: &'a mut dyn DynHardware<J>,
    pub(super) console: &'a mut dyn Console,
    pub(super) special: &'a mut dyn Special,
    pub(super) controller: &'a mut ControllerView<'m, J>,
    pub(super) state: &'a mut State,
}

impl<const J: usize> ControlCycle<'_, '_, J> {
    pub(super) fn run(&mut self, sink: Option<&mut dyn Sink>) -> Status {
        if let Some(emergency) = &self.state.emergency {
            self.robot.stop(&emergency.fault);
        } else if let Err(fault) = self.sample().and_then(|()| self.act(sink)) {
            self.stop(fault);
        }
        self.state.status
    }

    /// Runs phase 1: reads every sensor and the keyboard, and lets the controller take them in.
    fn sample(&mut self) -> Result<(), Fault> {
        if let Some(fault) = self.state.pending.take() {
            return Err(fault);
        }
        self.state.sampled_at = self.state.time;
        self.robot.read().map_err(hardware_fault)?;
        self.take_keys();
        if core::mem::take(&mut self.state.stop_requested) {
            return Err(Fault::EmergencyKey);
        }
        self.controller.sense_view(&self.robot.sensors())
    }

    fn take_keys(&mut self) {
        for _ in 0..KEYS_PER_CYCLE {
            match self.console.key(self.state.cycles) {
                Some(byte) => self.state.key(byte),
                None => break,
            }
        }
    }

    /// Phases 2 and 3: one step, unless there is none to run, then the robot.
    fn act(&mut self, mut sink: Option<&mut dyn Sink>) -> Result<(), Fault> {
        if !self.state.status.is_running() || self.state.paused {
            self.drive();
            return Ok(());
        }
        let step = self.program.at();
        let flow = self.step(sink.as_mut().map(|sink| &mut **sink as &mut dyn Sink))?;
        self.serve_console(step);
        if !matches!(flow, Flow::Finished(_)) {
            let mut devices = Devices {
                controller: self.controller,
                sensors: self.robot.sensors(),
                io: &mut self.state.io,
            };
            self.state.pending = self.special.cycle(&mut devices).err();
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
        self.state.cycles += 1;
        if let Flow::Finished(end) = flow {
            self.state.status = Status::Finished(end);
            self.console.ended();
        }
        Ok(())
    }

    /// Runs phase 2, the step.
    fn step(&mut self, mut sink: Option<&mut dyn Sink>) -> Result<Flow, Fault> {
        if let Some(sink) = &mut sink {
            sink.begin(self.program);
        }
        let flow = self.program.step(&mut StepContext {
            devices: Devices {
                controller: self.controller,
                sensors: self.robot.sensors(),
                io: &mut self.state.io,
            },
            special: self.special,
            console: self.console,
            sink: sink.map(|sink| sink as &mut dyn Sink),
            first: !self.state.waiting,
        })?;
        self.state.waiting = flow == Flow::Wait;
        if let Flow::Finished(_) = flow {
            self.controller.finish();
        }
        Ok(flow)
    }

    /// Serves the console requests that the step made and could not serve itself.
    fn serve_console(&mut self, step: u32) {
        let io = &mut self.state.io;
        if let Some(on) = io.silence.take() {
            self.console.silent(on);
        }
        let torques = self.robot.sensors().torques;
        io.graphs.show(
            self.state.sampled_at,
            torques,
            self.controller,
            self.console,
        );
        if core::mem::take(&mut io.dump_requested) {
            self.console.variables(&Dump {
                program: self.program,
                cycle: self.state.cycles,
                step,
            });
        }
    }

    /// Runs phase 3: trajectories, servo and plant advance by one sampling time.
    fn drive(&mut self) {
        let period = self.controller.period();
        self.controller.advance();
        let outputs = self.robot.outputs();
        self.controller.put_outputs(outputs.joints);
        *outputs.slider = self.controller.slider();
        *outputs.lamps = self.state.io.lamps;
        *outputs.period = period;
        if core::mem::take(&mut self.state.io.held_for_dump) {
            self.controller.release();
        }
        if let Err(fault) = self.robot.write() {
            self.state.pending.get_or_insert(hardware_fault(fault));
        }
        self.state.time += period;
    }

    /// Hands a row of TITAN.LOG to the console if this cycle is to be sampled.
    fn log(&mut self) {
        if self.state.io.sampling.take() {
            let sample = sample(&*self.robot, self.controller, self.state);
            self.console.sample(&sample);
        }
    }

    fn record(&self, sink: &mut dyn Sink, step: u32, next: Option<u32>) {
        sink.cycle(&record::Cycle {
            step,
            next,
            program: self.program,
            sample: sample(&*self.robot, self.controller, self.state),
        });
    }

    /// Stops in an emergency: the robot freezes where it is.
    fn stop(&mut self, fault: Fault) {
        let emergency = Emergency {
            fault,
            step: self.program.at(),
            cycle: self.state.cycles,
        };
        let was_running = self.state.status.is_running();
        self.state.emergency = Some(emergency);
        self.state.status = Status::Emergency;
        self.controller.emergency();
        self.robot.stop(&fault);
        self.console.emergency(&Report {
            emergency,
            program: self.program,
        });
        if was_running {
            self.console.ended();
        }
    }
}

fn hardware_fault(HardwareFault(what): HardwareFault) -> Fault {
    Fault::Hardware(what)
}

/// Returns the readings and outputs of a cycle.
fn sample<'a, const J: usize>(
    robot: &'a dyn DynHardware<J>,
    controller: &ControllerView<'_, J>,
    state: &State,
) -> Sample<'a> {
    let sensors = robot.sensors();
    let soles = sensors.inputs.of(Port::Paw(1));
    let senses_torque = !matches!(controller.robot().family, Family::Titan);
    Sample {
        cycle: state.cycles,
        time: state.sampled_at,
        joints_per_leg: J,
        angles: sensors.angles.as_flattened(),
        commands: robot.commands().as_flattened(),
        torques: if senses_torque {
            sensors.torques.as_flattened()
        } else {
            &[]
        },
        paws: soles.get(..sensors.angles.len()).unwrap_or(soles),
        knobs: sensors.inputs.of(Port::Knob(1)),
        antenna: sensors.inputs.get(Port::Antenna).unwrap_or(0.0),
    }
}
