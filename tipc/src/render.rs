//! Diagnostics as people and tools read them.

#[cfg(feature = "build")]
mod human;
#[cfg(feature = "build")]
mod json;

#[cfg(feature = "build")]
pub use human::{Style, human};
#[cfg(feature = "build")]
pub use json::{json, push_member, push_number, push_string};

use crate::code::Level;
use crate::diagnostic::Diagnostic;
use crate::message::Lang;
use crate::source::Source;
use std::fmt::Display;
use tip_runtime::printable::Printable;

/// Maximum number of bytes of a line that are shown.
const MAX_SHOWN_BYTES: usize = 4096;

/// Returns the part of a line that is shown.
fn shown(line: &str) -> &str {
    let mut end = line.len().min(MAX_SHOWN_BYTES);
    while !line.is_char_boundary(end) {
        end -= 1;
    }
    &line[..end]
}

/// Formats a text for display: what could act on a terminal is escaped.
fn printable(text: impl Display) -> String {
    Printable::line(text).to_string()
}

/// Maximum number of other locations that are listed.
const LOCATIONS: usize = 8;

/// The blanks that stand for a tab.
const TAB: &str = "    ";

/// Returns `CODE: REASON` and, below, the location, the line with carets, the help and the classical message.
///
/// The caller puts a word like `error:` before it.
pub fn plain(source: &Source, diagnostic: &Diagnostic, lang: Lang) -> String {
    let name = printable(source.name());
    let location = |start: usize| {
        let (line, column) = source.line_column(start);
        format!("{name}:{line}:{column}")
    };
    let span = diagnostic.span;
    let line = source.line(source.line_column(span.start).0);
    let number = line.number.to_string();
    let gap = " ".repeat(number.len());
    let (id, headline) = (diagnostic.id(), printable(diagnostic.headline(lang)));
    let mut out = format!(
        "{id}: {headline}\n{gap}--> {}\n{gap} |\n",
        location(span.start)
    );
    let text = shown(source.slice(line.span));
    // Such a location is not shown at the end of an endless line.
    if let Some(before) = text.get(..span.start.saturating_sub(line.span.start)) {
        let marked = &text[before.len()..];
        let marked = marked.get(..span.end - span.start).unwrap_or(marked);
        let (blanks, carets) = (width(before), width(marked).max(1));
        let (blanks, carets) = (" ".repeat(blanks), "^".repeat(carets));
        let text = typed(text);
        out += &format!("{number} | {text}\n{gap} | {blanks}{carets}\n{gap} |\n");
    }
    for label in diagnostic.labels.iter().take(LOCATIONS) {
        let text = printable(label.text.in_lang(lang));
        out += &format!("{gap} = {}: {text}\n", location(label.span.start));
    }
    if let Some(help) = &diagnostic.help {
        let name = lang.pick("help", "ヘルプ");
        out += &format!("{gap} = {name}: {}\n", printable(help.in_lang(lang)));
    }
    let name = lang.pick("note", "注");
    out + &format!("{gap} = {name}: {}\n", printable(diagnostic.title()))
}

/// Returns a piece of a line as it is shown.
fn typed(text: &str) -> String {
    printable(text.replace('\t', TAB))
}

/// Returns the columns that a piece of a line takes. Full-width characters take two.
fn width(text: &str) -> usize {
    let is_narrow = |char: char| char.is_ascii() || ('\u{FF61}'..='\u{FF9F}').contains(&char);
    let columns = |char| if is_narrow(char) { 1 } else { 2 };
    typed(text).chars().map(columns).sum()
}

/// Returns `FILE:LINE:COLUMN: error[CODE]: REASON (TIP_ERR:<message>)` or `FILE:LINE:COLUMN: warning[CODE]: <message>`
/// without line end. Characters of the file's name that could act on a terminal are escaped.
pub fn short(source: &Source, diagnostic: &Diagnostic, lang: Lang) -> String {
    let (line, column) = source.line_column(diagnostic.span.start);
    let (level, code) = (diagnostic.level(), diagnostic.id());
    let headline = diagnostic.headline(lang);
    let classical = match level {
        Level::Error => format!(" (TIP_ERR:{})", diagnostic.message()),
        Level::Warning => String::new(),
    };
    let (name, level) = (source.name(), level.name());
    let text = format_args!("{name}:{line}:{column}: {level}[{code}]: {headline}{classical}");
    Printable::line(text).to_string()
}

/// Returns `FILE:LINE:COLUMN: error: TIP_ERR:<message> (<kind>)` or `FILE:LINE:COLUMN: warning: <message>`, in English
/// and without line end (T.I.P. 3.1 §9). WARNING.LOG consists of such lines.
pub fn classical(source: &Source, diagnostic: &Diagnostic) -> String {
    let (line, column) = source.line_column(diagnostic.span.start);
    let level = diagnostic.level().name();
    let title = diagnostic.title();
    let name = source.name();
    Printable::line(format_args!("{name}:{line}:{column}: {level}: {title}")).to_string()
}

#[cfg(all(test, feature = "build"))]
mod tests;
