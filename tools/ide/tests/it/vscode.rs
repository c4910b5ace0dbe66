//! The files in `editors/vscode` that are made from the tables of the language: the grammar, the snippets, and how the
//! editor types. `TIP_BLESS=1` rewrites them.

mod configuration;
mod grammar;
mod rule;
mod snippets;

use serde::Serialize;
use std::path::{Path, PathBuf};
use std::{env, fs};

#[test]
fn the_grammar_is_that_of_the_tables() {
    hold("syntaxes/tip.tmLanguage.json", &grammar::grammar());
}

#[test]
fn the_snippets_are_those_of_the_tables() {
    hold("snippets/tip.json", &snippets::snippets());
}

#[test]
fn the_configuration_is_that_of_the_tables() {
    hold(
        "language-configuration.json",
        &configuration::configuration(),
    );
}

#[test]
fn the_extension_has_the_version_and_the_licence_of_the_crates() {
    let manifest = fs::read(extension().join("package.json")).expect("the manifest");
    let manifest: serde_json::Value = serde_json::from_slice(&manifest).expect("JSON");
    assert_eq!(manifest["version"], env!("CARGO_PKG_VERSION"));
    let licence = |folder: &Path| fs::read_to_string(folder.join("LICENSE")).expect("a licence");
    let own = Path::new(env!("CARGO_MANIFEST_DIR"));
    assert!(licence(&extension()) == licence(own));
}

fn extension() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../editors/vscode")
}

/// The file is what it should be, or becomes so.
#[track_caller]
fn hold(path: &str, content: &impl Serialize) {
    let path = extension().join(path);
    let mut fresh = serde_json::to_string_pretty(content).expect("it has no odd keys");
    fresh.push('\n');
    let text = fs::read_to_string(&path).unwrap_or_default();
    if text == fresh {
        return;
    }
    if env::var_os("TIP_BLESS").is_some() {
        fs::write(&path, fresh).expect("the file can be written");
        return;
    }
    let mut pairs = text.lines().zip(fresh.lines());
    let differing = pairs.find(|(old, new)| old != new);
    let path = path.display();
    panic!("{path} is out of date, set TIP_BLESS=1 to rewrite it: {differing:#?}");
}
