//! Every command in every form on every robot, each with all that can happen to it, and the case that shows it:
//! `docs/coverage.md` is generated here.
#![expect(
    clippy::disallowed_methods,
    reason = "the table is a file, made of files"
)]
#![allow(unreachable_pub, reason = "nothing of a test can be reached")]

mod command;
mod document;
mod equation;
mod form;
mod observe;
mod outcome;
mod row;
mod rule;
mod sentence;
mod why;
mod written;

use std::fs;
use tip_tests::root;

#[test]
fn the_table_is_complete_and_up_to_date() {
    let rows = row::Row::all();
    let seen = observe::Seen::in_cases(&rows);
    let (text, count) = document::document(&rows, &seen);
    assert!(
        count.contradictions.is_empty(),
        "cases show what the rules call impossible: {:#?}",
        count.contradictions
    );
    assert!(
        count.empty.is_empty(),
        "no case shows these: {:#?}",
        count.empty
    );
    let path = root().join("../docs/coverage.md");
    if std::env::var_os("TIP_BLESS").is_some() {
        fs::write(path, text).unwrap();
        return;
    }
    let page = fs::read_to_string(path).unwrap_or_default();
    assert!(
        page == text,
        "docs/coverage.md differs; TIP_BLESS=1 rewrites it"
    );
}
