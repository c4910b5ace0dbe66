//! Names of crates that cargo and Rust accept without a warning.

use crate::message::Using;
use crate::usage::BadValue;
use std::path::{Path, PathBuf};
use std::str::FromStr;

/// Maximum length of a name in registries.
const LONGEST: usize = 64;

/// Names that mean something else: to Rust, to cargo, to Windows, or in the crate that is made.
const TAKEN: &[&str] = &[
    // Keywords, also those that are kept for later.
    "abstract",
    "as",
    "async",
    "await",
    "become",
    "box",
    "break",
    "const",
    "continue",
    "crate",
    "do",
    "dyn",
    "else",
    "enum",
    "extern",
    "false",
    "final",
    "fn",
    "for",
    "gen",
    "if",
    "impl",
    "in",
    "let",
    "loop",
    "macro",
    "match",
    "mod",
    "move",
    "mut",
    "override",
    "priv",
    "pub",
    "ref",
    "return",
    "self",
    "static",
    "struct",
    "super",
    "trait",
    "true",
    "try",
    "type",
    "typeof",
    "unsafe",
    "unsized",
    "use",
    "virtual",
    "where",
    "while",
    "yield",
    // Crates that every build has.
    "alloc",
    "core",
    "proc-macro",
    "proc_macro",
    "std",
    "test",
    // Folders that cargo writes next to an executable.
    "build",
    "deps",
    "examples",
    "incremental",
    // Devices of Windows.
    "aux",
    "com1",
    "com2",
    "com3",
    "com4",
    "com5",
    "com6",
    "com7",
    "com8",
    "com9",
    "con",
    "lpt1",
    "lpt2",
    "lpt3",
    "lpt4",
    "lpt5",
    "lpt6",
    "lpt7",
    "lpt8",
    "lpt9",
    "nul",
    "prn",
    // What the crate depends on, and its other executable.
    "drive",
    "tip-macros",
    "tip-runtime",
    "tip-sim",
    "tip_macros",
    "tip_runtime",
    "tip_sim",
    "tipc",
];

/// The name and the folder of a new crate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct CratePath {
    folder: PathBuf,
    name: String,
}

impl CratePath {
    /// Returns the folder, which has the name of the crate.
    pub(super) fn folder(&self) -> &Path {
        &self.folder
    }

    /// Returns the name.
    pub(super) fn name(&self) -> &str {
        &self.name
    }

    /// Returns the name in Rust code.
    pub(super) fn crate_name(&self) -> String {
        self.name.replace('-', "_")
    }
}

impl FromStr for CratePath {
    type Err = BadValue;

    fn from_str(text: &str) -> Result<Self, BadValue> {
        let folder = PathBuf::from(text);
        let name = folder.file_name().unwrap_or_default();
        let name = name.to_string_lossy().into_owned();
        if !is_plain(&name) {
            let near = near(&name);
            return Err(BadValue(Using::NotACrateName { name, near }));
        }
        if TAKEN.contains(&&*name) {
            let near = near(&name);
            return Err(BadValue(Using::CrateNameTaken { name, near }));
        }
        Ok(CratePath { folder, name })
    }
}

/// Returns true for small letters and digits with single `-` or `_` between them, a letter first: cargo or registries refuse other
/// names, or the compiler warns of them.
fn is_plain(name: &str) -> bool {
    let is_word = |word: &str| {
        !word.is_empty()
            && word
                .bytes()
                .all(|b| b.is_ascii_lowercase() || b.is_ascii_digit())
    };
    name.starts_with(|first: char| first.is_ascii_lowercase())
        && name.len() <= LONGEST
        && name.split(['-', '_']).all(is_word)
}

/// Returns a similar name that is accepted.
fn near(name: &str) -> String {
    let small = name.to_lowercase();
    let words = small.split(|c: char| !c.is_ascii_alphanumeric());
    let words: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
    let near: String = words.join("-").chars().take(LONGEST / 2).collect();
    let near = near.trim_end_matches('-');
    match near.chars().next() {
        None => "demo".to_owned(),
        Some(first) if first.is_ascii_digit() || TAKEN.contains(&near) => format!("my-{near}"),
        Some(_) => near.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_cargo_and_rust_take_are_taken() {
        let longest = "a".repeat(LONGEST);
        for name in [
            "demo",
            "first-walk",
            "walk_2",
            "a",
            "x86",
            "tests",
            "new",
            "testing",
            "move-it",
            "r2d2",
            "com10",
            "tip",
            "main",
            "hardware",
            &longest,
        ] {
            let place: CratePath = name.parse().expect(name);
            assert_eq!((place.name(), place.folder()), (name, Path::new(name)));
        }
        let place: CratePath = "robots/first-walk/".parse().expect("a folder");
        assert_eq!(place.name(), "first-walk");
        assert_eq!(place.crate_name(), "first_walk");
    }

    #[test]
    fn other_names_are_refused_with_one_that_is_taken() {
        let too_long = "a".repeat(LONGEST + 1);
        for (name, better) in [
            ("", "demo"),
            (".", "demo"),
            ("..", "demo"),
            ("歩く", "demo"),
            ("2fast", "my-2fast"),
            ("Demo", "demo"),
            ("first walk", "first-walk"),
            ("first.walk", "first-walk"),
            ("first--walk", "first-walk"),
            ("_demo", "demo"),
            ("demo-", "demo"),
            ("wälk", "w-lk"),
            ("match", "my-match"),
            ("test", "my-test"),
            ("Test", "my-test"),
            ("std", "my-std"),
            ("deps", "my-deps"),
            ("nul", "my-nul"),
            ("tip-runtime", "my-tip-runtime"),
            ("tip_runtime", "my-tip_runtime"),
            (&too_long, &"a".repeat(LONGEST / 2)),
        ] {
            let refused = name.parse::<CratePath>().expect_err(name);
            let (Using::NotACrateName { near, .. } | Using::CrateNameTaken { near, .. }) =
                refused.0
            else {
                panic!("{name}: {refused}");
            };
            assert_eq!(near, better.replace('_', "-"), "{name}");
            near.parse::<CratePath>().expect("it is taken");
        }
    }
}
