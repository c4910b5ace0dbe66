//! A program as a list of steps, for the peers that are state machines.

use crate::infix::{Infix, Set};
use tipc::program::{Action, Op, Operand, StepId, Target};

/// One step: it assigns, asks for a command, and leads on.
pub(crate) struct Step {
    pub(crate) sets: Vec<Set>,
    pub(crate) ask: Option<Ask>,
    pub(crate) then: Then,
}

/// A command of the robot.
pub(crate) struct Ask {
    pub(crate) op: Op,
    pub(crate) target: Target,
    pub(crate) values: Vec<String>,
}

/// Successor of a step.
pub(crate) enum Then {
    To(StepId),
    If(String, StepId, StepId),
    Call { to: StepId, back: StepId },
    Return,
    Finish,
}

pub(crate) fn steps(infix: &Infix<'_>) -> Vec<Step> {
    let steps = infix.program.steps().iter();
    steps
        .zip(1..)
        .map(|(step, next)| flat(infix, &step.action, next))
        .collect()
}

fn flat(infix: &Infix<'_>, action: &Action, next: StepId) -> Step {
    let nothing_then = |then| Step {
        sets: Vec::new(),
        ask: None,
        then,
    };
    if let Some(sets) = infix.sets(action) {
        return Step {
            sets,
            ..nothing_then(Then::To(next))
        };
    }
    match action {
        Action::Nothing => nothing_then(Then::To(next)),
        Action::Goto { to } => nothing_then(Then::To(*to)),
        Action::If {
            condition,
            otherwise,
        } => nothing_then(Then::If(infix.condition(*condition), next, *otherwise)),
        Action::For {
            variable,
            from,
            to,
            step: Operand::Constant(1.0),
            exit,
        } => Step {
            sets: vec![Set {
                place: infix.place(*variable),
                value: infix.operand(*from),
                is_calculated: false,
            }],
            ..nothing_then(Then::If(
                format!("{} <= {}", infix.operand(*from), infix.operand(*to)),
                next,
                *exit,
            ))
        },
        Action::Next {
            variable, to, body, ..
        } => {
            let place = infix.place(*variable);
            Step {
                sets: vec![Set {
                    value: format!("{place} + 1.0"),
                    place: place.clone(),
                    is_calculated: true,
                }],
                ..nothing_then(Then::If(
                    format!("{place} <= {}", infix.operand(*to)),
                    *body,
                    next,
                ))
            }
        }
        Action::Gosub { to } => nothing_then(Then::Call {
            to: *to,
            back: next,
        }),
        Action::Return => nothing_then(Then::Return),
        Action::Finish(_) => nothing_then(Then::Finish),
        Action::Command {
            op,
            hs: false,
            target,
            arguments,
        } => Step {
            ask: Some(Ask {
                op: *op,
                target: *target,
                values: infix.arguments(arguments),
            }),
            ..nothing_then(Then::To(next))
        },
        other => panic!("beyond the peers: {other:?}"),
    }
}
