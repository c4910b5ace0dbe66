//! Lines 1 and 2: the version of the language, and the program's title.

use super::reader::Parsed;
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::language::Edition;
use crate::lex::{BLANKS, split_comment};
use crate::message::{Decimal, Message, Parsing, Suggestion};
use crate::source::{Source, Span};

/// The versions that `migrate` reads; some programs of the time of 2.1 say 4.0 (T.I.P. 3.1 §1-1).
const OLDER: &[f64] = &[1.0, 1.1, 2.0, 2.1, 3.0, 4.0];

/// Returns the edition of line 1, which must name `demanded`, compared as numbers; without one, any edition.
pub(super) fn version(source: &Source, demanded: Option<f64>) -> Parsed<Edition> {
    let span = version_word(source);
    let word = source.slice(span);
    let is_edition = |found: f64| Edition::ALL.iter().any(|one| one.number() == found);
    let is_right = |found: f64| demanded.map_or_else(|| is_edition(found), |one| found == one);
    let wanted = demanded.unwrap_or(Edition::default().number());
    let reason = match version_number(word) {
        Some(found) if is_right(found) => return Ok(Edition::of(found)),
        Some(_) => Parsing::OtherVersion {
            wanted: Decimal(wanted),
        },
        None if word.is_empty() => Parsing::NoVersion,
        None => Parsing::MoreThanVersion,
    };
    let is_older = version_number(word).is_some_and(|found| OLDER.contains(&found));
    let first = word.split(BLANKS).next().and_then(version_number);
    let is_title_behind = first.is_some_and(is_right);
    let wanted = first.filter(|_| is_title_behind).unwrap_or(wanted);
    let help: Message = match (is_older, is_title_behind) {
        (true, _) => Suggestion::Migrate.into(),
        (_, true) => Suggestion::TitleInLineTwo {
            wanted: Decimal(wanted),
        }
        .into(),
        _ => Parsing::StartWithVersion {
            wanted: Decimal(wanted),
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
