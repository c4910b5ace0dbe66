//! Loops that nothing ends once they turn.

use super::access::{assigns, reads};
use super::flow::{Flow, NodeId};
use super::walk::{Into, Walk};
use crate::program::{Action, Condition, Program, StepId};
use std::collections::BTreeSet;

/// The steps with a condition that ends a loop, in order, where nothing in the loop changes a variable of the condition.
/// Nothing else ends such a loop either: no jump, RETURN, END or EXIT. What a flag says may change at any time. A loop that
/// does nothing is left out: whoever runs the program may assign the variable that it waits for.
pub(crate) fn stuck(program: &Program, flow: &Flow) -> Vec<StepId> {
    let mut walk = Walk::new(flow);
    let steps = (0..).zip(program.steps());
    let loops =
        steps.filter_map(|(step, content)| Some((step, turn(flow, step, &content.action)?)));
    loops
        .filter(|(step, turn)| is_stuck(program, flow, &mut walk, *step, *turn) == Some(true))
        .map(|(step, _)| step)
        .collect()
}

/// Where a loop goes on to turn, if a step decides that by comparing variables.
fn turn(flow: &Flow, step: StepId, action: &Action) -> Option<NodeId> {
    let (condition, turn) = match action {
        Action::While { condition, .. } => (condition, step + 1),
        Action::Until { condition, back } => (condition, *back),
        Action::IfGoto { condition, to } if *to <= step => (condition, *to),
        _ => return None,
    };
    matches!(condition, Condition::Compare { .. }).then(|| flow.first(turn))
}

/// Whether the loop cannot end; `None` if it is too large to say.
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
    Some(!compared.is_empty() && acts && own.contains(&end) && !returns && !ends && !changes)
}
