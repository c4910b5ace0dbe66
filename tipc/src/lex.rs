//! A statement's characters to words and operators. It knows no command.
//!
//! Whatever takes a text and a [`Span`] panics if that is not of the text.

use crate::language::{Edition, Keyword, keywords};
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
    /// Class of the token: word or operator.
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
    let mut foreign = None;
    let mut at = span.start;
    loop {
        let start = skip_delimiters(bytes, at);
        if start >= bytes.len() {
            return foreign;
        }
        let (kind, end) = operator(bytes, start).unwrap_or_else(|| {
            let end = word_end(bytes, start);
            foreign = foreign.or_else(|| foreign_run(text, Span::new(start, end)));
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
fn skip_delimiters(bytes: &[u8], mut at: usize) -> usize {
    while let length @ 1.. = delimiter(bytes, at) {
        at += length;
    }
    at
}

/// Returns the start of the delimiters that end a stretch of text.
fn trim_delimiters(bytes: &[u8]) -> usize {
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

/// A part of a line before its comment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Piece {
    /// `NAME:`, a label.
    Label {
        /// The name; empty if only the colon is there.
        name: Span,
        /// The name and the colon.
        span: Span,
    },
    /// A statement.
    Statement {
        /// Its first word; empty before an operator.
        word: Span,
        /// All of it, without the delimiters at its end.
        span: Span,
        /// End of a text: the next `;`, or the end of the code.
        text_end: usize,
    },
}

/// The labels and statements of a line, from left to right.
#[derive(Debug)]
pub struct Pieces<'a> {
    text: &'a str,
    /// End of the line's code.
    code_end: usize,
    /// `;` is an ordinary character of texts.
    single: bool,
    edition: Edition,
    /// Position of the next byte to read.
    at: usize,
    /// Start of the delimiters before `part_end`.
    trimmed_end: usize,
    /// The next `;`, or the end of the code.
    part_end: usize,
}

impl<'a> Pieces<'a> {
    /// Splits `code` into pieces; `single`: a MESSAGE or REM goes on to its end, as before version 3.0.
    pub fn new(text: &'a str, code: Span, single: bool) -> Self {
        let mut pieces = Pieces {
            text,
            code_end: code.end,
            single,
            edition: Edition::default(),
            at: code.start,
            trimmed_end: code.start,
            part_end: code.start,
        };
        pieces.open_part(code.start);
        pieces
    }

    /// Reads the words of an edition.
    pub fn in_edition(self, edition: Edition) -> Self {
        Pieces { edition, ..self }
    }

    /// Goes on at `start`, up to the next `;`.
    fn open_part(&mut self, start: usize) {
        let rest = &self.text.as_bytes()[start..self.code_end];
        let length = rest.iter().position(|byte| *byte == b';');
        self.part_end = length.map_or(self.code_end, |length| start + length);
        let part = &self.text.as_bytes()[start..self.part_end];
        self.trimmed_end = start + trim_delimiters(part);
        self.at = start;
    }

    fn statement(&mut self, word: Span) -> Piece {
        if self.single && self.takes_text(word) {
            (self.part_end, self.trimmed_end) = (self.code_end, self.code_end);
        }
        self.at = self.trimmed_end;
        Piece::Statement {
            word,
            span: Span::new(word.start, self.trimmed_end),
            text_end: self.part_end,
        }
    }

    /// Returns the offset after the colon if `word` is a label. MESSAGE and REM may go on with a text that starts with
    /// one.
    fn label_end(&self, word: Span) -> Option<usize> {
        let bytes = &self.text.as_bytes()[..self.trimmed_end];
        let colon = skip_delimiters(bytes, word.end);
        // `A := 1` is the assignment of another language.
        let is_label = bytes.get(colon) == Some(&b':')
            && bytes.get(colon + 1) != Some(&b'=')
            && (colon == word.end || !self.takes_text(word));
        is_label.then_some(colon + 1)
    }

    /// Returns true if the word is followed by a text instead of operands.
    fn takes_text(&self, word: Span) -> bool {
        let keyword = keywords::find(&self.text[word.start..word.end], self.edition);
        keyword.is_some_and(Keyword::takes_text)
    }
}

impl Iterator for Pieces<'_> {
    type Item = Piece;

    fn next(&mut self) -> Option<Piece> {
        loop {
            let bytes = &self.text.as_bytes()[..self.trimmed_end];
            let start = skip_delimiters(bytes, self.at);
            if start < self.trimmed_end {
                let word = Span::new(start, word_end(bytes, start));
                let Some(end) = self.label_end(word) else {
                    return Some(self.statement(word));
                };
                self.at = end;
                return Some(Piece::Label {
                    name: word,
                    span: Span::new(start, end),
                });
            }
            if self.part_end == self.code_end {
                return None;
            }
            self.open_part(self.part_end + 1);
        }
    }
}

/// Returns the code of a line, and its comment.
pub fn split_comment(text: &str, line: Span) -> (Span, Option<Span>) {
    let bytes = &text.as_bytes()[line.start..line.end];
    match bytes.windows(2).position(|pair| pair == b"//") {
        Some(at) => {
            let at = line.start + at;
            (Span::new(line.start, at), Some(Span::new(at, line.end)))
        }
        None => (line, None),
    }
}

#[cfg(test)]
mod tests {
    use super::{Piece, Pieces, split_comment};
    use crate::source::Span;

    /// Checks the labels and statements of a line, its texts each up to where they end.
    #[track_caller]
    fn check(line: &str, single: bool, expected: &[&str]) {
        let (code, _) = split_comment(line, Span::new(0, line.len()));
        let pieces = Pieces::new(line, code, single).map(|piece| match piece {
            Piece::Label { span, .. } => &line[span.start..span.end],
            Piece::Statement { span, .. } => &line[span.start..span.end],
        });
        assert_eq!(pieces.collect::<Vec<_>>(), expected, "{line:?}");
    }

    // clauses: 1.6
    #[test]
    fn a_line_is_labels_and_statements() {
        check("", false, &[]);
        check(" ; ;;\t", false, &[]);
        check(
            "L1: L2 :A = 1 ; END // x;y",
            false,
            &["L1:", "L2 :", "A = 1", "END"],
        );
        check(":", false, &[":"]);
        check("REM: a", false, &["REM:", "a"]);
        check("REM : a ;b", false, &["REM : a", "b"]);
        check("- 1, ", false, &["- 1"]);
    }

    // clauses: 10.1
    #[test]
    fn an_old_text_goes_on_to_its_comment() {
        check("A = 1; MESSAGE a;b // c", true, &["A = 1", "MESSAGE a;b "]);
        check("A = 1; B", true, &["A = 1", "B"]);
    }
}
