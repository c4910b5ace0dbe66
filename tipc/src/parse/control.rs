//! Control structure: IF, ELSEIF, WHILE, UNTIL, FOR, NEXT, SUBROUTINE, THREAD, DEFINE, jumps and their labels
//! (T.I.P. 3.1 §7-6, §7-7).
//!
//! ```text
//! IF condition THEN               IF condition GOTO NAME:        IF condition GOSUB NAME:
//! ELSEIF condition THEN           WHILE condition                UNTIL condition
//! FOR variable = a TO b           FOR variable = a TO b STEP c   NEXT [variable]
//! SUBROUTINE NAME:                THREAD NAME:                   DEFINE NAME value
//! GOTO [NAME:]                    GOSUB NAME:                    CALL NAME:
//! ```
//!
//! [`recover::control`](super::recover::control) words the diagnostic of anything else.

use super::reader::{Fault, Parsed, Reader};
use super::recover::control::written;
use crate::language::Keyword;
use crate::lex::{Kind, Token};
use crate::message::phrase::End;
use crate::message::{Parsing, Suggestion};
use crate::source::Span;
use crate::syntax::{Condition, Counting, Jump, Operand, OperandKind, StatementKind, Then, Word};

/// A statement with the fault of the text after it, if there is one; or the fault of the statement.
pub(super) type Read = Parsed<(StatementKind, Parsed<()>)>;

impl Reader<'_> {
    /// Reads `IF condition THEN`, `IF condition GOTO NAME:` or `IF condition GOSUB NAME:`.
    pub(super) fn if_statement(&mut self, keyword: Span) -> Read {
        let condition = Box::new(self.condition()?);
        let (then, end) = self.then()?;
        let kind = StatementKind::If {
            keyword,
            condition,
            then,
        };
        Ok((kind, end))
    }

    fn then(&mut self) -> Parsed<(Then, Parsed<()>)> {
        if self.take_word(Keyword::Then).is_some() {
            return match self.left() {
                0 => Ok((Then::Block, Ok(()))),
                _ => self.statement_after_then(),
            };
        }
        if let Some(keyword) = self.take_word(Keyword::Goto) {
            let (jump, colon) = self.goto(keyword)?;
            let end = colon.and_then(|()| self.end_of_jump(Keyword::Goto));
            return Ok((Then::Goto(jump), end));
        }
        if let Some(keyword) = self.take_word(Keyword::Gosub) {
            let (jump, colon) = self.jump(keyword, Keyword::Gosub)?;
            let end = colon.and_then(|()| self.end_of_jump(Keyword::Gosub));
            return Ok((Then::Gosub(jump), end));
        }
        Err(self.missing_then())
    }

    /// Checks that nothing follows the jump of an IF.
    fn end_of_jump(&self, jump: Keyword) -> Parsed<()> {
        match self.behind_jump(jump) {
            Some(fault) => Err(fault),
            None => self.expect_end(End::Label),
        }
    }

    /// Reads `ELSEIF condition THEN`.
    pub(super) fn else_if(&mut self, keyword: Span) -> Read {
        let condition = Box::new(self.condition()?);
        let end = match self.take_word(Keyword::Then) {
            Some(_) => self.expect_end(End::Word {
                word: Keyword::Then.into(),
            }),
            None => Err(self.missing_then_of_else_if()),
        };
        Ok((StatementKind::ElseIf { keyword, condition }, end))
    }

    /// Reads `WHILE condition`.
    pub(super) fn while_statement(&mut self, keyword: Span) -> Read {
        let condition = Box::new(self.last_condition()?);
        let end = self.end_of_condition();
        Ok((StatementKind::While { keyword, condition }, end))
    }

    /// Reads `UNTIL condition`.
    pub(super) fn until(&mut self, keyword: Span) -> Read {
        let condition = Box::new(self.last_condition()?);
        let end = self.end_of_condition();
        Ok((StatementKind::Until { keyword, condition }, end))
    }

    /// Reads a condition after which nothing may stand. `INPOS ALL` is reported as a flag in two words.
    fn last_condition(&mut self) -> Parsed<Condition> {
        let condition = self.condition()?;
        match self.half_a_flag() {
            Some(fault) => Err(fault),
            None => Ok(condition),
        }
    }

    fn end_of_condition(&self) -> Parsed<()> {
        match self.joined().or_else(|| self.opened()) {
            Some(fault) => Err(fault),
            None => self.expect_end(End::Condition),
        }
    }

    /// Reads `FOR variable = a TO b` or `FOR variable = a TO b STEP c`.
    pub(super) fn for_statement(&mut self, keyword: Span) -> Read {
        let variable = self.loop_variable()?;
        self.expect_assignment()?;
        let from = self.operand_before_keyword().map_err(as_in_for)?;
        if self.take_word(Keyword::To).is_none() {
            return Err(self.missing_to());
        }
        let to = self.operand_before_keyword().map_err(as_in_for)?;
        let step = match self.take_word(Keyword::Step) {
            Some(_) => Some(self.operand_before_keyword().map_err(as_in_for)?),
            None => None,
        };
        let end = match self.left() {
            0 => Ok(()),
            _ => Err(self.behind_for()),
        };
        let kind = StatementKind::For {
            keyword,
            counting: Box::new(Counting {
                variable,
                from,
                to,
                step,
            }),
        };
        Ok((kind, end))
    }

    fn loop_variable(&mut self) -> Parsed<Operand> {
        let operand = self.operand_before_keyword()?;
        match operand.kind {
            OperandKind::Name(_) | OperandKind::Member(_) if !operand.negative => Ok(operand),
            _ => Err(self.fault_with_help(
                operand.span,
                Parsing::VariableBelongsHere,
                Parsing::WriteFor,
            )),
        }
    }

    fn expect_assignment(&mut self) -> Parsed<()> {
        match self.peek() {
            Some(Token {
                kind: Kind::Assign(None),
                ..
            }) => {
                self.take();
                Ok(())
            }
            _ => Err(self.fault_with_help(
                self.here(),
                Parsing::AssignmentBelongsHere,
                Parsing::WriteFor,
            )),
        }
    }

    /// Reads `NEXT` or `NEXT variable`.
    pub(super) fn next_statement(&mut self, keyword: Span) -> Read {
        let variable = match self.left() {
            0 => None,
            _ => Some(self.loop_variable_of_next()?),
        };
        let end = self.expect_end_or(End::NextAndVariable, self.next_help(keyword));
        Ok((StatementKind::Next { keyword, variable }, end))
    }

    fn loop_variable_of_next(&mut self) -> Parsed<Operand> {
        let operand = self.operand()?;
        match operand.kind {
            OperandKind::Name(_) | OperandKind::Member(_) if !operand.negative => Ok(operand),
            _ => Err(self.fault(operand.span, Parsing::NextNamesItsVariable)),
        }
    }

    /// Reads `SUBROUTINE NAME:` or `THREAD NAME:`.
    pub(super) fn routine(&mut self, word: Keyword, keyword: Span) -> Read {
        let name = self.declared_name(written(word, "NAME".into()))?;
        let (name, end) = match self.peek() {
            Some(token) if token.kind == Kind::Colon => {
                self.take();
                let end = self.expect_end_or(routine_and_name(word), Suggestion::NoValues);
                (name, end)
            }
            _ => self.routine_without_colon(word, name),
        };
        let kind = match word {
            Keyword::Thread => StatementKind::Thread { keyword, name },
            _ => StatementKind::Subroutine { keyword, name },
        };
        Ok((kind, end))
    }

    /// Reads `DEFINE NAME value`.
    pub(super) fn constant(&mut self, keyword: Span) -> Read {
        let help = Parsing::WriteDefine;
        let name = self.declared_name(help.clone())?;
        let value = self
            .operand()
            .map_err(|fault| fault.or_help(help.clone()))?;
        let end = self.expect_end_or(End::DefineAndValue, help);
        let kind = StatementKind::Constant {
            keyword,
            name,
            value,
        };
        Ok((kind, end))
    }

    /// Reads the name that a statement declares; `help` is its form.
    fn declared_name(&mut self, help: Parsing) -> Parsed<Word> {
        match self.take() {
            Some(token) if token.kind == Kind::Word => Ok(self.word(token.span)),
            Some(token) => Err(self.fault_with_help(token.span, Parsing::NameBelongsHere, help)),
            None => Err(self.fault_with_help(self.here(), Parsing::NameMissing, help)),
        }
    }

    /// Reads `CALL NAME:` or `GOSUB NAME:`.
    pub(super) fn call(
        &mut self,
        keyword: Span,
        name: Keyword,
        make: fn(Jump) -> StatementKind,
    ) -> Read {
        let (jump, colon) = self.jump(keyword, name)?;
        let end = colon.and_then(|()| match name {
            Keyword::Call => self.expect_end_or(End::Label, Suggestion::NoValues),
            _ => self.expect_end(End::Label),
        });
        Ok((make(jump), end))
    }

    /// Reads `GOTO` or `GOTO NAME:`.
    pub(super) fn goto_statement(&mut self, keyword: Span) -> Read {
        let (jump, colon) = self.goto(keyword)?;
        let end = colon.and_then(|()| self.expect_end(End::Label));
        Ok((StatementKind::Goto(jump), end))
    }

    /// Reads a word that is alone in its statement.
    pub(super) fn alone(&mut self, name: Keyword, kind: StatementKind) -> Read {
        let end = self.expect_end(End::Word { word: name.into() });
        let end = end.map_err(|fault| match self.alone_help(name) {
            Some(help) => fault.help(help),
            None => fault,
        });
        Ok((kind, end))
    }
}

fn routine_and_name(word: Keyword) -> End {
    match word {
        Keyword::Thread => End::ThreadAndName,
        _ => End::SubroutineAndName,
    }
}

/// Adds the form of FOR to the fault of an operand.
fn as_in_for(fault: Fault) -> Fault {
    fault.or_help(Parsing::WriteFor)
}

impl Reader<'_> {
    /// Reads the optional `NAME:` after GOTO.
    pub(super) fn goto(&mut self, keyword: Span) -> Parsed<(Jump, Parsed<()>)> {
        if self.left() == 0 {
            let jump = Jump {
                keyword,
                label: None,
                broken: false,
            };
            return Ok((jump, Ok(())));
        }
        self.jump(keyword, Keyword::Goto)
    }

    /// Reads `NAME:` after GOSUB or CALL. A name without its colon is reported and still used.
    pub(super) fn jump(&mut self, keyword: Span, name: Keyword) -> Parsed<(Jump, Parsed<()>)> {
        let (label, colon) = self.jump_label(name)?;
        let jump = Jump {
            keyword,
            label: Some(label),
            broken: colon.is_err(),
        };
        Ok((jump, colon))
    }

    /// Reads a label, with the fault of its colon if there is one.
    fn jump_label(&mut self, jump: Keyword) -> Parsed<(Word, Parsed<()>)> {
        if let Some(fault) = self.marked_label_of_jump() {
            return Err(fault);
        }
        let help = Parsing::WriteJump { jump: jump.into() };
        let word = match self.take() {
            Some(token) if token.kind == Kind::Word => self.word(token.span),
            Some(token) => {
                return Err(self.fault_with_help(token.span, Parsing::LabelBelongsHere, help));
            }
            None => return Err(self.fault_with_help(self.here(), Parsing::LabelMissing, help)),
        };
        if let Some(fault) = self.label_in_pieces_of_jump(word.span) {
            return Err(fault);
        }
        match self.peek() {
            Some(token) if token.kind == Kind::Colon && !token.spaced => {
                self.take();
                Ok((word, Ok(())))
            }
            next => self.label_without_colon(word, next),
        }
    }
}
