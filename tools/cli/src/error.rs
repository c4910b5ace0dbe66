//! Errors of a command, besides programs that do not load.

use super::Status;
use crate::message::Using;
use std::fmt;
use std::io;
use std::path::{Path, PathBuf};
use tip_sim::verify::NotBuilt;
use tipc::message::Lang;

/// The error of a command.
#[derive(Debug)]
pub(super) enum Error {
    /// The command line asks for something that does not exist.
    Usage(String),
    /// Something outside of this tool failed.
    Failed(String),
    /// Ctrl-C ended it; the progress so far.
    Interrupted(String),
    /// Cargo failed.
    Cargo {
        /// The reason.
        reason: String,
        /// The output of cargo.
        output: String,
    },
    /// A file cannot be written.
    CannotWrite {
        /// The file.
        path: PathBuf,
        /// The reason.
        reason: String,
    },
}

impl Error {
    /// Returns the error of a file that cannot be written.
    pub(super) fn cannot_write(path: &Path, reason: impl fmt::Display) -> Self {
        Error::CannotWrite {
            path: path.to_owned(),
            reason: reason.to_string(),
        }
    }

    /// Returns the exit status.
    pub(super) fn status(&self) -> Status {
        match self {
            Error::Usage(_) => Status::Usage,
            Error::Interrupted(_) => Status::Interrupted,
            Error::Failed(_) | Error::Cargo { .. } | Error::CannotWrite { .. } => Status::Failure,
        }
    }
}

impl From<NotBuilt> for Error {
    fn from(error: NotBuilt) -> Self {
        match error {
            NotBuilt::NoProject {
                reason,
                said: output,
            } => Error::Cargo { reason, output },
            NotBuilt::CannotWrite { path, reason } => Error::CannotWrite { path, reason },
            other => Error::Failed(other.to_string()),
        }
    }
}

impl Error {
    /// Returns the message in a language.
    pub(super) fn text(&self, lang: Lang) -> String {
        match self {
            Error::Usage(text) | Error::Failed(text) | Error::Cargo { reason: text, .. } => {
                text.clone()
            }
            Error::Interrupted(text) => format!("interrupted {text}"),
            Error::CannotWrite { path, reason } => {
                let file = path.display().to_string().into();
                // People have no use for the number of an error of the system.
                let reason = reason.split(" (os error ").next().unwrap_or_default();
                let reason = reason.to_owned().into();
                Using::CannotWrite { file, reason }
                    .in_lang(lang)
                    .to_string()
            }
        }
    }
}

/// Returns true if the reader of a pipe has closed it, which is not an error of the command.
pub(super) fn is_closed(error: &io::Error) -> bool {
    error.kind() == io::ErrorKind::BrokenPipe
}
