//! Full-width characters in names and after labels: each is reported, and the word counts as what it was meant to be.

use super::{Flow, Parser, narrow};
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::language::{commands, names};
use crate::lex::{DELIMITERS, foreign_run, word_end};
use crate::message::Parsing;
use crate::source::Span;
use crate::syntax::{StatementKind, Word, upper_case};

/// The colon of full-width text.
const COLON: char = '：';

impl Parser<'_> {
    /// A name as it was meant to be typed.
    pub(super) fn narrow_word(&self, span: Span) -> Word {
        let word = self.source.slice(span);
        Word {
            node: match word.is_ascii() {
                true => upper_case(word),
                false => upper_case(&narrow(word)),
            },
            span,
        }
    }

    /// `L1：`, `Ｌ１：`: where the name of a label ends that a full-width colon follows.
    pub(super) fn ends_with_wide_colon(&self, word: Span) -> Option<Span> {
        let text = self.source.slice(word);
        let name = &text[..text.find(COLON)?];
        let meant = upper_case(&narrow(name));
        let is_name = names::is_label(&meant) && commands::find(&meant).is_none();
        is_name.then(|| Span::new(word.start, word.start + name.len()))
    }

    /// A label with a full-width colon, and the statement after it.
    pub(super) fn wide_label(
        &mut self,
        name: Span,
        span: Span,
        text_end: usize,
        comment: Option<Span>,
    ) -> Flow {
        let whole = Span::new(name.start, name.end + COLON.len_utf8());
        let label = self.narrow_word(name);
        let place = foreign_run(self.text, whole).unwrap_or(whole);
        let narrow = narrow(self.source.slice(whole));
        let fault = Diagnostic::new(Code::Format, place, Parsing::ForeignCharacters);
        self.report(fault.help(Parsing::WriteHalfWidth { narrow }));
        self.check_name_length(&label);
        self.push(StatementKind::Label(label), whole);
        let rest = self.source.slice(Span::new(whole.end, span.end));
        let start = span.end - rest.trim_start_matches(DELIMITERS).len();
        if start == span.end {
            return Flow::Continue;
        }
        let word = word_end(&self.text.as_bytes()[..span.end], start);
        let rest = Span::new(start, span.end);
        self.statement(Span::new(start, word), rest, text_end, comment)
    }
}
