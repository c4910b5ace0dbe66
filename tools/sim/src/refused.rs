//! The reason why an event cannot happen to a run.

use crate::event::EventError;
use crate::message::Debugging;
use std::fmt;
use tip_runtime::command::Port;
use tip_runtime::machine::Mismatch;
use tip_runtime::program::VariableError;
use tipc::message::Lang;

/// The reason why an event cannot happen to a run.
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

impl Refused {
    /// Returns the message in a language. Messages of the runtime are English.
    pub fn text(&self, lang: Lang) -> String {
        let message = match self {
            Refused::Mismatch(mismatch) => return mismatch.to_string(),
            Refused::Text(error) => return error.to_string(),
            Refused::NoInput(port) => Debugging::NoInput {
                port: port.to_string().into(),
            },
            Refused::Variable(name, error) => return of_variable(name, *error, lang),
            Refused::Massless(event) => Debugging::Massless {
                event: event.clone().into(),
            },
        };
        message.in_lang(lang).to_string()
    }
}

/// Returns the message on an error of a variable.
pub(crate) fn of_variable(variable: &str, error: VariableError, lang: Lang) -> String {
    let name = variable.to_owned().into();
    let message = match error {
        VariableError::Unknown => Debugging::NoSuchVariable { name },
        VariableError::Constant => Debugging::IsConstant { name },
        VariableError::NotFinite => Debugging::NotFinite { name },
        other => return format!("{variable}: {other}"),
    };
    message.in_lang(lang).to_string()
}

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text(Lang::English))
    }
}

impl std::error::Error for Refused {}

impl From<Mismatch> for Refused {
    fn from(mismatch: Mismatch) -> Self {
        Refused::Mismatch(mismatch)
    }
}
