//! Programs, descriptions and scenes from files, and the paths of these.

use crate::error::Error;
use crate::interrupt;
use std::ffi::OsStr;
use std::fs::File;
use std::path::{Path, PathBuf, absolute};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::Duration;
use std::{env, fs, io, thread};
use tip_drives::described;
use tip_lint::migrate::Migration;
use tip_runtime::plant::Scene;
use tip_sim::import::{self, ImportOptions};
use tipc::code::Code;
use tipc::description::{self, Description, Project};
use tipc::diagnostic::Diagnostic;
use tipc::embed::LIMIT;
use tipc::language::Edition;
use tipc::message::Reading;
use tipc::source::{Encoding, Source, Span};
use tipc::{Loaded, Options, embed};

/// Time between two looks for an interrupt while a line is awaited.
const POLL_INTERVAL: Duration = Duration::from_millis(20);

/// Reads the answer to a question that was asked now; true for RETURN alone, which is not what someone answers who does not want it.
pub(super) fn is_confirmed() -> Result<bool, Error> {
    Ok(line()?.is_some_and(|line| line.trim_end_matches(['\r', '\n']).is_empty()))
}

/// Forgets what was typed before a question: it cannot answer it.
pub(super) fn forget_typed() {
    // Only a terminal can forget.
    #[cfg(unix)]
    let _ = rustix::termios::tcflush(io::stdin(), rustix::termios::QueueSelector::IFlush);
}

/// Reads a line of standard input; `None` at its end, or if the command is interrupted meanwhile.
pub(super) fn line() -> Result<Option<String>, Error> {
    let (sender, receiver) = channel();
    // A signal does not end the reading; the thread ends with the process then.
    thread::spawn(move || {
        let mut line = String::new();
        let read = io::stdin().read_line(&mut line);
        // Nobody may wait for it any more.
        let _ = sender.send(read.map(|count| (count > 0).then_some(line)));
    });
    loop {
        let line = match receiver.recv_timeout(POLL_INTERVAL) {
            Ok(line) => Some(line.map_err(|error| Error::Failed(error.to_string()))?),
            Err(RecvTimeoutError::Timeout) => None,
            Err(RecvTimeoutError::Disconnected) => Some(None),
        };
        if interrupt::is_requested() {
            return Ok(None);
        }
        if let Some(line) = line {
            return Ok(line);
        }
    }
}

/// Loads the program at `path`; a file that cannot be read is a diagnostic like any other.
pub(super) fn load(path: &Path, options: &Options) -> Loaded {
    loaded(name(path), read(path, LIMIT), options)
}

/// Loads the program of a regular file. Standard input, which `load` reads as well, may be an editor's connection.
pub(super) fn load_file(path: &Path, options: &Options) -> Loaded {
    let name = path.display().to_string();
    loaded(name, embed::read_file(path, LIMIT), options)
}

fn loaded(name: String, read: Result<Vec<u8>, Reading>, options: &Options) -> Loaded {
    match read {
        Ok(bytes) => tip_lint::load(&name, &bytes, options),
        Err(reason) => unreadable(name, reason),
    }
}

/// Reads the program at `path`; returns its name in diagnostics, too.
pub(super) fn bytes(path: &Path) -> Result<(String, Vec<u8>), Box<Loaded>> {
    let name = name(path);
    match read(path, LIMIT) {
        Ok(bytes) => Ok((name, bytes)),
        Err(reason) => Err(Box::new(unreadable(name, reason))),
    }
}

/// Migrates the program at `path`.
pub(super) fn migrate(
    path: &Path,
    encoding: Encoding,
    edition: Edition,
) -> Result<Migration, Box<Loaded>> {
    let (name, bytes) = bytes(path)?;
    tip_lint::migrate::migrate_to(edition, &name, &bytes, encoding)
}

/// Returns true if a file is called URDF or MJCF by its extension.
pub(super) fn is_model(path: &Path) -> bool {
    let ending = path.extension().and_then(OsStr::to_str);
    ending.is_some_and(|ending| ["urdf", "xml", "mjcf"].contains(&ending))
}

/// Returns the folder of a file, below which it may include others; a stream has none.
pub(super) fn folder(path: &Path) -> Option<PathBuf> {
    let folder = path.parent().filter(|_| !is_stream(path))?;
    Some(match folder.as_os_str().is_empty() {
        true => PathBuf::from("."),
        false => folder.to_owned(),
    })
}

/// Reads the text of a description at `path`, or imports a URDF or MJCF file; returns its name in diagnostics, too.
pub(super) fn description_text(path: &Path) -> Result<(String, Vec<u8>), Box<Loaded>> {
    let (name, bytes) = bytes(path)?;
    if !is_model(path) {
        return Ok((name, bytes));
    }
    let file = path.file_name().unwrap_or_default().to_string_lossy();
    let options = ImportOptions {
        folder: folder(path),
        ..ImportOptions::default()
    };
    let text = import::decode(&bytes);
    let imported = text.and_then(|text| import::import_with(&file, &text, &options));
    imported
        .map(|import| (name.clone(), import.toml.into_bytes()))
        .map_err(|refused| {
            let (source, _) = Source::decode(name, &bytes, Encoding::Utf8);
            let reason = refused.message().clone();
            let diagnostic = Diagnostic::new(Code::Description, Span::default(), reason);
            Box::new(Loaded::refused(source, vec![diagnostic]))
        })
}

/// Reads the description of a robot at `path`, or imports a URDF or MJCF file.
pub(super) fn describe(path: &Path) -> Result<Description, Box<Loaded>> {
    let (name, bytes) = description_text(path)?;
    description::parse_for_servos(&name, &bytes, &described::servos())
}

/// Reads the `tip.toml` at `path`; `is_there` says whether there is a file that it names.
pub(super) fn project(
    path: &Path,
    is_there: impl Fn(&str) -> bool,
) -> Result<Project, Box<Loaded>> {
    let name = name(path);
    match embed::read_file(path, LIMIT) {
        Ok(bytes) => description::parse_project(&name, &bytes, is_there),
        Err(reason) => Err(Box::new(unreadable(name, reason))),
    }
}

/// Reads the scene at `path`.
pub(super) fn scene(path: &Path) -> Result<Scene, Box<Loaded>> {
    let (name, bytes) = bytes(path)?;
    description::parse_scene(&name, &bytes)
}

/// Returns true if the path names standard input or output.
pub(super) fn is_standard(path: &Path) -> bool {
    path.to_str() == Some("-")
}

/// Returns true if the path names standard input or another open descriptor of this process, as the shell's `<(COMMAND)` does. A
/// link to one does not count: it may be part of a checkout.
pub(super) fn is_stream(path: &Path) -> bool {
    let folders = ["/dev/fd", "/proc/self/fd"].map(Path::new);
    let is_descriptor = || folders.contains(&path.parent().unwrap_or(path));
    is_standard(path) || path == Path::new("/dev/stdin") || is_descriptor()
}

/// Returns the path without links and `..`, as the system finds the file. As much of it as exists counts; a stream is in the
/// working directory.
pub(super) fn real(path: &Path) -> PathBuf {
    fn resolve(path: &Path) -> PathBuf {
        let missing = || Some(resolve(path.parent()?).join(path.file_name()?));
        let found = fs::canonicalize(path).ok().or_else(missing);
        found.unwrap_or_else(|| path.to_owned())
    }
    if is_stream(path) {
        let here = env::current_dir().unwrap_or_default();
        return resolve(&here).join("-");
    }
    // `..` is kept: only the system can resolve it.
    absolute(path).map_or_else(|_| path.to_owned(), |path| resolve(&path))
}

/// Returns a path relative to the working directory if it is inside.
pub(super) fn display_path(path: &Path) -> PathBuf {
    let here = env::current_dir().and_then(fs::canonicalize).ok();
    let inside = here.and_then(|here| path.strip_prefix(here).ok().map(Path::to_owned));
    inside.unwrap_or_else(|| path.to_owned())
}

/// Returns the name of a file in diagnostics.
pub(super) fn name(path: &Path) -> String {
    match is_standard(path) {
        true => "standard input".to_owned(),
        false => path.display().to_string(),
    }
}

/// Reads what the command line names: a regular file, or a stream that is open already.
pub(super) fn read(path: &Path, limit: usize) -> Result<Vec<u8>, Reading> {
    if is_standard(path) {
        return embed::read_stream(io::stdin().lock(), limit);
    }
    if is_stream(path)
        && let Ok(stream) = File::open(path)
    {
        return embed::read_stream(stream, limit);
    }
    embed::read_file(path, limit)
}

fn unreadable(name: String, reason: Reading) -> Loaded {
    let (source, _) = Source::decode(name.clone(), b"", Encoding::Utf8);
    let diagnostic = Diagnostic::new(Code::FileNotFound, Span::default(), reason);
    Loaded::refused(source, vec![diagnostic.about(name)])
}

/// Returns true if the file could be read.
pub(super) fn was_read(loaded: &Loaded) -> bool {
    let mut codes = loaded.diagnostics.iter().map(|diagnostic| diagnostic.code);
    codes.all(|code| code != Code::FileNotFound)
}
