//! Files that appear complete or not at all, and standard output that may be closed.

use super::error::{Error, is_closed};
use std::borrow::Cow;
use std::fs;
use std::io::{self, IsTerminal, Write};
use std::path::Path;
use tip_runtime::printable::Printable;
use tip_runtime::record::WholeFile;

/// Gives the file at `path` a new content.
pub(super) fn replace(path: &Path, content: impl AsRef<[u8]>) -> Result<(), Error> {
    let written = WholeFile::create(path).and_then(|mut file| {
        file.write_all(content.as_ref())?;
        file.commit()
    });
    written.map_err(|error| Error::cannot_write(path, error))
}

/// Writes to standard output, to the byte unless it is a terminal; a reader that went away has seen enough.
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

/// What a terminal shows of it.
fn on_terminal(content: &[u8]) -> Vec<u8> {
    let text = String::from_utf8_lossy(content).replace("\r\n", "\n");
    Printable::lines(text).to_string().into_bytes()
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
