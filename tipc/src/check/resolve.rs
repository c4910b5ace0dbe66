//! Resolution of the operands of every statement.

use super::blocks::{Block, Blocks};
use super::jumps;
use super::labels::Labels;
use super::names::{Names, ResolvedOperand};
use super::resolved::{Counting, Resolved, StatementId};
use super::structure::named_by;
use super::title::Title;
use super::uses::{Named, Uses};
use crate::code::Code;
use crate::diagnostic::{Diagnostic, Diagnostics, Label};
use crate::language::Keyword;
use crate::lex::split_comment;
use crate::message::{Commanding, Message, Naming, Structuring, Suggestion};
use crate::program::{self, Scalar, VariableId};
use crate::robot::Robot;
use crate::source::{Source, Span};
use crate::symbols::Access;
use crate::syntax::{
    self, Condition, Jump, LabelKind, Module, Operand, OperandKind, Statement, StatementKind, Then,
    VariableKind, Word,
};
use std::collections::HashMap;

/// Results of earlier passes.
#[derive(Clone, Copy)]
pub(super) struct Known<'a> {
    pub(super) source: &'a Source,
    pub(super) module: &'a Module,
    pub(super) robot: Robot,
    pub(super) names: &'a Names,
    pub(super) labels: &'a Labels<'a>,
    pub(super) blocks: &'a Blocks,
    pub(super) jumps: &'a jumps::Resolved,
    pub(super) title: &'a Title,
}

/// Reasons why a statement is not resolved.
enum Unresolved {
    /// It is wrong in itself: reported when it was read, or here.
    Wrong,
    /// The statement that it belongs to is missing or broken: reported by the passes before.
    Untied,
}

/// Resolves every statement; all of them, or none if one cannot be.
pub(super) fn statements(
    known: &Known<'_>,
    found: &mut Diagnostics,
) -> (Option<Vec<Resolved>>, Named) {
    let statements = &known.module.statements;
    let mut resolver = Resolver {
        robot: known.robot,
        names: known.names,
        known,
        uses: Uses::new(known.names, known.labels),
        counted: HashMap::new(),
        at: 0,
        last_wrong: None,
        flags: HashMap::new(),
        found,
    };
    let mut all = Some(Vec::with_capacity(statements.len()));
    for (index, statement) in statements.iter().enumerate() {
        resolver.uses.enter();
        resolver.at = index;
        let told = resolver.found.len();
        match (resolver.statement(index, statement), &mut all) {
            (Ok(resolved), Some(all)) => all.push(resolved),
            (Ok(_), None) => {}
            (Err(why), _) => {
                all = None;
                if let Unresolved::Wrong = why {
                    resolver.uses.excuse(known.source, statement.span);
                    resolver.uses.may_assign(&statement.kind);
                }
            }
        }
        if resolver.found.len() > told {
            resolver.last_wrong = Some((index, told));
        }
    }
    let Resolver {
        uses, flags, found, ..
    } = resolver;
    known.names.warn_of_flags(known.module, &flags, found);
    (all, uses.finish())
}

/// One pass over the statements. Its methods answer `None` once they have reported why.
pub(super) struct Resolver<'a> {
    pub(super) robot: Robot,
    pub(super) names: &'a Names,
    known: &'a Known<'a>,
    pub(super) uses: Uses<'a>,
    /// Counter of each FOR.
    counted: HashMap<StatementId, Counting>,
    /// The statement that is being resolved.
    at: StatementId,
    /// The last statement before with a diagnostic, and the index of that.
    last_wrong: Option<(StatementId, usize)>,
    /// Variables with the name of a flag, and where a fault tells of each.
    pub(super) flags: HashMap<VariableId, Span>,
    pub(super) found: &'a mut Diagnostics,
}

impl Resolver<'_> {
    fn statement(
        &mut self,
        index: StatementId,
        statement: &Statement,
    ) -> Result<Resolved, Unresolved> {
        Ok(match &statement.kind {
            StatementKind::Define { names, .. } => {
                for name in names {
                    self.uses.declare(name);
                }
                if self.slice(statement.span).contains(['=', '#']) {
                    // A value in a declaration is reported; it was to assign the name.
                    self.uses.excuse(self.known.source, statement.span);
                }
                Resolved::Define
            }
            StatementKind::Constant { name, value, .. } => {
                self.uses.define(name);
                if let OperandKind::Name(_) = &value.kind {
                    // Its value is evaluated already.
                    let constant = ResolvedOperand::Constant(0.0);
                    self.uses.operand(value, constant, Access::Read);
                }
                Resolved::Define
            }
            StatementKind::Label(name) => {
                self.uses.define_label(name, index);
                Resolved::Label
            }
            StatementKind::Equation(equation) => {
                Resolved::Equation(whole(self.equation(equation))?)
            }
            StatementKind::If {
                condition, then, ..
            } => self.branch(index, condition, then)?,
            StatementKind::ElseIf { condition, .. } => {
                let condition = whole(self.condition(condition))?;
                Resolved::ElseIf(condition, self.partner(index)?)
            }
            StatementKind::Else => Resolved::Else(self.partner(index)?),
            StatementKind::EndIf => Resolved::EndIf,
            StatementKind::While { condition, .. } => {
                let condition = whole(self.condition(condition))?;
                Resolved::While(condition, self.partner(index)?)
            }
            StatementKind::Wend => Resolved::Wend(self.partner(index)?),
            StatementKind::Repeat => Resolved::Repeat,
            StatementKind::Until { condition, .. } => {
                let condition = whole(self.condition(condition))?;
                Resolved::Until(condition, self.partner(index)?)
            }
            StatementKind::For { counting, .. } => {
                let counting = whole(self.counting(counting))?;
                self.counted.insert(index, counting);
                Resolved::For(counting, self.partner(index)?)
            }
            StatementKind::Next { keyword, variable } => {
                self.next(index, *keyword, variable.as_ref())?
            }
            StatementKind::Subroutine { name, .. } => {
                self.uses.define_label(name, index);
                Resolved::Subroutine
            }
            StatementKind::SubEnd => Resolved::SubEnd,
            StatementKind::Thread { name, .. } => {
                self.uses.define_label(name, index);
                Resolved::Thread
            }
            StatementKind::ThreadEnd => Resolved::ThreadEnd,
            StatementKind::StartThread(jump) => {
                Resolved::StartThread(self.jump(index, jump, Access::Start)?)
            }
            StatementKind::StopThread(jump) => {
                Resolved::StopThread(self.jump(index, jump, Access::Control)?)
            }
            StatementKind::WaitThread(jump) => {
                Resolved::WaitThread(self.jump(index, jump, Access::Control)?)
            }
            StatementKind::Call(jump) => Resolved::Call(self.jump(index, jump, Access::Call)?),
            StatementKind::Goto(jump) => Resolved::Goto(self.jump(index, jump, Access::Jump)?),
            StatementKind::Gosub(jump) => Resolved::Gosub(self.jump(index, jump, Access::Call)?),
            StatementKind::Return => Resolved::Return,
            StatementKind::End => Resolved::End,
            StatementKind::Exit => Resolved::Exit,
            StatementKind::Rem => Resolved::Rem,
            StatementKind::Message { text } => {
                let shown = self.known.source.slice(text.span);
                Resolved::Message(whole(self.message(Keyword::Message, shown, text.span))?)
            }
            StatementKind::FileMessage { text } => {
                let written = self.known.source.slice(text.span);
                Resolved::FileMessage(whole(self.message(
                    Keyword::FileMessage,
                    written,
                    text.span,
                ))?)
            }
            StatementKind::Command {
                name,
                arguments,
                malformed,
            } => whole(self.command(name, arguments, malformed.as_deref()))?,
            StatementKind::Broken(_) => return Err(Unresolved::Wrong),
        })
    }

    fn branch(
        &mut self,
        index: StatementId,
        condition: &Condition,
        then: &Then,
    ) -> Result<Resolved, Unresolved> {
        let condition = self.condition(condition);
        Ok(match then {
            Then::Block => Resolved::If(whole(condition)?, self.partner(index)?),
            Then::Goto(jump) => {
                let to = self.jump(index, jump, Access::Jump);
                Resolved::IfGoto(whole(condition)?, to?)
            }
            Then::Gosub(jump) => {
                let to = self.jump(index, jump, Access::Call);
                Resolved::IfGosub(whole(condition)?, to?)
            }
        })
    }

    /// Resolves a NEXT; without a name it counts the variable of its FOR.
    fn next(
        &mut self,
        index: StatementId,
        keyword: Span,
        variable: Option<&Operand>,
    ) -> Result<Resolved, Unresolved> {
        let opener = self.partner(index);
        let counting = opener.as_ref().ok().and_then(|it| self.counted.get(it));
        let counting = counting.copied();
        match (variable, counting) {
            (Some(named), _) => {
                let told = self.found.len();
                let variable = self.loop_variable(named, Access::Count);
                if let (None, Ok(opener)) = (variable, &opener) {
                    self.suggest_variable_of(*opener, told);
                }
                whole(variable)?;
            }
            (None, Some(Counting { variable, .. })) => {
                let left_out = Span::new(keyword.end, keyword.end);
                self.uses
                    .variable(left_out, variable.variable, Access::Count);
            }
            (None, None) => {}
        }
        Ok(Resolved::Next(counting.ok_or(Unresolved::Untied)?, opener?))
    }

    /// Suggests the variable of a FOR to a NEXT that names none.
    fn suggest_variable_of(&mut self, opener: StatementId, told: usize) {
        let StatementKind::For { counting, .. } = &self.known.module.statements[opener].kind else {
            return;
        };
        let variable = &counting.variable;
        let OperandKind::Name(name) = &variable.kind else {
            return;
        };
        if let Some(fault) = self
            .found
            .get_mut(told)
            .filter(|_| self.names.find(name).is_some())
        {
            fault.point(variable.span, Structuring::VariableOfFor);
            fault.help = Some(named_by(name).into());
            fault.is_guess = false;
        }
    }

    /// Returns the statement that a control word is tied to.
    fn partner(&self, index: StatementId) -> Result<StatementId, Unresolved> {
        let link = self.known.blocks.links[index];
        link.partner.ok_or(Unresolved::Untied)
    }

    /// Resolves the statement that a jump leads to.
    fn jump(
        &mut self,
        index: StatementId,
        jump: &Jump,
        access: Access,
    ) -> Result<StatementId, Unresolved> {
        self.uses.jump(index, jump, access);
        self.known.jumps.targets[index].ok_or(Unresolved::Untied)
    }

    fn counting(&mut self, counting: &syntax::Counting) -> Option<Counting> {
        let counter = self.loop_variable(&counting.variable, Access::Update);
        let from = self.number(&counting.from, Code::Argument);
        let to = self.number(&counting.to, Code::Argument);
        let step = match &counting.step {
            Some(step) => self.for_step(step).map(Some),
            None => Some(None),
        };
        Some(Counting {
            variable: counter?,
            from: from?,
            to: to?,
            step: step?,
        })
    }

    fn for_step(&mut self, step: &Operand) -> Option<program::Operand> {
        let number = self.number(step, Code::Argument)?;
        if number == program::Operand::Constant(0.0) {
            let reason = Commanding::NeverEnds;
            let warning = Diagnostic::new(Code::OutOfRange, step.span, reason);
            self.report(warning.help(Commanding::CountOtherwise));
        }
        Some(number)
    }

    fn loop_variable(&mut self, operand: &Operand, access: Access) -> Option<Scalar> {
        let meant = self.resolve_operand_as(operand, Code::Argument, Some(VariableKind::Var))?;
        match meant {
            ResolvedOperand::Scalar {
                scalar,
                member: false,
                ..
            } => {
                self.uses.operand(operand, meant, access);
                Some(scalar)
            }
            _ => {
                let reason = Commanding::CountsVar;
                let fault = Diagnostic::new(Code::Argument, operand.span, reason);
                self.report(fault.help(Commanding::CountVar));
                None
            }
        }
    }

    /// Resolves an operand.
    pub(super) fn resolve_operand(
        &mut self,
        operand: &Operand,
        shape: Code,
    ) -> Option<ResolvedOperand> {
        self.resolve_operand_as(operand, shape, None)
    }

    /// Resolves an operand that is used as a variable of this type.
    pub(super) fn resolve_operand_as(
        &mut self,
        operand: &Operand,
        shape: Code,
        guess: Option<VariableKind>,
    ) -> Option<ResolvedOperand> {
        match self.names.operand(operand, shape, guess) {
            Ok(meant) => meant,
            Err(fault) => {
                let fault = match fault.code {
                    Code::UnknownVariable => self.unknown_variable(*fault),
                    _ => *fault,
                };
                self.report(fault);
                None
            }
        }
    }

    /// Blames the title for a variable that is not declared, or names its type, if this use is the first that tells.
    fn unknown_variable(&mut self, fault: Diagnostic) -> Diagnostic {
        let name = fault.subject.clone().unwrap_or_default();
        let fault = self.known.title.declares(&name, fault);
        let mistake = fault.once.as_deref().unwrap_or_default();
        let is_open =
            |help: &Option<Message>| matches!(help, Some(Message::Naming(Naming::Declare { .. })));
        let is_typed = matches!(fault.help, Some(Message::Naming(Naming::DeclareAs { .. })));
        if let Some(first) = self.found.of_mistake(mistake)
            && is_open(&first.help)
            && is_typed
        {
            first.help.clone_from(&fault.help);
        }
        fault
    }

    /// Adds the first word of this statement to the fault of the line before, if it goes on there: `PTP F1` and
    /// `391 201 -150` are one mistake.
    pub(super) fn goes_on(&mut self, name: &Word) -> bool {
        let starts = |c: char| c.is_ascii_digit() || c == '-';
        let Some((before, fault)) = self.last_wrong.filter(|_| name.node.starts_with(starts))
        else {
            return false;
        };
        let statements = &self.known.module.statements;
        let is_next =
            before + 1 == self.at && statements[before].line + 1 == statements[self.at].line;
        let breaks_off =
            |it: &&mut Diagnostic| matches!(it.code, Code::Argument | Code::UnknownVariable);
        let fault = self.found.get_mut(fault).filter(|_| is_next);
        let Some(fault) = fault.filter(breaks_off) else {
            return false;
        };
        let label = Label {
            span: name.span,
            text: Suggestion::GoesOnHere.into(),
        };
        fault.labels.push(label);
        fault.help = Some(Suggestion::OneLine.into());
        true
    }

    /// Returns the opener of the block that the unknown statement that is being resolved was to close.
    pub(super) fn closes_here(&self) -> Option<Block> {
        let block = self.known.blocks.closed_by.get(&self.at)?;
        self.known.blocks.blocks.get(*block).copied()
    }

    /// Returns the jumps to the statement that is being resolved, if it is a label without its colon.
    pub(super) fn jumps_here(&self) -> Option<&[Span]> {
        self.known.jumps.bare.get(&self.at).map(Vec::as_slice)
    }

    /// Resolves a number that the statement reads. `shape` is the code of a struct in its place.
    pub(super) fn number(&mut self, operand: &Operand, shape: Code) -> Option<program::Operand> {
        let meant = self.resolve_operand_as(operand, shape, Some(VariableKind::Var))?;
        self.uses.operand(operand, meant, Access::Read);
        if let Some(number) = meant.number() {
            return Some(number);
        }
        let reason = Commanding::StructForNumber;
        let statement = self.known.module.statement_at(operand.span.start);
        let fault = Diagnostic::new(shape, operand.span, reason);
        let fault = fault.once(format!("statement {statement:?}"));
        self.report(fault.help(Commanding::NameMember));
        None
    }

    /// Returns the location of the first word of a statement.
    pub(super) fn keyword_of(&self, statement: StatementId) -> Span {
        self.known.module.statements[statement].keyword()
    }

    /// Returns the text at a span.
    pub(super) fn slice(&self, span: Span) -> &str {
        self.known.source.slice(span)
    }

    /// Returns the rest of the statement after a location.
    pub(super) fn rest_of_statement(&self, span: Span) -> &str {
        let rest = &self.known.source.text()[span.end..];
        let end = rest.find([';', '\n', '\r']).unwrap_or(rest.len());
        let (code, _) = split_comment(rest, Span::new(0, end));
        &rest[..code.end]
    }

    /// Returns whether a label of that name is a SUBROUTINE, if there is one.
    pub(super) fn is_subroutine(&self, name: &str) -> Option<bool> {
        let label = self.known.labels.find(name)?;
        Some(self.known.labels.all[label].kind == LabelKind::Subroutine)
    }

    /// Returns the text before a location on its line.
    pub(super) fn source_before(&self, span: Span) -> Option<&str> {
        let start = self.known.source.start_of_line_at(span.start);
        self.known.source.text().get(start..span.start)
    }

    pub(super) fn report(&mut self, diagnostic: Diagnostic) {
        self.found.push(diagnostic);
    }

    /// Reports, and answers that there is nothing.
    pub(super) fn refuse<T>(
        &mut self,
        code: Code,
        location: Span,
        reason: impl Into<Message>,
    ) -> Option<T> {
        self.report(Diagnostic::new(code, location, reason));
        None
    }
}

/// Requires an operand to be resolved.
fn whole<T>(resolved: Option<T>) -> Result<T, Unresolved> {
    resolved.ok_or(Unresolved::Wrong)
}
