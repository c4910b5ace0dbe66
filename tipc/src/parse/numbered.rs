//! Lines with numbers, as in BASIC and G-code.

use super::Parser;
use super::shape::meant;
use crate::diagnostic::Label;
use crate::foreign;
use crate::language::Keyword;
use crate::language::commands::{self, Meaning};
use crate::lex::Token;
use crate::load::MOST;
use crate::message::{Commanding, Instead};
use crate::source::Span;
use crate::syntax::{Shape, StatementKind};

impl Parser<'_> {
    /// `10 PTP F1 P`: one mistake, however many lines have a number.
    pub(super) fn line_number(&mut self, word: Span, tokens: &[Token]) -> Option<StatementKind> {
        let text = self.source.slice(word);
        let digits = text.trim_end_matches('.').trim_start_matches(['N', 'n']);
        let is_number = !digits.is_empty() && digits.bytes().all(|it| it.is_ascii_digit());
        let second = self.source.slice(tokens.get(1)?.span);
        let command = commands::find(second);
        if !is_number || command.is_none() && !foreign::is_g_code(second) {
            return None;
        }
        let shape = match command.map(|command| command.meaning) {
            Some(Meaning::Keyword(keyword)) => meant(keyword, self.text, &tokens[1..]),
            _ => Shape::Plain,
        };
        match self.numbered {
            Some(first) => {
                let text = Instead::NumberedToo.into();
                // Of too many findings it is omitted.
                if let Some(first) = self.diagnostics.get_mut(first)
                    && first.labels.len() < MOST
                {
                    first.labels.push(Label { span: word, text });
                }
            }
            None => {
                self.numbered = Some(self.diagnostics.len());
                let reason = Commanding::NoCommand { word: text.into() };
                self.report_unknown(word, text, reason, Instead::NoNumbers);
            }
        }
        Some(StatementKind::Broken(shape))
    }

    /// `90 END` at the end of the file: its number is reported.
    pub(super) fn ends_with_number(&self) -> bool {
        let last = self.module.statements.last();
        last.filter(|_| self.numbered.is_some())
            .is_some_and(|last| {
                let mut words = self.source.slice(last.span).split_whitespace();
                let is_end = |word: &str| word.eq_ignore_ascii_case(Keyword::End.word());
                matches!(last.kind, StatementKind::Broken(_))
                    && words.next_back().is_some_and(is_end)
            })
    }
}
