//! Robots without a plant: every command is answered immediately.

use std::fmt::Display;
use tip_runtime::command::{Command, Flag, MAX, Poll, Port, Target, Teach, Value};
use tip_runtime::fault::Fault;
use tip_runtime::program::{Context, Robot};
use tip_runtime::vibration::Vibration;

/// A robot that does `A` with each command and says that it is done. It has nothing else.
pub struct Answering<A>(pub A);

/// Receiver of commands.
pub trait Answer {
    /// Takes notice of it.
    fn notice(&mut self, command: &Command<'_>);
}

/// Counts commands: what is measured against.
#[derive(Default)]
pub struct Count(pub u64);

impl Answer for Count {
    fn notice(&mut self, _: &Command<'_>) {
        self.0 += 1;
    }
}

/// Hashes every command and its values together with the control cycle: FNV-1a 64.
pub struct Trace {
    /// The control cycle.
    pub cycle: u64,
    /// The hash so far.
    pub hash: u64,
}

impl Default for Trace {
    fn default() -> Self {
        Trace {
            cycle: 0,
            hash: 0xcbf2_9ce4_8422_2325,
        }
    }
}

impl Trace {
    fn mix(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.hash = (self.hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }
}

impl Answer for Trace {
    fn notice(&mut self, command: &Command<'_>) {
        self.mix(&self.cycle.to_le_bytes());
        self.mix(command.op.name().as_bytes());
        self.mix(command.target.to_string().as_bytes());
        self.mix(&[u8::from(command.hs)]);
        for value in command.values {
            self.mix(&value.number().to_le_bytes());
            self.mix(&[u8::from(matches!(value, Value::Relative(_)))]);
        }
    }
}

impl<A: Answer> Robot for Answering<A> {
    fn command(&mut self, command: &Command<'_>) -> Result<Poll, Fault> {
        self.0.notice(command);
        Ok(Poll::Done)
    }
    fn teach(&self, _: Teach, _: Target) -> Result<[f64; MAX], Fault> {
        Err(Fault::Domain)
    }
    fn analog(&self, _: Port) -> Result<f64, Fault> {
        Err(Fault::Domain)
    }
    fn flag(&self, _: Flag) -> bool {
        false
    }
    fn set_special_flag(&mut self, _: u8, _: bool) {}
    fn vibrate(&mut self, _: Target, _: Option<Vibration>) -> Result<(), Fault> {
        Err(Fault::Domain)
    }
    fn pull(&mut self, _: Target, _: [f64; 3], _: [f64; 3]) -> Result<(), Fault> {
        Err(Fault::Domain)
    }
    fn torques(&self, _: u8) -> Result<[f64; MAX], Fault> {
        Err(Fault::Domain)
    }
    fn inverse(&self, _: u8, _: &[f64; MAX], _: [f64; 3]) -> Result<[f64; MAX], Fault> {
        Err(Fault::Domain)
    }
    fn show_graph(&mut self, _: u8, _: bool) -> Result<(), Fault> {
        Err(Fault::Domain)
    }
    fn period(&self) -> f64 {
        20.0
    }
}

impl<A: Answer> Context for Answering<A> {
    fn key(&mut self) -> Option<u8> {
        None
    }
    fn message(&mut self, _: &dyn Display) {}
}
