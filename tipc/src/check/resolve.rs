//! The meaning of every statement: its operands resolved, and what it does.

use super::names::{Names, ResolvedOperand};
use super::structure::{Block, named_by};
use super::uses::{NameUses, Uses};
use super::{Known, jumps};
use crate::code::Code;
use crate::diagnostic::{Diagnostic, Diagnostics, Handle, Label, MistakeId};
use crate::language::Keyword;
use crate::lex::split_comment;
use crate::message::{Commanding, Message, Naming, Structuring, Suggestion};
use crate::program::{self, Action, End, Scalar, StepId, VariableId};
use crate::robot::Robot;
use crate::source::Span;
use crate::symbols::Access;
use crate::syntax::{
    self, Condition, Jump, LabelKind, Operand, OperandKind, Statement, StatementKind, Then,
    VariableKind, Word,
};
use std::collections::HashMap;

/// A statement of a module, by its index.
type StatementId = usize;

/// Reasons why a statement is not resolved.
enum Unresolved {
    /// The statement is wrong: the parser or this pass has reported it.
    Wrong,
    /// The statement that it belongs to is missing or broken: an earlier pass has reported that.
    Untied,
}

/// The diagnostic that tells why something is not resolved; `None` if the mistake is reported elsewhere.
pub(super) type Refused = Option<Handle>;

/// Counting of a FOR.
#[derive(Clone, Copy)]
struct Counting {
    variable: Scalar,
    from: program::Operand,
    to: program::Operand,
    /// 1 if the FOR names no other increment.
    step: program::Operand,
}

/// Returns the actions of all statements, or `None` if a statement cannot be resolved. A declaration has no action.
pub(super) fn statements(
    known: &Known<'_>,
    jumps: &jumps::Resolved,
    found: &mut Diagnostics,
) -> (Option<Vec<Option<Action>>>, NameUses) {
    let statements = &known.module.statements;
    let labels = known.labels.all.iter();
    let threads = labels.filter(|label| label.kind == LabelKind::Thread);
    let mut resolver = Resolver {
        robot: known.robot,
        names: known.names,
        known,
        jumps,
        threads: threads.map(|label| label.statement).collect(),
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
        let mark = resolver.found.mark();
        match (resolver.statement(index, statement), &mut all) {
            (Ok(action), Some(all)) => all.push(action),
            (Ok(_), None) => {}
            (Err(why), _) => {
                all = None;
                if let Unresolved::Wrong = why {
                    resolver.uses.suppress_named(known.source, statement.span);
                    resolver.uses.may_assign(&statement.kind);
                }
            }
        }
        if !resolver.found.since(mark).is_empty() {
            resolver.last_wrong = Some((index, mark));
        }
    }
    let Resolver {
        uses, flags, found, ..
    } = resolver;
    known.names.warn_of_flags(known.module, &flags, found);
    (all, uses.finish())
}

/// One pass over the statements. Methods that return `None` have reported the reason.
pub(super) struct Resolver<'a> {
    pub(super) robot: Robot,
    pub(super) names: &'a Names,
    known: &'a Known<'a>,
    jumps: &'a jumps::Resolved,
    /// The statements of THREAD.
    threads: Vec<StatementId>,
    pub(super) uses: Uses<'a>,
    /// Counter of each FOR.
    counted: HashMap<StatementId, Counting>,
    /// The statement that is being resolved.
    at: StatementId,
    /// The last earlier statement with a diagnostic, and its first diagnostic.
    last_wrong: Option<(StatementId, Handle)>,
    /// The variables with the name of a flag whose use an error explains, each with the location of that use.
    pub(super) flags: HashMap<VariableId, Span>,
    pub(super) found: &'a mut Diagnostics,
}

impl<'a> Resolver<'a> {
    fn statement(
        &mut self,
        index: StatementId,
        statement: &Statement,
    ) -> Result<Option<Action>, Unresolved> {
        Ok(Some(match &statement.kind {
            StatementKind::Define { names, .. } => {
                for name in names {
                    self.uses.declare(name);
                }
                if self.slice(statement.span).contains(['=', '#']) {
                    // A declaration with a value is reported. The value was meant as an assignment.
                    self.uses.suppress_named(self.known.source, statement.span);
                }
                return Ok(None);
            }
            StatementKind::Constant { name, value, .. } => {
                self.uses.define(name);
                if let OperandKind::Name(_) = &value.kind {
                    // Its value is evaluated already.
                    let constant = ResolvedOperand::Constant(0.0);
                    self.uses.operand(value, constant, Access::Read);
                }
                return Ok(None);
            }
            StatementKind::Label(name)
            | StatementKind::Subroutine { name, .. }
            | StatementKind::Thread { name, .. } => {
                self.uses.define_label(name, index);
                Action::Nothing
            }
            StatementKind::EndIf | StatementKind::Repeat | StatementKind::Rem => Action::Nothing,
            StatementKind::Equation(equation) => whole(self.equation(equation))?,
            StatementKind::If {
                condition, then, ..
            } => self.branch(index, condition, then)?,
            StatementKind::ElseIf { condition, .. } => Action::ElseIf {
                condition: whole(self.condition(condition))?,
                otherwise: self.partner_step(index)?,
            },
            StatementKind::Else => Action::Else {
                end: self.partner_step(index)?,
            },
            StatementKind::While { condition, .. } => Action::While {
                condition: whole(self.condition(condition))?,
                exit: self.partner_step(index)? + 1,
            },
            StatementKind::Wend => Action::Goto {
                to: self.partner_step(index)?,
            },
            StatementKind::Until { condition, .. } => Action::Until {
                condition: whole(self.condition(condition))?,
                back: self.partner_step(index)?,
            },
            StatementKind::For { counting, .. } => {
                let counting = whole(self.counting(counting))?;
                self.counted.insert(index, counting);
                let Counting {
                    variable,
                    from,
                    to,
                    step,
                } = counting;
                Action::For {
                    variable,
                    from,
                    to,
                    step,
                    exit: self.partner_step(index)? + 1,
                }
            }
            StatementKind::Next { keyword, variable } => {
                self.next(index, *keyword, variable.as_ref())?
            }
            StatementKind::ThreadEnd => Action::ThreadEnd,
            StatementKind::StartThread(jump) => Action::StartThread {
                thread: self.thread(index, jump, Access::Start)?,
            },
            StatementKind::StopThread(jump) => Action::StopThread {
                thread: self.thread(index, jump, Access::Control)?,
            },
            StatementKind::WaitThread(jump) => Action::WaitThread {
                thread: self.thread(index, jump, Access::Control)?,
            },
            StatementKind::Goto(jump) => Action::Goto {
                to: self.jump(index, jump, Access::Jump)?,
            },
            StatementKind::Call(jump) | StatementKind::Gosub(jump) => Action::Gosub {
                to: self.jump(index, jump, Access::Call)?,
            },
            StatementKind::SubEnd | StatementKind::Return => Action::Return,
            StatementKind::End => Action::Finish(End::End),
            StatementKind::Exit => Action::Finish(End::Exit),
            StatementKind::Message { text } => Action::Message {
                parts: whole(self.message(Keyword::Message, text.span))?,
            },
            StatementKind::FileMessage { text } => Action::FileMessage {
                parts: whole(self.message(Keyword::FileMessage, text.span))?,
            },
            StatementKind::Command {
                name,
                arguments,
                malformed,
            } => whole(self.command(name, arguments, malformed.as_deref()))?,
            StatementKind::Broken(_) => return Err(Unresolved::Wrong),
        }))
    }

    fn branch(
        &mut self,
        index: StatementId,
        condition: &Condition,
        then: &Then,
    ) -> Result<Action, Unresolved> {
        let condition = self.condition(condition);
        Ok(match then {
            Then::Block => Action::If {
                condition: whole(condition)?,
                otherwise: self.partner_step(index)?,
            },
            Then::Goto(jump) => {
                let to = self.jump(index, jump, Access::Jump);
                Action::IfGoto {
                    condition: whole(condition)?,
                    to: to?,
                }
            }
            Then::Gosub(jump) => {
                let to = self.jump(index, jump, Access::Call);
                Action::IfGosub {
                    condition: whole(condition)?,
                    to: to?,
                }
            }
        })
    }

    /// Resolves a NEXT; without a name it counts the variable of its FOR.
    fn next(
        &mut self,
        index: StatementId,
        keyword: Span,
        variable: Option<&Operand>,
    ) -> Result<Action, Unresolved> {
        let opener = self.partner(index);
        let counting = opener.as_ref().ok().and_then(|it| self.counted.get(it));
        let counting = counting.copied();
        match (variable, counting) {
            (Some(named), _) => {
                let variable = self.loop_variable(named, Access::Count);
                if let (Err(fault), Ok(opener)) = (variable, &opener) {
                    self.suggest_variable_of(*opener, fault);
                }
                whole(variable.ok())?;
            }
            (None, Some(Counting { variable, .. })) => {
                let left_out = Span::new(keyword.end, keyword.end);
                self.uses
                    .variable(left_out, variable.variable, Access::Count);
            }
            (None, None) => {}
        }
        let Counting {
            variable, to, step, ..
        } = counting.ok_or(Unresolved::Untied)?;
        Ok(Action::Next {
            variable,
            to,
            step,
            body: self.step(opener?) + 1,
        })
    }

    /// Suggests the variable of a FOR to a NEXT that names none.
    fn suggest_variable_of(&mut self, opener: StatementId, fault: Refused) {
        let StatementKind::For { counting, .. } = &self.known.module.statements[opener].kind else {
            return;
        };
        let variable = &counting.variable;
        let OperandKind::Name(name) = &variable.kind else {
            return;
        };
        if let Some(fault) = fault.and_then(|fault| self.found.get_mut(fault))
            && self.names.find(name).is_some()
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

    fn partner_step(&self, index: StatementId) -> Result<StepId, Unresolved> {
        Ok(self.step(self.partner(index)?))
    }

    fn step(&self, statement: StatementId) -> StepId {
        self.known.module.statements[statement].step
    }

    /// Resolves the step that a jump leads to.
    fn jump(
        &mut self,
        index: StatementId,
        jump: &Jump,
        access: Access,
    ) -> Result<StepId, Unresolved> {
        let to = self.target_of(index, jump, access)?;
        Ok(self.step(to))
    }

    /// Resolves the index of the thread that a statement names.
    fn thread(
        &mut self,
        index: StatementId,
        jump: &Jump,
        access: Access,
    ) -> Result<usize, Unresolved> {
        let opener = self.target_of(index, jump, access)?;
        Ok(self.threads.partition_point(|first| *first < opener))
    }

    fn target_of(
        &mut self,
        index: StatementId,
        jump: &Jump,
        access: Access,
    ) -> Result<StatementId, Unresolved> {
        self.uses.jump(index, jump, access);
        self.jumps.targets[index].ok_or(Unresolved::Untied)
    }

    fn counting(&mut self, counting: &syntax::Counting) -> Option<Counting> {
        let counter = self.loop_variable(&counting.variable, Access::Update);
        let from = self.number(&counting.from, Code::Argument);
        let to = self.number(&counting.to, Code::Argument);
        let step = match &counting.step {
            Some(step) => self.for_step(step),
            None => Some(program::Operand::Constant(1.0)),
        };
        Some(Counting {
            variable: counter.ok()?,
            from: from.ok()?,
            to: to.ok()?,
            step: step?,
        })
    }

    fn for_step(&mut self, step: &Operand) -> Option<program::Operand> {
        let number = self.number(step, Code::Argument).ok()?;
        if number == program::Operand::Constant(0.0) {
            let reason = Commanding::NeverEnds;
            let warning = Diagnostic::new(Code::OutOfRange, step.span, reason);
            self.report(warning.help(Commanding::CountOtherwise));
        }
        Some(number)
    }

    fn loop_variable(&mut self, operand: &Operand, access: Access) -> Result<Scalar, Refused> {
        let meant = self.resolve_operand_as(operand, Code::Argument, Some(VariableKind::Var))?;
        match meant {
            ResolvedOperand::Scalar {
                scalar,
                member: false,
                ..
            } => {
                self.uses.operand(operand, meant, access);
                Ok(scalar)
            }
            _ => {
                let fault = Diagnostic::new(Code::Argument, operand.span, Commanding::CountsVar);
                Err(self.report(fault.help(Commanding::CountVar)))
            }
        }
    }

    /// Resolves an operand that is used as a variable of this type.
    pub(super) fn resolve_operand_as(
        &mut self,
        operand: &Operand,
        mistake: Code,
        guess: Option<VariableKind>,
    ) -> Result<ResolvedOperand, Refused> {
        match self.names.operand(operand, mistake, guess) {
            Ok(meant) => meant.ok_or(None),
            Err(fault) => {
                let fault = match fault.code {
                    Code::UnknownVariable => self.unknown_variable(*fault),
                    _ => *fault,
                };
                Err(self.report(fault))
            }
        }
    }

    /// Explains an undeclared variable by a forgotten title, or adds its type to the help if this use is the first that
    /// shows it.
    fn unknown_variable(&mut self, fault: Diagnostic) -> Diagnostic {
        let name = fault.subject.clone().unwrap_or_default();
        let fault = self.known.title.declares(&name, fault);
        let is_open =
            |help: &Option<Message>| matches!(help, Some(Message::Naming(Naming::Declare { .. })));
        let is_typed = matches!(fault.help, Some(Message::Naming(Naming::DeclareAs { .. })));
        if let Some(mistake) = &fault.once
            && let Some(first) = self.found.of_mistake(mistake)
            && is_open(&first.help)
            && is_typed
        {
            first.help.clone_from(&fault.help);
        }
        fault
    }

    /// Adds the first word of this statement to the fault of the line before, if it goes on there: `PTP F1` and
    /// `391 201 -150` are one mistake.
    pub(super) fn add_to_line_before(&mut self, name: &Word) -> bool {
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

    /// Returns the block that the current, unknown statement was probably meant to close.
    pub(super) fn closes_here(&self) -> Option<Block> {
        let block = self.known.blocks.closed_by.get(&self.at)?;
        self.known.blocks.blocks.get(*block).copied()
    }

    /// Returns the jumps to the statement that is being resolved, if it is a label without its colon.
    pub(super) fn jumps_here(&self) -> Option<&[Span]> {
        self.jumps.bare.get(&self.at).map(Vec::as_slice)
    }

    /// Resolves a number that the statement reads. `mistake` is the code of a struct in its place.
    pub(super) fn number(
        &mut self,
        operand: &Operand,
        mistake: Code,
    ) -> Result<program::Operand, Refused> {
        let meant = self.resolve_operand_as(operand, mistake, Some(VariableKind::Var))?;
        self.uses.operand(operand, meant, Access::Read);
        if let Some(number) = meant.number() {
            return Ok(number);
        }
        let reason = Commanding::StructForNumber;
        let statement = self.known.module.statement_at(operand.span.start);
        let fault = Diagnostic::new(mistake, operand.span, reason);
        let fault = fault.once(MistakeId::StructForNumber(statement));
        Err(self.report(fault.help(Commanding::NameMember)))
    }

    /// Returns the location of the first word of a statement.
    pub(super) fn keyword_of(&self, statement: StatementId) -> Span {
        self.known.module.statements[statement].keyword()
    }

    /// Returns the text at a span.
    pub(super) fn slice(&self, span: Span) -> &'a str {
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

    /// Reports, and returns the diagnostic unless another one tells of the mistake.
    pub(super) fn report(&mut self, diagnostic: Diagnostic) -> Refused {
        self.found.push(diagnostic)
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

    /// Reports with a help, and answers that there is nothing.
    pub(super) fn refuse_with<T>(
        &mut self,
        code: Code,
        location: Span,
        reason: impl Into<Message>,
        help: impl Into<Message>,
    ) -> Option<T> {
        self.report(Diagnostic::new(code, location, reason).help(help));
        None
    }
}

/// Requires an operand to be resolved.
fn whole<T>(resolved: Option<T>) -> Result<T, Unresolved> {
    resolved.ok_or(Unresolved::Wrong)
}
