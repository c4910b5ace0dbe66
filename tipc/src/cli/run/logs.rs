//! The log files of `--out-dir`.

use super::super::error::Error;
use std::path::Path;
use tip_runtime::console::{LogError, LogFiles};
use tipc::Loaded;
use tipc::codes::Level;
use tipc::diagnostic::render_short;

/// Takes `folder` for the files of one program and writes its warnings.
pub(super) fn claim(folder: &Path, loaded: &Loaded) -> Result<LogFiles<()>, Error> {
    let name = Path::new(loaded.source.name()).file_name();
    let name = name.unwrap_or_default().to_string_lossy();
    let mut files = LogFiles::claim(folder, &name, ()).map_err(error)?;
    files.warnings(&warnings(loaded));
    finish(&mut files)?;
    Ok(files)
}

/// Writes what a run left to write, and tells the first error of all writing.
pub(super) fn finish(files: &mut LogFiles<()>) -> Result<(), Error> {
    files.flush();
    files
        .take_error()
        .map_or(Ok(()), |failed| Err(error(failed)))
}

fn error(LogError { path, reason }: LogError) -> Error {
    Error::cannot_write(&path, reason)
}

/// The content of WARNING.LOG.
fn warnings(loaded: &Loaded) -> String {
    let warnings = loaded
        .diagnostics
        .iter()
        .filter(|diagnostic| diagnostic.level() == Level::Warning);
    warnings
        .map(|warning| render_short(&loaded.source, warning).trim_end().to_owned() + "\n")
        .collect()
}
