//! A diagnostic as a plain text, for the errors of macros: its line with carets, its help, and the classical message.

use super::{printable, shown};
use crate::diagnostic::Diagnostic;
use crate::message::Lang;
use crate::source::Source;

/// The most other locations that are listed.
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

#[cfg(test)]
mod tests {
    use super::plain;
    use crate::load::{Options, load};
    use crate::message::Lang;

    fn rendered(statements: &str) -> String {
        let text = format!("3.1\nA title\n{statements}\nEND\n");
        let loaded = load("walk.prg", text.as_bytes(), &Options::default());
        plain(&loaded.source, &loaded.diagnostics[0], Lang::English)
    }

    #[test]
    fn an_error_is_shown_with_its_line_its_help_and_the_classical_message() {
        let expected = "E204-01: `FLY` is not a command
 --> walk.prg:3:1
  |
3 | FLY F1 10
  | ^^^
  |
  = help: a label ends with a colon, an equation has `=` after its variable
  = note: TIP_ERR:Unknown command \"FLY\" (SyntaxError)
";
        assert_eq!(rendered("FLY F1 10"), expected);
    }

    #[test]
    fn carets_stand_below_the_place_whatever_is_before_it() {
        let text = rendered("\tSLEEP 歩");
        let lines = "\n3 |     SLEEP 歩\n  |           ^^\n  |\n";
        assert!(text.contains(lines), "{text}");
    }

    #[test]
    fn other_places_are_listed() {
        let text = rendered("GOTO UP:\nGOSUB UP:");
        assert!(text.contains("\n  = walk.prg:4:7: "), "{text}");
    }
}
