//! The table of a sweep: a file that grows and can be gone on with, or standard output.

use super::tally::Tally;
use crate::error::{Error, is_closed};
use crate::message::{Sweeping, Using};
use crate::output;
use serde::{Deserialize, Serialize};
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufRead, BufReader, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use tip_sweep::{Columns, Spec};
use tipc::message::Lang;

/// The specification of a table, in a file next to it.
#[derive(Debug, PartialEq, Deserialize, Serialize)]
pub(crate) struct Saved {
    /// The version of the command that has written the table.
    tip: String,
    pub(crate) spec: Spec,
}

impl Saved {
    pub(super) fn new(spec: Spec) -> Self {
        Saved {
            tip: env!("CARGO_PKG_VERSION").to_owned(),
            spec,
        }
    }

    /// Reads the specification of a table.
    ///
    /// # Errors
    /// There is none.
    pub(crate) fn of(table: &Path, lang: Lang) -> Result<Self, Error> {
        let path = specification(table);
        let failed = |error: String| {
            let file = path.display().to_string().into();
            let error = error.into();
            Error::failed(Sweeping::NoSpecification { file, error }, lang)
        };
        let text = fs::read_to_string(&path).map_err(|error| failed(error.to_string()))?;
        serde_json::from_str(&text).map_err(|error| failed(error.to_string()))
    }

    fn text(&self) -> String {
        // The specification has string keys and no values that JSON lacks.
        serde_json::to_string_pretty(self).unwrap_or_default() + "\n"
    }
}

/// Returns true for the table of a sweep, complete or not.
pub(crate) fn is_table(path: &Path) -> bool {
    let name = path.to_string_lossy();
    name.ends_with(".csv") || name.ends_with(".csv.part")
}

/// Returns the path of the specification of a table.
pub(crate) fn specification(table: &Path) -> PathBuf {
    match table.extension() {
        Some(end) if end == "part" => table.with_extension("").with_extension("sweep.json"),
        _ => table.with_extension("sweep.json"),
    }
}

/// Returns the path of an unfinished table.
pub(super) fn part(table: &Path) -> PathBuf {
    let mut name = table.as_os_str().to_owned();
    name.push(".part");
    name.into()
}

/// A table that grows.
pub(super) struct Table {
    out: Out,
    has_header: bool,
}

enum Out {
    Stream,
    /// The complete table is there.
    Complete,
    Part {
        file: File,
        path: PathBuf,
    },
}

impl Table {
    /// Returns the table on standard output.
    pub(super) fn stream() -> Self {
        Table {
            out: Out::Stream,
            has_header: false,
        }
    }

    /// Starts a table, or resumes one if there is a `header`, the first line of the sweep's table. Counts the rows of a
    /// resumed table.
    ///
    /// # Errors
    /// A file cannot be written, or there is something that must not be lost: an unfinished table, a device, another
    /// file in the place of the specification.
    pub(super) fn open(
        path: &Path,
        saved: &Saved,
        header: Option<&str>,
        lang: Lang,
    ) -> Result<(Self, Tally), Error> {
        let refuse = |why: Using| Err(Error::failed(why, lang));
        // A new table takes the place of a file, not of a link to it.
        let path = &fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
        if fs::metadata(path).is_ok_and(|found| !found.is_file()) {
            let file = path.display().to_string().into();
            return refuse(Using::NotAFile { file });
        }
        let unfinished = part(path);
        let failed = |error| Error::cannot_write(&unfinished, error);
        let (has_part, is_there) = (unfinished.exists(), path.exists());
        if has_part && header.is_none() {
            let part = unfinished.display().to_string().into();
            return refuse(Using::HasPart { part });
        }
        let other_sweep = || {
            let file = path.display().to_string().into();
            refuse(Using::OtherSweep { file })
        };
        if let Some(header) = header.filter(|_| has_part || is_there) {
            if Saved::of(path, lang)? != *saved {
                return other_sweep();
            }
            let mut tally = Tally::default();
            let out = if has_part {
                let options = OpenOptions::new().read(true).write(true).open(&unfinished);
                let mut file = options.map_err(failed)?;
                let (end, is_whole) = count(&file, header, &mut tally).map_err(failed)?;
                if end == 0 && !is_whole {
                    return other_sweep();
                }
                // A kill may have left a piece of a row, and a power failure rows of zeros.
                let cut = file.set_len(end).and_then(|()| file.seek(SeekFrom::End(0)));
                cut.map_err(failed)?;
                let path = unfinished;
                Out::Part { file, path }
            } else {
                let file = File::open(path).map_err(failed)?;
                let (_, is_whole) = count(&file, header, &mut tally).map_err(failed)?;
                if !is_whole {
                    return other_sweep();
                }
                Out::Complete
            };
            let has_header = tally.has_header();
            return Ok((Table { out, has_header }, tally));
        }
        let specified = specification(path);
        if specified.exists() && Saved::of(path, lang).is_err() {
            let file = specified.display().to_string().into();
            return refuse(Using::NoSweep { file });
        }
        // The name that the user gave says more than that of the unfinished table.
        let file = File::create(&unfinished).map_err(|error| Error::cannot_write(path, error))?;
        output::replace(&specified, saved.text())?;
        let path = unfinished;
        let table = Table {
            out: Out::Part { file, path },
            has_header: false,
        };
        Ok((table, Tally::default()))
    }

    pub(super) fn is_stream(&self) -> bool {
        matches!(self.out, Out::Stream)
    }

    /// Adds rows; `false` if nobody reads them.
    pub(super) fn add(&mut self, columns: &Columns, tally: &mut Tally) -> Result<bool, Error> {
        if columns.is_empty() {
            return Ok(true);
        }
        let mut text = String::new();
        if !self.has_header {
            self.has_header = true;
            text = columns.csv_header();
        }
        text.push_str(&columns.csv_rows());
        text.lines().for_each(|line| tally.add(line));
        match &mut self.out {
            Out::Stream => {
                let mut out = io::stdout().lock();
                match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
                    Err(error) if is_closed(&error) => Ok(false),
                    Err(error) => Err(Error::cannot_write(Path::new("standard output"), error)),
                    Ok(()) => Ok(true),
                }
            }
            Out::Complete => Ok(true),
            Out::Part { file, path } => match file.write_all(text.as_bytes()) {
                Err(error) => Err(Error::cannot_write(path, error)),
                Ok(()) => Ok(true),
            },
        }
    }

    /// Gives the complete table its name.
    pub(super) fn finish(&mut self) -> Result<(), Error> {
        if let Out::Part { file, path } = &self.out {
            let table = path.with_extension("");
            let renamed = file.sync_all().and_then(|()| fs::rename(path, &table));
            renamed.map_err(|error| Error::cannot_write(&table, error))?;
        }
        Ok(())
    }
}

/// Counts the complete rows of a table up to the first line that is not the next one of the sweep. Returns their end,
/// and true if there is no such line.
fn count(file: &File, header: &str, tally: &mut Tally) -> io::Result<(u64, bool)> {
    let (mut end, mut line) = (0, Vec::new());
    let mut reader = BufReader::new(file);
    loop {
        line.clear();
        let length = reader.read_until(b'\n', &mut line)?;
        if !line.ends_with(b"\n") {
            return Ok((end, true));
        }
        let text = String::from_utf8_lossy(&line);
        let is_next = match tally.has_header() {
            false => text == header,
            true => tally.takes(text.trim_end()),
        };
        if !is_next {
            return Ok((end, false));
        }
        end += length as u64;
        tally.add(text.trim_end());
    }
}
