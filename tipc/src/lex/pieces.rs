//! The code of a line to labels and statements, for today's programs and for older ones.

use super::{skip_delimiters, trim_delimiters, word_end};
use crate::language::{Edition, Keyword, keywords};
use crate::source::Span;

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
