//! A folder of log files that belong to one program: complete or absent, and never replacing those
//! of another.
#![allow(
    clippy::disallowed_methods,
    reason = "this console is for writing files"
)]

use crate::printable::Printable;
use crate::record::AtomicFile;
use core::fmt;
use std::io::{self, BufRead, BufReader, Read, Write};
use std::path::{Path, PathBuf};
use std::string::{String, ToString};
use std::{format, fs, vec::Vec};

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
pub(super) struct LogFolder {
    folder: PathBuf,
    program: String,
}

impl LogFolder {
    pub(super) fn new(folder: PathBuf, program: &str) -> Self {
        LogFolder {
            folder,
            program: Printable::line(program).to_string(),
        }
    }

    /// Creates the folder and checks that every existing file of these names belongs to the
    /// program.
    pub(super) fn take(&self, names: &[&str]) -> Result<(), LogError> {
        fs::create_dir_all(&self.folder).map_err(|error| LogError::new(&self.folder, error))?;
        names.iter().try_for_each(|name| self.check_owner(name))
    }

    /// Replaces the content of a file, completely or not at all.
    pub(super) fn write(&self, name: &str, text: &str) -> Result<(), LogError> {
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
    pub(super) fn heading_len(&self, name: &str) -> usize {
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
    pub(super) fn remove(&self, name: &str) -> Result<(), LogError> {
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
