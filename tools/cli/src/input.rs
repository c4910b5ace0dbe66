//! Programs, descriptions and scenes from files.

use std::fs;
use std::io::{self, Read};
use std::path::Path;
use tip_lint::migrate::Migration;
use tip_runtime::plant::Scene;
use tipc::code::Code;
use tipc::description::{Description, Project};
use tipc::diagnostic::Diagnostic;
use tipc::message::Reading;
use tipc::source::{Encoding, Source, Span};
use tipc::{Loaded, Options};

/// Loads the program at `path`; a file that cannot be read is a diagnostic like any other.
pub(super) fn load(path: &Path, options: &Options) -> Loaded {
    let name = name(path);
    match read(path) {
        Ok(bytes) => tip_lint::load(&name, &bytes, options),
        Err(error) => unreadable(name, &error),
    }
}

/// The bytes of the program at `path`, and how findings call it.
pub(super) fn bytes(path: &Path) -> Result<(String, Vec<u8>), Box<Loaded>> {
    let name = name(path);
    match read(path) {
        Ok(bytes) => Ok((name, bytes)),
        Err(error) => Err(Box::new(unreadable(name, &error))),
    }
}

/// Migrates the program at `path`.
pub(super) fn migrate(path: &Path, encoding: Encoding) -> Result<Migration, Box<Loaded>> {
    let name = name(path);
    match read(path) {
        Ok(bytes) => tip_lint::migrate::migrate(&name, &bytes, encoding),
        Err(error) => Err(Box::new(unreadable(name, &error))),
    }
}

/// Reads the description of a robot at `path`.
pub(super) fn describe(path: &Path) -> Result<Description, Box<Loaded>> {
    let name = name(path);
    match read(path) {
        Ok(bytes) => tipc::description::parse(&name, &bytes),
        Err(error) => Err(Box::new(unreadable(name, &error))),
    }
}

/// Reads the `tip.toml` at `path`; `is_there` says whether there is a file that it names.
pub(super) fn project(
    path: &Path,
    is_there: impl Fn(&str) -> bool,
) -> Result<Project, Box<Loaded>> {
    let name = name(path);
    match read(path) {
        Ok(bytes) => tipc::description::parse_project(&name, &bytes, is_there),
        Err(error) => Err(Box::new(unreadable(name, &error))),
    }
}

/// Reads the scene at `path`.
pub(super) fn scene(path: &Path) -> Result<Scene, Box<Loaded>> {
    let name = name(path);
    match read(path) {
        Ok(bytes) => tipc::description::parse_scene(&name, &bytes),
        Err(error) => Err(Box::new(unreadable(name, &error))),
    }
}

/// What stands for standard input in the place of a file.
const STANDARD_INPUT: &str = "-";

/// Whether this is no file but standard input.
pub(super) fn is_standard(path: &Path) -> bool {
    path.to_str() == Some(STANDARD_INPUT)
}

/// How findings call a file.
fn name(path: &Path) -> String {
    match is_standard(path) {
        true => "standard input".to_owned(),
        false => path.display().to_string(),
    }
}

fn read(path: &Path) -> io::Result<Vec<u8>> {
    if !is_standard(path) {
        return fs::read(path);
    }
    let mut bytes = Vec::new();
    io::stdin().lock().read_to_end(&mut bytes)?;
    Ok(bytes)
}

fn unreadable(name: String, error: &io::Error) -> Loaded {
    let (source, _) = Source::decode(name.clone(), b"", Encoding::Utf8);
    let reason = match error.kind() {
        io::ErrorKind::IsADirectory => Reading::Folder,
        io::ErrorKind::NotFound => Reading::NoFile,
        io::ErrorKind::PermissionDenied => Reading::NotAllowed,
        _ => Reading::System {
            error: error.to_string().into(),
        },
    };
    let finding = Diagnostic::new(Code::FileNotFound, Span::default(), reason);
    Loaded::refused(source, vec![finding.about(name)])
}

/// Whether there was a file to load, good or bad.
pub(super) fn was_read(loaded: &Loaded) -> bool {
    let mut codes = loaded.diagnostics.iter().map(|diagnostic| diagnostic.code);
    codes.all(|code| code != Code::FileNotFound)
}
