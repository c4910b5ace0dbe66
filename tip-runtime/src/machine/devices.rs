//! The interface of steps and native code to the robot. Motion is passed on to the controller; all other commands are
//! handled here.

use super::state::IoState;
use super::threads::Threads;
use crate::analog::{self, Connection};
use crate::command::{Command, Flag, MAX, Op, Poll, Port, Target, Teach};
use crate::console::Console;
use crate::controller::ControllerView;
use crate::fault::Fault;
use crate::hardware::SensorsView;
use crate::model::Point;
use crate::program::{Context, Robot, SpecialVariable};
use crate::record::Sink;
use crate::special::{Call, Special};
use crate::vibration::Vibration;
use core::cell::Cell;
use core::fmt::Display;

/// The parts of a machine that a step can reach in one cycle, for a robot with any number of legs of `J` joints.
pub(super) struct Devices<'a, const J: usize> {
    pub(super) controller: &'a mut ControllerView<J>,
    pub(super) sensors: SensorsView<'a, J>,
    pub(super) io: &'a mut IoState,
    /// The native code of SPECIAL; `None` while that runs: it cannot call SPECIAL, and its commands are not recorded.
    pub(super) special: Option<&'a mut dyn Special>,
    pub(super) console: &'a mut dyn Console,
    pub(super) sink: Option<&'a mut dyn Sink>,
    /// True unless the step continues after a wait.
    pub(super) first: bool,
    /// The thread that runs the step; 0 for the main program.
    pub(super) thread: u8,
    pub(super) threads: &'a mut Threads,
    /// True if the step ends its turn, as a read of an input does.
    pub(super) ends_turn: Cell<bool>,
}

impl<const J: usize> Devices<'_, J> {
    /// Runs a command.
    fn run(&mut self, command: &Command<'_>) -> Result<Poll, Fault> {
        match command.op {
            Op::FlushBuf => self.io.key = None,
            Op::LampOn => self.switch_lamp(command, true)?,
            Op::LampOff => self.switch_lamp(command, false)?,
            Op::SilentOn => self.io.silence = Some(true),
            Op::SilentOff => self.io.silence = Some(false),
            Op::LogStart => self.io.samples = true,
            Op::LogStop => self.io.samples = false,
            Op::LogOneShot => self.io.samples_once = true,
            Op::OutputVariables => self.dump_variables(),
            Op::AllStop | Op::AllStopRelease | Op::InitialPosture => {
                return self.hold_or_release(command);
            }
            Op::StartTimer | Op::StopTimer | Op::RestartTimer | Op::ResetTimer => {
                self.set_timer(command)?;
            }
            Op::SpeedUp => self.set_speed(command)?,
            Op::Special => return self.call_special(command),
            _ => return self.controller.command(command),
        }
        Ok(Poll::Done)
    }

    fn call_special(&mut self, command: &Command<'_>) -> Result<Poll, Fault> {
        let special = self.special.take().ok_or(Fault::Domain)?;
        self.controller.tasks.begin()?;
        self.io.variables.share();
        let value = |place: usize| command.values.get(place).map(|value| value.number());
        let call = Call {
            number: whole_byte(value(0))?,
            arguments: [value(1), value(2)],
            first: self.first,
        };
        let poll = special.poll(call, self)?;
        self.controller.tasks.set_special(poll == Poll::Pending);
        self.special = Some(special);
        Ok(poll)
    }

    /// Records a command of the step.
    fn note(&mut self, command: &Command<'_>) {
        let (Some(sink), Some(_)) = (&mut self.sink, &self.special) else {
            return;
        };
        if self.first && command.op.is_traced() {
            sink.command(command);
        }
        let switched = match command.op {
            Op::LampOn => true,
            Op::LampOff => false,
            _ => return,
        };
        if let Ok(device) = first_operand(command) {
            sink.lamp(device, switched);
        }
    }

    fn dump_variables(&mut self) {
        self.io.dump_requested = true;
        self.io.held_for_dump |= self.controller.take_hold();
    }

    /// Runs a command that starts or ends a hold. If OUTPUT_VARIABLES of another step holds the robot, that hold still
    /// lasts to the end of the cycle, and no longer.
    fn hold_or_release(&mut self, command: &Command<'_>) -> Result<Poll, Fault> {
        let for_dump = core::mem::take(&mut self.io.held_for_dump);
        if for_dump {
            self.controller.release();
        }
        let poll = self.controller.command(command)?;
        if for_dump {
            self.io.held_for_dump = self.controller.take_hold();
        }
        Ok(poll)
    }

    fn set_timer(&mut self, command: &Command<'_>) -> Result<(), Fault> {
        let timer = first_operand(command)?;
        let (resets, runs) = match command.op {
            Op::StartTimer => (true, Some(true)),
            Op::StopTimer => (false, Some(false)),
            Op::RestartTimer => (false, Some(true)),
            _ => (true, None),
        };
        self.io.timers.set(timer, resets, runs)
    }

    fn set_speed(&mut self, command: &Command<'_>) -> Result<(), Fault> {
        match first_operand(command)? {
            0 => return Err(Fault::Domain),
            speed => self.io.speed = speed,
        }
        Ok(())
    }

    fn switch_lamp(&mut self, command: &Command<'_>, on: bool) -> Result<(), Fault> {
        let device = first_operand(command)?;
        if device >= self.controller.robot().lamps {
            return Err(Fault::Domain);
        }
        let bit = 1 << (device % 32);
        if let Some(word) = self.io.lamps.get_mut(usize::from(device / 32)) {
            *word = if on { *word | bit } else { *word & !bit };
        }
        Ok(())
    }

    fn channel(&self, channel: u8) -> Result<f64, Fault> {
        match analog::connection(channel, self.sensors.angles.len(), J).ok_or(Fault::Domain)? {
            Connection::Joint(leg, joint) => self.joint(leg, joint),
            Connection::Input(port) => self.input(port),
            Connection::Open => Ok(0.0),
        }
    }

    fn joint(&self, leg: usize, joint: usize) -> Result<f64, Fault> {
        let angle = self.sensors.angles.get(leg).and_then(|leg| leg.get(joint));
        match (self.controller.joint(leg, joint), angle) {
            (Some(joint), Some(angle)) => Ok(analog::volts_of_angle(joint.outer, *angle)),
            _ => Err(Fault::Domain),
        }
    }

    fn input(&self, port: Port) -> Result<f64, Fault> {
        let legs = self.sensors.angles.len();
        let has = !matches!(port, Port::Paw(leg) if usize::from(leg) > legs);
        let volts = self.sensors.inputs.get(port).filter(|_| has);
        volts.ok_or(Fault::Domain)
    }
}

/// Returns the first operand as a number of 0…255.
fn first_operand(command: &Command<'_>) -> Result<u8, Fault> {
    whole_byte(command.values.first().map(|value| value.number()))
}

/// Returns a number given as a float, truncated, if it is 0…255.
fn whole_byte(value: Option<f64>) -> Result<u8, Fault> {
    let whole = libm::trunc(value.ok_or(Fault::Domain)?);
    if (0.0..=255.0).contains(&whole) {
        Ok(whole as u8)
    } else {
        Err(Fault::Domain)
    }
}

/// Returns the index of a leg or joint that counts from 1; an index beyond every array for 0.
fn index(number: u8) -> usize {
    usize::from(number).wrapping_sub(1)
}

impl<const J: usize> Robot for Devices<'_, J> {
    fn command(&mut self, command: &Command<'_>) -> Result<Poll, Fault> {
        let poll = self.run(command)?;
        self.note(command);
        if command.op.ends_turn() {
            self.ends_turn.set(true);
        }
        Ok(poll)
    }

    fn teach(&self, what: Teach, target: Target) -> Result<[f64; MAX], Fault> {
        self.controller.teach(what, target)
    }

    fn analog(&self, port: Port) -> Result<f64, Fault> {
        self.ends_turn.set(true);
        let volts = match port {
            Port::Channel(channel) => self.channel(channel)?,
            Port::Joint(leg, joint) => self.joint(index(leg), index(joint))?,
            port => self.input(port)?,
        };
        if volts.is_finite() {
            Ok(volts)
        } else {
            Err(Fault::Sensor(port))
        }
    }

    fn flag(&self, flag: Flag) -> bool {
        self.io.flag(flag, self.controller, self.sensors.inputs)
    }

    fn set_special_flag(&mut self, n: u8, on: bool) {
        if let Some(flag) = self.io.special_flags.get_mut(usize::from(n)) {
            *flag = on;
        }
    }

    fn vibrate(&mut self, joint: Target, vibration: Option<Vibration>) -> Result<(), Fault> {
        self.controller.vibrate(joint, vibration)
    }

    fn pull(&mut self, point: Target, to: Point, stiffness: [f64; 3]) -> Result<(), Fault> {
        self.controller.pull(point, to, stiffness)
    }

    fn torques(&self, leg: u8) -> Result<[f64; MAX], Fault> {
        self.controller.torques(leg)
    }

    fn inverse(&self, leg: u8, from: &[f64; MAX], position: Point) -> Result<[f64; MAX], Fault> {
        self.controller.inverse(leg, from, position)
    }

    fn show_graph(&mut self, graph: u8, on: bool) -> Result<(), Fault> {
        if self.controller.robot().forces.is_none() {
            return Err(Fault::Domain);
        }
        self.io.graphs.switch(graph, on)
    }

    fn period(&self) -> f64 {
        self.controller.period()
    }

    fn special_variable(&self, variable: SpecialVariable) -> f64 {
        self.io.variables.get(variable, J)
    }

    fn set_special_variable(&mut self, variable: SpecialVariable, value: f64) -> Result<(), Fault> {
        self.io.variables.set(variable, J, value)
    }
}

impl<const J: usize> Context for Devices<'_, J> {
    fn key(&mut self) -> Option<u8> {
        self.ends_turn.set(true);
        self.io.key.take().map(|key| key.to_ascii_uppercase())
    }

    fn message(&mut self, text: &dyn Display) {
        self.ends_turn.set(true);
        self.console.message(text);
        if let Some(sink) = &mut self.sink {
            sink.say(text);
        }
    }

    fn append(&mut self, text: &dyn Display) {
        self.ends_turn.set(true);
        self.console.append(text);
        if let Some(sink) = &mut self.sink {
            sink.out(text);
        }
    }

    fn timer(&self, n: u8) -> f64 {
        self.io.timers.time(n)
    }

    fn start_thread(&mut self, thread: u8) -> Result<(), Fault> {
        self.threads.start(thread)
    }

    fn stop_thread(&mut self, thread: u8) {
        self.threads.stop(thread);
    }

    fn wait_thread(&mut self, thread: u8) -> Result<Poll, Fault> {
        self.ends_turn.set(true);
        self.threads.wait(thread, self.thread)
    }
}
