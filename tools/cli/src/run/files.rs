//! The files that a run writes: nothing that it reads, no two of them one, and the log files of `--out-dir`.

use super::super::error::Error;
use super::super::output;
use super::Run;
use super::trace::STANDARD_OUTPUT;
use std::ffi::OsStr;
use std::fs;
use std::path::{Component, Path, PathBuf};
use tip_lint::listing;
use tip_runtime::console::{LogError, LogFiles};
use tipc::Loaded;

/// Refuses a target that is an input of the run, or another of its targets.
pub(super) fn check(arguments: &Run) -> Result<(), Error> {
    let robot = arguments.source.robot().file();
    let scene = arguments
        .inputs
        .scene
        .as_ref()
        .and_then(|scene| scene.file());
    let inputs: Vec<&Path> = [robot, scene]
        .into_iter()
        .flatten()
        .chain([&*arguments.file])
        .collect();
    let logs = arguments.out_dir.as_deref().map(logs).unwrap_or_default();
    for log in &logs {
        output::refuse_inputs(log, &inputs)?;
    }
    let trace = arguments.trace.as_deref();
    let Some(trace) = trace.filter(|path| path.as_os_str() != STANDARD_OUTPUT) else {
        return Ok(());
    };
    output::refuse_inputs(trace, &inputs)?;
    match logs.iter().find(|log| is_place(trace, log)) {
        Some(log) => {
            let name = log.file_name().unwrap_or_default().to_string_lossy();
            let reason = format!("this is the run's own {name}");
            Err(Error::cannot_write(trace, reason))
        }
        None => Ok(()),
    }
}

fn logs(folder: &Path) -> Vec<PathBuf> {
    let names = LogFiles::<()>::NAMES.iter();
    names.map(|name| folder.join(name)).collect()
}

/// Whether two paths lead to one file, or would if it was there.
fn is_place(one: &Path, other: &Path) -> bool {
    let folder = |path: &Path| match path.parent() {
        Some(folder) if folder.as_os_str().is_empty() => fs::canonicalize("."),
        Some(folder) => fs::canonicalize(folder),
        None => fs::canonicalize(path),
    };
    let is_one_folder =
        matches!((folder(one), folder(other)), (Ok(one), Ok(other)) if one == other);
    output::is_same(one, other) || is_one_folder && one.file_name() == other.file_name()
}

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
