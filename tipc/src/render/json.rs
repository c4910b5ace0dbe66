//! One JSON object for each diagnostic.

use crate::diagnostic::Diagnostic;
use crate::source::Source;
use std::fmt::Write;
use tip_runtime::printable::acts;

/// An object on one line, without line end: `level`, `kind` (of errors), `message`, `code`, `file`, `line`, `column`
/// (both from 1, the column in characters) and, if there is any, `help`.
pub fn json(source: &Source, diagnostic: &Diagnostic) -> String {
    let (line, column) = source.line_column(diagnostic.span.start);
    let mut out = String::from("{\"level\":");
    push_string(&mut out, diagnostic.level().name());
    if let Some(kind) = diagnostic.code.kind() {
        push_member(&mut out, "kind", kind.name());
    }
    push_member(&mut out, "message", &diagnostic.message());
    push_member(&mut out, "code", diagnostic.code.id());
    push_member(&mut out, "file", source.name());
    push_number(&mut out, "line", line);
    push_number(&mut out, "column", column);
    if let Some(help) = &diagnostic.help {
        push_member(&mut out, "help", &help.to_string());
    }
    out.push('}');
    out
}

/// Another member of an object, a string.
pub(crate) fn push_member(out: &mut String, key: &str, value: &str) {
    out.push(',');
    push_string(out, key);
    out.push(':');
    push_string(out, value);
}

/// Another member of an object, a number.
pub(crate) fn push_number(out: &mut String, key: &str, value: u32) {
    // Writing to a string cannot fail.
    let _ = write!(out, ",\"{key}\":{value}");
}

/// A string in quotes.
pub(crate) fn push_string(out: &mut String, text: &str) {
    out.push('"');
    for char in text.chars() {
        match char {
            '"' | '\\' => out.extend(['\\', char]),
            // All that could act on a terminal is below 0x10000.
            _ if acts(char) => {
                let _ = write!(out, "\\u{:04x}", u32::from(char));
            }
            _ => out.push(char),
        }
    }
    out.push('"');
}
