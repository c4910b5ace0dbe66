//! Lines 1 and 2: the version of the language, and the program's title.

use super::reader::Parsed;
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::lex::BLANKS;
use crate::message::Parsing;
use crate::source::Source;
use crate::syntax::Span;

/// Whether line 1 names `wanted`, compared as numbers; blanks and a comment may stand beside it.
pub(super) fn version(source: &Source, wanted: f64) -> Parsed<()> {
    let line = source.line(1).span;
    let text = source.slice(line);
    let code = text.split_once("//").map_or(text, |(code, _)| code);
    let word = code.trim_end_matches(BLANKS);
    let start = line.start + word.len() - word.trim_start_matches(BLANKS).len();
    let span = Span::new(start, line.start + word.len());
    let word = source.slice(span);
    let reason = match number(word) {
        Some(found) if found == wanted => return Ok(()),
        Some(_) => Parsing::OtherVersion { wanted },
        None if word.is_empty() => Parsing::NoVersion,
        None => Parsing::MoreThanVersion,
    };
    let help = Parsing::StartWithVersion { wanted };
    Err(Box::new(
        Diagnostic::new(Code::Version, span, reason).help(help),
    ))
}

/// Line 2, its full-width spaces as two half-width ones.
pub(super) fn title(source: &Source) -> String {
    let line = source.line_text(2).trim_matches(BLANKS);
    line.replace('\u{3000}', "  ")
}

fn number(word: &str) -> Option<f64> {
    let starts_like_one = word.starts_with(|first: char| first.is_ascii_digit() || first == '.');
    starts_like_one.then(|| word.parse().ok())?
}
