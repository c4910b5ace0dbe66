//! Files that appear complete or not at all, and standard output that may be closed.

use super::error::{Error, is_closed};
use super::input::is_standard;
use super::interrupt;
use std::borrow::Cow;
use std::fmt::Write as _;
use std::fs;
use std::io::{self, IsTerminal, Write};
use std::path::Path;
use std::thread;
use std::time::Duration;
use tip_runtime::printable::{Printable, is_control};
use tip_runtime::record::AtomicFile;
use tipc::embed;
use tipc::message::{Lang, Message, Reading};

/// Writes content that is no program to the file that an option names, which none of the inputs may be, or to standard output.
pub(super) fn write(
    out: Option<&Path>,
    inputs: &[&Path],
    content: impl AsRef<[u8]>,
) -> Result<(), Error> {
    let Some(out) = out else {
        return print(content);
    };
    refuse_inputs(out, inputs)?;
    replace(out, content)
}

/// Replaces the content of a file, or prints it if the path is `-`. A pipe may never get a reader: a signal ends the process then.
pub(super) fn replace(path: &Path, content: impl AsRef<[u8]>) -> Result<(), Error> {
    if is_standard(path) {
        return print(content);
    }
    if is_pipe(path) {
        interrupt::release();
    }
    let written = begin(path).and_then(|mut file| {
        file.write_all(content.as_ref())?;
        file.commit()
    });
    written.map_err(|error| Error::cannot_write(path, error))
}

/// Replaces the content of a file with much content. A signal that comes before all of it is written ends the process, and the earlier
/// file stays.
pub(super) fn replace_unless_interrupted(path: &Path, content: &[u8]) -> Result<(), Error> {
    if is_standard(path) || is_pipe(path) {
        return replace(path, content);
    }
    let written = begin(path).and_then(|mut file| {
        interrupt::discards(file.part());
        file.write_all(content)?;
        interrupt::hold();
        file.commit()
    });
    written.map_err(|error| Error::cannot_write(path, error))
}

/// Replaces the content of a file, unless it differs from what was `read`: an editor may have saved it since.
pub(super) fn update(path: &Path, read: &[u8], content: &[u8], lang: Lang) -> Result<(), Error> {
    let changed = || io::Error::other(Reading::Changed.in_lang(lang).to_string());
    let place = || {
        let now = embed::read_file(path, embed::LIMIT);
        match now.as_deref().is_ok_and(|now| now == read) {
            true => Ok((fs::canonicalize(path)?, fs::metadata(path)?)),
            false => Err(changed()),
        }
    };
    let written = place().and_then(|(before, found)| {
        let mut file = begin(path)?;
        file.write_all(content)?;
        let (after, now) = place()?;
        match after == before && is_one(&found, &now) {
            true => file.commit(),
            false => Err(changed()),
        }
    });
    written.map_err(|error| Error::cannot_write(path, error))
}

/// Opens a file for writing; for a pipe, waits for a reader until a signal ends the process.
pub(super) fn begin(path: &Path) -> io::Result<AtomicFile> {
    loop {
        match AtomicFile::create(path) {
            Err(error) if is_pipe(path) && error.raw_os_error() == Some(NO_READER) => {
                thread::sleep(PAUSE);
            }
            file => return file,
        }
    }
}

/// The error number of a pipe without a reader: ENXIO.
const NO_READER: i32 = 6;
/// Time between two attempts to open a pipe.
const PAUSE: Duration = Duration::from_millis(20);

#[cfg(unix)]
fn is_pipe(path: &Path) -> bool {
    use std::os::unix::fs::FileTypeExt;
    fs::metadata(path).is_ok_and(|found| found.file_type().is_fifo())
}

#[cfg(not(unix))]
fn is_pipe(_: &Path) -> bool {
    false
}

/// Writes bytes to standard output, made printable for a terminal. A closed output is not an error.
pub(super) fn print(content: impl AsRef<[u8]>) -> Result<(), Error> {
    let mut out = io::stdout().lock();
    let content = match out.is_terminal() {
        true => Cow::Owned(on_terminal(content.as_ref())),
        false => Cow::Borrowed(content.as_ref()),
    };
    match out.write_all(&content).and_then(|()| out.flush()) {
        Err(error) if !is_closed(&error) => {
            Err(Error::cannot_write(Path::new("standard output"), error))
        }
        _ => Ok(()),
    }
}

/// Prints a message on a line of its own.
pub(super) fn say(message: impl Into<Message>, lang: Lang) -> Result<(), Error> {
    print(format!("{}\n", message.into().in_lang(lang)))
}

/// Makes content printable for a terminal.
fn on_terminal(content: &[u8]) -> Vec<u8> {
    let text = String::from_utf8_lossy(content).replace("\r\n", "\n");
    Printable::lines(text).to_string().into_bytes()
}

/// Returns the number of columns of a line; characters of Japanese are two wide.
pub(super) fn width(line: &str) -> usize {
    let columns = line.chars().map(|char| match char < '\u{2e80}' {
        true => 1,
        false => 2,
    });
    columns.sum()
}

/// Returns the name of an output in messages.
pub(super) fn name(path: &Path) -> String {
    match is_standard(path) {
        true => "standard output".to_owned(),
        false => path.display().to_string(),
    }
}

/// Returns an error if a file to write, which becomes no program, is one of those that are read, or any program.
pub(super) fn refuse_inputs(out: &Path, inputs: &[&Path]) -> Result<(), Error> {
    refuse_same(out, inputs)?;
    let is_program = out
        .extension()
        .is_some_and(|it| it.eq_ignore_ascii_case("prg"));
    match is_program && out.is_file() {
        true => {
            let reason = "this is a program, which would be lost: name another file";
            Err(Error::cannot_write(out, reason))
        }
        false => Ok(()),
    }
}

/// Returns an error if a file to write is one of those that are read.
pub(super) fn refuse_same(out: &Path, inputs: &[&Path]) -> Result<(), Error> {
    match inputs.iter().find(|input| is_same(out, input)) {
        Some(input) if !is_standard(out) => {
            let reason = format!("this is {}, which is being read", input.display());
            Err(Error::cannot_write(out, reason))
        }
        _ => Ok(()),
    }
}

/// Returns true if two paths lead to the same file.
pub(super) fn is_same(one: &Path, other: &Path) -> bool {
    let is_one_path = fs::canonicalize(one)
        .and_then(|one| Ok(one == fs::canonicalize(other)?))
        .unwrap_or(false);
    let Ok(found) = fs::metadata(one) else {
        return false;
    };
    let is_linked = || fs::metadata(other).is_ok_and(|other| is_one(&found, &other));
    found.is_file() && (is_one_path || is_linked())
}

/// Returns true if both belong to the same file, as far as the system numbers files.
#[cfg(unix)]
pub(super) fn is_one(one: &fs::Metadata, other: &fs::Metadata) -> bool {
    use std::os::unix::fs::MetadataExt;
    (one.dev(), one.ino()) == (other.dev(), other.ino())
}

#[cfg(not(unix))]
pub(super) fn is_one(_: &fs::Metadata, other: &fs::Metadata) -> bool {
    other.is_file()
}

/// Escapes characters of JSON that could act on a terminal. They occur in strings only.
pub(super) fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for char in text.chars() {
        match char {
            '\n' => out.push(char),
            // Writing to a String cannot fail. All such characters are below 0x10000.
            _ if is_control(char) => drop(write!(out, "\\u{:04x}", u32::from(char))),
            _ => out.push(char),
        }
    }
    out
}
