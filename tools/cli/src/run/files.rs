//! What a run writes is nothing that it reads, and no two files of it are one.

use super::super::error::Error;
use super::super::output;
use super::Run;
use super::trace::STANDARD_OUTPUT;
use std::fs;
use std::path::{Path, PathBuf};
use tip_runtime::console::LogFiles;

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
