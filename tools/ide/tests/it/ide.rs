//! The features of documents. `$0` is the cursor; programs begin with their third line.

mod complete;
mod edit;
mod hover;
mod navigate;
mod show;

use tip_ide::{Document, Edit};
use tipc::{Options, Robot};

/// A program for a robot, and the cursor in it.
#[track_caller]
fn on(robot: Robot, statements: &str) -> (Document, usize) {
    let text = format!("3.1\nTitle\n{statements}");
    let at = text.find("$0").expect("a cursor");
    let text = text.replacen("$0", "", 1);
    let options = Options {
        robot,
        ..Options::default()
    };
    (Document::new("test.prg", &text, &options), at)
}

#[track_caller]
fn cursor(statements: &str) -> (Document, usize) {
    on(Robot::Titan8, statements)
}

/// The statements after a change.
#[track_caller]
fn changed(document: &Document, edits: &[Edit]) -> String {
    let text = document.source().text();
    let mut out = String::new();
    let mut at = 0;
    for edit in edits {
        assert!(
            at <= edit.span.start && edit.span.start <= edit.span.end,
            "{edits:?}"
        );
        out += &text[at..edit.span.start];
        out += &edit.text;
        at = edit.span.end;
    }
    out += &text[at..];
    out.strip_prefix("3.1\nTitle\n")
        .expect("they stay")
        .to_owned()
}
