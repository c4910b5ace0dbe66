//! One control cycle, for any program and hardware. It is compiled once for all numbers of legs.

use super::devices::Devices;
use super::state::{State, Status};
use super::threads::bit;
use crate::command::Port;
use crate::console::Console;
use crate::controller::ControllerView;
use crate::emergency::{Emergency, Report, ThreadName};
use crate::fault::Fault;
use crate::hardware::{
    Hardware, HardwareFault, JointCommand, Outputs, OutputsView, Sensors, SensorsView,
};
use crate::model::Family;
use crate::program::{End, Flow, Program};
use crate::record::{self, Dump, Sample, Sink};
use crate::special::Special;
use core::cell::Cell;

/// Maximum number of bytes taken from the console in one cycle, so that an endless source cannot stall it.
const KEYS_PER_CYCLE: usize = 256;

/// All parts of a machine, for one cycle.
pub(super) struct ControlCycle<'a, const J: usize> {
    pub(super) program: &'a mut dyn Program,
    pub(super) robot: &'a mut dyn HardwareIo<J>,
    pub(super) console: &'a mut dyn Console,
    pub(super) special: &'a mut dyn Special,
    pub(super) controller: &'a mut ControllerView<J>,
    pub(super) state: &'a mut State,
}

/// The progress of the steps of one cycle.
struct Steps {
    /// Number of steps that are left in the turn.
    left: u8,
    /// Number of steps in a turn.
    speed: u8,
    /// Number of scalars that the program shares with native code.
    specials: usize,
    /// Number of records of the cycle so far.
    sub: u32,
    /// The last step. Its record is written before the next step, or after the robot has moved.
    last: Option<Ran>,
}

/// A step that ran to its end.
struct Ran {
    thread: u8,
    step: u32,
    next: Option<u32>,
}

impl<const J: usize> ControlCycle<'_, J> {
    pub(super) fn run(&mut self, sink: Option<&mut dyn Sink>) -> Status {
        if let Some(emergency) = &mut self.state.emergency {
            let stopped = self.robot.stop(&emergency.fault);
            emergency.stop_fault = emergency.stop_fault.or(stopped.err());
        } else if let Err(fault) = self.sample().and_then(|()| self.act(sink)) {
            self.stop(fault);
        }
        self.state.status
    }

    /// Runs phase 1: reads every sensor and the keyboard, and passes the readings to the controller.
    fn sample(&mut self) -> Result<(), Fault> {
        if let Some(fault) = self.state.pending.take() {
            return Err(fault);
        }
        self.state.sampled_at = self.state.time;
        self.robot.read().map_err(Fault::Hardware)?;
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

    /// Runs phases 2 and 3: the steps, if there are any to run, then the robot.
    fn act(&mut self, mut sink: Option<&mut dyn Sink>) -> Result<(), Fault> {
        if !self.state.status.is_running() || self.state.paused {
            self.drive();
            return Ok(());
        }
        let mut steps = Steps {
            left: 0,
            speed: self.state.io.speed,
            specials: self.program.specials(),
            sub: 0,
            last: None,
        };
        let end = self.turns(&mut steps, &mut sink)?;
        if end.is_none() {
            self.run_native(steps.specials);
        }
        let period = self.drive();
        self.log();
        if let (Some(sink), Some(step)) = (sink, steps.last) {
            self.record(sink, step, steps.sub, true);
        }
        self.state.cycles += 1;
        self.state.io.timers.grow(period);
        if self.state.threads.change() {
            self.change_threads();
        }
        if let Some(end) = end {
            self.state.status = Status::Finished(end);
            self.console.ended();
        }
        Ok(())
    }

    /// Runs phase 2: the turn of the main program, then of each thread that ran when the cycle began.
    fn turns(
        &mut self,
        steps: &mut Steps,
        sink: &mut Option<&mut dyn Sink>,
    ) -> Result<Option<End>, Fault> {
        // One call of `turn` serves the main program and the threads, so that the compiler can inline it.
        let mut threads = self.state.threads.running();
        let end = loop {
            let end = self.turn(steps, sink)?;
            match threads.next() {
                Some(thread) if end.is_none() => self.select(thread),
                _ => break end,
            }
        };
        if self.state.turn != 0 {
            self.select(0);
        }
        Ok(end)
    }

    /// Selects the main program (0) or a thread for the following steps.
    fn select(&mut self, thread: u8) {
        self.state.turn = thread;
        self.program.select(thread);
        self.controller.tasks.select(thread);
    }

    /// Runs the steps of one turn.
    fn turn(
        &mut self,
        steps: &mut Steps,
        sink: &mut Option<&mut dyn Sink>,
    ) -> Result<Option<End>, Fault> {
        let thread = self.state.turn;
        steps.left = steps.speed;
        loop {
            if let (Some(sink), Some(step)) = (&mut *sink, steps.last.take()) {
                self.record(&mut **sink, step, steps.sub, false);
                steps.sub = steps.sub.saturating_add(1);
            }
            let step = self.program.at();
            let sink = sink.as_mut().map(|sink| &mut **sink as &mut dyn Sink);
            let (flow, ends_turn) = self.step(steps.specials, sink)?;
            self.serve_console(step);
            let next = match flow {
                Flow::Next | Flow::Wait => Some(self.program.at()),
                Flow::ThreadEnd | Flow::Finished(_) => None,
            };
            steps.last = Some(Ran { thread, step, next });
            match flow {
                Flow::Next => {}
                Flow::Wait => return Ok(None),
                Flow::ThreadEnd => {
                    self.state.threads.end(thread);
                    return Ok(None);
                }
                Flow::Finished(end) => return Ok(Some(end)),
            }
            steps.left = steps.left.saturating_sub(1);
            if ends_turn || steps.left == 0 {
                return Ok(None);
            }
        }
    }

    /// Runs one step; returns true with its flow if the turn ends with it.
    fn step(
        &mut self,
        specials: usize,
        mut sink: Option<&mut dyn Sink>,
    ) -> Result<(Flow, bool), Fault> {
        if let Some(sink) = &mut sink {
            sink.begin(self.program);
        }
        if specials > 0 {
            self.state.io.variables.read(self.program, specials);
        }
        let thread = self.state.turn;
        let mut context = Devices {
            controller: self.controller,
            sensors: self.robot.sensors(),
            io: &mut self.state.io,
            special: Some(self.special),
            console: self.console,
            sink: sink.map(|sink| sink as &mut dyn Sink),
            first: self.state.waiting & bit(thread) == 0,
            thread,
            threads: &mut self.state.threads,
            ends_turn: Cell::new(false),
        };
        let flow = self.program.step(&mut context)?;
        let ends_turn = context.ends_turn.get();
        if flow == Flow::Wait {
            self.state.waiting |= bit(thread);
        } else {
            self.state.waiting &= !bit(thread);
        }
        if specials > 0 {
            self.state.io.variables.write(self.program, specials);
        }
        if let Flow::Finished(_) = flow {
            self.controller.finish();
        }
        Ok((flow, ends_turn))
    }

    /// Continues the native code of SPECIAL, in the motion phase.
    fn run_native(&mut self, specials: usize) {
        if specials > 0 {
            self.state.io.variables.read(self.program, specials);
        }
        let mut devices = Devices {
            controller: self.controller,
            sensors: self.robot.sensors(),
            io: &mut self.state.io,
            special: None,
            console: self.console,
            sink: None,
            first: false,
            thread: 0,
            threads: &mut self.state.threads,
            ends_turn: Cell::new(false),
        };
        self.state.pending = self.special.cycle(&mut devices).err();
        if specials > 0 {
            self.state.io.variables.write(self.program, specials);
        }
    }

    /// Ends the threads that were stopped in this cycle, and puts those that begin in the next one at their first step.
    fn change_threads(&mut self) {
        let (stopped, started) = self.state.threads.turn_over();
        for thread in stopped {
            self.controller.tasks.select(thread);
            self.controller.give_up();
            self.state.waiting &= !bit(thread);
        }
        self.controller.tasks.select(0);
        for thread in started {
            self.program.begin(thread);
        }
    }

    /// Serves the console requests of the step, which a step cannot serve itself.
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

    /// Runs phase 3: advances trajectories, servo and plant by one sampling time. Returns the sampling time, ms.
    fn drive(&mut self) -> f64 {
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
            self.state.pending.get_or_insert(Fault::Hardware(fault));
        }
        self.state.time += period;
        period
    }

    /// Passes a row of TITAN.LOG to the console if this cycle is sampled.
    fn log(&mut self) {
        let io = &mut self.state.io;
        if core::mem::take(&mut io.samples_once) || io.samples {
            let sample = sample(&*self.robot, self.controller, self.state);
            self.console.sample(&sample);
        }
    }

    // Out of line, since most turns are not recorded.
    #[inline(never)]
    fn record(&self, sink: &mut dyn Sink, Ran { thread, step, next }: Ran, sub: u32, last: bool) {
        sink.cycle(&record::Cycle {
            sub,
            last,
            thread: self.thread_name(thread),
            step,
            next,
            program: self.program,
            sample: sample(&*self.robot, self.controller, self.state),
        });
    }

    fn thread_name(&self, thread: u8) -> Option<&str> {
        match thread {
            0 => None,
            thread => self.program.thread(thread).map(|(name, _)| name),
        }
    }

    /// Stops in an emergency: the robot freezes where it is.
    fn stop(&mut self, fault: Fault) {
        let emergency = Emergency {
            fault,
            step: self.program.at(),
            cycle: self.state.cycles,
            thread: self.thread_name(self.state.turn).map(ThreadName::new),
            stop_fault: self.robot.stop(&fault).err(),
        };
        if self.state.turn != 0 {
            self.select(0);
        }
        let was_running = self.state.status.is_running();
        self.state.emergency = Some(emergency);
        self.state.status = Status::Emergency;
        self.controller.emergency();
        self.console.emergency(&Report {
            emergency,
            program: self.program,
        });
        if was_running {
            self.console.ended();
        }
    }
}

/// Returns the readings and outputs of a cycle.
fn sample<'a, const J: usize>(
    robot: &'a dyn HardwareIo<J>,
    controller: &ControllerView<J>,
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

/// Hardware with its last readings and its next commands, for any number of legs of `J` joints.
pub(super) trait HardwareIo<const J: usize> {
    fn read(&mut self) -> Result<(), HardwareFault>;
    fn sensors(&self) -> SensorsView<'_, J>;
    fn outputs(&mut self) -> OutputsView<'_, J>;
    fn commands(&self) -> &[[JointCommand; J]];
    fn write(&mut self) -> Result<(), HardwareFault>;
    fn stop(&mut self, why: &Fault) -> Result<(), HardwareFault>;
}

/// Hardware of a known size with its readings and commands.
pub(super) struct SizedIo<'a, H, const L: usize, const J: usize> {
    pub(super) hardware: &'a mut H,
    pub(super) sensors: &'a mut Sensors<L, J>,
    pub(super) outputs: &'a mut Outputs<L, J>,
}

impl<H: Hardware<L, J>, const L: usize, const J: usize> HardwareIo<J> for SizedIo<'_, H, L, J> {
    fn read(&mut self) -> Result<(), HardwareFault> {
        self.hardware.read(self.sensors)
    }

    fn sensors(&self) -> SensorsView<'_, J> {
        self.sensors.view()
    }

    fn outputs(&mut self) -> OutputsView<'_, J> {
        self.outputs.view()
    }

    fn commands(&self) -> &[[JointCommand; J]] {
        &self.outputs.joints
    }

    fn write(&mut self) -> Result<(), HardwareFault> {
        self.hardware.write(self.outputs)
    }

    fn stop(&mut self, why: &Fault) -> Result<(), HardwareFault> {
        self.hardware.stop(why)
    }
}
