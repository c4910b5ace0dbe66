//! Compiles a slice of the random programs to Rust, for the tests to run.
#![expect(
    clippy::disallowed_methods,
    reason = "a build script writes files and talks to Cargo"
)]
#![allow(clippy::disallowed_macros, reason = "a build script talks to Cargo")]

use random_programs::{Edition, program, rust};
use std::path::Path;
use std::{env, fs};

/// Number of programs of each edition that every test run compiles.
const SLICE: u64 = 50;
/// Number of programs of each edition with `TIP_ALL_PROGRAMS=1`.
const ALL: u64 = 150;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-env-changed=TIP_ALL_PROGRAMS");
    let is_all = env::var_os("TIP_ALL_PROGRAMS").is_some();
    let seeds = if is_all { ALL } else { SLICE };
    let of_edition = |edition: &Edition| {
        let edition = *edition;
        (0..seeds).map(move |seed| program(edition, seed))
    };
    let specimens: Vec<_> = Edition::ALL.iter().flat_map(of_edition).collect();
    let text = rust(&specimens, |code| code).unwrap_or_else(|error| panic!("{error}"));
    let out = env::var("OUT_DIR").expect("Cargo sets it");
    fs::write(Path::new(&out).join("random.rs"), text).expect("the output folder is writable");
}
