//! Every diagnostic has its finest code, whatever is wrong with a program.
#![expect(clippy::disallowed_methods, reason = "programs are files")]

use std::fs;
use std::path::{Path, PathBuf};
use tip_lint::{Options, load};
use tipc::code::Mistake;

/// About as many words of a program are left out, doubled or taken for another.
const MAX_VARIANTS: usize = 4;

/// Collects all programs in a folder and the folders in it, in order.
fn programs(folder: &Path, found: &mut Vec<PathBuf>) {
    let entries = fs::read_dir(folder).expect("a folder of programs");
    let mut paths: Vec<PathBuf> = entries
        .map(|entry| entry.expect("an entry").path())
        .collect();
    paths.sort();
    for path in paths {
        if path.is_dir() {
            programs(&path, found);
        } else if path.extension().is_some_and(|end| end == "prg") {
            found.push(path);
        }
    }
}

/// Returns the program with a word left out, doubled, or taken for the next one, for some of its words.
fn variants(text: &str) -> Vec<String> {
    let words: Vec<&str> = text.split_whitespace().skip(2).collect();
    let place = |word: &str| word.as_ptr() as usize - text.as_ptr() as usize;
    let stride = words.len() / MAX_VARIANTS + 1;
    let mut variants = Vec::new();
    for pair in words.windows(2).step_by(stride) {
        let (start, end) = (place(pair[0]), place(pair[0]) + pair[0].len());
        for instead in ["", &format!("{0} {0}", pair[0]), pair[1]] {
            variants.push(format!("{}{instead}{}", &text[..start], &text[end..]));
        }
    }
    variants
}

#[track_caller]
fn check(path: &Path, bytes: &[u8]) {
    for diagnostic in load("codes.prg", bytes, &Options::default()).diagnostics {
        let is_plain = Mistake::of_class(diagnostic.code).next().is_none();
        assert!(
            is_plain || diagnostic.id() != diagnostic.code.id(),
            "{}: {:?} has no finer code:\n{}",
            path.display(),
            diagnostic.reason,
            String::from_utf8_lossy(bytes)
        );
    }
}

#[test]
fn every_diagnostic_of_a_program_or_a_variant_of_it_has_its_finest_code() {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut found = Vec::new();
    programs(&package.join("tests/diagnostics"), &mut found);
    programs(&package.join("../../tests/language/cases"), &mut found);
    for path in &found {
        let bytes = fs::read(path).expect("a program");
        check(path, &bytes);
        if let Ok(text) = std::str::from_utf8(&bytes) {
            variants(text)
                .iter()
                .for_each(|variant| check(path, variant.as_bytes()));
        }
    }
}
