//! One JSON object for each diagnostic.

use crate::diagnostic::Diagnostic;
use crate::message::Lang;
use crate::robot::Robot;
use crate::source::{Position, Source, Span, Unit};
use std::fmt::Write;
use tip_runtime::printable::is_control;

/// Renders an object on one line, without line end: `level`, `kind` (of errors), `message` (the classical one),
/// `code`, `file`,
/// `line`, `column` (both from 1, the column in characters) and, if there is any, `help`; then `reason`, `class` (the code
/// that finer codes are part of), `range`, `labels` and `fixes` with the locations in every unit, the file's `encoding`, the name
/// of the `robot` that the program was checked for, `related` (the labels at which the same mistake shows again, with file,
/// line and column), and how to see the code's `page`.
pub fn json(source: &Source, diagnostic: &Diagnostic, robot: Option<Robot>, lang: Lang) -> String {
    let (line, column) = source.line_column(diagnostic.span.start);
    let mut out = String::from("{\"level\":");
    push_string(&mut out, diagnostic.level().name());
    if let Some(kind) = diagnostic.code.kind() {
        push_member(&mut out, "kind", kind.name());
    }
    push_member(&mut out, "message", &diagnostic.message());
    push_member(&mut out, "code", diagnostic.id());
    push_member(&mut out, "file", source.name());
    push_number(&mut out, "line", line);
    push_number(&mut out, "column", column);
    if let Some(help) = &diagnostic.help {
        push_member(&mut out, "help", &help.in_lang(lang).to_string());
    }
    push_member(
        &mut out,
        "reason",
        &diagnostic.reason.in_lang(lang).to_string(),
    );
    push_member(&mut out, "class", diagnostic.code.id());
    out.push_str(",\"range\":");
    push_range(&mut out, source, diagnostic.span);
    push_labels(&mut out, source, diagnostic, lang);
    push_fixes(&mut out, source, diagnostic, lang);
    push_member(&mut out, "encoding", source.charset().name());
    if let Some(robot) = robot {
        push_member(&mut out, "robot", robot.name());
    }
    push_related(&mut out, source, diagnostic, lang);
    push_member(
        &mut out,
        "page",
        &format!("tip explain {}", diagnostic.id()),
    );
    out.push('}');
    out
}

/// Writes a list of objects, each by its members.
fn push_objects<T>(
    out: &mut String,
    objects: impl IntoIterator<Item = T>,
    members: impl Fn(&mut String, T),
) {
    out.push('[');
    for (index, object) in objects.into_iter().enumerate() {
        out.push_str(if index == 0 { "{" } else { ",{" });
        members(out, object);
        out.push('}');
    }
    out.push(']');
}

/// Writes the locations at which the same mistake shows again.
fn push_related(out: &mut String, source: &Source, diagnostic: &Diagnostic, lang: Lang) {
    out.push_str(",\"related\":");
    let again = diagnostic.labels.iter().filter(|label| label.is_again());
    push_objects(out, again, |out, label| {
        let (line, column) = source.line_column(label.span.start);
        out.push_str("\"file\":");
        push_string(out, source.name());
        push_number(out, "line", line);
        push_number(out, "column", column);
        push_member(out, "text", &label.text.in_lang(lang).to_string());
    });
}

/// Writes the other locations that matter, each with its text.
fn push_labels(out: &mut String, source: &Source, diagnostic: &Diagnostic, lang: Lang) {
    out.push_str(",\"labels\":");
    push_objects(out, &diagnostic.labels, |out, label| {
        out.push_str("\"text\":");
        push_string(out, &label.text.in_lang(lang).to_string());
        out.push_str(",\"range\":");
        push_range(out, source, label.span);
    });
}

/// Writes the fixes, each with its edits.
fn push_fixes(out: &mut String, source: &Source, diagnostic: &Diagnostic, lang: Lang) {
    out.push_str(",\"fixes\":");
    push_objects(out, &diagnostic.fixes, |out, fix| {
        out.push_str("\"title\":");
        push_string(out, &fix.title.in_lang(lang).to_string());
        push_member(out, "applicability", fix.applicability.name());
        out.push_str(",\"edits\":");
        push_objects(out, &fix.edits, |out, edit| {
            out.push_str("\"range\":");
            push_range(out, source, edit.span);
            push_member(out, "text", &edit.text);
        });
    });
}

/// Writes the start and end of a span.
fn push_range(out: &mut String, source: &Source, span: Span) {
    out.push_str("{\"start\":");
    push_position(out, source, span.start);
    out.push_str(",\"end\":");
    push_position(out, source, span.end);
    out.push('}');
}

/// Writes a position: the byte of the file from 0; the line from 1; and the column from 1, in characters, in bytes of
/// UTF-8 and in units of UTF-16.
fn push_position(out: &mut String, source: &Source, offset: usize) {
    let column = |unit| source.position(offset, unit).column;
    let Position {
        line,
        column: characters,
    } = source.position(offset, Unit::Character);
    let byte = source.file_offset(offset);
    let (utf8, utf16) = (column(Unit::Utf8), column(Unit::Utf16));
    // Writing to a string cannot fail.
    let _ = write!(
        out,
        "{{\"byte\":{byte},\"line\":{line},\"column\":{characters},\"utf8\":{utf8},\"utf16\":{utf16}}}"
    );
}

/// Writes another member of an object, a string.
pub fn push_member(out: &mut String, key: &str, value: &str) {
    out.push(',');
    push_string(out, key);
    out.push(':');
    push_string(out, value);
}

/// Writes another member of an object, a number.
pub fn push_number(out: &mut String, key: &str, value: u32) {
    // Writing to a string cannot fail.
    let _ = write!(out, ",\"{key}\":{value}");
}

/// Writes a string in quotes.
pub fn push_string(out: &mut String, text: &str) {
    out.push('"');
    for char in text.chars() {
        match char {
            '"' | '\\' => out.extend(['\\', char]),
            // All that could act on a terminal is below 0x10000.
            _ if is_control(char) => {
                let _ = write!(out, "\\u{:04x}", u32::from(char));
            }
            _ => out.push(char),
        }
    }
    out.push('"');
}
