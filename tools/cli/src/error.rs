//! Why a command can fail, besides a program that does not load.

use super::Status;
use std::fmt;
use std::io;
use std::path::{Path, PathBuf};
use tip_sim::verify::NotBuilt;
use tipc::code::Code;
use tipc::diagnostic::Diagnostic;
use tipc::message::Reading;
use tipc::source::Span;

/// Why a command stopped.
#[derive(Debug)]
pub(super) enum Error {
    /// The command line asks for something that does not exist.
    Usage(String),
    /// Something outside of this tool does not do what it is asked.
    Failed(String),
    /// Ctrl-C ended it; how far it came.
    Interrupted(String),
    /// The same, after what cargo says of it.
    Cargo {
        /// What is wrong.
        reason: String,
        /// What cargo says.
        said: String,
    },
    /// A file cannot be written.
    CannotWrite {
        /// Which one.
        path: PathBuf,
        /// Why.
        reason: String,
    },
}

impl Error {
    /// A file that cannot be written.
    pub(super) fn cannot_write(path: &Path, reason: impl fmt::Display) -> Self {
        Error::CannotWrite {
            path: path.to_owned(),
            reason: reason.to_string(),
        }
    }

    /// The exit status that belongs to it.
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
            NotBuilt::NoProject { reason, said } => Error::Cargo { reason, said },
            NotBuilt::CannotWrite { path, reason } => Error::CannotWrite { path, reason },
            other => Error::Failed(other.to_string()),
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Error::Usage(text) | Error::Failed(text) | Error::Cargo { reason: text, .. } => {
                f.write_str(text)
            }
            Error::Interrupted(text) => write!(f, "interrupted {text}"),
            Error::CannotWrite { path, reason } => {
                let error = reason.clone().into();
                let reason = Reading::System { error };
                let diagnostic = Diagnostic::new(Code::CannotWrite, Span::default(), reason)
                    .about(path.display().to_string());
                write!(f, "{}: {}", diagnostic.title(), diagnostic.reason)
            }
        }
    }
}

/// Whether the reader of a pipe went away, which is not our fault.
pub(super) fn is_closed(error: &io::Error) -> bool {
    error.kind() == io::ErrorKind::BrokenPipe
}
