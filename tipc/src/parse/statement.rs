//! One statement: which family it is of.

use super::control::Read;
use super::line::not_alone;
use super::reader::Reader;
use super::shape::shape;
use super::{Flow, Parser, equation};
use crate::code::Code;
use crate::lex::{Kind, Token, foreign_run, lex};
use crate::message::Parsing;
use crate::syntax::{Shape, Span, StatementKind, VariableKind, Word, upper_case};
use smol_str::SmolStr;

impl Parser<'_> {
    /// Reads the statement at `span`, whose first word is `word` (empty before an operator).
    ///
    /// A text may go on up to `text_end`; `comment` stands there if one does.
    pub(super) fn statement(
        &mut self,
        word: Span,
        span: Span,
        text_end: usize,
        comment: Option<Span>,
    ) -> Flow {
        let keyword = upper_case(self.source.slice(word));
        match keyword.as_str() {
            "END" => {
                self.push(StatementKind::End, word);
                return Flow::End;
            }
            "MESSAGE" => self.message(word, text_end, comment),
            "REM" => self.push(StatementKind::Rem, span),
            _ => self.words(keyword, word, span),
        }
        Flow::Continue
    }

    /// A statement that is made of words.
    fn words(&mut self, keyword: SmolStr, word: Span, span: Span) {
        let mut tokens = std::mem::take(&mut self.tokens);
        tokens.clear();
        let foreign = lex(self.text, span, &mut tokens);
        if let Some(foreign) = foreign {
            self.report_foreign(foreign);
        }
        let kind = self.kind(keyword, word, &tokens, foreign.is_some());
        if let StatementKind::Subroutine { name, .. } = &kind {
            self.check_name_length(name);
        }
        self.push(kind, span);
        self.tokens = tokens;
    }

    fn kind(
        &mut self,
        keyword: SmolStr,
        word: Span,
        tokens: &[Token],
        reported: bool,
    ) -> StatementKind {
        if let Some(kind) = self.lone_statement(&keyword, tokens, reported) {
            return kind;
        }
        if let Some(kind) = variable_kind(&keyword).filter(|_| !equation::looks_like_one(tokens)) {
            return self.define(kind, word, tokens, reported);
        }
        if reported {
            return StatementKind::Broken(shape(&keyword, self.text, tokens));
        }
        if equation::looks_like_one(tokens) {
            return match equation::equation(self.text, tokens) {
                Ok(equation) => StatementKind::Equation(Box::new(equation)),
                Err(fault) => {
                    self.report(*fault);
                    StatementKind::Broken(Shape::Plain)
                }
            };
        }
        match self.control(&keyword, word, tokens) {
            Some(Ok((kind, Ok(())))) => kind,
            Some(Ok((kind, Err(fault)))) => {
                self.report(*fault);
                kind
            }
            Some(Err(fault)) => {
                self.report(*fault);
                StatementKind::Broken(shape(&keyword, self.text, tokens))
            }
            None => self.command(keyword, tokens),
        }
    }

    /// ELSE, ENDIF, WEND and REPEAT keep their meaning even if something stands behind them.
    fn lone_statement(
        &mut self,
        keyword: &str,
        tokens: &[Token],
        reported: bool,
    ) -> Option<StatementKind> {
        let kind = match keyword {
            "ELSE" => StatementKind::Else,
            "ENDIF" => StatementKind::EndIf,
            "WEND" => StatementKind::Wend,
            "REPEAT" => StatementKind::Repeat,
            _ => return None,
        };
        if let ([word, next, ..], [.., last], false) = (tokens, tokens, reported) {
            self.report(not_alone(keyword, word.span, next.span.to(last.span)));
        }
        Some(kind)
    }

    fn control(&self, keyword: &str, word: Span, tokens: &[Token]) -> Option<Read> {
        let mut reader = Reader::new(self.text, tokens, 1, Code::Argument);
        Some(match keyword {
            "IF" => reader.if_statement(word),
            "ELSEIF" => reader.else_if(word),
            "WHILE" => reader.while_statement(word),
            "UNTIL" => reader.until(word),
            "FOR" => reader.for_statement(word),
            "NEXT" => reader.next_statement(word),
            "SUBROUTINE" => reader.subroutine(word),
            "SUBEND" => reader.alone(keyword, StatementKind::SubEnd),
            "CALL" => reader.call(word, keyword, StatementKind::Call),
            "GOSUB" => reader.call(word, keyword, StatementKind::Gosub),
            "GOTO" => reader.goto_statement(word),
            "RETURN" => reader.alone(keyword, StatementKind::Return),
            "EXIT" => reader.alone(keyword, StatementKind::Exit),
            _ => return None,
        })
    }

    /// `DEF_… NAME NAME …`: the names as written; what is no word is reported.
    fn define(
        &mut self,
        kind: VariableKind,
        keyword: Span,
        tokens: &[Token],
        reported: bool,
    ) -> StatementKind {
        let reader = Reader::new(self.text, tokens, 0, Code::Argument);
        let is_word = |token: &&Token| token.kind == Kind::Word;
        if let Some(odd) = tokens
            .iter()
            .find(|token| !is_word(token))
            .filter(|_| !reported)
        {
            let reason = Parsing::OnlyNames;
            let help = Parsing::SeparateNames;
            self.report(*reader.fault_with_help(odd.span, reason, help));
        }
        let names: Vec<Word> = tokens[1..]
            .iter()
            .filter(|token| is_word(token) && foreign_run(self.text, token.span).is_none())
            .map(|token| reader.word(token.span))
            .collect();
        for name in &names {
            self.check_name_length(name);
        }
        StatementKind::Define {
            kind,
            keyword,
            names,
        }
    }
}

fn variable_kind(keyword: &str) -> Option<VariableKind> {
    match keyword {
        "DEF_VAR" => Some(VariableKind::Var),
        "DEF_POS" => Some(VariableKind::Pos),
        "DEF_JOINT" => Some(VariableKind::Joint),
        _ => None,
    }
}
