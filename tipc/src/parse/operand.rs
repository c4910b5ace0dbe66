//! Operands, and commands with operands in a row (T.I.P. 3.1 §4).
//!
//! ```text
//! operand = ["+" | "-"] number | ["-"] name ["." member]
//! command = word {operand}
//! ```
//!
//! [`recover::operand`](super::recover::operand) words the diagnostic of anything else.

use super::Parser;
use super::reader::{Parsed, Reader};
use crate::code::Code;
use crate::language::Keyword;
use crate::lex::{Kind, Token};
use crate::message::{Parsing, Suggestion};
use crate::source::Span;
use crate::syntax::{Arithmetic, Operand, OperandKind, StatementKind, Word, upper_case};

/// Words that end an operand list in conditions and FOR; no variable has such a name.
pub(super) const STOPS: &[Keyword] = &[
    Keyword::Then,
    Keyword::Goto,
    Keyword::Gosub,
    Keyword::Call,
    Keyword::To,
    Keyword::Step,
];

impl Reader<'_> {
    /// Reads an operand with its sign.
    pub(super) fn operand(&mut self) -> Parsed<Operand> {
        match self.peek() {
            Some(Token {
                kind: Kind::Arithmetic(sign @ (Arithmetic::Add | Arithmetic::Sub)),
                span,
                ..
            }) => self.signed(sign, span),
            Some(token) if token.kind == Kind::Word => {
                self.take();
                self.value(token.span)
            }
            Some(token) => Err(self.no_operand(token)),
            None => Err(self.missing_operand()),
        }
    }

    /// Reads an operand of a condition or of FOR.
    pub(super) fn operand_before_keyword(&mut self) -> Parsed<Operand> {
        match STOPS.iter().find(|stop| self.at_word(**stop)) {
            Some(stop) => {
                let reason = Parsing::OperandMissingBefore {
                    word: (*stop).into(),
                };
                Err(self.fault(self.here(), reason))
            }
            None => self.operand(),
        }
    }

    /// Reads a sign right before a constant, or a minus right before a name.
    fn signed(&mut self, sign: Arithmetic, location: Span) -> Parsed<Operand> {
        let operand = match self.peek_second() {
            Some(word) if word.kind == Kind::Word && !word.spaced => word.span,
            next => return Err(self.sign_alone(location, next)),
        };
        self.take();
        self.take();
        let operand = self.value(operand)?;
        let span = location.to(operand.span);
        match (operand.kind, sign) {
            (OperandKind::Number(number), Arithmetic::Sub) => Ok(Operand {
                kind: OperandKind::Number(-number),
                negative: false,
                span,
            }),
            (kind @ OperandKind::Number(_), _) => Ok(Operand {
                kind,
                negative: false,
                span,
            }),
            (kind, Arithmetic::Sub) => Ok(Operand {
                kind,
                negative: true,
                span,
            }),
            _ => Err(self.fault_with_help(
                location,
                Parsing::PlusBeforeConstants,
                Parsing::LeavePlusOut,
            )),
        }
    }

    /// Reads a word as constant, name or member.
    pub(super) fn value(&self, span: Span) -> Parsed<Operand> {
        let word = self.slice(span);
        let kind = match word.as_bytes().first() {
            Some(b'0'..=b'9' | b'.') => OperandKind::Number(self.number(word, span)?),
            _ => self.name(word, span)?,
        };
        Ok(Operand {
            kind,
            negative: false,
            span,
        })
    }

    fn number(&self, word: &str, span: Span) -> Parsed<f64> {
        match word.parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(number),
            Ok(_) => {
                let reason = Parsing::ConstantTooLarge;
                Err(self.fault_with_help(span, reason, Suggestion::LargestNumber))
            }
            Err(_) => Err(self.no_number(word, span)),
        }
    }

    /// Reads `NAME` or `NAME.MEMBER`. The name of a special variable begins with `@`.
    fn name(&self, word: &str, span: Span) -> Parsed<OperandKind> {
        let sign = usize::from(self.is_reading(word));
        let (name, member) = match word.split_once('.') {
            Some((name, member)) => (name, Some(member)),
            None => (word, None),
        };
        let is_odd = |char: char| !is_name_char(char) && char != '.';
        if let Some(at) = word[sign..].find(is_odd).map(|at| sign + at) {
            let character = word[at..].chars().next().map_or(0, char::len_utf8);
            let start = span.start + at;
            return Err(self.foreign_in_name(word, Span::new(start, start + character)));
        }
        if member.is_some_and(|member| member.is_empty() || member.contains('.')) {
            let help = Parsing::Members;
            return Err(self.fault_with_help(span, Parsing::NoMember { word: word.into() }, help));
        }
        let name = upper_case(name);
        Ok(match member {
            Some(member) => OperandKind::Member(Box::new((name, upper_case(member)))),
            None => OperandKind::Name(name),
        })
    }
}

impl Reader<'_> {
    /// Reads operands up to the end. At the first bad one it stops, and returns those before it and the fault.
    ///
    /// After an operand a sign belongs to the next one and needs a delimiter before it.
    pub(super) fn operands(&mut self) -> (Vec<Operand>, Parsed<()>) {
        let mut operands = Vec::with_capacity(self.left());
        while let Some(token) = self.peek() {
            let is_sign = token.kind != Kind::Word;
            if is_sign && !token.spaced && !operands.is_empty() {
                return (operands, Err(self.glued(token)));
            }
            match self.operand() {
                Ok(operand) => operands.push(operand),
                Err(fault) => return (operands, Err(fault)),
            }
        }
        (operands, Ok(()))
    }
}

impl Parser<'_> {
    /// Reads a command word and its arguments. The parser does not look the command up: only the checker knows if it
    /// exists. A misspelt command is reported instead of its arguments, so the statement carries their fault to the
    /// checker.
    pub(super) fn command(&self, keyword: Span, tokens: &[Token]) -> StatementKind {
        let mut reader = Reader::new(self.text, tokens, 1, Code::Argument, self.module.edition);
        let (arguments, read) = reader.operands();
        StatementKind::Command {
            name: self.command_word(keyword, tokens),
            arguments,
            malformed: read.err().map(|fault| fault.diagnostic),
        }
    }

    /// Returns the command word; an operator in its place is shown as one.
    fn command_word(&self, keyword: Span, tokens: &[Token]) -> Word {
        let span = tokens.first().map(|token| token.span).unwrap_or_default();
        let node = match tokens.first() {
            Some(token) if token.kind != Kind::Word => self.source.slice(span).into(),
            _ => upper_case(self.source.slice(keyword)),
        };
        Word { node, span }
    }
}

fn is_name_char(char: char) -> bool {
    char.is_ascii_alphanumeric() || char == '_'
}
