//! The files of a sweep: a table that grows and can be resumed, and the specification next to it.
//!
//! Both grow under names with `.part`, and get their own names when the table is complete: the specification first. Each row has a check
//! over its cells and the specification, so that a process that is killed at any point leaves files that belong together, or files whose
//! rows are refused.

use super::summary::Summary;
use crate::error::{Error, is_closed};
use crate::message::{Sweeping, Using};
use crate::output;
use std::collections::HashSet;
use std::ffi::OsStr;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, BufRead, BufReader, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use tip_sweep::{Ranking, Row, Saved, Sweep};
use tipc::embed;
use tipc::message::Lang;

/// Maximum size of a specification, MiB: the texts of a program, a robot and a scene.
const MAX_SPECIFICATION: usize = 128;

/// Returns true for the table of a sweep, complete or not.
pub(crate) fn is_table(path: &Path) -> bool {
    let name = path.to_string_lossy();
    name.ends_with(".csv") || name.ends_with(".csv.part")
}

/// Returns the path of the specification of a table.
pub(crate) fn specification(table: &Path) -> PathBuf {
    if table.extension() != Some(OsStr::new("part")) {
        return table.with_extension("sweep.json");
    }
    let complete = table.with_extension("").with_extension("sweep.json");
    // Of a sweep that was killed as it became complete, the specification has its name already.
    match with_part(&complete) {
        unfinished if unfinished.exists() => unfinished,
        _ => complete,
    }
}

/// Returns the name of an unfinished file.
pub(super) fn with_part(path: &Path) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(".part");
    name.into()
}

/// Reads the specification of a table.
///
/// # Errors
/// There is none.
pub(super) fn saved(table: &Path, lang: Lang) -> Result<Saved, Error> {
    let path = specification(table);
    let failed = |error: String| {
        let file = path.display().to_string().into();
        let error = error.into();
        Error::failed(Sweeping::NoSpecification { file, error }, lang)
    };
    let text = embed::read_file(&path, MAX_SPECIFICATION);
    let text = text.map_err(|reason| failed(reason.in_lang(lang).to_string()))?;
    Saved::read(&text).map_err(|error| failed(error.to_string()))
}

/// Reads the rows of a table that the sweep has written. The last line of an unfinished table may be cut off.
///
/// # Errors
/// The file cannot be read, or has a line that the sweep has not written, or a row twice.
pub(super) fn rows(
    path: &Path,
    sweep: &Sweep,
    lang: Lang,
    mut found: impl FnMut(Row),
) -> Result<(), Error> {
    let cannot_read = |reason: String| Error::Failed(format!("{}: {reason}", path.display()));
    let file = embed::open_file(path);
    let file = file.map_err(|reason| cannot_read(reason.in_lang(lang).to_string()))?;
    let is_finished = path.extension() != Some(OsStr::new("part"));
    let mut lines = Lines::of(&file, sweep, false);
    let mut cases = HashSet::new();
    let number = loop {
        let line = lines.next();
        match line.map_err(|error| cannot_read(error.to_string()))? {
            Line::Header => {}
            Line::Row(row) if cases.insert(row.case()) => found(row),
            // The row is the one that was read last.
            Line::Row(_) => break lines.count,
            Line::End if is_finished && (lines.count == 0 || !lines.line.is_empty()) => {
                break lines.count + 1;
            }
            Line::End => return Ok(()),
            Line::Other { number } => break number,
        }
    };
    let name = || path.display().to_string().into();
    let reason = match number {
        1 => Sweeping::NoTable { file: name() },
        _ => Sweeping::OtherRow {
            file: name(),
            line: number.to_string(),
            specification: specification(path).display().to_string().into(),
        },
    };
    Err(Error::failed(reason, lang))
}

/// A line of a table.
enum Line {
    Header,
    /// The row of the next case.
    Row(Row),
    /// A line that the sweep has not written there.
    Other {
        number: u64,
    },
    /// The end of the file, or a line without an end.
    End,
}

/// The lines of a table that the sweep has written; with `in_order` those of all cases from the first one on.
struct Lines<'a> {
    reader: BufReader<&'a File>,
    sweep: &'a Sweep,
    in_order: bool,
    line: Vec<u8>,
    /// Number of lines that the sweep has written, and their end.
    count: u64,
    end: u64,
}

impl<'a> Lines<'a> {
    fn of(file: &'a File, sweep: &'a Sweep, in_order: bool) -> Self {
        Lines {
            reader: BufReader::new(file),
            sweep,
            in_order,
            line: Vec::new(),
            count: 0,
            end: 0,
        }
    }

    fn next(&mut self) -> io::Result<Line> {
        self.line.clear();
        let length = self.reader.read_until(b'\n', &mut self.line)?;
        if !self.line.ends_with(b"\n") {
            return Ok(Line::End);
        }
        let text = String::from_utf8_lossy(&self.line);
        let line = match self.count.checked_sub(1) {
            None if text == self.sweep.header() => Line::Header,
            None => Line::Other { number: 1 },
            Some(case) => match self.sweep.read_row(&text) {
                Some(row) if !self.in_order || row.case() == case => Line::Row(row),
                _ => Line::Other {
                    number: self.count + 1,
                },
            },
        };
        if !matches!(line, Line::Other { .. }) {
            self.count += 1;
            self.end += length as u64;
        }
        Ok(line)
    }

    /// Returns true if the line was written by a program that ends lines or begins files in another way.
    fn is_foreign(&self) -> bool {
        self.line.ends_with(b"\r\n") || self.line.starts_with("\u{feff}".as_bytes())
    }
}

/// A table that grows.
pub(super) enum Table {
    /// Standard output.
    Stream,
    /// The complete table is there.
    Complete,
    /// Files under names with `.part`. The table is locked.
    Part { file: File, paths: Paths },
}

/// The files of a sweep.
pub(super) struct Paths {
    table: PathBuf,
    part: PathBuf,
    specification: PathBuf,
    specification_part: PathBuf,
}

impl Paths {
    /// Returns the paths for a table.
    ///
    /// # Errors
    /// A place has something that must not be lost: a link, a device, a read-only file, or something else than a specification.
    fn of(table: &Path, lang: Lang) -> Result<Self, Error> {
        let table = table.to_owned();
        let name = |path: &Path| path.display().to_string().into();
        let refuse = |why: Using| Err(Error::failed(why, lang));
        let found = fs::metadata(&table);
        if found.as_ref().is_ok_and(|found| !found.is_file()) {
            return refuse(Using::NotAFile { file: name(&table) });
        }
        if table.extension() != Some(OsStr::new("csv")) {
            return refuse(Using::NotATableName { file: name(&table) });
        }
        let specification = table.with_extension("sweep.json");
        // A link is neither followed nor replaced.
        for file in [&table, &specification] {
            if file.is_symlink() {
                return refuse(Using::IsLink { file: name(file) });
            }
        }
        if fs::symlink_metadata(&specification).is_ok() {
            let text = embed::read_file(&specification, MAX_SPECIFICATION);
            if !text.is_ok_and(|text| Saved::read(&text).is_ok()) {
                let file = name(&specification);
                return refuse(Using::NoSweep { file });
            }
        }
        // To rename asks the folder for leave only.
        for file in [&table, &specification] {
            if fs::metadata(file).is_ok_and(|found| found.permissions().readonly()) {
                let error = io::Error::from(io::ErrorKind::PermissionDenied);
                return Err(Error::cannot_write(file, error));
            }
        }
        let paths = Paths {
            part: with_part(&table),
            specification_part: with_part(&specification),
            specification,
            table,
        };
        // Neither is a link to another file followed, nor a pipe waited for.
        for part in [&paths.part, &paths.specification_part] {
            if fs::symlink_metadata(part).is_ok_and(|found| !found.is_file()) {
                return refuse(Using::NotAPart { part: name(part) });
            }
        }
        Ok(paths)
    }

    /// Opens and locks the unfinished table, which is made if it is not there.
    fn lock(&self, lang: Lang) -> Result<File, Error> {
        // The name that the user gave says more than that of the unfinished table.
        let failed = |error| Error::cannot_write(&self.table, error);
        let mut options = OpenOptions::new();
        let options = options.read(true).write(true).create(true).truncate(false);
        let file = options.open(&self.part).map_err(failed)?;
        let is_locked = match file.try_lock() {
            Ok(()) => true,
            Err(TryLockError::WouldBlock) => false,
            // Some file systems have no locks.
            Err(TryLockError::Error(_)) => true,
        };
        // The other sweep may have become complete in between, and the file have got its name.
        let found = file.metadata().map_err(failed)?;
        let is_there = |part: fs::Metadata| output::is_one(&part, &found);
        if is_locked && fs::symlink_metadata(&self.part).is_ok_and(is_there) {
            return Ok(file);
        }
        let part = self.part.display().to_string().into();
        Err(Error::failed(Using::IsLocked { part }, lang))
    }

    /// Writes the specification of a table that begins.
    fn begin(&self, sweep: &Sweep, ranking: &Ranking) -> Result<(), Error> {
        let path = &self.specification_part;
        // A link is not followed.
        let written = match fs::remove_file(path) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
            _ => File::create_new(path).and_then(|mut file| {
                file.write_all(Saved::of(sweep, ranking.clone()).text().as_bytes())?;
                file.sync_all()
            }),
        };
        written.map_err(|error| Error::cannot_write(&self.specification, error))
    }

    /// Writes the goals of a complete table anew, if they are others.
    fn rank(&self, sweep: &Sweep, ranking: &Ranking, lang: Lang) -> Result<(), Error> {
        if saved(&self.table, lang)?.ranking == *ranking {
            return Ok(());
        }
        self.begin(sweep, ranking)?;
        let renamed = fs::rename(&self.specification_part, &self.specification);
        renamed.map_err(|error| Error::cannot_write(&self.specification, error))
    }
}

impl Table {
    /// Starts a table, or resumes one. Counts the rows of a resumed table.
    ///
    /// # Errors
    /// A file cannot be written, or there is something that must not be lost: an unfinished table, a device, another
    /// file in the place of the specification.
    pub(super) fn open(
        path: &Path,
        sweep: &Sweep,
        ranking: Ranking,
        resume: bool,
        force: bool,
        lang: Lang,
    ) -> Result<(Self, Summary), Error> {
        let paths = Paths::of(path, lang)?;
        let length = |path: &Path| fs::metadata(path).map(|found| found.len()).ok();
        if !resume && !force && length(&paths.table).unwrap_or(0) > 0 {
            let file = path.display().to_string().into();
            return Err(Error::failed(Using::HasTable { file }, lang));
        }
        let part = length(&paths.part);
        if resume && part.unwrap_or(0) == 0 && paths.table.exists() {
            let other_sweep = || other_sweep(&paths.table, lang);
            let known = saved(&paths.table, lang)?;
            if !known.is_of(sweep) {
                return Err(other_sweep());
            }
            let mut summary = Summary::new(ranking);
            rows(&paths.table, sweep, lang, |row| summary.add(&row))?;
            if summary.runs != sweep.cases() {
                return Err(other_sweep());
            }
            if known.ranking != *summary.ranking() {
                // Nobody writes the specification meanwhile.
                let _lock = paths.lock(lang)?;
                let ranked = paths.rank(sweep, summary.ranking(), lang);
                let _ = fs::remove_file(&paths.part);
                ranked?;
            }
            return Ok((Table::Complete, summary));
        }
        let mut file = paths.lock(lang)?;
        if length(&paths.part) != Some(0) {
            if !resume {
                let part = paths.part.display().to_string().into();
                return Err(Error::failed(Using::HasPart { part }, lang));
            }
            let summary = resumed(&mut file, &paths, sweep, ranking, lang)?;
            return Ok((Table::Part { file, paths }, summary));
        }
        if let Err(error) = paths.begin(sweep, &ranking) {
            // Nothing has been written: there is nothing to resume.
            let _ = fs::remove_file(&paths.specification_part);
            let _ = fs::remove_file(&paths.part);
            return Err(error);
        }
        Ok((Table::Part { file, paths }, Summary::new(ranking)))
    }

    pub(super) fn is_stream(&self) -> bool {
        matches!(self, Table::Stream)
    }

    /// Adds rows; `false` if nobody reads them. If a row cannot be written, those before it are in the table and in the summary.
    pub(super) fn add(
        &mut self,
        rows: &[Row],
        sweep: &Sweep,
        summary: &mut Summary,
    ) -> Result<bool, Error> {
        for row in rows {
            let header = (summary.runs == 0).then(|| sweep.header());
            let text = header.unwrap_or_default() + &row.line();
            match self {
                Table::Stream => match io::stdout().write_all(text.as_bytes()) {
                    Err(error) if is_closed(&error) => return Ok(false),
                    written => written.map_err(cannot_print)?,
                },
                Table::Complete => {}
                Table::Part { file, paths } => {
                    let written = file.write_all(text.as_bytes());
                    written.map_err(|error| Error::cannot_write(&paths.part, error))?;
                }
            }
            summary.add(row);
        }
        match io::stdout().flush() {
            Err(error) if self.is_stream() && is_closed(&error) => Ok(false),
            Err(error) if self.is_stream() => Err(cannot_print(error)),
            _ => Ok(true),
        }
    }

    /// Gives the complete table and its specification their names.
    pub(super) fn finish(
        &mut self,
        sweep: &Sweep,
        ranking: &Ranking,
        lang: Lang,
    ) -> Result<(), Error> {
        let Table::Part { file, paths } = self else {
            return Ok(());
        };
        let named = file.sync_all().and_then(|()| {
            match fs::rename(&paths.specification_part, &paths.specification) {
                // A sweep that was killed here has named it already.
                Err(error) if error.kind() == io::ErrorKind::NotFound => {}
                renamed => renamed?,
            }
            fs::rename(&paths.part, &paths.table)
        });
        named.map_err(|error| Error::cannot_write(&paths.table, error))?;
        paths.rank(sweep, ranking, lang)
    }
}

fn cannot_print(error: io::Error) -> Error {
    Error::cannot_write(Path::new("standard output"), error)
}

fn other_sweep(file: &Path, lang: Lang) -> Error {
    let file = file.display().to_string().into();
    Error::failed(Using::OtherSweep { file }, lang)
}

/// Counts the rows of an unfinished table, and cuts off what the sweep has not written: a kill may have left a piece of a row, and a
/// power failure rows of zeros.
fn resumed(
    file: &mut File,
    paths: &Paths,
    sweep: &Sweep,
    ranking: Ranking,
    lang: Lang,
) -> Result<Summary, Error> {
    let failed = |error| Error::cannot_write(&paths.part, error);
    if !saved(&paths.part, lang)?.is_of(sweep) {
        return Err(other_sweep(&paths.table, lang));
    }
    let mut summary = Summary::new(ranking);
    let mut lines = Lines::of(file, sweep, true);
    loop {
        match lines.next().map_err(failed)? {
            Line::Header => {}
            Line::Row(row) => summary.add(&row),
            Line::End => break,
            Line::Other { number } => {
                if lines.is_foreign() {
                    let part = paths.part.display().to_string().into();
                    return Err(Error::failed(Using::ForeignLines { part }, lang));
                }
                // The specification is that of this sweep. Without a row that can be kept, the file is not thrown away.
                if number == 1 || number == 2 && lines.line.starts_with(b"0,") {
                    let part = paths.part.display().to_string().into();
                    let line = number.to_string();
                    return Err(Error::failed(Using::DamagedPart { part, line }, lang));
                }
                break;
            }
        }
    }
    // Without a row there is no header: the first row brings it.
    let end = if summary.runs == 0 { 0 } else { lines.end };
    let cut = file.set_len(end).and_then(|()| file.seek(SeekFrom::End(0)));
    cut.map_err(failed)?;
    Ok(summary)
}
