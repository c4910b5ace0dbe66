//! Why a debugger does not do what it is asked.

use super::hits::NotHits;
use crate::refused;
use std::fmt;
use tip_runtime::fault::Fault;
use tip_runtime::program::VariableError;
use tipc::diagnostic::Diagnostic;
use tipc::message::Lang;

/// Why something is refused.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Refused {
    /// No step is on this line, and none after it.
    NoStep(u32),
    /// No routine, label or command has this name.
    NoName(String),
    /// The program has no such variable, or it is a constant.
    NoVariable(String, VariableError),
    /// The text is not a condition or number of the program.
    Wrong(Box<Diagnostic>),
    /// It cannot be calculated, or reads what is not assigned.
    Fault(Fault),
    /// The text does not say how many hits.
    Hits(NotHits),
    /// So many cycles have been run after this position, and would be discarded.
    WouldDiscard(u64),
    /// The program is over.
    Ended,
    /// It cannot happen to this robot or program.
    Event(refused::Refused),
}

impl Refused {
    /// What it says, in one of the languages of messages where it comes from the compiler.
    pub fn text(&self, lang: Lang) -> String {
        match self {
            Refused::Wrong(diagnostic) => diagnostic.headline(lang),
            other => other.to_string(),
        }
    }
}

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Refused::NoStep(line) => write!(f, "no step is on line {line} or after it"),
            Refused::NoName(name) => {
                write!(
                    f,
                    "'{name}' is not a routine, label or command of the program"
                )
            }
            Refused::NoVariable(name, error) => write!(f, "{name}: {error}"),
            Refused::Wrong(diagnostic) => f.write_str(&diagnostic.headline(Lang::English)),
            Refused::Fault(fault) => fault.fmt(f),
            Refused::Hits(error) => error.fmt(f),
            Refused::WouldDiscard(cycles) => {
                write!(
                    f,
                    "{cycles} cycles have been run after this one, and would be discarded"
                )
            }
            Refused::Ended => f.write_str("the program is over"),
            Refused::Event(refused) => refused.fmt(f),
        }
    }
}

impl std::error::Error for Refused {}

impl From<NotHits> for Refused {
    fn from(error: NotHits) -> Self {
        Refused::Hits(error)
    }
}

impl From<Box<Diagnostic>> for Refused {
    fn from(error: Box<Diagnostic>) -> Self {
        Refused::Wrong(error)
    }
}

impl From<Fault> for Refused {
    fn from(error: Fault) -> Self {
        Refused::Fault(error)
    }
}
