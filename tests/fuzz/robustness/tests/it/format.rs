//! Every program here and many random ones: formatted they are in the style, and the same programs. `TIP_PROGRAMS=100000`
//! before a run in release mode takes so many random ones.

use random_programs::{Edition, Specimen, program, untidy};
use robustness::format::{for_some_robot, formatted};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::{env, fs};
use tip_lint::listing;
use tip_runtime::random::Random;
use tipc::source::Encoding;
use tipc::{Options, load};

/// Default number of random programs.
const PROGRAMS: u64 = 300;

/// The programs in a folder and below it.
fn programs(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        let is_built = path.ends_with("target") || path.ends_with("work");
        if path.is_dir() && !is_built {
            programs(&path, found);
        } else if path.extension().is_some_and(|end| end == "prg") {
            found.push(path);
        }
    }
}

#[test]
fn every_program_of_the_project_stays_the_same() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../..");
    let mut found = Vec::new();
    for folder in ["benches", "docs", "examples", "tests", "tip-macros", "tipc"] {
        programs(&root.join(folder), &mut found);
    }
    assert!(found.len() > 1200, "{} programs", found.len());
    let is_formatted = |path: &PathBuf| {
        let bytes = fs::read(path).expect("a readable file");
        for_some_robot(&bytes, Encoding::Auto).is_some()
    };
    let formatted = found.iter().filter(|path| is_formatted(path)).count();
    assert!(formatted > 800, "{formatted} programs load");
}

/// Checks that programs which people copy are in the style.
#[test]
fn the_examples_are_formatted() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../..");
    let mut found = Vec::new();
    for folder in ["benches", "examples", "tip-macros"] {
        programs(&root.join(folder), &mut found);
    }
    assert!(found.len() > 8, "{found:?}");
    for path in found {
        let bytes = fs::read(&path).expect("a readable file");
        // A program for a described robot loads for none of those that have a name.
        if let Some(formatted) = for_some_robot(&bytes, Encoding::Auto) {
            assert!(formatted == bytes, "tip fmt {}", path.display());
        }
    }
}

/// Random programs.
fn seeds() -> Range<u64> {
    let asked = env::var("TIP_PROGRAMS").ok();
    0..asked.map_or(PROGRAMS, |count| count.parse().expect("a number"))
}

/// The random program of a seed, of each edition in turn.
fn specimen(seed: u64) -> Specimen {
    let editions = Edition::ALL;
    program(editions[seed as usize % editions.len()], seed)
}

/// Bytes that mean something to someone who reads a program.
const BYTES: &[u8] = b" \t,;:/-+*=<>!%.\r\n\x1A\0\\R1E\x81\xE3";

#[test]
fn damaged_programs_stay_the_same_or_are_left() {
    for seed in seeds() {
        let mut bytes = untidy(&specimen(seed));
        let mut random = Random::new(seed);
        for _ in 0..=random.index(3) {
            let at = random.index(bytes.len());
            let byte = BYTES[random.index(BYTES.len())];
            match random.index(3) {
                0 => bytes[at] = byte,
                1 => drop(bytes.remove(at)),
                _ => bytes.insert(at, byte),
            }
        }
        for_some_robot(&bytes, Encoding::Auto);
    }
}

#[test]
fn random_programs_stay_the_same_however_they_are_written() {
    for seed in seeds() {
        let specimen = specimen(seed);
        let options = Options {
            robot: specimen.robot,
            ..Options::default()
        };
        let formal = |bytes: &[u8]| {
            let loaded = load("random.prg", bytes, &options);
            assert!(loaded.program.is_some(), "{seed}: {:?}", loaded.diagnostics);
            listing::formal(&loaded.source, &loaded.module)
        };
        let expected = formal(specimen.source.as_bytes());
        for bytes in [specimen.source.as_bytes(), &untidy(&specimen)] {
            let formatted = formatted(bytes, &options).unwrap_or_else(|| panic!("{seed}"));
            assert_eq!(formal(&formatted), expected, "{seed}");
        }
    }
}
