//! Waits for what nothing in the program moves or sets: they end immediately, never, or stop the program.
//!
//! A wait for ALL stays silent, so does a question that is no loop, and a program with a SPECIAL, whose native code may
//! move anything.

use super::LintContext;
use super::conditions::condition;
use super::unreachable::Unreachable;
use crate::message::Linting;
use tipc::code::Code;
use tipc::diagnostic::{Diagnostic, Diagnostics};
use tipc::language::commands::{self, Moves};
use tipc::program::{Action, Condition, Flag, Op, Step, Target};
use tipc::source::Span;
use tipc::syntax::{Statement, StatementKind};

pub(super) fn warn(context: &LintContext<'_>, unreachable: &Unreachable, found: &mut Diagnostics) {
    let steps = context.program.steps();
    if steps.iter().any(calls_native_code) {
        return;
    }
    let mut moved = Vec::new();
    for target in steps.iter().filter_map(moves) {
        // Robots have few of them, and programs many steps.
        if !moved.contains(&target) {
            moved.push(target);
        }
    }
    for (step, content) in (0..).zip(steps) {
        let reason = waits_for_nothing(&content.action, &moved);
        if let Some(reason) = reason.filter(|_| unreachable.is_live(step))
            && let Some(statement) = context.statement(step)
        {
            let help = way_out(&reason);
            let diagnostic = Diagnostic::new(Code::WaitsForNothing, location(statement), reason);
            found.push(diagnostic.help(help));
        }
    }
}

fn calls_native_code(step: &Step) -> bool {
    matches!(
        step.action,
        Action::Command {
            op: Op::Special,
            ..
        }
    )
}

/// Returns what a step brings under control, if it moves anything.
fn moves(step: &Step) -> Option<Target> {
    let Action::Command { op, target, .. } = step.action else {
        return None;
    };
    match commands::find(op.name())?.moves {
        Moves::Nothing => None,
        Moves::Target => Some(target),
        Moves::Robot => Some(Target::All),
    }
}

/// Returns why a step waits for nothing.
fn waits_for_nothing(action: &Action, moved: &[Target]) -> Option<Linting> {
    let is_one = |target: Target| !matches!(target, Target::All | Target::None);
    // A program in which nothing moves at all is a sketch.
    let others_move =
        |target: Target| !moved.is_empty() && !moved.iter().any(|moved| meets(*moved, target));
    let rests = |target: Target| is_one(target) && others_move(target);
    match *action {
        Action::Command {
            op: Op::WaitInpos,
            target,
            ..
        } if rests(target) => Some(Linting::PassesAtOnce { target }),
        Action::Command {
            op: Op::WaitNear,
            target,
            ..
        } if rests(target) => Some(Linting::NeverControlled { target }),
        Action::While {
            condition: Condition::Flag { flag, .. },
            ..
        }
        | Action::Until {
            condition: Condition::Flag { flag, .. },
            ..
        } => match flag {
            Flag::Inpos(target) if rests(target) => Some(Linting::InposOfNothing { target }),
            Flag::Near(target) if rests(target) => Some(Linting::NearOfNothing { target }),
            Flag::Special(_) => Some(Linting::NobodySets),
            _ => None,
        },
        _ => None,
    }
}

/// Returns true if two targets have a joint in common.
fn meets(one: Target, other: Target) -> bool {
    match (one, other) {
        (Target::All, _) | (_, Target::All) => true,
        (Target::Foot(leg), Target::Joint(of, _)) | (Target::Joint(of, _), Target::Foot(leg)) => {
            leg == of
        }
        (one, other) => one == other,
    }
}

fn way_out(reason: &Linting) -> Linting {
    match reason {
        Linting::NobodySets => Linting::CallSpecial,
        _ => Linting::WaitForMoved,
    }
}

/// Returns the target of a command, or the flag.
fn location(statement: &Statement) -> Span {
    match &statement.kind {
        StatementKind::Command { arguments, .. } => {
            let target = arguments.first();
            target.map_or(statement.span, |target| target.span)
        }
        _ => condition(statement),
    }
}
