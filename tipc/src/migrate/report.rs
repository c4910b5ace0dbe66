//! The report for people and for tools.

use super::{Migration, Note, NoteKind};
use crate::render::{push_member, push_number, push_string};
use std::fmt::Write;

/// Every question with its line, or every change; one sentence at the end.
pub fn render_human(migration: &Migration) -> String {
    let mut out = String::new();
    for note in &migration.notes {
        let source = &migration.source;
        // Writing to a string cannot fail.
        let _ = writeln!(out, "{}", line(migration, note));
        if note.kind == NoteKind::Question {
            let _ = writeln!(out, "    {}", source.line_text(note.line).trim());
        }
    }
    out + &summary(migration)
}

fn summary(migration: &Migration) -> String {
    let name = migration.source.name();
    let (changes, questions) = (migration.changes().count(), migration.questions().count());
    match (changes, questions) {
        (0, 0) => format!("{name}: is a program of version 3.1 already, nothing is changed\n"),
        (_, 0) => format!(
            "{name}: {}, {}\n",
            plural(changes, "change"),
            loads(migration)
        ),
        _ => format!(
            "{name}: {} to answer first, nothing is written\n",
            plural(questions, "question")
        ),
    }
}

fn loads(migration: &Migration) -> String {
    let robots: Vec<&str> = migration
        .robots()
        .iter()
        .map(|robot| robot.name())
        .collect();
    if robots.is_empty() {
        return "loads for no robot yet; `tipc check` on the new program says why".to_owned();
    }
    format!("loads for {}", robots.join(", "))
}

fn plural(count: usize, what: &str) -> String {
    let end = if count == 1 { "" } else { "s" };
    format!("{count} {what}{end}")
}

/// `FILE:LINE:COLUMN: change: <text>` or `…: question: <text>`, one line each.
pub fn render_short(migration: &Migration) -> String {
    let notes = migration.notes.iter();
    notes.map(|note| line(migration, note) + "\n").collect()
}

fn line(migration: &Migration, note: &Note) -> String {
    format!(
        "{}:{}:{}: {}: {}",
        migration.source.name(),
        note.line,
        note.column,
        note.kind.name(),
        note.text
    )
}

/// One object a line: `level` (`change` or `question`), `message`, `file`, `line`, `column`.
pub fn render_json(migration: &Migration) -> String {
    let notes = migration.notes.iter();
    notes.map(|note| object(migration, note) + "\n").collect()
}

fn object(migration: &Migration, note: &Note) -> String {
    let mut out = String::from("{\"level\":");
    push_string(&mut out, note.kind.name());
    push_member(&mut out, "message", &note.text);
    push_member(&mut out, "file", migration.source.name());
    push_number(&mut out, "line", note.line);
    push_number(&mut out, "column", note.column);
    out.push('}');
    out
}
