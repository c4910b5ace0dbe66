//! Why a debugger does not do what it is asked.

use super::hits::NotHits;
use crate::message::Debugging;
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
    /// What it says in a language. A fault has its classical text in each.
    pub fn text(&self, lang: Lang) -> String {
        let message = match self {
            Refused::Wrong(diagnostic) => return diagnostic.headline(lang),
            Refused::Fault(fault) => return fault.to_string(),
            Refused::Event(refused) => return refused.text(lang),
            Refused::NoStep(line) => Debugging::NoStepFrom { line: *line },
            Refused::NoName(name) => Debugging::NoSuchName {
                name: name.clone().into(),
            },
            Refused::NoVariable(name, error) => return refused::of_variable(name, *error, lang),
            Refused::Hits(error) => error.message(),
            Refused::WouldDiscard(cycles) => Debugging::WouldDiscard {
                cycles: usize::try_from(*cycles).unwrap_or(usize::MAX),
            },
            Refused::Ended => Debugging::Ended,
        };
        message.in_lang(lang).to_string()
    }
}

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text(Lang::English))
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
