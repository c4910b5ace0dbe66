//! Steps that no path leads to.

use super::flow::{Flow, NodeId};
use crate::program::{Action, Program, StepId};

/// The steps that no path from the start leads to, in order. Each branch of the steps `open`, which have to be in order,
/// counts as taken, even if constants decide otherwise.
pub(crate) fn dead(program: &Program, flow: &Flow, open: &[StepId]) -> Vec<StepId> {
    let mut is_live = vec![false; flow.nodes().len()];
    let mut next = vec![0];
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

/// Where a step with two branches leads.
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
        | Action::Message { .. } => flow.first(step + 1),
    };
    [flow.first(step + 1), other]
}
