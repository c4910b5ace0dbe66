//! What the fuzzer of the folder `fuzz` found, tried again: each file of its corpora and of its former crashers.
#![expect(
    clippy::disallowed_methods,
    reason = "corpora and dictionaries are files"
)]

mod damaged;
mod dictionaries;
#[path = "../random/mod.rs"]
mod random;
#[allow(unreachable_pub, reason = "they are shared with the fuzzer")]
mod targets;

use std::fs;
use std::path::{Path, PathBuf};

/// The folder of the fuzzer; the package alone has none.
fn fuzzer() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../fuzz")
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
                replay(stringify!($target), targets::$target::examine);
            }
        )*
    };
}

targets! { compile description load migrate run scene urdf }
