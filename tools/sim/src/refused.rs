//! Why something cannot happen to a run.

use crate::event::EventError;
use std::fmt;
use tip_runtime::command::Port;
use tip_runtime::machine::Mismatch;
use tip_runtime::program::VariableError;

/// Why something cannot happen to a run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refused {
    /// The program is for another robot.
    Mismatch(Mismatch),
    /// The robot has no such input.
    NoInput(Port),
    /// The program has no such variable, or it cannot have the value.
    Variable(String, VariableError),
    /// This event cannot happen to the robot: it has no mass.
    Massless(String),
    /// The text is not an event.
    Text(EventError),
}

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Refused::Mismatch(mismatch) => mismatch.fmt(f),
            Refused::NoInput(port) => write!(f, "the robot has no input {port}"),
            Refused::Variable(name, error) => write!(f, "{name}: {error}"),
            Refused::Massless(event) => {
                write!(
                    f,
                    "'{event}' is for walking robots with mass: --plant dynamic"
                )
            }
            Refused::Text(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for Refused {}

impl From<Mismatch> for Refused {
    fn from(mismatch: Mismatch) -> Self {
        Refused::Mismatch(mismatch)
    }
}
