//! Steps that no path leads to.

use super::LintContext;
use crate::message::Linting;
use std::collections::HashMap;
use tipc::analysis::flow::{Flow, NodeId};
use tipc::code::Code;
use tipc::diagnostic::{Diagnostic, Diagnostics};
use tipc::program::{Action, Program, StepId};
use tipc::syntax::StatementKind;

/// The steps that no path leads to, in order; what only a constant condition keeps from running is not among them.
pub(super) struct Unreachable(Vec<StepId>);

impl Unreachable {
    /// Creates each branch of the steps `open`, which have to be in order, counts as taken.
    pub(super) fn of(context: &LintContext<'_>, open: &[StepId]) -> Self {
        Unreachable(dead(context.program, context.flow, open))
    }

    pub(super) fn is_live(&self, step: StepId) -> bool {
        self.0.binary_search(&step).is_err()
    }

    /// Warns once of each run of steps that would do something. Silent about routines that nothing calls: a program may
    /// have more of them than it needs.
    pub(super) fn warn(&self, context: &LintContext<'_>, found: &mut Diagnostics) {
        if self.0.is_empty() {
            return;
        }
        let sources = sources(context.program);
        let is_subroutine = |step: StepId| {
            let statement = context.statement(step);
            statement.is_some_and(|it| matches!(it.kind, StatementKind::Subroutine { .. }))
        };
        let belongs = |before: &StepId, step: &StepId| before + 1 == *step && !is_subroutine(*step);
        for run in self.0.chunk_by(belongs) {
            found.extend(warning(context, run, &sources));
        }
    }
}

/// Returns the steps that jump to each step.
fn sources(program: &Program) -> HashMap<StepId, Vec<StepId>> {
    let mut sources: HashMap<StepId, Vec<StepId>> = HashMap::new();
    for (step, content) in (0..).zip(program.steps()) {
        if let Action::Goto { to }
        | Action::IfGoto { to, .. }
        | Action::Gosub { to }
        | Action::IfGosub { to, .. } = &content.action
        {
            sources.entry(*to).or_default().push(step);
        }
    }
    sources
}

fn warning(
    context: &LintContext<'_>,
    run: &[StepId],
    sources: &HashMap<StepId, Vec<StepId>>,
) -> Option<Diagnostic> {
    let actions = run
        .iter()
        .map(|step| &context.program.steps()[*step as usize].action);
    let is_routine = actions
        .clone()
        .any(|action| matches!(action, Action::Return));
    if !actions.clone().any(Action::acts) {
        return None;
    }
    let mut statements = run.iter().filter_map(|step| context.statement(*step));
    let start = statements.find(|statement| !closes(&statement.kind))?;
    if is_routine && start.kind.label().is_some() {
        return None;
    }
    let (first, last) = (*run.first()?, *run.last()?);
    // What other unreachable steps jump to follows from them.
    let mut jumps = sources.get(&start.step).into_iter().flatten();
    if jumps.any(|from| !(first..=last).contains(from)) {
        return None;
    }
    let (reason, help) = match start.kind.label() {
        Some((name, _)) => {
            let name = name.node.clone();
            (
                Linting::NothingJumps { name: name.clone() },
                Linting::JumpOrDelete { name },
            )
        }
        None => (Linting::NoPath, Linting::LabelOrDelete),
    };
    let diagnostic = Diagnostic::new(Code::Unreachable, start.keyword(), reason).help(help);
    let above = first
        .checked_sub(1)
        .and_then(|step| context.statement(step));
    Some(
        match above.filter(|above| !above.kind.goes_on() && !closes(&above.kind)) {
            Some(above) => diagnostic.label(above.span, Linting::LeadsElsewhere),
            None => diagnostic,
        },
    )
}

/// Returns true if a step only closes a block.
fn closes(kind: &StatementKind) -> bool {
    matches!(
        kind,
        StatementKind::Else
            | StatementKind::EndIf
            | StatementKind::Wend
            | StatementKind::Until { .. }
            | StatementKind::Next { .. }
            | StatementKind::SubEnd
            | StatementKind::ThreadEnd
    )
}

/// Returns the steps that no path from the start leads to, in order. Each branch of the steps `open`, which have to be
/// in order, counts as taken, even if constants decide otherwise.
fn dead(program: &Program, flow: &Flow, open: &[StepId]) -> Vec<StepId> {
    let mut is_live = vec![false; flow.nodes().len()];
    let mut next = flow.starts().to_vec();
    while let Some(id) = next.pop() {
        let Some(node) = flow.nodes().get(id) else {
            continue;
        };
        if std::mem::replace(&mut is_live[id], true) {
            continue;
        }
        let called = node.call.iter().flat_map(|call| [call.entry, call.back]);
        next.extend(node.next.iter().copied().chain(called));
        if open.binary_search(&node.step).is_ok() {
            let action = &program.steps()[node.step as usize].action;
            next.extend(branches(flow, node.step, action));
        }
    }
    let steps = 0..program.steps().len() as StepId;
    let is_dead = |step: &StepId| !is_live[flow.first(*step)] && !is_live[flow.last(*step)];
    steps.filter(is_dead).collect()
}

/// Returns the targets of a step with two branches.
fn branches(flow: &Flow, step: StepId, action: &Action) -> [NodeId; 2] {
    let other = match action {
        Action::If { otherwise, .. } | Action::ElseIf { otherwise, .. } => flow.last(*otherwise),
        Action::While { exit: to, .. }
        | Action::Until { back: to, .. }
        | Action::For { exit: to, .. }
        | Action::Next { body: to, .. }
        | Action::IfGoto { to, .. }
        | Action::IfGosub { to, .. } => flow.first(*to),
        Action::Nothing
        | Action::SetScalar { .. }
        | Action::SetStruct { .. }
        | Action::Else { .. }
        | Action::Goto { .. }
        | Action::Gosub { .. }
        | Action::Return
        | Action::Finish(_)
        | Action::Command { .. }
        | Action::TeachStruct { .. }
        | Action::TeachScalar { .. }
        | Action::AdIn { .. }
        | Action::KeyIn { .. }
        | Action::StartThread { .. }
        | Action::StopThread { .. }
        | Action::WaitThread { .. }
        | Action::ThreadEnd
        | Action::FileMessage { .. }
        | Action::Message { .. } => flow.first(step + 1),
    };
    [flow.first(step + 1), other]
}
