//! Why a program is not built beside the interpreter, or why nothing answers.

use std::error::Error;
use std::fmt;
use std::path::PathBuf;

/// What keeps both engines from running.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum NotBuilt {
    /// Cargo knows no project there.
    NoProject {
        /// What is wrong.
        reason: String,
        /// What cargo says of it, line by line.
        said: String,
    },
    /// Something outside does not do what it is asked.
    Failed(String),
    /// A file cannot be written.
    CannotWrite {
        /// Which one.
        path: PathBuf,
        /// Why.
        reason: String,
    },
}

impl fmt::Display for NotBuilt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NotBuilt::NoProject { reason, .. } | NotBuilt::Failed(reason) => f.write_str(reason),
            NotBuilt::CannotWrite { path, reason } => {
                write!(f, "{} cannot be written: {reason}", path.display())
            }
        }
    }
}

impl Error for NotBuilt {}
