//! What the operands of every statement stand for.

use super::names::{Meant, Names};
use super::usage::Usage;
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::message::Message;
use crate::program::{self, Action, Condition, Scalar, VariableId};
use crate::robot::Robot;
use crate::source::Source;
use crate::syntax::{Counting, Module, Operand, Span, Statement, StatementKind};

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

/// Resolves every statement.
pub(crate) fn statements(
    source: &Source,
    module: &Module,
    robot: Robot,
    names: &Names,
    found: &mut Vec<Diagnostic>,
) -> (Vec<Resolved>, Usage) {
    let mut resolver = Resolver {
        robot,
        names,
        source,
        usage: Usage::new(names.variables.len()),
        found,
    };
    let resolved = module
        .statements
        .iter()
        .enumerate()
        .map(|(index, statement)| {
            resolver.usage.enter(index);
            let resolved = resolver.statement(statement);
            if resolved == Some(Resolved::Failed) || resolved.is_none() {
                resolver.excuse(source.slice(statement.span));
            }
            resolved.unwrap_or(Resolved::Failed)
        })
        .collect();
    (resolved, resolver.usage)
}

/// One pass over the statements. Its methods answer `None` once they have reported why.
pub(super) struct Resolver<'a> {
    pub(super) robot: Robot,
    pub(super) names: &'a Names,
    source: &'a Source,
    pub(super) usage: Usage,
    pub(super) found: &'a mut Vec<Diagnostic>,
}

impl Resolver<'_> {
    fn statement(&mut self, statement: &Statement) -> Option<Resolved> {
        match &statement.kind {
            StatementKind::Equation(equation) => self.equation(equation).map(Resolved::Action),
            StatementKind::If { condition, .. }
            | StatementKind::ElseIf { condition, .. }
            | StatementKind::While { condition, .. }
            | StatementKind::Until { condition, .. } => {
                self.condition(condition).map(Resolved::Condition)
            }
            StatementKind::For { counting, .. } => self.counting(counting),
            StatementKind::Next { variable, .. } => match variable {
                Some(variable) => self.loop_variable(variable).map(|_| Resolved::Plain),
                None => Some(Resolved::Plain),
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
            StatementKind::Define { .. }
            | StatementKind::Label(_)
            | StatementKind::Else
            | StatementKind::EndIf
            | StatementKind::Wend
            | StatementKind::Repeat
            | StatementKind::Subroutine { .. }
            | StatementKind::SubEnd
            | StatementKind::Call(_)
            | StatementKind::Goto(_)
            | StatementKind::Gosub(_)
            | StatementKind::Return
            | StatementKind::End
            | StatementKind::Exit
            | StatementKind::Rem => Some(Resolved::Plain),
        }
    }

    fn counting(&mut self, counting: &Counting) -> Option<Resolved> {
        let counter = self.loop_variable(&counting.variable);
        let from = self.number(&counting.from, Code::Argument);
        let to = self.number(&counting.to, Code::Argument);
        let step = match &counting.step {
            Some(step) => self.for_step(step),
            None => Some(program::Operand::Constant(1.0)),
        };
        let counter = counter?;
        self.usage.assign(counter.variable);
        self.usage.read(counter.variable, counting.variable.span);
        Some(Resolved::For {
            variable: counter,
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

    fn loop_variable(&mut self, operand: &Operand) -> Option<Scalar> {
        match self.meant(operand, Code::Argument)? {
            Meant::Scalar {
                scalar,
                member: false,
                ..
            } => Some(scalar),
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
        self.read(meant, operand.span);
        if let Some(number) = meant.number() {
            return Some(number);
        }
        let reason = "a struct stands where one number belongs";
        let fault = Diagnostic::new(shape, operand.span, reason);
        self.report(fault.help("name a member, as `P.X` or `Q.J2`"));
        None
    }

    /// Notes that the statement reads what an operand stands for.
    pub(super) fn read(&mut self, meant: Meant, place: Span) {
        match meant {
            Meant::Constant(_) => {}
            Meant::Scalar { scalar, .. } => self.usage.read(scalar.variable, place),
            Meant::Struct { variable, .. } => self.usage.read(variable, place),
        }
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

    /// Lets the pass over the use of variables say nothing of those that a broken statement names.
    fn excuse(&mut self, text: &str) {
        let is_name = |char: char| char.is_ascii_alphanumeric() || char == '_';
        for word in text.split(|char| !is_name(char)) {
            let id: Option<VariableId> = self.names.find(&word.to_ascii_uppercase());
            if let Some(id) = id {
                self.usage.excuse(id);
            }
        }
    }
}
