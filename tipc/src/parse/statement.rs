//! Choice of the reader of a statement.
//!
//! ```text
//! statement = END | MESSAGE text | F_MESSAGE text | REM text
//!           | ELSE | ENDIF | WEND | REPEAT | declaration | equation | control | command
//! ```

use super::control::Read;
use super::declaration::declared_kind;
use super::reader::{Broken, Fault, Reader};
use super::recover::condition::with_intended_relation;
use super::recover::statement::shape;
use super::{Flow, Parser, equation};
use crate::code::Code;
use crate::language::{Keyword, keywords};
use crate::lex::{Token, lex};
use crate::source::Span;
use crate::syntax::{Shape, StatementKind};

/// Beginning of a statement.
#[derive(Clone, Copy)]
struct First {
    keyword: Option<Keyword>,
    word: Span,
    /// True if a brace or colon that opens a block was removed from its end.
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
        let Some((word, span)) = self.behind_wide_labels(word, span) else {
            return Flow::Continue;
        };
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
            keyword => {
                if let Some(flow) = self.foreign_line(keyword, word, span) {
                    return flow;
                }
                self.words(keyword, word, span);
            }
        }
        Flow::Continue
    }

    /// Reads a statement that is made of words.
    fn words(&mut self, keyword: Option<Keyword>, word: Span, span: Span) {
        let mut tokens = std::mem::take(&mut self.tokens);
        tokens.clear();
        let foreign = lex(self.text, span, &mut tokens);
        // If the first word is unknown, foreign characters after it are not reported as well.
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
        match kind {
            StatementKind::Next { .. } if self.names_several(&tokens) => {
                self.push_each_next(&tokens, span);
            }
            kind => self.push(kind, span),
        }
        self.tokens = tokens;
    }

    /// Reads a statement whose first word is a keyword, if there is one. `reported` is true if foreign characters in it
    /// are reported.
    fn kind(&mut self, first: First, tokens: &[Token], reported: bool) -> StatementKind {
        let First { keyword, word, .. } = first;
        if let Some(lone) = keyword.and_then(lone_word) {
            return match tokens {
                [_] => lone,
                _ => self.behind_lone_word(lone, tokens, reported),
            };
        }
        if let Some(kind) = keyword.and_then(declared_kind)
            && !equation::looks_like_one(tokens)
        {
            return self.define(kind, word, tokens, reported);
        }
        if let Some(broken) = self.broken_statement(keyword, word, tokens, reported) {
            return broken;
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
            && let Some(tokens) = with_intended_relation(fault, tokens)
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

    /// Reports a fault of a statement. A brace or colon that opens its block takes the place of THEN: then only that is
    /// reported.
    fn report_broken(&mut self, first: First, fault: Fault) {
        if !first.is_opened || fault.broken != Broken::Then {
            self.report(*fault.diagnostic);
        }
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
            // Other keywords start no statement, or are read elsewhere.
            _ => return None,
        })
    }
}

/// Returns the statement of a word that is alone on its line: `ELSE`, `ENDIF`, `WEND`, `REPEAT`.
pub(super) fn lone_word(keyword: Keyword) -> Option<StatementKind> {
    Some(match keyword {
        Keyword::Else => StatementKind::Else,
        Keyword::EndIf => StatementKind::EndIf,
        Keyword::Wend => StatementKind::Wend,
        Keyword::Repeat => StatementKind::Repeat,
        _ => return None,
    })
}
