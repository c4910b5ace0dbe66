//! The files of a build script.
#![expect(
    clippy::disallowed_methods,
    reason = "a build script is where files are read and written"
)]

use super::BuildError;
use crate::message::Building;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use std::{env, fs};

/// Files that this build script generated so far, each with its source.
static GENERATED: Mutex<BTreeMap<PathBuf, PathBuf>> = Mutex::new(BTreeMap::new());

/// Returns the folder of generated files.
pub(super) fn out_dir(chosen: Option<&Path>) -> Result<PathBuf, BuildError> {
    match (chosen, env::var_os("OUT_DIR")) {
        (Some(folder), _) => Ok(folder.to_owned()),
        (None, Some(folder)) => Ok(folder.into()),
        (None, None) => Err(BuildError::setting(Building::NoOutDir)),
    }
}

/// Refuses a file that another input of this build script is generated to already: it would be overwritten.
pub(super) fn claim(output: &Path, input: &Path) -> Result<(), BuildError> {
    let mut generated = GENERATED.lock().unwrap_or_else(PoisonError::into_inner);
    let first = generated.entry(output.to_owned());
    let first = first.or_insert_with(|| input.to_owned());
    match first == input {
        true => Ok(()),
        false => Err(super::same_output(first, input)),
    }
}

/// Leaves a file with this very text alone, so that nothing is rebuilt because of it.
pub(super) fn write_if_changed(path: &Path, text: &str) -> Result<(), BuildError> {
    if fs::read(path).is_ok_and(|old| old == text.as_bytes()) {
        return Ok(());
    }
    let folder = path.parent().map_or(Ok(()), fs::create_dir_all);
    folder
        .and_then(|()| fs::write(path, text))
        .map_err(|error| {
            BuildError::setting(Building::CannotWrite {
                path: path.display().to_string().into(),
                error: error.to_string().into(),
            })
        })
}
