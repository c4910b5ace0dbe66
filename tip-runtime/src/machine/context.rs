//! The parts of a machine that the step of one cycle can reach.

use super::devices::{Devices, whole_byte};
use super::threads::Threads;
use crate::command::{Command, Flag, MAX, Op, Poll, Port, Target, Teach};
use crate::console::Console;
use crate::fault::Fault;
use crate::model::Point;
use crate::program::{Context, Robot, SpecialVariable};
use crate::record::Sink;
use crate::special::{Call, Special};
use crate::vibration::Vibration;
use core::cell::Cell;
use core::fmt::Display;

pub(super) struct StepContext<'a, const J: usize> {
    pub(super) devices: Devices<'a, J>,
    pub(super) special: &'a mut dyn Special,
    pub(super) console: &'a mut dyn Console,
    pub(super) sink: Option<&'a mut dyn Sink>,
    /// The step does not continue one that waited.
    pub(super) first: bool,
    /// The thread that runs the step; 0 for the main program.
    pub(super) thread: u8,
    pub(super) threads: &'a mut Threads,
    /// The step ends its turn. Reading an input does, too.
    pub(super) ends_turn: Cell<bool>,
}

impl<const J: usize> StepContext<'_, J> {
    fn call_special(&mut self, command: &Command<'_>) -> Result<Poll, Fault> {
        self.devices.controller.begin_special()?;
        self.devices.io.variables.share();
        let value = |place: usize| command.values.get(place).map(|value| value.number());
        let call = Call {
            number: whole_byte(value(0))?,
            arguments: [value(1), value(2)],
            first: self.first,
        };
        let poll = self.special.poll(call, &mut self.devices)?;
        self.devices.controller.set_special(poll == Poll::Pending);
        Ok(poll)
    }

    fn note(&mut self, command: &Command<'_>) {
        let Some(sink) = &mut self.sink else {
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
        if let Ok(device) = whole_byte(command.values.first().map(|value| value.number())) {
            sink.lamp(device, switched);
        }
    }
}

impl<const J: usize> Robot for StepContext<'_, J> {
    fn command(&mut self, command: &Command<'_>) -> Result<Poll, Fault> {
        let poll = match command.op {
            Op::Special => self.call_special(command)?,
            _ => self.devices.command(command)?,
        };
        self.note(command);
        if command.op.ends_turn() {
            self.ends_turn.set(true);
        }
        Ok(poll)
    }

    fn teach(&self, what: Teach, target: Target) -> Result<[f64; MAX], Fault> {
        self.devices.teach(what, target)
    }

    fn analog(&self, port: Port) -> Result<f64, Fault> {
        self.ends_turn.set(true);
        self.devices.analog(port)
    }

    fn flag(&self, flag: Flag) -> bool {
        self.devices.flag(flag)
    }

    fn set_special_flag(&mut self, n: u8, on: bool) {
        self.devices.set_special_flag(n, on);
    }

    fn vibrate(&mut self, joint: Target, vibration: Option<Vibration>) -> Result<(), Fault> {
        self.devices.vibrate(joint, vibration)
    }

    fn pull(&mut self, point: Target, to: Point, stiffness: [f64; 3]) -> Result<(), Fault> {
        self.devices.pull(point, to, stiffness)
    }

    fn torques(&self, leg: u8) -> Result<[f64; MAX], Fault> {
        self.devices.torques(leg)
    }

    fn inverse(&self, leg: u8, from: &[f64; MAX], position: Point) -> Result<[f64; MAX], Fault> {
        self.devices.inverse(leg, from, position)
    }

    fn show_graph(&mut self, graph: u8, on: bool) -> Result<(), Fault> {
        self.devices.show_graph(graph, on)
    }

    fn period(&self) -> f64 {
        self.devices.period()
    }

    fn special_variable(&self, variable: SpecialVariable) -> f64 {
        self.devices.special_variable(variable)
    }

    fn set_special_variable(&mut self, variable: SpecialVariable, value: f64) -> Result<(), Fault> {
        self.devices.set_special_variable(variable, value)
    }
}

impl<const J: usize> Context for StepContext<'_, J> {
    fn key(&mut self) -> Option<u8> {
        self.ends_turn.set(true);
        self.devices.io.keyboard.take()
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
        self.devices.io.timers.time(n)
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
