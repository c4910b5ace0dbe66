//! The files of language cases, and the options in their headers: for the build script that compiles cases, and for the
//! harness that runs them.

mod settings;

pub use settings::Settings;

use std::fs;
use std::path::{Path, PathBuf};

/// Returns the folder of the tests of the language.
///
/// # Panics
/// Never: this package is in it.
pub fn root() -> &'static Path {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    package.parent().expect("the package stands in a folder")
}

/// Returns every case below `folder`, as `<area>/<name>`, in order.
pub fn cases(folder: &Path) -> Vec<String> {
    let mut cases = Vec::new();
    for area in entries(folder) {
        for file in entries(&area) {
            if file.extension().is_some_and(|extension| extension == "prg") {
                let case = file.with_extension("");
                let case = case.strip_prefix(folder).expect("it is below the folder");
                cases.push(case.to_string_lossy().replace('\\', "/"));
            }
        }
    }
    cases
}

fn entries(folder: &Path) -> Vec<PathBuf> {
    let Ok(entries) = fs::read_dir(folder) else {
        return Vec::new();
    };
    let mut entries: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    entries.sort();
    entries
}
