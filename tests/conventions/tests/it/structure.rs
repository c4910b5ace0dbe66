//! The rules of ARCHITECTURE.md that a compiler does not hold.

use conventions::{circles, modules, packages, root};
use std::fs;

/// Folders of crates.
const FOLDERS: [&str; 11] = [
    "tip-runtime",
    "tipc",
    "tip-macros",
    "tools",
    "examples",
    "tests",
    "tests/codegen",
    "tests/differential",
    "tests/fuzz",
    "tests/language",
    "benches",
];

#[test]
fn no_modules_import_each_other_in_a_loop() {
    let all = packages(&FOLDERS);
    assert!(all.len() > 10, "the packages are found");
    for package in all {
        let circles = circles(&modules(&package.folder.join("src")));
        let found: String = circles.iter().map(ToString::to_string).collect();
        assert!(found.is_empty(), "{}:\n{found}", package.name);
    }
}

/// Allowed dependencies of each product crate and tool on others of the workspace, tests included.
const ARROWS: &[(&str, &[&str])] = &[
    ("tip-runtime", &[]),
    ("tip-compiler", &["tip-runtime"]),
    ("tip-macros", &["tip-compiler"]),
    ("tip-lint", &["tip-runtime", "tip-compiler"]),
    // Its front page compares compiled code.
    (
        "tip-sim",
        &["tip-runtime", "tip-compiler", "tip-lint", "tip-macros"],
    ),
    // The debug adapter runs programs, and the language server warns about the reach of robots.
    (
        "tip-ide",
        &["tip-runtime", "tip-compiler", "tip-lint", "tip-sim"],
    ),
    // The editor of a live page asks what every editor asks.
    (
        "tip-view",
        &[
            "tip-runtime",
            "tip-compiler",
            "tip-lint",
            "tip-sim",
            "tip-ide",
        ],
    ),
    (
        "tip-log",
        &["tip-runtime", "tip-compiler", "tip-sim", "tip-view"],
    ),
    // Where there is a file, it reads the bus of a description.
    ("tip-drives", &["tip-runtime", "tip-compiler"]),
    // Its tests compare compiled code.
    (
        "tip-sweep",
        &["tip-runtime", "tip-compiler", "tip-sim", "tip-macros"],
    ),
    (
        "tip-cli",
        &[
            "tip-runtime",
            "tip-compiler",
            "tip-drives",
            "tip-lint",
            "tip-log",
            "tip-sim",
            "tip-ide",
            "tip-sweep",
            "tip-view",
        ],
    ),
];

#[test]
fn dependencies_point_one_way() {
    let published = packages(&["tip-runtime", "tipc", "tip-macros", "tools"]);
    assert_eq!(published.len(), ARROWS.len(), "each crate has its row");
    for package in published {
        let row = ARROWS.iter().find(|(name, _)| *name == package.name);
        let (name, allowed) = row.expect("each crate has its row");
        let ours = |name: &str| ARROWS.iter().any(|(other, _)| *other == name);
        for dependency in package.dependencies.iter().filter(|name| ours(name)) {
            assert!(
                allowed.contains(&dependency.as_str()),
                "{name} -> {dependency}"
            );
        }
    }
}

/// Allowed entries of the root folder.
const ROOT: [&str; 18] = [
    "ARCHITECTURE.md",
    "CHANGELOG.md",
    "CONTRIBUTING.md",
    "Cargo.lock",
    "Cargo.toml",
    "LICENSE",
    "README.ja.md",
    "README.md",
    "SECURITY.md",
    "benches",
    "clippy.toml",
    "docs",
    "editors",
    "examples",
    "site",
    "tests",
    "tip-macros",
    "tip-runtime",
];

#[test]
fn the_root_holds_what_the_architecture_draws() {
    let entries = fs::read_dir(root()).expect("a folder");
    for entry in entries.map(|entry| entry.expect("an entry").file_name()) {
        let name = entry.to_string_lossy();
        let is_known = ROOT.contains(&&*name) || ["tipc", "tools", "target"].contains(&&*name);
        let is_output = [".jsonl", ".csv", ".html"]
            .iter()
            .any(|ending| name.ends_with(ending));
        assert!(is_known || is_output || name.starts_with('.'), "{name}");
    }
}
