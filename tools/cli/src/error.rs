//! Errors of a command, besides programs that do not load.

use super::Status;
use crate::choices::OutputOptions;
use crate::message::Using;
use std::fmt;
use std::io;
use std::path::{Path, PathBuf};
use tip_lint::message::More;
use tip_sim::verify::NotBuilt;
use tipc::message::{Lang, Message};
use tipc::{Loaded, render};

/// The error of a command.
#[derive(Debug)]
pub(super) enum Error {
    /// A program, or a file that it needs, has errors.
    Refused(Box<Loaded>, OutputOptions),
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
    /// Returns the error of files with errors, which are reported in the form that the options say.
    pub(super) fn refused(options: OutputOptions) -> impl Fn(Box<Loaded>) -> Self {
        move |loaded| Error::Refused(loaded, options)
    }

    /// Returns an error of the command line.
    pub(super) fn usage(reason: impl Into<Message>, lang: Lang) -> Self {
        Error::Usage(reason.into().in_lang(lang).to_string())
    }

    /// Returns an error of something outside of this tool.
    pub(super) fn failed(reason: impl Into<Message>, lang: Lang) -> Self {
        Error::Failed(reason.into().in_lang(lang).to_string())
    }

    /// Returns the error of a file that cannot be written.
    pub(super) fn cannot_write(path: &Path, reason: impl fmt::Display) -> Self {
        Error::CannotWrite {
            path: path.to_owned(),
            reason: reason.to_string(),
        }
    }

    pub(super) fn status(&self) -> Status {
        match self {
            Error::Usage(_) => Status::Usage,
            Error::Interrupted(_) => Status::Interrupted,
            _ => Status::Failure,
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
            Error::Refused(loaded, _) => diagnostics(loaded, lang),
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

/// Returns all diagnostics, one line each.
pub(super) fn diagnostics(loaded: &Loaded, lang: Lang) -> String {
    let lines = loaded.diagnostics.iter();
    let lines = lines.map(|one| render::short(&loaded.source, one, lang));
    let omitted = loaded.omitted.count();
    let more = (omitted > 0).then(|| More::from(omitted).in_lang(lang).to_string());
    let lines: Vec<String> = lines.chain(more).collect();
    lines.join("\n")
}

/// Returns true if the reader of a pipe has closed it, which is not an error of the command.
pub(super) fn is_closed(error: &io::Error) -> bool {
    error.kind() == io::ErrorKind::BrokenPipe
}
