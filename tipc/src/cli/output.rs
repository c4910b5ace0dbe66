//! Files that appear whole or not at all, and standard output that may be closed.

use super::error::{Error, is_closed};
use std::ffi::OsString;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::{fs, process};

/// Gives the file at `path` a new content: it is written beside its place, then renamed.
pub(super) fn replace(path: &Path, content: impl AsRef<[u8]>) -> Result<(), Error> {
    let temporary = beside(path);
    let written = fs::write(&temporary, content).and_then(|()| fs::rename(&temporary, path));
    written.map_err(|error| {
        // What is left of a failed attempt is of no use; that it may not exist is fine.
        let _ = fs::remove_file(&temporary);
        Error::cannot_write(path, error)
    })
}

/// A name that no other process uses, in the folder of `path`.
fn beside(path: &Path) -> PathBuf {
    let mut name = OsString::from(".");
    name.push(path.file_name().unwrap_or_default());
    name.push(format!(".{}.part", process::id()));
    path.with_file_name(name)
}

/// Writes to standard output; a reader that went away has seen enough.
pub(super) fn print(content: impl AsRef<[u8]>) -> Result<(), Error> {
    let mut out = io::stdout().lock();
    match out.write_all(content.as_ref()).and_then(|()| out.flush()) {
        Err(error) if !is_closed(&error) => {
            Err(Error::cannot_write(Path::new("standard output"), error))
        }
        _ => Ok(()),
    }
}

/// Refuses to write over the program that is being read.
pub(super) fn refuse_source(out: &Path, source: &Path) -> Result<(), Error> {
    let same = fs::canonicalize(out)
        .and_then(|out| Ok(out == fs::canonicalize(source)?))
        .unwrap_or(false);
    if same {
        return Err(Error::cannot_write(out, "this is the program itself"));
    }
    Ok(())
}
