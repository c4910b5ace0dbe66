//! The report for people and for tools.

use super::{Migration, Note, NoteKind};
use crate::message::Loads;
use crate::message::Migrating;
use std::fmt::Write;
use tip_runtime::printable::Printable;
use tipc::language::Edition;
use tipc::message::Lang;
use tipc::message::list::List;
use tipc::parse::header::{version_number, version_word};
use tipc::render::{push_member, push_number, push_string};

/// Returns every question with its line, or every change; one sentence at the end.
pub fn render_human(migration: &Migration, lang: Lang) -> String {
    let mut out = String::new();
    for note in &migration.notes {
        let source = &migration.source;
        // Writing to a string cannot fail.
        let _ = writeln!(out, "{}", line(migration, note, lang));
        if note.kind == NoteKind::Question {
            let text = source.line_text(note.line).trim();
            let _ = writeln!(out, "    {}", Printable::line(text));
        }
    }
    let _ = writeln!(out, "{}", Printable::line(summary(migration).in_lang(lang)));
    out
}

fn summary(migration: &Migration) -> Migrating {
    let file = migration.source.name().to_owned().into();
    let (changes, questions) = (migration.changes().count(), migration.questions().count());
    match (changes, questions) {
        (0, 0) => {
            let source = &migration.source;
            let version = version_number(source.slice(version_word(source)));
            let version = Edition::of(version.unwrap_or_default());
            Migrating::AlreadyCurrent { file, version }
        }
        (_, 0) => Migrating::Migrated {
            file,
            changes: changes.into(),
            loads: loads(migration),
        },
        _ => Migrating::ToAnswer {
            file,
            questions: questions.into(),
        },
    }
}

fn loads(migration: &Migration) -> Loads {
    let robots = migration.robots();
    let robots: Vec<String> = robots.iter().map(|robot| robot.name().to_owned()).collect();
    match robots.is_empty() {
        true => Loads::ForNone,
        false => Loads::For {
            robots: List(robots),
        },
    }
}

/// `FILE:LINE:COLUMN: change: <text>` or `…: question: <text>`, one line each.
pub fn render_short(migration: &Migration, lang: Lang) -> String {
    let notes = migration.notes.iter();
    notes
        .map(|note| line(migration, note, lang) + "\n")
        .collect()
}

fn line(migration: &Migration, note: &Note, lang: Lang) -> String {
    let name = migration.source.name();
    let (line, column, kind) = (note.line, note.column, note.kind.name());
    let text = note.text.in_lang(lang);
    Printable::line(format_args!("{name}:{line}:{column}: {kind}: {text}")).to_string()
}

/// Returns one object a line: `level` (`change` or `question`), `message`, `file`, `line`, `column`.
pub fn render_json(migration: &Migration, lang: Lang) -> String {
    let notes = migration.notes.iter();
    notes
        .map(|note| object(migration, note, lang) + "\n")
        .collect()
}

fn object(migration: &Migration, note: &Note, lang: Lang) -> String {
    let mut out = String::from("{\"level\":");
    push_string(&mut out, note.kind.name());
    push_member(&mut out, "message", &note.text.in_lang(lang).to_string());
    push_member(&mut out, "file", migration.source.name());
    push_number(&mut out, "line", note.line);
    push_number(&mut out, "column", note.column);
    out.push('}');
    out
}
