//! The files of a run: TITAN.LOG, EMG.log and VARIABLES.LOG, each written whole.

use super::Console;
use crate::machine::Report;
use crate::record::{Sample, TitanLog};
use core::fmt::Display;
use std::ffi::OsString;
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::string::{String, ToString};
use std::{fs, io};

/// The rows of LOG_START and LOG_ONE_SHOT.
const TITAN_LOG: &str = "TITAN.LOG";
/// The report of an emergency stop.
const EMERGENCY_LOG: &str = "EMG.log";
/// Every text of OUTPUT_VARIABLES, one behind the other.
const VARIABLES_LOG: &str = "VARIABLES.LOG";

/// Writes the files of a run into one folder; keys and messages are the inner console's affair.
///
/// Files appear only when there is something to write, and never half written: the text goes to a
/// temporary file beside the final one, which it then replaces. TITAN.LOG and VARIABLES.LOG are
/// written when the program is over.
#[derive(Debug)]
pub struct LogFiles<C> {
    inner: C,
    folder: PathBuf,
    log: TitanLog,
    variables: String,
    failed: Option<(PathBuf, io::Error)>,
}

impl<C> LogFiles<C> {
    /// Files go to `folder`, which must exist.
    pub fn new(folder: impl Into<PathBuf>, inner: C) -> Self {
        LogFiles {
            inner,
            folder: folder.into(),
            log: TitanLog::default(),
            variables: String::new(),
            failed: None,
        }
    }

    /// Keeps at most `rows` rows of TITAN.LOG.
    #[must_use]
    pub fn with_capacity(mut self, rows: usize) -> Self {
        self.log = TitanLog::with_capacity(rows);
        self
    }

    /// The console inside.
    pub fn inner(&self) -> &C {
        &self.inner
    }

    /// The console inside.
    pub fn inner_mut(&mut self) -> &mut C {
        &mut self.inner
    }

    /// The first file that could not be written, and why.
    pub fn take_error(&mut self) -> Option<(PathBuf, io::Error)> {
        self.failed.take()
    }

    /// Writes what was collected so far: for a host that ends a run before the program does.
    pub fn flush(&mut self) {
        if !self.log.is_empty() {
            let text = self.log.to_string();
            self.write(TITAN_LOG, &text);
        }
        if !self.variables.is_empty() {
            let text = core::mem::take(&mut self.variables);
            self.write(VARIABLES_LOG, &text);
            self.variables = text;
        }
    }

    fn write(&mut self, name: &str, text: &str) {
        let path = self.folder.join(name);
        if let Err(error) = replace(&path, text)
            && self.failed.is_none()
        {
            self.failed = Some((path, error));
        }
    }
}

/// Gives the file at `path` a new content, all of it or nothing.
#[allow(
    clippy::disallowed_methods,
    reason = "this console is for writing files"
)]
fn replace(path: &Path, text: &str) -> io::Result<()> {
    let mut temporary = OsString::from(path);
    temporary.push(".part");
    let temporary = PathBuf::from(temporary);
    let mut file = fs::File::create(&temporary)?;
    file.write_all(text.as_bytes())?;
    file.sync_all()?;
    fs::rename(&temporary, path)
}

impl<C: Console> Console for LogFiles<C> {
    fn key(&mut self, cycle: u64) -> Option<u8> {
        self.inner.key(cycle)
    }

    fn message(&mut self, text: &dyn Display) {
        self.inner.message(text);
    }

    fn silent(&mut self, on: bool) {
        self.inner.silent(on);
    }

    fn sample(&mut self, sample: &Sample<'_>) {
        self.log.push(sample);
        self.inner.sample(sample);
    }

    fn variables(&mut self, dump: &dyn Display) {
        // Writing to a String cannot fail.
        let _ = write!(self.variables, "{dump}");
        self.inner.variables(dump);
    }

    fn emergency(&mut self, report: &Report<'_>) {
        self.write(EMERGENCY_LOG, &report.to_string());
        self.inner.emergency(report);
    }

    fn ended(&mut self) {
        self.flush();
        self.inner.ended();
    }
}
