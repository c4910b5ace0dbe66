//! The log files of `--out-dir`.

use super::super::error::Error;
use std::ffi::OsStr;
use std::fs;
use std::path::{Component, Path, PathBuf};
use tip_lint::listing;
use tip_runtime::console::{LogError, LogFiles};
use tipc::Loaded;

/// Takes `folder` for the files of one program and writes its warnings.
pub(super) fn claim(folder: &Path, loaded: &Loaded) -> Result<LogFiles<()>, Error> {
    fs::create_dir_all(folder).map_err(|reason| Error::cannot_write(folder, reason))?;
    let name = seen_from(folder, Path::new(loaded.source.name()));
    let mut files = LogFiles::claim(folder, &name, ()).map_err(error)?;
    files.warnings(&listing::warnings(&loaded.source, &loaded.diagnostics));
    files
        .take_error()
        .map_or(Ok(files), |failed| Err(error(failed)))
}

/// The program's path from the folder, with `/` everywhere: two programs never share it, and it stays true when both move.
fn seen_from(folder: &Path, program: &Path) -> String {
    let path = match (fs::canonicalize(folder), fs::canonicalize(program)) {
        (Ok(folder), Ok(program)) => relative(&folder, &program),
        // One of them has gone since it was read: what was asked for names it well enough.
        _ => program.to_owned(),
    };
    let parts = path.iter().map(OsStr::to_string_lossy);
    parts.collect::<Vec<_>>().join("/")
}

/// The path from `folder` to `file`, both absolute; `file` itself if they have no root in common.
fn relative(folder: &Path, file: &Path) -> PathBuf {
    let common = folder
        .components()
        .zip(file.components())
        .take_while(|(folder, file)| folder == file)
        .count();
    if common == 0 {
        return file.to_owned();
    }
    let up = folder.components().skip(common);
    let down = file.components().skip(common);
    up.map(|_| Component::ParentDir).chain(down).collect()
}

/// Writes what a run left to write, and returns the first error of all writing.
pub(super) fn finish(files: &mut LogFiles<()>) -> Result<(), Error> {
    files.flush();
    files
        .take_error()
        .map_or(Ok(()), |failed| Err(error(failed)))
}

fn error(LogError { path, reason }: LogError) -> Error {
    Error::cannot_write(&path, reason)
}
