//! Dependencies of the packages of the workspace.

use crate::tree::root;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// A package of the workspace.
#[derive(Clone, Debug)]
pub struct Package {
    /// Its name.
    pub name: String,
    /// Its folder.
    pub folder: PathBuf,
    /// The names of what it depends on: to run, to build, and to be tested.
    pub dependencies: BTreeSet<String>,
}

/// The packages in these folders of the root, or in the folders right below them.
///
/// # Panics
/// A manifest cannot be read.
pub fn packages(folders: &[&str]) -> Vec<Package> {
    let mut found = Vec::new();
    for folder in folders {
        let folder = root().join(folder);
        found.extend(package(&folder));
        let entries = fs::read_dir(&folder).into_iter().flatten().flatten();
        found.extend(entries.filter_map(|entry| package(&entry.path())));
    }
    found
}

fn package(folder: &Path) -> Option<Package> {
    let text = fs::read_to_string(folder.join("Cargo.toml")).ok()?;
    let manifest: toml::Table = text.parse().expect("manifests are TOML");
    let name = manifest.get("package")?.get("name")?.as_str()?;
    let mut dependencies = BTreeSet::new();
    collect(&manifest, &mut dependencies);
    for target in tables(&manifest, "target").flat_map(toml::Table::values) {
        collect(target.as_table()?, &mut dependencies);
    }
    Some(Package {
        name: name.to_owned(),
        folder: folder.to_owned(),
        dependencies,
    })
}

fn collect(manifest: &toml::Table, found: &mut BTreeSet<String>) {
    for kind in ["dependencies", "build-dependencies", "dev-dependencies"] {
        found.extend(tables(manifest, kind).flat_map(toml::Table::keys).cloned());
    }
}

fn tables<'t>(manifest: &'t toml::Table, name: &str) -> impl Iterator<Item = &'t toml::Table> {
    manifest
        .get(name)
        .and_then(toml::Value::as_table)
        .into_iter()
}
