//! What is published of each crate.

use house::{Package, packages, root};
use std::process::Command;
use std::{env, fs};

/// The crates that are published.
fn published() -> Vec<Package> {
    let found = packages(&["tip-runtime", "tipc", "tip-macros", "tools"]);
    assert_eq!(found.len(), 7, "the published crates are found");
    found
}

#[test]
fn each_published_package_holds_its_licences_and_its_front_page() {
    let licence = fs::read_to_string(root().join("LICENSE")).expect("the licence");
    for text in ["MIT License", "Apache License"] {
        assert!(licence.contains(text), "{text}");
    }
    for package in published() {
        let cargo = env::var_os("CARGO").expect("cargo runs tests");
        let output = Command::new(cargo)
            .args(["package", "--list", "--allow-dirty", "--offline"])
            .current_dir(&package.folder)
            .output()
            .expect("cargo starts");
        let list = String::from_utf8_lossy(&output.stdout);
        for file in ["LICENSE", "README.md", "Cargo.toml"] {
            let is_there = list.lines().any(|line| line == file);
            let errors = String::from_utf8_lossy(&output.stderr);
            assert!(is_there, "{}: no {file} in\n{list}{errors}", package.name);
        }
        let own = fs::read_to_string(package.folder.join("LICENSE")).expect("the crate's licence");
        assert!(
            own == licence,
            "{}: LICENSE is not the project's",
            package.name
        );
    }
}
