//! Inputs that the fuzzer of `tests/fuzz` found: each file of its corpora and of its former crashers.

mod damaged;
mod dictionaries;
mod messages;

use std::fs;
use std::path::{Path, PathBuf};

/// The folder of the fuzzer.
fn fuzzer() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Examines every file that is kept for a target.
fn replay(target: &str, examine: fn(&[u8])) {
    for kind in ["corpus", "artifacts"] {
        let folder = fuzzer().join(kind).join(target);
        for entry in fs::read_dir(folder).into_iter().flatten() {
            let path = entry.expect("an entry").path();
            println!("{}", path.display());
            examine(&fs::read(path).expect("a readable file"));
        }
    }
}

macro_rules! targets {
    ($($target:ident)*) => {
        $(
            #[test]
            fn $target() {
                replay(stringify!($target), robustness::$target::examine);
            }
        )*
    };
}

targets! { compile description editing fix format load lsp migrate names requests run scene terminal urdf }
#[cfg(unix)]
targets! { files }
