//! Conditions whose outcome never changes, and loops that therefore never run, or never end (T.I.P. 3.1 §7-6).

use super::LintContext;
use super::unreachable::Unreachable;
use super::walk::{Into, Walk};
use crate::message::Linting;
use std::collections::BTreeSet;
use tipc::analysis::access::{assigns, reads};
use tipc::analysis::flow::{Entry, Flow, NodeId, always, enters};
use tipc::code::Code;
use tipc::diagnostic::{Diagnostic, Diagnostics};
use tipc::program::{Action, Condition, Operand, Program, StepId};
use tipc::source::Span;
use tipc::syntax::{Statement, StatementKind};

/// A step whose outcome is always the same.
#[derive(Clone, Copy, Debug)]
pub(super) struct Constant {
    pub(super) step: StepId,
    /// Presence of a warning about it.
    outcome: Outcome,
}

#[derive(Clone, Copy, Debug)]
enum Outcome {
    /// A condition.
    Is(bool),
    /// A FOR that runs its body not even once.
    Never,
    /// A count by 0, of which another warning speaks.
    Stops,
}

/// Returns the steps whose outcome is always the same, in order, but for endless loops: `WHILE 1 == 1` and `UNTIL 1 ==
/// 0` are meant so.
pub(super) fn constant(context: &LintContext<'_>) -> Vec<Constant> {
    let steps = (0..).zip(context.program.steps());
    let constant = |(step, content): (StepId, &tipc::program::Step)| {
        let outcome = outcome(&content.action)?;
        Some(Constant { step, outcome })
    };
    steps.filter_map(constant).collect()
}

fn outcome(action: &Action) -> Option<Outcome> {
    if let Action::For { from, to, step, .. } = action {
        return match enters(*from, *to, *step) {
            Entry::Known(false) => Some(Outcome::Never),
            Entry::Fails => Some(Outcome::Stops),
            Entry::Known(true) | Entry::Open => None,
        };
    }
    if let Action::Next {
        step: Operand::Constant(0.0),
        ..
    } = action
    {
        return Some(Outcome::Stops);
    }
    let is = settled(*action.condition()?)?;
    let is_endless = match action {
        Action::While { .. } => is,
        Action::Until { .. } => !is,
        _ => false,
    };
    (!is_endless).then_some(Outcome::Is(is))
}

/// Returns the constant result of a condition: two constants compared, or a variable with itself.
fn settled(condition: Condition) -> Option<bool> {
    use tipc::program::Relation::{Eq, Ge, Gt, Le, Lt, Ne};
    match condition {
        Condition::Compare {
            left: left @ Operand::Scalar { .. },
            relation,
            right,
        } if left == right => Some(match relation {
            Eq | Le | Ge => true,
            Ne | Lt | Gt => false,
        }),
        _ => always(condition),
    }
}

pub(super) fn warn(
    context: &LintContext<'_>,
    constant: &[Constant],
    unreachable: &Unreachable,
    found: &mut Diagnostics,
) {
    let deeds = Deeds::of(context.program);
    for Constant { step, outcome } in constant {
        let Some(statement) = context
            .statement(*step)
            .filter(|_| unreachable.is_live(*step))
        else {
            continue;
        };
        found.extend(match outcome {
            _ if !deeds.depend_on(context.program, *step) => None,
            Outcome::Is(is) => Some(always_so(statement, *is)),
            Outcome::Never => Some(never_runs(context.program, statement, *step)),
            Outcome::Stops => None,
        });
    }
    let location = |step: &StepId| constant.binary_search_by_key(step, |one| one.step);
    let is_judged = |step: &StepId| location(step).is_err();
    let stuck = stuck(context.program, context.flow)
        .into_iter()
        .filter(is_judged);
    for step in stuck.filter(|step| unreachable.is_live(*step)) {
        found.extend(context.statement(step).map(never_ends));
    }
}

/// For each step how many before it do something or go elsewhere.
struct Deeds(Vec<u32>);

impl Deeds {
    fn of(program: &Program) -> Self {
        let mut deeds = vec![0];
        let mut count = 0;
        for step in program.steps() {
            count += u32::from(step.action.acts() || leads_on(&step.action));
            deeds.push(count);
        }
        Deeds(deeds)
    }

    /// Returns true if something depends on a step: a block without any action is a sketch.
    fn depend_on(&self, program: &Program, step: StepId) -> bool {
        match &program.steps()[step as usize].action {
            Action::If { otherwise: end, .. }
            | Action::ElseIf { otherwise: end, .. }
            | Action::For { exit: end, .. } => {
                let before = |step: StepId| self.0.get(step as usize).or(self.0.last());
                before(step) < before(*end)
            }
            _ => true,
        }
    }
}

/// Returns true if a step in a block goes elsewhere.
fn leads_on(action: &Action) -> bool {
    matches!(
        action,
        Action::Goto { .. }
            | Action::IfGoto { .. }
            | Action::Gosub { .. }
            | Action::IfGosub { .. }
            | Action::Return
            | Action::Finish(_)
    )
}

fn always_so(statement: &Statement, is: bool) -> Diagnostic {
    let (reason, help) = match (&statement.kind, is) {
        (StatementKind::While { .. }, _) => (Linting::AlwaysFalse, Linting::NeverTurns),
        (StatementKind::Until { .. }, _) => (Linting::AlwaysTrue, Linting::TurnsOnce),
        (_, true) => (Linting::AlwaysTrue, Linting::CompareVariable),
        (_, false) => (Linting::AlwaysFalse, Linting::CompareVariable),
    };
    Diagnostic::new(Code::ConstantCondition, condition(statement), reason).help(help)
}

fn never_runs(program: &Program, statement: &Statement, step: StepId) -> Diagnostic {
    let action = &program.steps()[step as usize].action;
    let (reason, help) = match action {
        Action::For {
            from: Operand::Constant(from),
            to: Operand::Constant(to),
            step: Operand::Constant(step),
            ..
        } => {
            let (from, to, step) = (*from, *to, -*step);
            (Linting::BeyondEnd { from, to }, Linting::CountBack { step })
        }
        _ => return always_so(statement, false),
    };
    Diagnostic::new(Code::ForNever, statement.span, reason).help(help)
}

fn never_ends(statement: &Statement) -> Diagnostic {
    let location = condition(statement);
    Diagnostic::new(Code::EndlessLoop, location, Linting::NothingChanges)
        .help(Linting::ChangeOrLoop)
}

/// Returns the location of a condition.
pub(super) fn condition(statement: &Statement) -> Span {
    use tipc::syntax::Condition::{Compare, Flag};
    match &statement.kind {
        StatementKind::If { condition, .. }
        | StatementKind::ElseIf { condition, .. }
        | StatementKind::While { condition, .. }
        | StatementKind::Until { condition, .. } => match &**condition {
            Compare { left, right, .. } => left.span.to(right.span),
            Flag { name, .. } => name.span,
        },
        _ => statement.span,
    }
}

/// Returns the steps with a condition that ends a loop, in order, where nothing in the loop changes a variable of the
/// condition. Nothing else ends such a loop either: no jump, RETURN, END or EXIT. What a flag or a special variable says
/// may change at any time, and so may a variable that native code or another thread assigns. A loop that does nothing is left out: whoever runs the program may assign the variable that it waits for.
fn stuck(program: &Program, flow: &Flow) -> Vec<StepId> {
    if !program.threads().is_empty() {
        return Vec::new();
    }
    let mut walk = Walk::new(flow);
    let steps = (0..).zip(program.steps());
    let loops =
        steps.filter_map(|(step, content)| Some((step, turn(flow, step, &content.action)?)));
    loops
        .filter(|(step, turn)| is_stuck(program, flow, &mut walk, *step, *turn) == Some(true))
        .map(|(step, _)| step)
        .collect()
}

/// Returns the node where a loop goes on to turn, if a step decides that by comparing variables.
fn turn(flow: &Flow, step: StepId, action: &Action) -> Option<NodeId> {
    let (condition, turn) = match action {
        Action::While { condition, .. } => (condition, step + 1),
        Action::Until { condition, back } => (condition, *back),
        Action::IfGoto { condition, to } if *to <= step => (condition, *to),
        _ => return None,
    };
    let is_fixed = |operand: &Operand| !matches!(operand, Operand::Reading { .. });
    let compares = match condition {
        Condition::Compare { left, right, .. } => is_fixed(left) && is_fixed(right),
        Condition::Flag { .. } => false,
    };
    compares.then(|| flow.first(turn))
}

/// Returns whether the loop cannot end; `None` if it is too large to say.
fn is_stuck(
    program: &Program,
    flow: &Flow,
    walk: &mut Walk<'_>,
    step: StepId,
    turn: NodeId,
) -> Option<bool> {
    let mut compared = BTreeSet::new();
    let action = |id: NodeId| &program.steps()[flow.nodes()[id].step as usize].action;
    let end = flow.first(step);
    reads(program, action(end), |scalar| {
        compared.insert(scalar);
    });
    let own = walk.from(&[turn], Some(end), Into::Itself)?;
    let all = walk.from(&[turn], Some(end), Into::Calls)?;
    let returns = own.iter().any(|id| flow.nodes()[*id].returns);
    let ends = all
        .iter()
        .any(|id| matches!(action(*id), Action::Finish(_)));
    let changes = all
        .iter()
        .any(|id| assigns(program, action(*id)).any(|scalar| compared.contains(&scalar)));
    let acts = all.iter().any(|id| action(*id).acts());
    let variable = |scalar: &usize| &program.variables()[program.variable_of(*scalar)];
    let is_shared = compared
        .iter()
        .any(|scalar| variable(scalar).special.is_some());
    let changes = changes || is_shared;
    Some(!compared.is_empty() && acts && own.contains(&end) && !returns && !ends && !changes)
}
