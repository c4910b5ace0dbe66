//! A stand-in for a robot.

use std::collections::VecDeque;
use std::fmt::Display;
use tip_runtime::command::{Command, MAX, Poll};
use tip_runtime::fault::Fault;
use tip_runtime::program::{Context, Robot};
use tip_runtime::vibration::Vibration;
use tipc::program::{Flag, Port, Target, Teach};

/// A robot that answers from a script and remembers what it was asked.
#[derive(Default)]
pub(super) struct Script {
    pub(super) keys: VecDeque<u8>,
    /// Number of times that the next command answers that it is pending.
    pub(super) pending: u32,
    pub(super) flags: bool,
    pub(super) fault: Option<Fault>,
    pub(super) said: Vec<String>,
    pub(super) commands: Vec<String>,
}

impl Robot for Script {
    fn command(&mut self, command: &Command<'_>) -> Result<Poll, Fault> {
        if let Some(fault) = self.fault {
            return Err(fault);
        }
        if self.pending > 0 {
            self.pending -= 1;
            return Ok(Poll::Pending);
        }
        let name = command.op.name();
        let values: Vec<f64> = command.values.iter().map(|value| value.number()).collect();
        self.commands
            .push(format!("{name} {} {values:?}", command.target));
        Ok(Poll::Done)
    }

    fn teach(&self, _: Teach, _: Target) -> Result<[f64; MAX], Fault> {
        Ok([1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0])
    }

    fn analog(&self, _: Port) -> Result<f64, Fault> {
        Ok(2.5)
    }

    fn flag(&self, _: Flag) -> bool {
        self.flags
    }

    fn set_special_flag(&mut self, _: u8, _: bool) {}

    fn vibrate(&mut self, _: Target, _: Option<Vibration>) -> Result<(), Fault> {
        Ok(())
    }

    fn pull(&mut self, _: Target, _: [f64; 3], _: [f64; 3]) -> Result<(), Fault> {
        Ok(())
    }

    fn torques(&self, _: u8) -> Result<[f64; MAX], Fault> {
        Ok([0.0; MAX])
    }

    fn inverse(&self, _: u8, from: &[f64; MAX], _: [f64; 3]) -> Result<[f64; MAX], Fault> {
        Ok(*from)
    }

    fn show_graph(&mut self, _: u8, _: bool) -> Result<(), Fault> {
        Ok(())
    }

    fn period(&self) -> f64 {
        20.0
    }
}

impl Context for Script {
    fn key(&mut self) -> Option<u8> {
        let key = self.keys.pop_front();
        self.keys.clear();
        key
    }

    fn message(&mut self, text: &dyn Display) {
        self.said.push(text.to_string());
    }
}
