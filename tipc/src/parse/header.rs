//! Lines 1 and 2: the version of the language, and the program's title.

use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::language::Edition;
use crate::lex::{BLANKS, split_comment};
use crate::message::list::{Alternatives, OneOf};
use crate::message::{Decimal, Message, Parsing, Suggestion};
use crate::source::{Source, Span};

/// The versions that `migrate` reads; some programs of the time of 2.1 say 4.0 (T.I.P. 3.1 §1-1).
const OLDER: &[f64] = &[1.0, 1.1, 2.0, 2.1, 3.0, 4.0];

/// Returns the edition of line 1, which must name `demanded`, compared as numbers; without one, any edition.
pub(super) fn version(source: &Source, demanded: Option<f64>) -> Result<Edition, Box<Diagnostic>> {
    let span = version_word(source);
    let word = source.slice(span);
    let editions = Edition::ALL.iter().map(|edition| edition.number());
    let wanted = demanded.map_or_else(|| editions.collect(), |one| vec![one]);
    let is_right = |found: f64| wanted.contains(&found);
    let names = || wanted.iter().map(|one| format!("{one:?}")).collect();
    let reason = match version_number(word) {
        Some(found) if is_right(found) => return Ok(Edition::of(found)),
        Some(_) => Parsing::OtherVersion {
            wanted: OneOf(names()),
        },
        None if word.is_empty() => Parsing::NoVersion,
        None => Parsing::MoreThanVersion,
    };
    let is_older = version_number(word).is_some_and(|found| OLDER.contains(&found));
    let first = word.split(BLANKS).next().and_then(version_number);
    let help: Message = match first.filter(|first| is_right(*first)) {
        _ if is_older => Suggestion::Migrate.into(),
        Some(first) => Suggestion::TitleInLineTwo {
            wanted: Decimal(first),
        }
        .into(),
        None => Parsing::StartWithVersion {
            wanted: Alternatives(names()),
        }
        .into(),
    };
    Err(Box::new(
        Diagnostic::new(Code::Version, span, reason).help(help),
    ))
}

/// Returns the location of the version number in line 1; blanks and a comment may surround it.
pub fn version_word(source: &Source) -> Span {
    let (code, _) = split_comment(source.text(), source.line(1).span);
    let word = source.slice(code).trim_end_matches(BLANKS);
    let end = code.start + word.len();
    Span::new(end - word.trim_start_matches(BLANKS).len(), end)
}

/// Returns the number that a version word is, if it is one.
pub fn version_number(word: &str) -> Option<f64> {
    let starts_like_one = word.starts_with(|first: char| first.is_ascii_digit() || first == '.');
    starts_like_one.then(|| word.parse().ok())?
}

/// Returns line 2, its full-width spaces as two half-width ones.
pub(super) fn title(source: &Source) -> String {
    let line = source.line_text(2).trim_matches(BLANKS);
    line.replace('\u{3000}', "  ")
}
