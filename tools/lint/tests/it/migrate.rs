//! Programs of older versions become programs of version 3.1.

mod cases;
mod encodings;
mod questions;
mod random;
mod rules;

use tip_lint::migrate::{Migration, Note, migrate};
use tipc::source::Encoding;

/// Migrates a text.
fn migrated(text: &str) -> Migration {
    migrate("old.prg", text.as_bytes(), Encoding::Auto).expect("this is text")
}

/// Returns the new program.
fn result(text: &str) -> String {
    let migration = migrated(text);
    let open: Vec<&Note> = migration.questions().collect();
    let bytes = migration.bytes();
    let bytes = bytes.unwrap_or_else(|| panic!("questions about {text:?}: {open:#?}"));
    String::from_utf8(bytes.to_vec()).expect("the encoding is kept")
}

/// Returns a line of a program of `version` after migration, without the declarations.
fn line_of(version: &str, line: &str) -> String {
    let new = result(&format!("{version}\ntitle\n{line}\nEND\n"));
    let lines = new.lines().filter(|line| !line.starts_with("DEF_"));
    let lines: Vec<&str> = lines.collect();
    let ["3.1", "title", line, "END"] = lines[..] else {
        panic!("{new}");
    };
    line.to_owned()
}

/// Checks what each line of version 2.0 becomes.
fn check_lines(lines: &[(&str, &str)]) {
    for (old, new) in lines {
        assert_eq!(line_of("2.0", old), *new, "{old}");
    }
}

/// Returns the only question about a program: its line and text.
fn question(text: &str) -> (u32, String) {
    let migration = migrated(text);
    assert_eq!(migration.bytes(), None, "{text:?} is decided");
    let questions: Vec<&Note> = migration.questions().collect();
    let [question] = questions[..] else {
        panic!("{questions:#?}");
    };
    (question.line, question.text.to_string())
}
