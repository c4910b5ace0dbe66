//! Fixes: each leads to what was meant, breaks nothing, and leaves the rest of its file as it is.

mod certain;
mod every;
mod kept;
mod likely;
mod warnings;

use tip_lint::load;
use tip_lint::repair::{Repaired, repair};
use tipc::diagnostic::Applicability::{self, Certain, Likely};
use tipc::{Loaded, Options};

fn loaded(bytes: &[u8]) -> Loaded {
    load("fixes.prg", bytes, &Options::default())
}

fn repaired(bytes: &[u8], least: Applicability) -> Repaired {
    repair(loaded(bytes), &Options::default(), least)
}

/// Returns some statements after their fixes.
fn fixed(statements: &str, least: Applicability) -> String {
    let text = format!("3.1\ntitle\n{statements}\nEND\n");
    let repaired = repaired(text.as_bytes(), least);
    let text = repaired.loaded.source.text();
    let text = text.strip_prefix("3.1\ntitle\n").unwrap_or(text);
    text.strip_suffix("\nEND\n").unwrap_or(text).to_owned()
}

/// Checks statements after certain fixes; likely ones do nothing to that.
#[track_caller]
fn check_certain(before: &str, after: &str) {
    assert_eq!(fixed(before, Certain), after, "{before}");
    assert_eq!(fixed(before, Likely), after, "{before}: likely");
}

/// Checks statements after likely fixes, and that certain ones do nothing.
#[track_caller]
fn check_likely(before: &str, after: &str) {
    assert_eq!(fixed(before, Certain), before, "{before}: certain");
    assert_eq!(fixed(before, Likely), after, "{before}");
}

/// Checks that nothing is done to statements.
#[track_caller]
fn check_kept(before: &str) {
    assert_eq!(fixed(before, Likely), before, "{before}");
}
