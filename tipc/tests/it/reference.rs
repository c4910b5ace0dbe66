//! The documents of the language: what they repeat of the compiler's tables and of tested programs,
//! and that nothing is missing in them. `TIP_BLESS=1` rewrites what is generated.
#![expect(clippy::disallowed_methods, reason = "documents are files")]

mod descriptions;
mod entries;
mod facts;
mod links;
mod originals;
mod snippets;
mod tables;

use std::path::{Path, PathBuf};
use std::{env, fs};

fn workspace() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Reads a file of the workspace.
fn read(path: &str) -> String {
    fs::read_to_string(workspace().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// Returns every document for users, by its path in the workspace.
fn documents() -> Vec<String> {
    let mut paths = [
        "README.md",
        "README.ja.md",
        "ARCHITECTURE.md",
        "CONTRIBUTING.md",
    ]
    .map(str::to_owned)
    .to_vec();
    for folder in ["docs", "examples"] {
        for entry in fs::read_dir(workspace().join(folder)).expect("a folder") {
            let name = entry.expect("an entry").file_name();
            let path = format!("{folder}/{}", name.to_string_lossy());
            let readme = format!("{path}/README.md");
            if path.ends_with(".md") {
                paths.push(path);
            } else if workspace().join(&readme).exists() {
                paths.push(readme);
            }
        }
    }
    paths
}

/// Checks that the document is up to date, or updates it.
fn hold(path: &str, text: &str, fresh: &str) {
    if text == fresh {
        return;
    }
    if env::var_os("TIP_BLESS").is_some() {
        fs::write(workspace().join(path), fresh).expect("the document can be written");
        return;
    }
    let pairs = text.lines().zip(fresh.lines());
    let differing = pairs.into_iter().find(|(old, new)| old != new);
    panic!("{path} is out of date, set TIP_BLESS=1 to rewrite it: {differing:#?}");
}
