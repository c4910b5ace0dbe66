//! The texts of MESSAGE and REM, which are not tokens (T.I.P. 3.1 §7-9-4).

use super::Parser;
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::lex::{BLANKS, delimiter};
use crate::message::Parsing;
use crate::source::{Span, first_beyond};
use crate::syntax::{Shape, Spanned, StatementKind};

/// The most bytes that a MESSAGE text may have.
const TEXT_LIMIT: usize = 70;

impl Parser<'_> {
    /// MESSAGE, whose word is at `keyword` and whose text may reach up to `end`.
    pub(super) fn message(&mut self, keyword: Span, end: usize, comment: Option<Span>) {
        let first = delimiter(&self.text.as_bytes()[..end], keyword.end);
        let is_blank = |char: char| BLANKS.contains(&char);
        let place = self.trim(Span::new(keyword.end + first, end), is_blank);
        if first == 0 && keyword.end < end {
            return self.glued_message(keyword, place);
        }
        if let Some(comment) = comment.filter(|_| first > 0) {
            self.warn_of_comment(comment);
        }
        self.check_text(place);
        let text = Spanned {
            node: self.source.slice(place).replace('\u{3000}', "  "),
            span: place,
        };
        let end = if text.node.is_empty() {
            keyword.end
        } else {
            place.end
        };
        self.push(
            StatementKind::Message { text },
            Span::new(keyword.start, end),
        );
    }

    fn glued_message(&mut self, keyword: Span, text: Span) {
        let reason = Parsing::BlankBehindMessage;
        self.report(Diagnostic::new(Code::Argument, text, reason));
        self.push(StatementKind::Broken(Shape::Plain), keyword.to(text));
    }

    fn warn_of_comment(&mut self, comment: Span) {
        let reason = Parsing::TextEndsHere;
        let help = Parsing::CommentElsewhere;
        self.report(Diagnostic::new(Code::CommentInMessage, comment, reason).help(help));
    }

    fn check_text(&mut self, place: Span) {
        let text = self.source.slice(place);
        if let Some(at) = line_break(text) {
            let at = place.start + at;
            let length = text[at - place.start..].chars().take(2).map(char::len_utf8);
            let escape = Span::new(at, at + length.sum::<usize>());
            let reason = Parsing::LineBreak;
            let help = Parsing::Escapes;
            self.report(Diagnostic::new(Code::Format, escape, reason).help(help));
        }
        if let Some(at) = first_beyond(text, TEXT_LIMIT) {
            let rest = Span::new(place.start + at, place.end);
            let reason = Parsing::TextTooLong { limit: TEXT_LIMIT };
            let help = Parsing::FullWidthCounts;
            self.report(Diagnostic::new(Code::LongString, rest, reason).help(help));
        }
    }
}

/// Where `\n` is; a backslash (or yen sign) and the character after it are read as one.
fn line_break(text: &str) -> Option<usize> {
    let mut chars = text.char_indices();
    while let Some((at, char)) = chars.next() {
        if matches!(char, '\\' | '\u{A5}') && chars.next().is_some_and(|(_, next)| next == 'n') {
            return Some(at);
        }
    }
    None
}
