//! Clauses of the language reference, and who names them.
#![expect(clippy::disallowed_methods, reason = "tests read the workspace")]

use case_files::{cases, root};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

/// Every clause of `docs/language.md`, such as `2.4`; it is read once.
///
/// # Panics
/// The reference cannot be read.
pub fn of_reference() -> &'static BTreeSet<String> {
    static CLAUSES: LazyLock<BTreeSet<String>> = LazyLock::new(read_reference);
    &CLAUSES
}

fn read_reference() -> BTreeSet<String> {
    let path = workspace().join("docs/language.md");
    let text = fs::read_to_string(path).unwrap_or_else(|error| panic!("docs/language.md: {error}"));
    let brackets = text
        .split('[')
        .skip(1)
        .filter_map(|rest| rest.split_once(']'));
    brackets
        .map(|(inside, _)| inside)
        .filter(|inside| is_clause(inside))
        .map(str::to_owned)
        .collect()
}

/// The clauses that an expectation's header names.
pub fn of_header(expectation: &str) -> BTreeSet<String> {
    let header = expectation.lines().take_while(|line| line.starts_with('#'));
    header
        .filter_map(|line| line.strip_prefix("# clauses:"))
        .flat_map(words)
        .collect()
}

/// The clauses that some case or some Rust test of the workspace names.
pub fn named_by_tests() -> BTreeSet<String> {
    let folder = root().join("cases");
    let expectations = cases(&folder).into_iter().flat_map(|case| {
        ["trace", "stops", "check"].map(|extension| folder.join(format!("{case}.{extension}")))
    });
    let mut named: BTreeSet<String> = expectations
        .filter_map(|path| fs::read_to_string(path).ok())
        .flat_map(|text| of_header(&text))
        .collect();
    for file in rust_files(workspace()) {
        let text = fs::read_to_string(file).unwrap_or_default();
        let comments = text
            .lines()
            .filter_map(|line| line.trim().strip_prefix("// clauses:"));
        named.extend(comments.flat_map(words));
    }
    named
}

fn workspace() -> &'static Path {
    let mut around = root().ancestors();
    around.nth(2).expect("the package is in the workspace")
}

fn words(line: &str) -> impl Iterator<Item = String> {
    line.split_whitespace().map(str::to_owned)
}

fn is_clause(text: &str) -> bool {
    let number = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    text.split_once('.')
        .is_some_and(|(section, clause)| number(section) && number(clause))
}

/// Every Rust file of the workspace; what a build left there does not count.
fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        let name = entry.file_name();
        if path.is_dir() && name != "target" && !name.to_string_lossy().starts_with('.') {
            files.extend(rust_files(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    files
}
