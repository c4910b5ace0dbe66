//! Contents of the published packages.

use conventions::{Package, packages, root, rust_files};
use std::process::Command;
use std::{env, fs};

/// The crates that are published.
fn published() -> Vec<Package> {
    let found = packages(&["tip-runtime", "tipc", "tip-macros", "tools"]);
    assert_eq!(found.len(), 11, "the published crates are found");
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

/// PyPI would take a wheel of an old version for one that it has.
#[test]
fn the_python_package_has_the_version_of_the_crates() {
    let manifest = root().join("tools/python/native/Cargo.toml");
    let manifest = fs::read_to_string(manifest).expect("a manifest");
    let version = format!("\nversion = \"{}\"\n", env!("CARGO_PKG_VERSION"));
    assert!(manifest.contains(&version), "not{version}");
}

/// docs.rs shows every feature, each item with the feature that it needs.
#[test]
fn each_published_package_is_documented_with_all_features() {
    for package in published() {
        let manifest = fs::read_to_string(package.folder.join("Cargo.toml")).expect("a manifest");
        assert!(
            manifest.contains("\n[package.metadata.docs.rs]\nall-features = true\n"),
            "{}",
            package.name
        );
        if let Ok(library) = fs::read_to_string(package.folder.join("src/lib.rs")) {
            assert!(
                library.contains("\n#![cfg_attr(docsrs, feature(doc_cfg))]\n"),
                "{}",
                package.name
            );
        }
    }
}

/// The page of the playground gives its module a clock and nothing else; bindings of browsers would import more. Logs and plots
/// are for the command.
#[test]
fn the_playground_has_no_bindings_of_browsers_and_no_logs() {
    let cargo = env::var_os("CARGO").expect("cargo runs tests");
    let output = Command::new(cargo)
        .args(["tree", "--locked", "--package", "tip-playground"])
        .args(["--target", "wasm32-unknown-unknown"])
        .args(["--edges", "normal", "--prefix", "none"])
        .current_dir(root())
        .output()
        .expect("cargo starts");
    let tree = String::from_utf8_lossy(&output.stdout);
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(tree.contains("tip-view v"), "{tree}{errors}");
    for name in ["wasm-bindgen", "js-sys", "web-sys", "tip-log"] {
        assert!(
            !tree.contains(name),
            "the playground depends on {name}:\n{tree}"
        );
    }
}

#[test]
fn no_source_includes_what_is_outside_of_its_package() {
    let mut climbing = 0;
    for package in published() {
        for file in rust_files(&package.folder.join("src")) {
            let text = fs::read_to_string(&file).expect("a source");
            let inside = file.strip_prefix(&package.folder).expect("a package's");
            let depth = inside.components().count() - 1;
            for path in included(&text) {
                let up = path.matches("../").count();
                let name = inside.display();
                assert!(up <= depth, "{}: {name} includes {path}", package.name);
                climbing += up.min(1);
            }
        }
    }
    assert!(climbing > 10, "{climbing} paths lead out of their folders");
}

/// The paths that `include_str!` and `include_bytes!` name in a source, up to what a macro fills in.
fn included(text: &str) -> impl Iterator<Item = &str> {
    let macros = ["include_str!(", "include_bytes!("];
    let after = macros.into_iter().flat_map(|name| text.split(name).skip(1));
    after.filter_map(|rest| {
        let path = rest.trim_start_matches("concat!(").strip_prefix('"')?;
        path.split('"').next()
    })
}

#[test]
fn included_paths_are_found() {
    let text = r#"include_str!("../a") include_bytes!(concat!("../../b/", $n)) include_str!(c)"#;
    assert_eq!(included(text).collect::<Vec<_>>(), ["../a", "../../b/"]);
}
