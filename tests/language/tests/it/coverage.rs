//! Every command in every form on every robot, each with all that can happen to it, has a case that shows it. The cases
//! of `covering.txt`, which every test run compiles, show each of these by itself, and each clause.
#![expect(clippy::disallowed_methods, reason = "cases are files")]
#![allow(unreachable_pub, reason = "nothing of a test can be reached")]

mod cells;
mod command;
mod equation;
mod form;
mod observe;
mod outcome;
mod row;
mod rule;
mod sentence;
mod subset;
mod written;

use std::fs;
use std::sync::LazyLock;
use tip_tests::root;

/// The rows of the table, and the cases that show their cells.
static TABLE: LazyLock<(Vec<row::Row>, observe::Seen)> = LazyLock::new(|| {
    let rows = row::Row::all();
    let seen = observe::Seen::in_cases(&rows);
    (rows, seen)
});

#[test]
fn every_cell_has_a_case() {
    let (rows, seen) = &*TABLE;
    let wrong = cells::wrong(rows, seen);
    assert!(
        wrong.contradictions.is_empty(),
        "cases show what the rules call impossible: {:#?}",
        wrong.contradictions
    );
    assert!(
        wrong.empty.is_empty(),
        "no case shows these: {:#?}",
        wrong.empty
    );
}

#[test]
fn the_compiled_cases_cover_the_language() {
    let (rows, seen) = &*TABLE;
    let shown = subset::shown(rows, seen);
    let path = root().join("covering.txt");
    if std::env::var_os("TIP_BLESS").is_some() {
        fs::write(path, subset::covering(&shown).join("\n") + "\n").unwrap();
        return;
    }
    let listed = fs::read_to_string(path).unwrap_or_default();
    let missing = subset::missing(&shown, &listed);
    assert!(
        missing.is_empty(),
        "TIP_BLESS=1 rewrites covering.txt, which lacks: {missing:#?}"
    );
    let unknown = subset::unknown(&shown, &listed);
    assert!(unknown.is_empty(), "no such cases run: {unknown:?}");
}
