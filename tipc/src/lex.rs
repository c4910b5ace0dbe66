//! A statement's characters to words and operators. It knows no command.
//!
//! Whatever takes a text and a [`Span`] panics if that is not of the text.

mod pieces;

pub use pieces::{Piece, Pieces, split_comment};

use crate::source::Span;
use crate::syntax::{Arithmetic, Relation};

/// Kind of a token.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A name, a number or anything else between delimiters and operators.
    Word,
    /// `=`, or `+= -= *= /=`.
    Assign(Option<Arithmetic>),
    /// `== <> < > <= >=`
    Relation(Relation),
    /// `+ - * /`
    Arithmetic(Arithmetic),
    /// `!`
    Not,
    /// `:`
    Colon,
}

/// A word or operator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Token {
    /// Kind of the token.
    pub kind: Kind,
    /// Location in the source.
    pub span: Span,
    /// A delimiter precedes it.
    pub spaced: bool,
}

/// The full-width space in UTF-8.
const FULL_WIDTH_SPACE: &[u8] = b"\xE3\x80\x80";

/// The characters that only take up room.
pub const BLANKS: &[char] = &[' ', '\t', '\u{3000}'];
/// The characters between words: blanks and the comma.
pub const DELIMITERS: &[char] = &[' ', '\t', '\u{3000}', ','];

/// Reads the tokens of `span` into `tokens` and returns the first characters that no statement may hold.
///
/// Such characters become part of words, so that the tokens around them stay usable.
pub fn lex(text: &str, span: Span, tokens: &mut Vec<Token>) -> Option<Span> {
    let bytes = &text.as_bytes()[..span.end];
    // Nearly no statement holds one.
    let is_plain = bytes[span.start..].iter().all(|byte| !is_foreign(*byte));
    let mut foreign = None;
    let mut at = span.start;
    loop {
        let start = skip_delimiters(bytes, at);
        if start >= bytes.len() {
            return foreign;
        }
        let (kind, end) = operator(bytes, start).unwrap_or_else(|| {
            let end = word_end(bytes, start);
            if !is_plain && foreign.is_none() {
                foreign = foreign_run(text, Span::new(start, end));
            }
            (Kind::Word, end)
        });
        tokens.push(Token {
            kind,
            span: Span::new(start, end),
            spaced: start > at,
        });
        at = end;
    }
}

/// Returns the first offset from `at` on without a delimiter.
pub(crate) fn skip_delimiters(bytes: &[u8], mut at: usize) -> usize {
    while let length @ 1.. = delimiter(bytes, at) {
        at += length;
    }
    at
}

/// Returns the start of the delimiters that end a stretch of text.
pub(crate) fn trim_delimiters(bytes: &[u8]) -> usize {
    let mut end = bytes.len();
    loop {
        match &bytes[..end] {
            [.., b' ' | b'\t' | b','] => end -= 1,
            rest if rest.ends_with(FULL_WIDTH_SPACE) => end -= FULL_WIDTH_SPACE.len(),
            _ => return end,
        }
    }
}

/// Returns the length of the delimiter at `at`; 0 if there is none.
pub(crate) fn delimiter(bytes: &[u8], at: usize) -> usize {
    match bytes.get(at) {
        Some(b' ' | b'\t' | b',') => 1,
        Some(0xE3) if bytes[at..].starts_with(FULL_WIDTH_SPACE) => FULL_WIDTH_SPACE.len(),
        _ => 0,
    }
}

/// Returns the end of the word that starts at `start`.
pub fn word_end(bytes: &[u8], start: usize) -> usize {
    let end = plain_word_end(bytes, start);
    if is_open_exponent(&bytes[start..end], &bytes[end..]) {
        return plain_word_end(bytes, end + 1);
    }
    end
}

fn plain_word_end(bytes: &[u8], start: usize) -> usize {
    let mut at = start;
    while let Some(byte) = bytes.get(at) {
        let ends = match byte {
            b'0'..=b'9' | b'A'..=b'Z' | b'a'..=b'z' | b'_' | b'.' => false,
            b'+' | b'-' | b'*' | b'/' | b'=' | b'<' | b'>' | b'!' | b':' => true,
            _ => delimiter(bytes, at) > 0,
        };
        if ends {
            break;
        }
        at += 1;
    }
    at
}

/// Returns true if `word` is a number up to its `E` and `rest` goes on with the exponent's sign and digits.
fn is_open_exponent(word: &[u8], rest: &[u8]) -> bool {
    let [b'+' | b'-', b'0'..=b'9', ..] = rest else {
        return false;
    };
    let [mantissa @ .., b'E' | b'e'] = word else {
        return false;
    };
    !mantissa.is_empty()
        && mantissa
            .iter()
            .all(|byte| matches!(byte, b'0'..=b'9' | b'.'))
}

fn operator(bytes: &[u8], at: usize) -> Option<(Kind, usize)> {
    let equals = bytes.get(at + 1) == Some(&b'=');
    let arithmetic = |operation| match equals {
        true => (Kind::Assign(Some(operation)), 2),
        false => (Kind::Arithmetic(operation), 1),
    };
    let (kind, length) = match bytes[at] {
        b'=' if equals => (Kind::Relation(Relation::Eq), 2),
        b'=' => (Kind::Assign(None), 1),
        b'<' if equals => (Kind::Relation(Relation::Le), 2),
        b'<' if bytes.get(at + 1) == Some(&b'>') => (Kind::Relation(Relation::Ne), 2),
        b'<' => (Kind::Relation(Relation::Lt), 1),
        b'>' if equals => (Kind::Relation(Relation::Ge), 2),
        b'>' => (Kind::Relation(Relation::Gt), 1),
        b'+' => arithmetic(Arithmetic::Add),
        b'-' => arithmetic(Arithmetic::Sub),
        b'*' => arithmetic(Arithmetic::Mul),
        b'/' => arithmetic(Arithmetic::Div),
        b'!' => (Kind::Not, 1),
        b':' => (Kind::Colon, 1),
        _ => return None,
    };
    Some((kind, at + length))
}

/// Returns true if a byte is of such a character.
const fn is_foreign(byte: u8) -> bool {
    !byte.is_ascii() || byte.is_ascii_control()
}

/// Returns the first run of characters in `span` that only comments and texts may hold.
pub fn foreign_run(text: &str, span: Span) -> Option<Span> {
    let word = &text[span.start..span.end];
    let start = word.bytes().position(is_foreign)?;
    let run = word.bytes().skip(start).take_while(|it| is_foreign(*it));
    let length = run.count();
    Some(Span::new(span.start + start, span.start + start + length))
}
