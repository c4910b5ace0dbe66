//! One statement: which family it is of.

use super::comment::is_comment;
use super::control::Read;
use super::declaration::declared_kind;
use super::line::{is_sign, not_alone};
use super::reader::{Broken, Fault, Reader};
use super::{Flow, Parser, condition, equation};
use crate::code::Code;
use crate::language::{Keyword, commands, keywords};
use crate::lex::{Kind, Token, lex};
use crate::message::Suggestion;
use crate::source::Span;
use crate::syntax::{Shape, StatementKind};

/// Beginning of a statement.
#[derive(Clone, Copy)]
struct First {
    keyword: Option<Keyword>,
    word: Span,
    /// A brace or colon that opens a block was taken off its end.
    is_opened: bool,
}

impl Parser<'_> {
    /// Reads the statement at `span`, whose first word is `word` (empty before an operator).
    ///
    /// A text may go on up to `text_end`, where `comment` begins if there is one.
    pub(super) fn statement(
        &mut self,
        word: Span,
        span: Span,
        text_end: usize,
        comment: Option<Span>,
    ) -> Flow {
        let (mut word, mut span) = (word, span);
        while let Some(name) = self.ends_with_wide_colon(word) {
            match self.wide_label(name, word, span) {
                Some(rest) => (word, span) = rest,
                None => return Flow::Continue,
            }
        }
        match keywords::find(self.source.slice(word), self.module.edition) {
            Some(Keyword::End) => {
                self.push(StatementKind::End, word);
                self.module.after_end = self.word_after(word, span);
                return Flow::End;
            }
            Some(keyword @ (Keyword::Message | Keyword::FileMessage)) => {
                self.message(keyword, word, text_end, comment);
            }
            Some(Keyword::Rem) => self.push(StatementKind::Rem, span),
            None if is_comment(self.source.slice(span)) => {
                self.foreign_comment(span);
                return Flow::NextLine;
            }
            None if self.is_end_with_dot(word) => {
                self.end_with_dot(word);
                return Flow::End;
            }
            None if self.narrow_keyword(word) == Some(Keyword::End) => {
                self.report_foreign(word);
                self.push(StatementKind::End, word);
                return Flow::End;
            }
            Some(Keyword::For) if self.is_for_of_c(word, span) => return self.for_of_c(span),
            keyword => self.words(keyword, word, span),
        }
        Flow::Continue
    }

    /// Reads a statement that is made of words.
    fn words(&mut self, keyword: Option<Keyword>, word: Span, span: Span) {
        let mut tokens = std::mem::take(&mut self.tokens);
        tokens.clear();
        let foreign = lex(self.text, span, &mut tokens);
        // Of a statement whose first word is unknown the characters after it do not matter.
        let foreign = foreign.filter(|foreign| {
            keyword.is_some()
                || equation::looks_like_one(&tokens)
                || !self.is_unknown(word, *foreign)
        });
        if let Some(foreign) = foreign {
            self.report_foreign(foreign);
        }
        let keyword = keyword.or_else(|| self.narrow_keyword(word).filter(|_| foreign.is_some()));
        let before = self.diagnostics.mark();
        let opening = self.take_brace(keyword, &mut tokens);
        let first = First {
            keyword,
            word,
            is_opened: opening.is_some(),
        };
        let kind = self.kind(first, &tokens, foreign.is_some());
        let kind = match opening {
            Some(opening) => self.opened_block(word, opening, before, kind),
            None => kind,
        };
        if let StatementKind::Subroutine { name, .. }
        | StatementKind::Thread { name, .. }
        | StatementKind::Constant { name, .. } = &kind
        {
            self.check_name_length(name);
        }
        // `NEXT I, J` was to close both.
        if matches!(kind, StatementKind::Next { .. }) && self.names_several(&tokens) {
            let mut start = span.start;
            for name in &tokens[1..] {
                let part = Span::new(start, name.span.end);
                self.push(StatementKind::Broken(Shape::Next), part);
                start = name.span.end;
            }
        } else {
            self.push(kind, span);
        }
        self.tokens = tokens;
    }

    /// Returns true if a first word is none of the language, as far as it is plain, and such a character follows it. A
    /// wide sign may be that of an equation.
    fn is_unknown(&self, word: Span, foreign: Span) -> bool {
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
    fn names_several(&self, tokens: &[Token]) -> bool {
        let is_name = |token: &Token| {
            let word = self.source.slice(token.span);
            let starts = word.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_');
            starts && keywords::find(word, self.module.edition).is_none()
        };
        tokens.len() > 2 && tokens[1..].iter().all(is_name)
    }

    fn kind(&mut self, first: First, tokens: &[Token], reported: bool) -> StatementKind {
        let First { keyword, word, .. } = first;
        match keyword {
            Some(Keyword::Else) if self.is_else_if(tokens) => {
                self.report_else_if(tokens);
                return StatementKind::Broken(Shape::ElseIf);
            }
            Some(keyword @ (Keyword::Else | Keyword::EndIf | Keyword::Wend | Keyword::Repeat)) => {
                let is_alone = self.check_alone(keyword, tokens, reported);
                return match keyword {
                    Keyword::Else => StatementKind::Else,
                    Keyword::EndIf => StatementKind::EndIf,
                    // `WEND KB_HIT` was to close another block.
                    Keyword::Wend if !is_alone && !reported => StatementKind::Broken(Shape::Wend),
                    Keyword::Wend => StatementKind::Wend,
                    // What closes it may stand on its line.
                    _ if !is_alone => StatementKind::Broken(Shape::Repeat),
                    _ => StatementKind::Repeat,
                };
            }
            Some(Keyword::Then) if self.follows_broken_if() => {
                return StatementKind::Broken(Shape::Plain);
            }
            _ => {}
        }
        if let Some(kind) = keyword.and_then(declared_kind)
            && !equation::looks_like_one(tokens)
        {
            return self.define(kind, word, tokens, reported);
        }
        if reported && keyword == Some(Keyword::Subroutine) {
            return self.broken_subroutine(word, tokens);
        }
        if reported || self.names_hyphened(tokens) {
            return StatementKind::Broken(shape(keyword, self.text, tokens));
        }
        if equation::looks_like_one(tokens) {
            return match equation::equation(self.text, tokens, self.module.edition) {
                Ok(equation) => StatementKind::Equation(Box::new(equation)),
                Err(fault) => {
                    self.report(*fault.diagnostic);
                    StatementKind::Broken(Shape::Plain)
                }
            };
        }
        let read = keyword.and_then(|keyword| self.control(keyword, word, tokens));
        if let Some(Err(fault) | Ok((_, Err(fault)))) = &read
            && let Some(tokens) = condition::with_intended_relation(fault, tokens)
        {
            self.report((*fault.diagnostic).clone());
            let first = First {
                is_opened: false,
                ..first
            };
            return self.kind(first, &tokens, reported);
        }
        match read {
            Some(Ok((kind, Ok(())))) => kind,
            Some(Ok((kind, Err(fault)))) => {
                self.report_broken(first, fault);
                match self.closes_itself(&kind, tokens) {
                    true => StatementKind::Broken(Shape::Plain),
                    false => kind,
                }
            }
            Some(Err(fault)) => {
                self.report_broken(first, fault);
                StatementKind::Broken(shape(keyword, self.text, tokens))
            }
            None => self
                .unknown(word, tokens)
                .unwrap_or_else(|| self.command(word, tokens)),
        }
    }

    /// Reports a fault of a statement. A brace or colon that opens its block stands for a THEN, and is reported itself.
    fn report_broken(&mut self, first: First, fault: Fault) {
        if !first.is_opened || fault.broken != Broken::Then {
            self.report(*fault.diagnostic);
        }
    }

    /// Reports what follows a word that must be alone on its line.
    fn check_alone(&mut self, keyword: Keyword, tokens: &[Token], reported: bool) -> bool {
        if let ([word, next, ..], [.., last], false) = (tokens, tokens, reported) {
            let fault = not_alone(keyword, word.span, next.span.to(last.span));
            let counts = self.source.slice(next.span).parse::<f64>().is_ok();
            self.report(match keyword {
                Keyword::Repeat if counts => fault.help(Suggestion::CountTimes),
                _ => fault,
            });
        }
        tokens.len() == 1
    }

    /// Returns true if the statement before is an IF without its THEN, which is reported.
    fn follows_broken_if(&self) -> bool {
        let before = self.module.statements.last();
        before.is_some_and(|it| it.kind == StatementKind::Broken(Shape::If))
    }

    /// `WHILE !KB_HIT WEND`: a block on one line.
    fn closes_itself(&self, kind: &StatementKind, tokens: &[Token]) -> bool {
        let closer = match kind.shape() {
            Shape::While => Keyword::Wend,
            Shape::For => Keyword::Next,
            _ => return false,
        };
        let is_closer = |token: &Token| closer.is(self.source.slice(token.span));
        tokens.iter().any(is_closer)
    }

    fn control(&self, keyword: Keyword, word: Span, tokens: &[Token]) -> Option<Read> {
        let mut reader = Reader::new(self.text, tokens, 1, Code::Argument, self.module.edition);
        Some(match keyword {
            Keyword::If => reader.if_statement(word),
            Keyword::ElseIf => reader.else_if(word),
            Keyword::While => reader.while_statement(word),
            Keyword::Until => reader.until(word),
            Keyword::For => reader.for_statement(word),
            Keyword::Next => reader.next_statement(word),
            Keyword::Subroutine | Keyword::Thread => reader.routine(keyword, word),
            Keyword::ThreadEnd => reader.alone(keyword, StatementKind::ThreadEnd),
            Keyword::StartThread => reader.call(word, keyword, StatementKind::StartThread),
            Keyword::StopThread => reader.call(word, keyword, StatementKind::StopThread),
            Keyword::WaitThread => reader.call(word, keyword, StatementKind::WaitThread),
            Keyword::Define => reader.constant(word),
            Keyword::SubEnd => reader.alone(keyword, StatementKind::SubEnd),
            Keyword::Call => reader.call(word, keyword, StatementKind::Call),
            Keyword::Gosub => reader.call(word, keyword, StatementKind::Gosub),
            Keyword::Goto => reader.goto_statement(word),
            Keyword::Return => reader.alone(keyword, StatementKind::Return),
            Keyword::Exit => reader.alone(keyword, StatementKind::Exit),
            // The others start no statement, or are read elsewhere.
            _ => return None,
        })
    }
}

/// Returns the shape of a statement that starts with `keyword`.
pub(super) fn shape(keyword: Option<Keyword>, text: &str, tokens: &[Token]) -> Shape {
    let Some(keyword) = keyword else {
        return Shape::Plain;
    };
    match keyword {
        Keyword::If if has_statement_after_then(text, tokens) => Shape::OneLineIf,
        Keyword::If if opens_block(text, tokens) => Shape::If,
        Keyword::ElseIf => Shape::ElseIf,
        Keyword::While => Shape::While,
        Keyword::Until => Shape::Until,
        Keyword::For => Shape::For,
        Keyword::Next => Shape::Next,
        Keyword::Subroutine => Shape::Subroutine,
        Keyword::SubEnd => Shape::SubEnd,
        Keyword::Thread => Shape::Thread,
        Keyword::ThreadEnd => Shape::ThreadEnd,
        // ELSE, ENDIF, WEND and REPEAT keep their meaning whatever follows them: they are never broken.
        _ => Shape::Plain,
    }
}

/// Returns the shape of a statement that was meant to begin with `keyword`.
pub(super) fn intended_shape(keyword: Keyword, text: &str, tokens: &[Token]) -> Shape {
    match keyword {
        Keyword::Else => Shape::Else,
        Keyword::EndIf => Shape::EndIf,
        Keyword::Wend => Shape::Wend,
        Keyword::Repeat => Shape::Repeat,
        keyword => shape(Some(keyword), text, tokens),
    }
}

/// `IF … THEN` with its statement on the same line.
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
