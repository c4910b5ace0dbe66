//! Braces and colons that open and close blocks in other languages, and the FOR of C.

use crate::code::Code;
use crate::diagnostic::{Diagnostic, Handle};
use crate::language::{Keyword, keywords};
use crate::lex::{Kind, Token};
use crate::message::{Commanding, Parsing, Suggestion};
use crate::parse::{Flow, Parser};
use crate::source::Span;
use crate::syntax::{Shape, StatementKind};

const OPEN: &str = "{";
const CLOSE: &str = "}";

impl Parser<'_> {
    /// Removes the brace or colon that opens a block from the end of a statement, so that the words before it are read.
    pub(in crate::parse) fn take_brace(
        &self,
        keyword: Option<Keyword>,
        tokens: &mut Vec<Token>,
    ) -> Option<Token> {
        let last = *tokens.last().filter(|_| tokens.len() > 1)?;
        let opens = match last.kind {
            Kind::Word => self.source.slice(last.span) == OPEN,
            Kind::Colon => self.opens_with_colon(keyword?, tokens),
            _ => false,
        };
        opens.then(|| tokens.pop())?
    }

    /// Returns true for a colon after a condition or THEN, but not after the label of a jump.
    pub(in crate::parse) fn opens_with_colon(&self, keyword: Keyword, tokens: &[Token]) -> bool {
        let ends_condition = || match tokens {
            [.., before, last, _] => {
                let is_then = Keyword::Then.is(self.source.slice(last.span));
                is_then || tokens.len() == 3 || before.kind != Kind::Word
            }
            _ => false,
        };
        match keyword {
            Keyword::While | Keyword::Until | Keyword::For => true,
            Keyword::If | Keyword::ElseIf => ends_condition(),
            _ => false,
        }
    }

    /// Reports the brace or colon that opened the block of a statement, unless a fault of the statement is reported
    /// since `before`. Such a statement, and the end of its block, are not reported again.
    pub(in crate::parse) fn opened_block(
        &mut self,
        location: Span,
        opening: Token,
        before: Handle,
        kind: StatementKind,
    ) -> StatementKind {
        let word = self.source.slice(location);
        let (reason, help) = match opening.kind {
            Kind::Colon => (Suggestion::NoColon, Suggestion::WriteThen),
            // `} ELSE {` closes and opens a block; its first brace is reported.
            _ if word == CLOSE => return kind,
            // The whole statement is unknown: `SWITCH (A) {`.
            _ if !self.is_command(word) => {
                self.braces.push(!self.diagnostics.since(before).is_empty());
                return kind;
            }
            _ => {
                self.braces.push(true);
                (Suggestion::NoBraces, Suggestion::Braces)
            }
        };
        if self.diagnostics.since(before).is_empty() {
            let fault = Diagnostic::new(Code::Argument, opening.span, reason);
            self.report(fault.help(help));
        }
        match kind.shape() {
            Shape::Plain => kind,
            shape => StatementKind::Broken(shape),
        }
    }

    /// Reads a statement that begins with a brace.
    pub(in crate::parse) fn brace(
        &mut self,
        word: Span,
        tokens: &[Token],
    ) -> Option<StatementKind> {
        let shape = match self.source.slice(word) {
            OPEN if tokens.len() == 1 => self.lone_brace(word),
            CLOSE => {
                let next = tokens.get(1).map(|token| self.source.slice(token.span));
                let next = next.and_then(|next| keywords::find(next, self.module.edition));
                let begins_block = match (self.braces.pop(), next) {
                    (Some(begins_block), _) => begins_block,
                    // The block that this brace ends began without one.
                    (None, Some(Keyword::Else)) => {
                        let reason = Commanding::NoCommand { word: CLOSE.into() };
                        self.report_unknown(word, CLOSE, reason, Suggestion::Braces);
                        true
                    }
                    (None, _) => return None,
                };
                match next {
                    Some(Keyword::Else) => {
                        self.braces.push(true);
                        let is_else_if = self.is_else_if(&tokens[1..]);
                        if is_else_if {
                            Shape::ElseIf
                        } else {
                            Shape::Else
                        }
                    }
                    _ if begins_block => Shape::Close,
                    _ => Shape::Plain,
                }
            }
            _ => return None,
        };
        Some(StatementKind::Broken(shape))
    }

    /// Reads `{` on a line of its own. It belongs to the statement before it, if that opens a block.
    pub(in crate::parse) fn lone_brace(&mut self, word: Span) -> Shape {
        let before = self.module.statements.last().map(|it| &it.kind);
        let opens = |kind: &StatementKind| {
            matches!(
                kind.shape(),
                Shape::If | Shape::ElseIf | Shape::Else | Shape::While | Shape::For
            )
        };
        self.braces.push(before.is_some_and(opens));
        // A broken statement before it is reported already: an IF without THEN.
        if !matches!(before, Some(StatementKind::Broken(_))) {
            let reason = Commanding::NoCommand { word: OPEN.into() };
            self.report_unknown(word, OPEN, reason, Suggestion::Braces);
        }
        Shape::Plain
    }

    /// Reads and reports a line with a FOR of C: `FOR (I = 0; I < 3; I++)`.
    pub(in crate::parse) fn for_of_c(&mut self, span: Span) -> Flow {
        let statement = self.source.slice(span);
        let open = statement.find('(').unwrap_or_default();
        let location = Span::new(span.start + open, span.end);
        let line = Span::new(span.start, self.line.span.end);
        if self.source.slice(line).trim_end().ends_with(OPEN) {
            self.braces.push(true);
        }
        let fault = Diagnostic::new(Code::Argument, location, Suggestion::ForCounts);
        self.report(fault.help(Parsing::WriteFor));
        self.push(StatementKind::Broken(Shape::For), span);
        Flow::NextLine
    }

    /// Returns true if a FOR has the form of C.
    pub(in crate::parse) fn is_for_of_c(&self, word: Span, span: Span) -> bool {
        let rest = self.source.slice(Span::new(word.end, span.end));
        let line = self.source.slice(Span::new(span.end, self.line.span.end));
        rest.trim_start().starts_with('(') && line.trim_start().starts_with(';')
    }
}
