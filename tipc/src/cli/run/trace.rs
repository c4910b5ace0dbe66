//! The trace of a run, on its way to a file or to standard output.

use super::super::error::{Error, is_closed};
use super::super::output;
use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use tip_runtime::record::{Ending, JsonLines, Sink, Stream};

/// The name that stands for standard output.
const STANDARD_OUTPUT: &str = "-";

/// A trace that is being written.
pub(super) struct Trace {
    path: PathBuf,
    lines: JsonLines<Stream<BufWriter<Box<dyn Write>>>>,
}

impl Trace {
    /// Whether a trace to `path` takes standard output for itself.
    pub(super) fn takes_standard_output(path: Option<&Path>) -> bool {
        path.is_some_and(|path| path.as_os_str() == STANDARD_OUTPUT)
    }

    /// Begins a trace of the program in `source`.
    pub(super) fn begin(path: &Path, with_state: bool, source: &Path) -> Result<Self, Error> {
        let out: Box<dyn Write> = if Self::takes_standard_output(Some(path)) {
            Box::new(io::stdout())
        } else {
            output::refuse_source(path, source)?;
            Box::new(File::create(path).map_err(|error| Error::cannot_write(path, error))?)
        };
        Ok(Trace {
            path: path.to_owned(),
            lines: JsonLines::new(Stream::new(BufWriter::new(out)), with_state),
        })
    }

    /// Takes the records of the cycles.
    pub(super) fn sink(&mut self) -> &mut dyn Sink {
        &mut self.lines
    }

    /// Whether it can still be written.
    pub(super) fn is_open(&self) -> bool {
        self.lines.result().is_ok()
    }

    /// Writes the last record and sees that all of it arrived.
    pub(super) fn end(mut self, ending: Ending, cycles: u64) -> Result<(), Error> {
        self.lines.end(ending, cycles);
        match self.lines.get_mut().finish() {
            Err(error) if !is_closed(&error) => Err(Error::cannot_write(&self.path, error)),
            _ => Ok(()),
        }
    }
}
