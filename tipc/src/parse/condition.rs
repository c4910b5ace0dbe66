//! Conditions of IF, ELSEIF, WHILE and UNTIL (T.I.P. 3.1 §6).
//!
//! ```text
//! condition = operand relation operand | FLAG | "!" FLAG
//! ```
//!
//! [`recover::condition`](super::recover::condition) words the diagnostic of anything else.

use super::reader::{Fault, Parsed, Reader};
use crate::lex::{Kind, Token};
use crate::message::Parsing;
use crate::source::Span;
use crate::syntax::{Condition, Operand, OperandKind, Relation, Word};

impl Reader<'_> {
    /// Reads `a REL b`, `FLAG` or `!FLAG`.
    pub(super) fn condition(&mut self) -> Parsed<Condition> {
        match self.peek() {
            None => Err(self.missing_condition()),
            Some(token) if token.kind == Kind::Not => {
                self.take();
                self.negated_flag(token)
            }
            Some(_) => {
                let left = self.operand_before_keyword().map_err(as_in_condition)?;
                self.comparison_or_flag(left)
            }
        }
    }

    /// Reads `FLAG` after its `!`.
    fn negated_flag(&mut self, not: Token) -> Parsed<Condition> {
        match self.peek() {
            Some(word) if self.is_negatable(word) => {
                self.take();
                Ok(Condition::Flag {
                    name: self.word(word.span),
                    negated: true,
                })
            }
            other => Err(self.negates_no_flag(not, other)),
        }
    }

    /// Returns true if a token is a name right after a `!`.
    fn is_negatable(&self, token: Token) -> bool {
        token.kind == Kind::Word && !token.spaced && !self.slice(token.span).starts_with('(')
    }

    /// Reads the rest of a condition after its first operand, which may be a flag.
    fn comparison_or_flag(&mut self, left: Operand) -> Parsed<Condition> {
        match self.peek() {
            Some(Token {
                kind: Kind::Relation(relation),
                span,
                ..
            }) => {
                self.take();
                self.comparison(left, relation, span)
            }
            Some(token) if token.kind != Kind::Word || self.calls_function(&left) => {
                Err(self.no_relation(&left, token))
            }
            _ => self.flag(left),
        }
    }

    /// Reads `b` of `a REL b`.
    fn comparison(&mut self, left: Operand, relation: Relation, sign: Span) -> Parsed<Condition> {
        if let Some(fault) = self.relation_in_pieces(relation, sign) {
            return Err(fault);
        }
        let right = self.operand_before_keyword().map_err(as_in_condition)?;
        match self.peek() {
            Some(token) if token.kind != Kind::Word => Err(self.behind_comparison(token)),
            _ => Ok(Condition::Compare {
                left,
                relation,
                right,
            }),
        }
    }

    /// Returns the condition of a flag.
    fn flag(&self, operand: Operand) -> Parsed<Condition> {
        match operand.kind {
            OperandKind::Name(name) if !operand.negative => Ok(Condition::Flag {
                name: Word {
                    node: name,
                    span: operand.span,
                },
                negated: false,
            }),
            _ => Err(self.compared_with_nothing(&operand)),
        }
    }
}

/// Adds the forms of conditions to the fault of an operand.
fn as_in_condition(fault: Fault) -> Fault {
    fault.or_help(Parsing::Conditions)
}
