//! Crates outside the workspace, as users have them: without an operating system, with a renamed
//! run-time, and with nothing but the two crates that every user needs.
#![allow(
    clippy::disallowed_methods,
    reason = "the test prepares folders for cargo"
)]

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::{LazyLock, Mutex, MutexGuard, PoisonError};
use std::{env, fs};

/// The most crates that a user's proc macro may cost, tip-macros itself included, with the versions of the lock file;
/// encoding_rs 0.8.44 brings five more.
const MACRO_CRATES: usize = 11;

/// A folder of crates beside this one, with a target folder of its own.
struct Outside {
    folder: PathBuf,
    target: PathBuf,
}

impl Outside {
    /// Dependencies get the versions of the workspace's lock file, so that nothing is downloaded.
    fn open(name: &str) -> Self {
        let here = Path::new(env!("CARGO_MANIFEST_DIR"));
        let folder = here.join(name);
        fs::copy(here.join("../Cargo.lock"), folder.join("Cargo.lock")).expect("a lock file");
        Outside {
            folder,
            target: Path::new(env!("CARGO_TARGET_TMPDIR")).join(name),
        }
    }

    fn cargo(&self, arguments: &str) -> String {
        let cargo = env::var_os("CARGO").expect("cargo runs tests");
        let output = Command::new(cargo)
            .args(arguments.split_whitespace())
            .arg("--offline")
            .current_dir(&self.folder)
            .env("CARGO_TARGET_DIR", &self.target)
            .output()
            .expect("cargo starts");
        succeeded(&output, arguments)
    }
}

/// What it printed.
fn succeeded(output: &Output, what: &str) -> String {
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(
        output.status.success(),
        "{what}: {}\n{errors}",
        output.status
    );
    String::from_utf8_lossy(&output.stdout).into_owned()
}

#[test]
#[cfg(all(
    target_os = "linux",
    any(target_arch = "x86_64", target_arch = "aarch64")
))]
fn a_program_and_its_robot_run_without_std_heap_or_panic_paths() {
    let outside = Outside::open("no-std");
    outside.cargo("build --release");
    let program = Command::new(outside.target.join("release/no-std")).output();
    succeeded(&program.expect("it starts"), "no-std");
}

/// The user crates, one cargo at a time: each rewrites the lock file.
fn users() -> MutexGuard<'static, Outside> {
    static USERS: LazyLock<Mutex<Outside>> = LazyLock::new(|| Mutex::new(Outside::open("renamed")));
    USERS.lock().unwrap_or_else(PoisonError::into_inner)
}

#[test]
fn a_renamed_runtime_serves_every_form_of_program() {
    users().cargo("run --quiet --package renamed");
}

#[test]
fn the_smallest_controller_runs() {
    users().cargo("run --quiet --package minimal");
}

#[test]
fn the_macro_side_of_a_users_crate_is_small_and_free_of_the_robot() {
    let tree =
        users().cargo("tree --package tip-macros --edges normal,build --prefix none --format {p}");
    let crates: BTreeSet<&str> = tree
        .lines()
        .filter_map(|line| line.split(' ').next())
        .collect();
    assert!(crates.contains("tip-runtime"), "{crates:?}");
    assert!(crates.len() <= MACRO_CRATES, "{} {crates:?}", crates.len());
    for heavy in ["nalgebra", "clap", "prettyplease", "serde_json"] {
        assert!(!crates.contains(heavy), "{heavy} in {crates:?}");
    }
}
