//! What a statement waits for, and since when a run does.

use super::summary::tenths;
use crate::message::running::{Until, Waiting};
use tip_runtime::command::{Op, Target};
use tip_sim::Wait;
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

/// What a run waits for, in words.
pub(in super::super) fn said(wait: &Wait) -> Waiting {
    let [first, last] = wait.lines;
    let [since, time] = [wait.since, wait.time].map(|time| tenths(time / 1000.0));
    match wait.on.clone() {
        Some(what) if first == last => Waiting::Line {
            line: first,
            what,
            since,
            time,
        },
        Some(what) => Waiting::Loop {
            first,
            last,
            what,
            since,
            time,
        },
        None => Waiting::Endless {
            first,
            last,
            since,
            time,
        },
    }
}
