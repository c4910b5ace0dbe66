//! Constant targets that a robot cannot reach, found before it moves.
//!
//! The program must give every number of the target as a constant, and none of them relative. A program that says EMG_OFF
//! is left alone: there a joint stops at its limit, and the program goes on. Whether a foot comes straight from where it is
//! to a target within reach is not looked at.
//!
//! ```
//! use tip_sim::{Robot, reach};
//! use tipc::code::Code;
//!
//! let robot = Robot::named("titan8").expect("it has a name");
//! let program = b"3.1\nToo far\nPTP F1 -2000 200 -200\nEND\n";
//! let mut loaded = tipc::load("far.prg", program, &robot.options());
//! reach::warn(&mut loaded, &robot);
//! assert_eq!(loaded.diagnostics[0].code, Code::OutOfReach);
//! ```

use crate::Robot;
use crate::body::Miss;
use tip_runtime::command::Op;
use tipc::Loaded;
use tipc::code::Code;
use tipc::diagnostic::Diagnostic;
use tipc::message::Warning;
use tipc::program::{Action, Mark, Operand, Program, Step};
use tipc::source::Span;
use tipc::syntax::{OperandKind, Statement, StatementKind};

/// Adds a warning to what was found for each target that the robot cannot reach.
pub fn warn(loaded: &mut Loaded, robot: &Robot) {
    let Some(program) = loaded
        .program
        .as_ref()
        .filter(|program| stops_at_limits(program))
    else {
        return;
    };
    let steps = loaded.module.steps().zip(program.steps());
    let found = steps.filter_map(|(statement, step)| warning(statement, step, robot));
    let found = found.collect();
    loaded.add(found);
}

/// Whether a joint at its limit is always an emergency.
fn stops_at_limits(program: &Program) -> bool {
    let clips = |step: &Step| matches!(step.action, Action::Command { op: Op::EmgOff, .. });
    !program.steps().iter().any(clips)
}

fn warning(statement: &Statement, step: &Step, robot: &Robot) -> Option<Diagnostic> {
    let Action::Command {
        op: op @ (Op::Ptp | Op::PtpAngle),
        target,
        arguments,
        ..
    } = &step.action
    else {
        return None;
    };
    let constant = |argument: &tipc::program::Argument| match (argument.operand, argument.mark) {
        (Operand::Constant(number), Mark::None) => Some(number),
        _ => None,
    };
    let values: Vec<f64> = arguments.iter().map(constant).collect::<Option<_>>()?;
    let miss = robot.miss(*op, *target, &values)?;
    let place = place(statement, miss);
    let (reason, help) = match miss {
        Miss::Turns {
            joint, by, limits, ..
        } => {
            let limit = if by < 0.0 { limits.min } else { limits.max };
            let reason = Warning::TurnsTooFar {
                joint,
                by: tenths(by.abs()),
                limit: tenths(limit),
            };
            let (min, max) = (tenths(limits.min), tenths(limits.max));
            (reason, Warning::TurnsFromTo { joint, min, max })
        }
        Miss::Ends { by } => {
            let by = tenths(by).max(0.1);
            let target = *target;
            (Warning::ComesNoNearer { target, by }, Warning::ChooseNearer)
        }
        Miss::Slides { axis, travel } => {
            let (min, max) = (tenths(travel.min), tenths(travel.max));
            (
                Warning::SlidesNotThere,
                Warning::SlidesFromTo { axis, min, max },
            )
        }
    };
    Some(Diagnostic::new(Code::OutOfReach, place, reason).help(help))
}

/// The number of the joint that misses its limit, if there is one for each joint; else all numbers.
fn place(statement: &Statement, miss: Miss) -> Span {
    let StatementKind::Command { arguments, .. } = &statement.kind else {
        return statement.span;
    };
    let is_number =
        |operand: &&tipc::syntax::Operand| matches!(operand.kind, OperandKind::Number(_));
    let numbers: Vec<Span> = arguments
        .iter()
        .filter(is_number)
        .map(|it| it.span)
        .collect();
    match (miss, numbers.as_slice()) {
        (
            Miss::Turns {
                number: Some(number),
                ..
            },
            numbers,
        ) => numbers.get(number).copied().unwrap_or(statement.span),
        (_, [first, .., last]) => first.to(*last),
        (_, _) => statement.span,
    }
}

/// Rounded to a tenth, as people read it.
fn tenths(number: f64) -> f64 {
    (number * 10.0).round() / 10.0
}
