//! Crates outside the workspace, as users have them: without an operating system, with a renamed
//! runtime, and with nothing but the two crates that every user needs.
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
const MACRO_CRATES: usize = 12;

/// A folder of crates beside this one. All nested builds of the tests share a target folder.
struct Outside {
    folder: PathBuf,
    target: PathBuf,
}

impl Outside {
    /// Dependencies get the versions of the workspace's lock file, so that nothing is downloaded.
    fn open(name: &str) -> Self {
        let here = Path::new(env!("CARGO_MANIFEST_DIR"));
        let folder = here.join("../codegen").join(name);
        fs::copy(here.join("../../Cargo.lock"), folder.join("Cargo.lock")).expect("a lock file");
        Outside {
            folder,
            target: Path::new(env!("CARGO_TARGET_TMPDIR")).join("nested"),
        }
    }

    fn cargo(&self, arguments: &str) -> String {
        succeeded(&self.run(arguments), arguments)
    }

    /// Expected error of a build that must fail.
    fn refused(&self, arguments: &str) -> String {
        let output = self.run(arguments);
        let errors = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(!output.status.success(), "{arguments}: {errors}");
        errors
    }

    fn run(&self, arguments: &str) -> Output {
        let cargo = env::var_os("CARGO").expect("cargo runs tests");
        Command::new(cargo)
            .args(arguments.split_whitespace())
            .arg("--offline")
            .current_dir(&self.folder)
            .env("CARGO_TARGET_DIR", &self.target)
            .env("CARGO_PROFILE_DEV_DEBUG", "false")
            .env("CARGO_INCREMENTAL", "0")
            .output()
            .expect("cargo starts")
    }
}

/// Output of the build.
fn succeeded(output: &Output, what: &str) -> String {
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(
        output.status.success(),
        "{what}: {}\n{errors}",
        output.status
    );
    String::from_utf8_lossy(&output.stdout).into_owned()
}

/// Processes without std exist for this machine.
#[cfg(all(
    target_os = "linux",
    any(target_arch = "x86_64", target_arch = "aarch64")
))]
mod without_std {
    use super::*;

    /// Symbols that a program without panics and heap must not have.
    const FORBIDDEN: [&str; 5] = [
        "core9panicking",
        "rust_begin_unwind",
        "unwrap_failed",
        "__rust_alloc",
        "malloc",
    ];

    /// The linked program: the link itself fails if a panic path is left.
    static PROGRAM: LazyLock<PathBuf> = LazyLock::new(|| {
        let outside = Outside::open("no-std");
        outside.cargo("build --release");
        outside.target.join("release/no-std")
    });

    #[test]
    fn a_robot_links_without_std_heap_or_panic_paths() {
        let program = fs::read(&*PROGRAM).expect("a program");
        let holds = |name: &str| program.windows(name.len()).any(|at| at == name.as_bytes());
        assert!(holds("_start"), "its symbols are there to be looked at");
        let found = FORBIDDEN.map(|name| (name, holds(name)));
        assert_eq!(found, FORBIDDEN.map(|name| (name, false)));
    }

    /// Here with std and hardly optimised, there without std and optimised as far as it goes.
    #[test]
    fn a_robot_leaves_the_same_traces_without_std() {
        let output = Command::new(&*PROGRAM).output();
        let without = succeeded(&output.expect("it starts"), "no-std");
        let mut with = String::new();
        assert!(robots::run(&mut robots::walker().unwrap(), &mut with));
        assert!(robots::run(&mut robots::hand().unwrap(), &mut with));
        assert!(robots::run(&mut robots::heavy_walker().unwrap(), &mut with));
        for (without, with) in without.lines().zip(with.lines()) {
            assert_eq!(without, with);
        }
        assert_eq!(without.lines().count(), with.lines().count());
    }
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

/// A macro that is left out without its feature makes rustc itself panic.
#[test]
fn a_described_robot_without_the_feature_is_refused_with_a_hint() {
    let errors = users().refused("check --package minimal --bin robot --features robot");
    let hint = "error: robots from description files need the feature `robot-files` of tip-macros";
    assert!(errors.contains(hint), "{errors}");
    assert!(errors.contains("src/robot.rs:5:1"), "{errors}");
    assert!(!errors.contains("panicked"), "{errors}");
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
