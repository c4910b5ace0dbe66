//! The role of a broken statement among the blocks, and diagnostics of statements of other languages.

use super::characters::is_sign;
use super::comment::is_comment;
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::language::{Keyword, commands, keywords};
use crate::lex::{Kind, Token};
use crate::message::{Parsing, Suggestion};
use crate::parse::{Flow, Parser};
use crate::source::Span;
use crate::syntax::{Shape, StatementKind};

impl Parser<'_> {
    /// Reads a line that begins as in another language: a comment, `END.`, a FOR of C.
    pub(in crate::parse) fn foreign_line(
        &mut self,
        keyword: Option<Keyword>,
        word: Span,
        span: Span,
    ) -> Option<Flow> {
        match keyword {
            None if is_comment(self.source.slice(span)) => {
                self.foreign_comment(span);
                Some(Flow::NextLine)
            }
            None if self.is_end_with_dot(word) => {
                self.end_with_dot(word);
                Some(Flow::End)
            }
            None if self.narrow_keyword(word) == Some(Keyword::End) => {
                self.report_foreign(word);
                self.push(StatementKind::End, word);
                Some(Flow::End)
            }
            Some(Keyword::For) if self.is_for_of_c(word, span) => Some(self.for_of_c(span)),
            _ => None,
        }
    }

    /// Returns the role of a statement that is not read because it is part of a reported mistake: its characters, one
    /// of its names, or the IF before it.
    pub(in crate::parse) fn broken_statement(
        &self,
        keyword: Option<Keyword>,
        word: Span,
        tokens: &[Token],
        reported: bool,
    ) -> Option<StatementKind> {
        match keyword {
            Some(Keyword::Then) if self.follows_broken_if() => {
                Some(StatementKind::Broken(Shape::Plain))
            }
            Some(Keyword::Subroutine) if reported => Some(self.broken_subroutine(word, tokens)),
            keyword if reported || self.names_hyphened(tokens) => {
                Some(StatementKind::Broken(shape(keyword, self.text, tokens)))
            }
            _ => None,
        }
    }

    /// Reports what follows a word that must be alone on its line: `ELSE IF`, `WEND KB_HIT`, `REPEAT 5`.
    pub(in crate::parse) fn behind_lone_word(
        &mut self,
        lone: StatementKind,
        tokens: &[Token],
        reported: bool,
    ) -> StatementKind {
        if lone == StatementKind::Else && self.is_else_if(tokens) {
            self.report_else_if(tokens);
            return StatementKind::Broken(Shape::ElseIf);
        }
        if let ([word, next, ..], [.., last], Some(name), false) =
            (tokens, tokens, lone.shape().keyword(), reported)
        {
            let fault = not_alone(name, word.span, next.span.to(last.span));
            let counts = self.source.slice(next.span).parse::<f64>().is_ok();
            self.report(match name {
                Keyword::Repeat if counts => fault.help(Suggestion::CountTimes),
                _ => fault,
            });
        }
        match lone {
            // The word was meant to close another block.
            StatementKind::Wend if !reported => StatementKind::Broken(Shape::Wend),
            // Its closer may be on the same line.
            StatementKind::Repeat => StatementKind::Broken(Shape::Repeat),
            lone => lone,
        }
    }

    /// Adds a NEXT for each name of `NEXT I, J`, which closes both loops.
    pub(in crate::parse) fn push_each_next(&mut self, tokens: &[Token], span: Span) {
        let mut start = span.start;
        for name in &tokens[1..] {
            let part = Span::new(start, name.span.end);
            self.push(StatementKind::Broken(Shape::Next), part);
            start = name.span.end;
        }
    }

    /// Returns true if the part of the first word before a foreign character is no word of the language. Returns false
    /// for a foreign sign, which may be that of an equation.
    pub(in crate::parse) fn is_unknown(&self, word: Span, foreign: Span) -> bool {
        let first = self.source.slice(foreign).chars().next();
        if first.is_some_and(is_sign) {
            return false;
        }
        let before = self
            .source
            .slice(Span::new(word.start, foreign.start.max(word.start)));
        let is_end = |c: char| !(c.is_ascii_alphanumeric() || c == '_' || c == '.');
        let (name, rest) = before.split_at(before.find(is_end).unwrap_or(before.len()));
        !name.is_empty()
            && !rest.is_empty()
            && (word.end < foreign.start || rest.starts_with('('))
            && (commands::find(name).is_none() || rest.starts_with('('))
    }

    /// Returns true if more than one name follows a word, and nothing else.
    pub(in crate::parse) fn names_several(&self, tokens: &[Token]) -> bool {
        let is_name = |token: &Token| {
            let word = self.source.slice(token.span);
            let starts = word.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_');
            starts && keywords::find(word, self.module.edition).is_none()
        };
        tokens.len() > 2 && tokens[1..].iter().all(is_name)
    }

    /// Returns true if the statement before is an IF without its THEN, which is reported.
    pub(in crate::parse) fn follows_broken_if(&self) -> bool {
        let before = self.module.statements.last();
        before.is_some_and(|it| it.kind == StatementKind::Broken(Shape::If))
    }

    /// Returns true for a block on one line: `WHILE !KB_HIT WEND`.
    pub(in crate::parse) fn closes_itself(&self, kind: &StatementKind, tokens: &[Token]) -> bool {
        let closer = match kind.shape() {
            Shape::While => Keyword::Wend,
            Shape::For => Keyword::Next,
            _ => return false,
        };
        let is_closer = |token: &Token| closer.is(self.source.slice(token.span));
        tokens.iter().any(is_closer)
    }
}

/// Returns the role of a statement that begins, or was meant to begin, with `keyword`.
pub(in crate::parse) fn shape(keyword: Option<Keyword>, text: &str, tokens: &[Token]) -> Shape {
    match keyword {
        Some(Keyword::If) if has_statement_after_then(text, tokens) => Shape::OneLineIf,
        Some(Keyword::If) if !opens_block(text, tokens) => Shape::Plain,
        keyword => keyword.and_then(Shape::of).unwrap_or(Shape::Plain),
    }
}

/// Returns true for `IF … THEN` with its statement on the same line.
fn has_statement_after_then(text: &str, tokens: &[Token]) -> bool {
    let then = tokens.iter().position(|it| is(text, it, Keyword::Then));
    then.is_some_and(|at| at + 1 < tokens.len())
}

fn is(text: &str, token: &Token, keyword: Keyword) -> bool {
    keyword.is(&text[token.span.start..token.span.end])
}

/// Returns true if an IF opens a block: it contains THEN, or nothing in it looks like a jump.
fn opens_block(text: &str, tokens: &[Token]) -> bool {
    let jumps = |token: &Token| {
        token.kind == Kind::Colon
            || [Keyword::Goto, Keyword::Gosub, Keyword::Call]
                .iter()
                .any(|word| is(text, token, *word))
    };
    tokens.iter().any(|token| is(text, token, Keyword::Then)) || !tokens.iter().any(jumps)
}

/// Reports ELSE, ENDIF, WEND or REPEAT on one line with something else.
pub(in crate::parse) fn not_alone(name: Keyword, location: Span, other: Span) -> Diagnostic {
    let reason = Parsing::NotAlone { word: name.into() };
    Diagnostic::new(Code::Format, location, reason)
        .label(other, Parsing::WantsOwnLine)
        .help(Parsing::LabelBeforeCommentBehind)
}
