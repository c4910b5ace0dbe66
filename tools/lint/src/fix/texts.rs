//! Texts for people: PRINT of other languages, quotes, and line breaks.

use super::site::Site;
use crate::message::{Fixing, Linting};
use tipc::diagnostic::{Edit, Fix};
use tipc::language::Keyword;
use tipc::lex::DELIMITERS;
use tipc::message::{Message, Parsing, Suggestion};
use tipc::source::Span;
use tipc::syntax::StatementKind;

/// Line end in a text of C.
const BREAK: &str = "\\n";
/// Starts of placeholders and escapes: other languages mean something else by them.
const SPECIAL: &[char] = &['%', '\\', '\u{A5}', '{'];

pub(super) fn fix(site: &Site<'_>) -> Option<Fix> {
    match (site.reason(), site.help()) {
        (_, Some(Message::Suggestion(Suggestion::Glued { command })))
            if *command == Keyword::Message.word() =>
        {
            glued(site)
        }
        (Message::Parsing(Parsing::LineBreak), _) => last_break(site),
        (_, Some(help)) => match help.get() {
            Some(Linting::ShowValue { name }) => Some(value(site, name)),
            _ => None,
        },
        _ => None,
    }
}

/// `PRINT "text"`.
pub(super) fn print(site: &Site<'_>) -> Option<Fix> {
    let start = site.span().start;
    let word = Span::new(start, start + name(site.text()).len());
    let rest = Span::new(word.end, site.statement()?.span.end);
    let [opening, closing] = quotes(site, rest)?;
    let gap = if opening.start == word.end { " " } else { "" };
    let edits = [
        site.write(word, Keyword::Message.word()),
        Edit::replace(opening, gap),
        Edit::remove(closing),
    ];
    Some(Fix::certain(Fixing::Show, edits))
}

/// `MESSAGE"text"`, `MESSAGE("text")`.
fn glued(site: &Site<'_>) -> Option<Fix> {
    let statement = site.statement()?.span;
    let start = statement.start + Keyword::Message.word().len();
    let [opening, closing] = quotes(site, Span::new(start, statement.end))?;
    let edits = [Edit::replace(opening, " "), Edit::remove(closing)];
    Some(Fix::certain(Fixing::Show, edits))
}

/// Returns opener and closer of the one text that stands there: quotes, perhaps in parentheses.
fn quotes(site: &Site<'_>, location: Span) -> Option<[Span; 2]> {
    let location = trimmed(site, location);
    let mut inside = location;
    if site.slice(location).starts_with('(')
        && site.slice(location).ends_with(')')
        && location.end > location.start + 1
    {
        inside = trimmed(site, Span::new(location.start + 1, location.end - 1));
    }
    let quoted = site.slice(inside);
    let quote = quoted
        .chars()
        .next()
        .filter(|char| ['"', '\''].contains(char))?;
    let text = quoted.get(1..)?.strip_suffix(quote)?;
    let shown = text.strip_suffix(BREAK).unwrap_or(text);
    if shown.is_empty() || shown.contains(quote) || shown.contains(SPECIAL) {
        return None;
    }
    let start = inside.start + 1;
    let end = start + shown.len();
    Some([
        Span::new(location.start, start),
        Span::new(end, location.end),
    ])
}

/// `$N`, `{N}`, `%N` of a variable.
fn value(site: &Site<'_>, name: &str) -> Fix {
    let new = format!("%{name}%");
    let title = Fixing::Replace {
        old: site.text().into(),
        new: new.as_str().into(),
    };
    Fix::certain(title, [Edit::replace(site.span(), new)])
}

/// Returns a span without the blanks at its ends.
fn trimmed(site: &Site<'_>, location: Span) -> Span {
    let text = site.slice(location);
    let kept = text.trim_end_matches(DELIMITERS);
    let end = location.start + kept.len();
    Span::new(end - kept.trim_start_matches(DELIMITERS).len(), end)
}

/// `\n` at the end of a text, which ends there anyway.
fn last_break(site: &Site<'_>) -> Option<Fix> {
    let StatementKind::Message { text } = &site.statement()?.kind else {
        return None;
    };
    let is_last = site.span().end == text.span.end;
    let title = Fixing::Remove {
        text: site.text().into(),
    };
    is_last.then(|| Fix::certain(title, [Edit::remove(site.span())]))
}

/// Returns the name that a word begins with: `PRINT` of `PRINT("…")`, `time.sleep` of `time.sleep(1)`.
pub(crate) fn name(word: &str) -> &str {
    let end = word.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_' || c == '.'));
    &word[..end.unwrap_or(word.len())]
}
