//! `MESSAGE` and `F_MESSAGE`: the word, and a text up to the end of its statement (T.I.P. 3.1 §7-35).

use super::Parser;
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::language::Keyword;
use crate::lex::{BLANKS, delimiter};
use crate::message::Parsing;
use crate::source::{Span, first_beyond};
use crate::syntax::{Shape, Spanned, StatementKind};

/// Maximum length of a MESSAGE text, bytes.
const TEXT_LIMIT: usize = 70;

/// Maximum length of an F_MESSAGE text, bytes.
const FILE_TEXT_LIMIT: usize = 200;

impl Parser<'_> {
    /// Reads MESSAGE or F_MESSAGE, whose word is at `keyword` and whose text may reach up to `end`.
    pub(super) fn message(
        &mut self,
        word: Keyword,
        keyword: Span,
        end: usize,
        comment: Option<Span>,
    ) {
        let first = delimiter(&self.text.as_bytes()[..end], keyword.end);
        let is_blank = |char: char| BLANKS.contains(&char);
        let location = self.trim(Span::new(keyword.end + first, end), is_blank);
        if first == 0 && keyword.end < end {
            return self.glued_message(keyword, location);
        }
        if let Some(comment) = comment.filter(|_| first > 0) {
            self.warn_of_comment(comment);
        }
        self.check_text(word, location);
        let text = Spanned {
            node: self.source.slice(location).replace('\u{3000}', "  "),
            span: location,
        };
        let end = if text.node.is_empty() {
            keyword.end
        } else {
            location.end
        };
        let kind = match word {
            Keyword::FileMessage => StatementKind::FileMessage { text },
            _ => StatementKind::Message { text },
        };
        self.push(kind, Span::new(keyword.start, end));
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

    fn check_text(&mut self, word: Keyword, location: Span) {
        let text = self.source.slice(location);
        let is_file = word == Keyword::FileMessage;
        if let Some(at) = line_break(text).filter(|_| !is_file) {
            let at = location.start + at;
            let length = text[at - location.start..]
                .chars()
                .take(2)
                .map(char::len_utf8);
            let escape = Span::new(at, at + length.sum::<usize>());
            let reason = Parsing::LineBreak;
            let help = Parsing::Escapes;
            self.report(Diagnostic::new(Code::Format, escape, reason).help(help));
        }
        let limit = if is_file { FILE_TEXT_LIMIT } else { TEXT_LIMIT };
        if let Some(at) = first_beyond(text, limit) {
            self.is_text_too_long = true;
            let rest = Span::new(location.start + at, location.end);
            let reason = match is_file {
                true => Parsing::FileTextTooLong { limit },
                false => Parsing::TextTooLong { limit },
            };
            let help = Parsing::FullWidthCounts;
            self.report(Diagnostic::new(Code::LongString, rest, reason).help(help));
        }
    }
}

/// Returns the location of `\n`; a backslash (or yen sign) and the character after it are read as one.
fn line_break(text: &str) -> Option<usize> {
    let mut chars = text.char_indices();
    while let Some((at, char)) = chars.next() {
        if matches!(char, '\\' | '\u{A5}') && chars.next().is_some_and(|(_, next)| next == 'n') {
            return Some(at);
        }
    }
    None
}
