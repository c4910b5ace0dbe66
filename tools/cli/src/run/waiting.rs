//! What a statement waits for.

use crate::message::running::Until;
use tip_runtime::command::{Op, Target};
use tipc::program::Action;

/// What ends the wait of a step that may take several cycles.
pub(super) fn until(action: &Action) -> Option<Until> {
    match action {
        Action::KeyIn { .. } => Some(Until::Key),
        Action::Command { op, target, .. } => of_command(*op, *target),
        _ => None,
    }
}

fn of_command(op: Op, target: Target) -> Option<Until> {
    match op {
        Op::Sleep => Some(Until::Time),
        Op::WaitInpos => Some(Until::InPosition { target }),
        Op::WaitNear => Some(Until::Near { target }),
        Op::StandUp | Op::SitDown | Op::InitialPosture => Some(Until::Motion),
        Op::DetectFloor | Op::DetectObject => Some(Until::Touch),
        Op::Special => Some(Until::Native),
        _ => None,
    }
}
