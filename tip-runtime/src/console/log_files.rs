//! The log files of a run: TITAN.LOG, EMG.log, VARIABLES.LOG, FOUT.LOG and WARNING.LOG, each written
//! completely or not at all.
#![allow(
    clippy::disallowed_methods,
    reason = "this console is for writing files"
)]

use super::{Bars, Console};
use crate::emergency::Report;
use crate::printable::Printable;
use crate::record::{AtomicFile, Dump, Sample, TitanLog};
use core::fmt;
use core::fmt::Display;
use std::fmt::Write as _;
use std::io::{self, BufRead, BufReader, Read, Write};
use std::path::{Path, PathBuf};
use std::string::{String, ToString};
use std::vec::Vec;
use std::{format, fs};

/// The rows of LOG_START and LOG_ONE_SHOT.
const TITAN_LOG: &str = "TITAN.LOG";
/// The report of an emergency stop.
const EMERGENCY_LOG: &str = "EMG.log";
/// The texts of OUTPUT_VARIABLES, in order.
const VARIABLES_LOG: &str = "VARIABLES.LOG";
/// The texts of F_MESSAGE.
const FILE_OUTPUT: &str = "FOUT.LOG";
/// The compiler's warnings.
const WARNING_LOG: &str = "WARNING.LOG";

/// Maximum size of VARIABLES.LOG, bytes.
const MAX_LOG_BYTES: usize = 16 << 20;
/// Maximum size of FOUT.LOG, bytes.
const MOST_OUTPUT: usize = 1 << 20;
/// The last line of a VARIABLES.LOG that reached its maximum size.
const FULL: &str = "# full, later ones are left out";

/// Writes the log files of a run into one folder; forwards keys and messages to the inner console.
///
/// A file appears only when there is something to write, and never half written. Each begins with a
/// line that names its program; a file that does not name this program is never replaced. TITAN.LOG,
/// VARIABLES.LOG and FOUT.LOG are written at the end of the program, FOUT.LOG at every
/// OUTPUT_VARIABLES too. VARIABLES.LOG grows to at most 16 MiB, FOUT.LOG to 1 MiB.
/// Files of an earlier run of the same program stay until this run replaces them or ends without
/// needing them; where a new file cannot be written, the earlier one stays.
#[derive(Debug)]
pub struct LogFiles<C> {
    inner: C,
    folder: LogFolder,
    log: TitanLog,
    variables: String,
    /// VARIABLES.LOG has reached its maximum size.
    is_full: bool,
    output: String,
    /// Number of texts that FOUT.LOG had no room for.
    dropped: u64,
    /// Files that may be left from an earlier run.
    earlier: Vec<&'static str>,
    failed: Option<LogError>,
}

impl<C> LogFiles<C> {
    /// The names of the files.
    pub const NAMES: [&'static str; 5] = [
        WARNING_LOG,
        TITAN_LOG,
        VARIABLES_LOG,
        FILE_OUTPUT,
        EMERGENCY_LOG,
    ];

    /// Takes `folder` for the files of `program`, and creates it if it is missing.
    ///
    /// # Errors
    /// The folder cannot be created, or holds a file of the same name that belongs to another
    /// program or is not a log.
    pub fn claim(folder: impl Into<PathBuf>, program: &str, inner: C) -> Result<Self, LogError> {
        let folder = LogFolder::new(folder.into(), program);
        folder.take(&Self::NAMES)?;
        Ok(LogFiles {
            inner,
            folder,
            log: TitanLog::default(),
            variables: String::new(),
            is_full: false,
            output: String::new(),
            dropped: 0,
            earlier: Vec::from(Self::NAMES),
            failed: None,
        })
    }

    /// Returns the inner console.
    pub fn inner(&self) -> &C {
        &self.inner
    }

    /// Writes WARNING.LOG: the compiler's warnings, one a line.
    pub fn warnings(&mut self, text: &str) {
        self.write(WARNING_LOG, text);
    }

    /// Writes what was collected so far, and removes files that an earlier run left. For a host
    /// that ends a run before the program does.
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
        self.write_output();
        for name in core::mem::take(&mut self.earlier) {
            let removed = self.folder.remove(name);
            self.note(removed);
        }
    }

    /// Returns the number of texts that F_MESSAGE did not append, since FOUT.LOG was full.
    pub fn dropped(&self) -> u64 {
        self.dropped
    }

    /// Returns the first file that could not be written, with the reason.
    pub fn take_error(&mut self) -> Option<LogError> {
        self.failed.take()
    }

    fn write_output(&mut self) {
        if !self.output.is_empty() {
            let text = core::mem::take(&mut self.output);
            self.write(FILE_OUTPUT, &text);
            self.output = text;
        }
    }

    fn write(&mut self, name: &'static str, text: &str) {
        self.earlier.retain(|earlier| *earlier != name);
        let written = self.folder.write(name, text);
        self.note(written);
    }

    /// Keeps the first error.
    fn note(&mut self, result: Result<(), LogError>) {
        if let (Err(error), None) = (result, &self.failed) {
            self.failed = Some(error);
        }
    }
}

impl<C: Console> Console for LogFiles<C> {
    fn key(&mut self, cycle: u64) -> Option<u8> {
        self.inner.key(cycle)
    }

    fn message(&mut self, text: &dyn Display) {
        self.inner.message(text);
    }

    fn append(&mut self, text: &dyn Display) {
        let before = self.output.len();
        // Writing to a String cannot fail.
        let _ = write!(self.output, "{text}");
        if self.folder.heading_len(FILE_OUTPUT) + self.output.len() > MOST_OUTPUT {
            self.output.truncate(before);
            self.dropped += 1;
        }
        self.inner.append(text);
    }

    fn silent(&mut self, on: bool) {
        self.inner.silent(on);
    }

    fn bars(&mut self, graph: u8, bars: Bars<'_>) {
        self.inner.bars(graph, bars);
    }

    fn sample(&mut self, sample: &Sample<'_>) {
        self.log.push(sample);
        self.inner.sample(sample);
    }

    fn variables(&mut self, dump: &Dump<'_>) {
        if !self.is_full {
            self.is_full = self.variables.len() >= MAX_LOG_BYTES;
            // Writing to a String cannot fail.
            let _ = match self.is_full {
                true => writeln!(self.variables, "{FULL}"),
                false => write!(self.variables, "{dump}"),
            };
        }
        self.write_output();
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

/// Maximum length of a heading that this module writes, bytes.
const LONGEST_HEADING: u64 = 4096;

/// The error for a file that cannot be written.
#[derive(Debug)]
pub struct LogError {
    /// The file.
    pub path: PathBuf,
    /// The reason.
    pub reason: io::Error,
}

impl LogError {
    fn new(path: &Path, reason: io::Error) -> Self {
        LogError {
            path: path.to_path_buf(),
            reason,
        }
    }
}

impl fmt::Display for LogError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let path = self.path.display();
        write!(f, "{}: {}", Printable::line(path), self.reason)
    }
}

impl core::error::Error for LogError {}

/// A folder and the program whose files it holds.
#[derive(Debug)]
struct LogFolder {
    folder: PathBuf,
    program: String,
}

impl LogFolder {
    fn new(folder: PathBuf, program: &str) -> Self {
        LogFolder {
            folder,
            program: Printable::line(program).to_string(),
        }
    }

    /// Creates the folder and checks that every existing file of these names belongs to the
    /// program.
    fn take(&self, names: &[&str]) -> Result<(), LogError> {
        fs::create_dir_all(&self.folder).map_err(|error| LogError::new(&self.folder, error))?;
        names.iter().try_for_each(|name| self.check_owner(name))
    }

    /// Replaces the content of a file, completely or not at all.
    fn write(&self, name: &str, text: &str) -> Result<(), LogError> {
        let path = self.folder.join(name);
        let replace = || {
            let mut file = AtomicFile::create(&path)?;
            writeln!(file, "{}", self.heading(name))?;
            file.write_all(text.as_bytes())?;
            file.commit()
        };
        replace().map_err(|error| LogError::new(&path, error))
    }

    /// Returns the length of the first line of a file, with its end.
    fn heading_len(&self, name: &str) -> usize {
        self.heading(name).len() + 1
    }

    fn heading(&self, name: &str) -> String {
        format!("# {name} of {}", self.program)
    }

    fn check_owner(&self, name: &str) -> Result<(), LogError> {
        let path = self.folder.join(name);
        let refuse = |error| Err(LogError::new(&path, error));
        match first_line(&path) {
            Ok(line) if line == self.heading(name).as_bytes() => writable(&path).or_else(refuse),
            Ok(_) => refuse(io::Error::new(
                io::ErrorKind::AlreadyExists,
                format!("it is not a log of {} and would be lost", self.program),
            )),
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(()),
            Err(error) => refuse(error),
        }
    }

    /// Removes the file of an earlier run.
    fn remove(&self, name: &str) -> Result<(), LogError> {
        let path = self.folder.join(name);
        match fs::remove_file(&path) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => {
                Err(LogError::new(&path, error))
            }
            _ => Ok(()),
        }
    }
}

/// Refuses a file that its owner marked read-only.
fn writable(path: &Path) -> io::Result<()> {
    if fs::metadata(path)?.permissions().readonly() {
        return Err(io::ErrorKind::PermissionDenied.into());
    }
    Ok(())
}

/// Returns the first line of a file; empty for a device or a pipe, which may never have one.
fn first_line(path: &Path) -> io::Result<Vec<u8>> {
    let mut line = Vec::new();
    let found = fs::metadata(path)?;
    if !found.is_file() && !found.is_dir() {
        return Ok(line);
    }
    let file = BufReader::new(fs::File::open(path)?);
    file.take(LONGEST_HEADING).read_until(b'\n', &mut line)?;
    if line.last() == Some(&b'\n') {
        line.pop();
    }
    Ok(line)
}
