//! Fixes of characters and texts: full-width words, comments and PRINT of other languages, quotes, and line breaks.

use super::Site;
use crate::message::{Fixing, Linting};
use tipc::diagnostic::{Edit, Fix, Label};
use tipc::language::{Keyword, keywords};
use tipc::lex::{BLANKS, DELIMITERS, foreign_run, word_end};
use tipc::message::{Message, Naming, Parsing, Suggestion};
use tipc::parse::{self, LONG_VOWEL, comment_after, comment_mark, is_comment, narrow};
use tipc::source::Span;
use tipc::syntax::StatementKind;

/// Start of a comment in this language.
const COMMENT: &str = "//";

/// Opener of a comment of C.
const OPENS: &str = "/*";
const CLOSES: &str = "*/";

/// Line end in a text of C.
const BREAK: &str = "\\n";
/// Starts of placeholders and escapes, which differ from those of other languages.
const SPECIAL: &[char] = &['%', '\\', '\u{A5}', '{'];

/// Returns the fix of a full-width or typographic character, or of a comment.
pub(super) fn characters(site: &Site<'_>) -> Option<Fix> {
    match (site.reason(), site.help()?) {
        (_, Message::Parsing(Parsing::WriteHalfWidth { .. }))
        | (_, Message::Suggestion(Suggestion::Plain { .. } | Suggestion::PlainBlank)) => {
            half_width(site)
        }
        (_, Message::Suggestion(Suggestion::Invisible)) => {
            let title = Fixing::RemoveInvisible;
            Some(Fix::certain(title, [Edit::remove(site.span())]))
        }
        (_, Message::Suggestion(Suggestion::Comment)) => comment(site),
        _ => None,
    }
}

/// Returns the fix of full-width words such as `ＮＥＸＴ` at each location of the diagnostic.
fn half_width(site: &Site<'_>) -> Option<Fix> {
    let also = |label: &&Label| label.text == Naming::AlsoHere.into();
    let others = site.diagnostic.labels.iter().filter(also);
    let locations = [site.span()].into_iter().chain(others.map(|it| it.span));
    let statements = locations.filter_map(|location| site.module.statement_at(location.start));
    let mut statements: Vec<usize> = statements.collect();
    statements.dedup();
    let spans = statements.iter().map(|at| site.module.statements[*at].span);
    let edits = spans.flat_map(|span| narrowed(site, span));
    Some(Fix::certain(Fixing::HalfWidth, edits.collect::<Vec<_>>()))
}

/// Returns edits for all full-width characters of a statement: fixing only one leaves the diagnostic in place.
fn narrowed(site: &Site<'_>, mut span: Span) -> Vec<Edit> {
    let text = site.source.text();
    let first = Span::new(
        span.start,
        word_end(&text.as_bytes()[..span.end], span.start),
    );
    // These words may be followed by any characters.
    let word = narrow(site.slice(first));
    let takes_text = keywords::find(&word, site.module.edition)
        .is_some_and(|word| matches!(word, Keyword::Message | Keyword::Rem));
    if takes_text {
        span = first;
    }
    let mut edits = Vec::new();
    'words: for token in site.tokens_of(span) {
        let mut rest = token.span;
        while let Some(run) = foreign_run(text, rest) {
            let written = plain(site.slice(run));
            let comments = written.contains(COMMENT);
            edits.push(Edit::replace(run, written));
            if comments {
                break 'words;
            }
            rest.start = run.end;
        }
    }
    edits
}

/// Returns the plain spelling of full-width and typographic characters.
fn plain(text: &str) -> String {
    if text == LONG_VOWEL {
        return "-".to_owned();
    }
    let mut out = String::new();
    for char in text.chars() {
        match parse::plain(char) {
            Some(plain) => out += plain,
            None if char.is_whitespace() => out.push(' '),
            None => out.push(char),
        }
    }
    narrow(&out)
}

/// Returns the fix of a comment of another language on one line: `# …`, `' …`, `/* … */`.
fn comment(site: &Site<'_>) -> Option<Fix> {
    let line = site.line().span;
    let before = site.slice(Span::new(line.start, site.span().end));
    let starts = site.statement().map(|it| it.span.start);
    // A comment after a statement begins at its mark.
    let start = match starts.filter(|start| is_comment(&before[start - line.start..])) {
        Some(start) => start,
        None => line.start + comment_after(before)?,
    };
    let rest = Span::new(start, line.end);
    let text = site.slice(rest);
    let mark = comment_mark(text)?;
    let mut edits = vec![Edit::replace(Span::new(start, start + mark.len()), COMMENT)];
    let kept = text.trim_end_matches(BLANKS);
    if let Some(at) = kept.find(CLOSES).filter(|_| mark == OPENS) {
        // A statement follows the comment.
        if at + CLOSES.len() != kept.len() {
            return None;
        }
        edits.push(without_end(site, start + mark.len(), start + at));
    }
    match surely_comments(text) {
        true => Some(Fix::certain(Fixing::Comment, edits)),
        false => Some(Fix::likely(Fixing::Comment, edits)),
    }
}

/// Returns true if a text can only be a comment. `#define` and `--N` may be statements.
fn surely_comments(comment: &str) -> bool {
    let directives = ["define", "if", "else", "endif", "undef", "pragma"];
    let rest = comment.trim_start_matches('#');
    match comment_mark(comment) {
        Some("#") => !directives.iter().any(|word| rest.starts_with(word)),
        Some(mark @ "--") => comment[mark.len()..].starts_with(' '),
        mark => mark.is_some(),
    }
}

/// Returns the end of a comment, and the blanks before it, from `start` on.
fn without_end(site: &Site<'_>, start: usize, closes: usize) -> Edit {
    let before = site
        .slice(Span::new(start, closes))
        .trim_end_matches(BLANKS);
    let end = Span::new(start + before.len(), closes + CLOSES.len());
    Edit::remove(end)
}

/// Returns the fix of the text of a MESSAGE.
pub(super) fn messages(site: &Site<'_>) -> Option<Fix> {
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

/// Returns the fix of `PRINT "text"`.
pub(crate) fn print(site: &Site<'_>) -> Option<Fix> {
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

/// Returns the fix of `MESSAGE"text"` and `MESSAGE("text")`.
fn glued(site: &Site<'_>) -> Option<Fix> {
    let statement = site.statement()?.span;
    let start = statement.start + Keyword::Message.word().len();
    let [opening, closing] = quotes(site, Span::new(start, statement.end))?;
    let edits = [Edit::replace(opening, " "), Edit::remove(closing)];
    Some(Fix::certain(Fixing::Show, edits))
}

/// Returns the spans before and after a text in quotes: the quotes, parentheses around them, and a `\n` at the end of
/// the text. Returns `None` unless there is just one text.
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

/// Returns the fix of a value in the form of another language: `$N`, `{N}`, `%N`.
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

/// Returns the fix that removes `\n` at the end of a text, where the line ends anyway.
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
