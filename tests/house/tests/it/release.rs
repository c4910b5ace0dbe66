//! The scripts that pack and publish, run with tools that only look like it.

use house::root;
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::{env, fs};

const HOST: &str = "here-none-linux";

/// A folder of tools for one test.
struct Tools(PathBuf);

impl Tools {
    fn new(name: &str) -> Self {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(folder.join("bin")).expect("the target folder is writable");
        Tools(folder)
    }

    fn with(self, name: &str, script: &str) -> Self {
        let path = self.0.join("bin").join(name);
        fs::write(&path, format!("#!/bin/sh\n{script}\n")).expect("a script");
        fs::set_permissions(&path, fs::Permissions::from_mode(0o755)).expect("it is ours");
        self
    }

    /// Runs a script with these tools before those of `path`.
    fn run(&self, script: &str, argument: &Path, path: &str) -> Output {
        Command::new("/bin/bash")
            .arg(root().join(script))
            .arg(argument)
            .env("PATH", format!("{}:{path}", self.0.join("bin").display()))
            .output()
            .expect("bash starts")
    }
}

fn version() -> String {
    let text = fs::read_to_string(root().join("Cargo.toml")).expect("the workspace");
    let manifest: toml::Table = text.parse().expect("manifests are TOML");
    let version = &manifest["workspace"]["package"]["version"];
    version.as_str().expect("a text").to_owned()
}

/// What cargo-binstall makes of a template.
fn filled(template: &str) -> String {
    let values = [
        ("{ repo }", ""),
        ("{ version }", &version()),
        ("{ target }", HOST),
        ("{ bin }", "tipc"),
        ("{ binary-ext }", ""),
    ];
    let filled = values
        .iter()
        .fold(template.to_owned(), |text, (name, value)| {
            text.replace(name, value)
        });
    assert!(!filled.contains('{'), "{filled}");
    filled
}

#[test]
fn a_release_is_where_binstall_looks_and_the_same_each_time() {
    let path = env::var("PATH").unwrap_or_default();
    let build = format!(
        "mkdir -p \"$CARGO_TARGET_DIR/release\" && cd \"$CARGO_TARGET_DIR/release\" || exit 1\n\
         printf '#!/bin/sh\\necho tipc {}\\n' >tipc && chmod +x tipc",
        version()
    );
    let tools = Tools::new("release")
        .with("rustc", &format!("echo host: {HOST}"))
        .with("cargo", &build);
    let packed = |folder: &str| {
        let folder = tools.0.join(folder);
        let output = tools.run(".ci/release", &folder, &path);
        assert!(output.status.success(), "{output:?}");
        folder
    };

    let manifest =
        fs::read_to_string(root().join("tools/cli/Cargo.toml")).expect("the command's manifest");
    let manifest: toml::Table = manifest.parse().expect("manifests are TOML");
    let metadata = &manifest["package"]["metadata"]["binstall"];
    let said = |key: &str| filled(metadata[key].as_str().expect("a text"));
    let address = said("pkg-url");
    let archive = address.rsplit('/').next().expect("a name");

    let [first, second] = ["first", "second folder"].map(packed);
    let bytes = |folder: &Path| fs::read(folder.join(archive)).expect("the archive is there");
    assert!(bytes(&first) == bytes(&second), "the archives differ");

    let list = Command::new("tar")
        .arg("-tzf")
        .arg(first.join(archive))
        .output()
        .expect("tar starts");
    let list = String::from_utf8_lossy(&list.stdout).into_owned();
    let binary = said("bin-dir");
    let beside = |name: &str| binary.replace("/tipc", &format!("/{name}"));
    for file in [
        binary.clone(),
        beside("LICENSE"),
        beside("README.md"),
        beside("CHANGELOG.md"),
    ] {
        assert!(
            list.lines().any(|line| line == file),
            "no {file} in\n{list}"
        );
    }

    let sum = Command::new("sha256sum")
        .arg("-c")
        .arg(format!("{archive}.sha256"))
        .current_dir(&first)
        .output();
    assert!(sum.expect("sha256sum starts").status.success());
}

#[test]
fn what_is_missing_is_said() {
    let none = Tools::new("none");
    let refused = |tools: &Tools, script: &str, words: &str| {
        let output = tools.run(script, Path::new("unused"), "");
        assert_eq!(output.status.code(), Some(1), "{script}: {output:?}");
        let errors = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(errors.trim(), words, "{script}");
    };
    refused(&none, ".ci/release", "cargo is not installed");
    refused(&none, ".ci/publish-dry-run", "cargo is not installed");
    let old = Tools::new("old").with("cargo", "echo cargo 1.89.0 '(c24e10642 2025-06-23)'");
    refused(&old, ".ci/release", "rustc is not installed");
    refused(
        &old,
        ".ci/publish-dry-run",
        "cargo is older than 1.90, which is the first to publish crates that depend on each other in one go",
    );
}

#[test]
fn a_version_that_the_registry_has_is_no_success() {
    let path = env::var("PATH").unwrap_or_default();
    let published = |name: &str, says: &str| {
        let script = format!(
            "case $1 in --version) echo cargo 1.90.0 ;; *) echo '   Uploading tip-runtime v0.1.0 (here)'; {says} ;; esac"
        );
        let tools = Tools::new(name).with("cargo", &script);
        tools.run(".ci/publish-dry-run", Path::new("--offline"), &path)
    };
    let free = published("free", ":");
    assert!(free.status.success(), "{free:?}");
    let order = String::from_utf8_lossy(&free.stdout).into_owned();
    assert!(
        order.ends_with("the order would be:\n  tip-runtime v0.1.0\n"),
        "{order}"
    );

    let taken = published(
        "taken",
        "echo 'warning: crate tipc@0.1.0 already exists on crates.io index' >&2",
    );
    assert_eq!(taken.status.code(), Some(1), "{taken:?}");
    assert!(
        String::from_utf8_lossy(&taken.stderr).ends_with("\n  tipc@0.1.0\n"),
        "{taken:?}"
    );
}
