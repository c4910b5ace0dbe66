//! Steps that no path leads to.

use super::Judged;
use crate::analysis::dead::dead;
use crate::code::Code;
use crate::diagnostic::{Diagnostic, Findings};
use crate::message::Warning;
use crate::program::{Action, Program, StepId};
use crate::syntax::StatementKind;
use std::collections::HashMap;

/// The steps that no path leads to, in order; what only a constant condition keeps from running is not among them.
pub(super) struct Unreachable(Vec<StepId>);

impl Unreachable {
    /// Each branch of the steps `open`, which have to be in order, counts as taken.
    pub(super) fn of(judged: &Judged<'_>, open: &[StepId]) -> Self {
        Unreachable(dead(judged.program, judged.flow, open))
    }

    pub(super) fn is_live(&self, step: StepId) -> bool {
        self.0.binary_search(&step).is_err()
    }

    /// Warns once of each run of steps that would do something. Silent about routines that nothing calls: a program may
    /// have more of them than it needs.
    pub(super) fn warn(&self, judged: &Judged<'_>, found: &mut Findings) {
        if self.0.is_empty() {
            return;
        }
        let sources = sources(judged.program);
        let is_subroutine = |step: StepId| {
            let statement = judged.statement(step);
            statement.is_some_and(|it| matches!(it.kind, StatementKind::Subroutine { .. }))
        };
        let belongs = |before: &StepId, step: &StepId| before + 1 == *step && !is_subroutine(*step);
        for run in self.0.chunk_by(belongs) {
            found.extend(warning(judged, run, &sources));
        }
    }
}

/// The steps that jump to each step.
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
    judged: &Judged<'_>,
    run: &[StepId],
    sources: &HashMap<StepId, Vec<StepId>>,
) -> Option<Diagnostic> {
    let actions = run
        .iter()
        .map(|step| &judged.program.steps()[*step as usize].action);
    let is_routine = actions
        .clone()
        .any(|action| matches!(action, Action::Return));
    if !actions.clone().any(Action::acts) {
        return None;
    }
    let mut statements = run.iter().filter_map(|step| judged.statement(*step));
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
                Warning::NothingJumps { name: name.clone() },
                Warning::JumpOrDelete { name },
            )
        }
        None => (Warning::NoPath, Warning::LabelOrDelete),
    };
    let finding = Diagnostic::new(Code::Unreachable, start.keyword(), reason).help(help);
    let above = first.checked_sub(1).and_then(|step| judged.statement(step));
    Some(
        match above.filter(|above| !above.kind.goes_on() && !closes(&above.kind)) {
            Some(above) => finding.label(above.span, Warning::LeadsElsewhere),
            None => finding,
        },
    )
}

/// Whether a step only closes a block.
fn closes(kind: &StatementKind) -> bool {
    matches!(
        kind,
        StatementKind::Else
            | StatementKind::EndIf
            | StatementKind::Wend
            | StatementKind::Until { .. }
            | StatementKind::Next { .. }
            | StatementKind::SubEnd
    )
}
