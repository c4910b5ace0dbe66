//! What the operands of every statement stand for.

use super::blocks::Blocks;
use super::labels::Labels;
use super::names::{Meant, Names};
use super::uses::{Named, Uses};
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::message::Message;
use crate::program::{self, Action, Condition, Scalar};
use crate::robot::Robot;
use crate::source::{Source, Span};
use crate::symbols::Access;
use crate::syntax::{Counting, Module, Operand, OperandKind, Statement, StatementKind, Then};

/// A statement with its operands resolved.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Resolved {
    /// Nothing to resolve.
    Plain,
    /// The whole action.
    Action(Action),
    /// The condition of a control word.
    Condition(Condition),
    /// The operands of FOR.
    For {
        variable: Scalar,
        from: program::Operand,
        to: program::Operand,
        step: program::Operand,
    },
    /// Reported; there will be no program.
    Failed,
}

/// What the passes before know.
#[derive(Clone, Copy)]
pub(super) struct Known<'a> {
    pub(super) source: &'a Source,
    pub(super) module: &'a Module,
    pub(super) robot: Robot,
    pub(super) names: &'a Names,
    pub(super) labels: &'a Labels<'a>,
    pub(super) blocks: &'a Blocks,
}

/// Resolves every statement.
pub(super) fn statements(known: &Known<'_>, found: &mut Vec<Diagnostic>) -> (Vec<Resolved>, Named) {
    let Known {
        source,
        module,
        robot,
        names,
        labels,
        blocks,
    } = *known;
    let mut resolver = Resolver {
        robot,
        names,
        module,
        blocks,
        source,
        uses: Uses::new(names, labels),
        found,
    };
    let resolved = module
        .statements
        .iter()
        .enumerate()
        .map(|(index, statement)| {
            resolver.uses.enter();
            let resolved = resolver.statement(index, statement);
            if resolved == Some(Resolved::Failed) || resolved.is_none() {
                resolver.uses.excuse(source, statement.span);
            }
            resolved.unwrap_or(Resolved::Failed)
        })
        .collect();
    (resolved, resolver.uses.finish())
}

/// One pass over the statements. Its methods answer `None` once they have reported why.
pub(super) struct Resolver<'a> {
    pub(super) robot: Robot,
    pub(super) names: &'a Names,
    module: &'a Module,
    blocks: &'a Blocks,
    source: &'a Source,
    pub(super) uses: Uses<'a>,
    pub(super) found: &'a mut Vec<Diagnostic>,
}

impl Resolver<'_> {
    fn statement(&mut self, index: usize, statement: &Statement) -> Option<Resolved> {
        match &statement.kind {
            StatementKind::Equation(equation) => self.equation(equation).map(Resolved::Action),
            StatementKind::If {
                condition, then, ..
            } => {
                let condition = self.condition(condition);
                match then {
                    Then::Block => {}
                    Then::Goto(jump) => self.uses.jump(index, jump, Access::Jump),
                    Then::Gosub(jump) => self.uses.jump(index, jump, Access::Call),
                }
                condition.map(Resolved::Condition)
            }
            StatementKind::ElseIf { condition, .. }
            | StatementKind::While { condition, .. }
            | StatementKind::Until { condition, .. } => {
                self.condition(condition).map(Resolved::Condition)
            }
            StatementKind::For { counting, .. } => self.counting(counting),
            StatementKind::Next { keyword, variable } => match variable {
                Some(variable) => {
                    let counter = self.loop_variable(variable, Access::Count);
                    counter.map(|_| Resolved::Plain)
                }
                None => {
                    self.count_unnamed(index, *keyword);
                    Some(Resolved::Plain)
                }
            },
            StatementKind::Message { text } => {
                let shown = self.source.slice(text.span);
                Some(Resolved::Action(self.message(shown, text.span)))
            }
            StatementKind::Command {
                name,
                arguments,
                malformed,
            } => self
                .command(name, arguments, malformed.as_deref())
                .map(Resolved::Action),
            StatementKind::Broken(_) => Some(Resolved::Failed),
            StatementKind::Define { names, .. } => {
                for name in names {
                    self.uses.declare(name);
                }
                Some(Resolved::Plain)
            }
            StatementKind::Label(name) | StatementKind::Subroutine { name, .. } => {
                self.uses.define_label(name, index);
                Some(Resolved::Plain)
            }
            StatementKind::Goto(jump) => {
                self.uses.jump(index, jump, Access::Jump);
                Some(Resolved::Plain)
            }
            StatementKind::Call(jump) | StatementKind::Gosub(jump) => {
                self.uses.jump(index, jump, Access::Call);
                Some(Resolved::Plain)
            }
            StatementKind::Else
            | StatementKind::EndIf
            | StatementKind::Wend
            | StatementKind::Repeat
            | StatementKind::SubEnd
            | StatementKind::Return
            | StatementKind::End
            | StatementKind::Exit
            | StatementKind::Rem => Some(Resolved::Plain),
        }
    }

    fn counting(&mut self, counting: &Counting) -> Option<Resolved> {
        let counter = self.loop_variable(&counting.variable, Access::Update);
        let from = self.number(&counting.from, Code::Argument);
        let to = self.number(&counting.to, Code::Argument);
        let step = match &counting.step {
            Some(step) => self.for_step(step),
            None => Some(program::Operand::Constant(1.0)),
        };
        Some(Resolved::For {
            variable: counter?,
            from: from?,
            to: to?,
            step: step?,
        })
    }

    fn for_step(&mut self, step: &Operand) -> Option<program::Operand> {
        let number = self.number(step, Code::Argument)?;
        if number == program::Operand::Constant(0.0) {
            let reason = "FOR never ends with a step of 0";
            let warning = Diagnostic::new(Code::OutOfRange, step.span, reason);
            self.report(warning.help("count by another number, or leave STEP out to count by 1"));
        }
        Some(number)
    }

    /// NEXT without a name counts the variable of its FOR.
    fn count_unnamed(&mut self, next: usize, keyword: Span) {
        let opener = self.blocks.links[next].partner;
        if let Some(opener) = opener
            && let StatementKind::For { counting, .. } = &self.module.statements[opener].kind
            && let OperandKind::Name(name) = &counting.variable.kind
            && let Some(variable) = self.names.find(name)
        {
            let left_out = Span::new(keyword.end, keyword.end);
            self.uses.variable(left_out, variable, Access::Count);
        }
    }

    fn loop_variable(&mut self, operand: &Operand, access: Access) -> Option<Scalar> {
        let meant = self.meant(operand, Code::Argument)?;
        match meant {
            Meant::Scalar {
                scalar,
                member: false,
                ..
            } => {
                self.uses.operand(operand, meant, access);
                Some(scalar)
            }
            _ => {
                let reason = "the variable of a FOR is a VAR";
                let fault = Diagnostic::new(Code::Argument, operand.span, reason);
                self.report(fault.help("count a VAR, as `FOR I = 1 TO 10`"));
                None
            }
        }
    }

    /// What an operand stands for.
    pub(super) fn meant(&mut self, operand: &Operand, shape: Code) -> Option<Meant> {
        match self.names.operand(operand, shape) {
            Ok(meant) => meant,
            Err(fault) => {
                self.report(*fault);
                None
            }
        }
    }

    /// A number that the statement reads. `shape` is the code of a struct in its place.
    pub(super) fn number(&mut self, operand: &Operand, shape: Code) -> Option<program::Operand> {
        let meant = self.meant(operand, shape)?;
        self.uses.operand(operand, meant, Access::Read);
        if let Some(number) = meant.number() {
            return Some(number);
        }
        let reason = "a struct stands where one number belongs";
        let fault = Diagnostic::new(shape, operand.span, reason);
        self.report(fault.help("name a member, as `P.X` or `Q.J2`"));
        None
    }

    pub(super) fn report(&mut self, diagnostic: Diagnostic) {
        self.found.push(diagnostic);
    }

    /// Reports, and answers that there is nothing.
    pub(super) fn refuse<T>(
        &mut self,
        code: Code,
        place: Span,
        reason: impl Into<Message>,
    ) -> Option<T> {
        self.report(Diagnostic::new(code, place, reason));
        None
    }
}
