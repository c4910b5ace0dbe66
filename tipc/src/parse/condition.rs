//! Conditions of IF, ELSEIF, WHILE and UNTIL (T.I.P. 3.1 §6).

use super::reader::{Fault, Parsed, Reader};
use crate::lex::{Kind, Token};
use crate::syntax::{Condition, Operand, OperandKind, Relation, Word};

impl Reader<'_> {
    /// `a REL b`, `FLAG` or `!FLAG`.
    pub(super) fn condition(&mut self) -> Parsed<Condition> {
        if let Some(token) = self.peek().filter(|token| token.kind == Kind::Not) {
            self.take();
            return self.negated_flag(token);
        }
        if self.left() == 0 {
            return Err(self.fault_with_help(self.here(), "a condition is missing here", FORMS));
        }
        let left = self.operand_before_keyword()?;
        match self.peek() {
            Some(Token {
                kind: Kind::Relation(relation),
                ..
            }) => {
                self.take();
                self.comparison(left, relation)
            }
            Some(token) if token.kind != Kind::Word => Err(self.no_relation(token)),
            _ => self.flag(left),
        }
    }

    fn negated_flag(&mut self, not: Token) -> Parsed<Condition> {
        match self.peek() {
            Some(word) if word.kind == Kind::Word && !word.spaced => {
                self.take();
                Ok(Condition::Flag {
                    name: self.word(word.span),
                    negated: true,
                })
            }
            _ => Err(self.fault_with_help(
                not.span,
                "`!` stands right before an event flag, without a blank",
                FORMS,
            )),
        }
    }

    fn comparison(&mut self, left: Operand, relation: Relation) -> Parsed<Condition> {
        if let Some(token) = self.peek().filter(is_part_of_relation) {
            let reason = "no relation is written like this";
            return Err(self.fault_with_help(token.span, reason, RELATIONS));
        }
        let right = self.operand_before_keyword()?;
        match self.peek() {
            Some(token) if token.kind != Kind::Word => {
                let reason = format!("`{}` cannot stand here", self.slice(token.span));
                Err(self.fault_with_help(token.span, reason, FORMS))
            }
            _ => Ok(Condition::Compare {
                left,
                relation,
                right,
            }),
        }
    }

    fn no_relation(&self, token: Token) -> Fault {
        let reason = match token.kind {
            Kind::Assign(None) => "`=` assigns; it compares nothing",
            Kind::Arithmetic(_) => "a condition cannot calculate",
            _ => "a relation belongs here",
        };
        self.fault_with_help(token.span, reason, RELATIONS)
    }

    fn flag(&self, operand: Operand) -> Parsed<Condition> {
        let span = operand.span;
        match operand.kind {
            OperandKind::Name(name) if !operand.negative => Ok(Condition::Flag {
                name: Word { node: name, span },
                negated: false,
            }),
            _ => Err(self.fault_with_help(span, "this is compared with nothing", FORMS)),
        }
    }
}

const FORMS: &str = "a condition is a comparison of two numbers, as `A >= 5`, or an event flag, as `KB_HIT` or `!KB_HIT`";
const RELATIONS: &str = "the relations are `==` (equal), `<>` (not equal), `<`, `>`, `<=`, `>=`";

fn is_part_of_relation(token: &Token) -> bool {
    matches!(
        token.kind,
        Kind::Relation(_) | Kind::Assign(None) | Kind::Not
    )
}
