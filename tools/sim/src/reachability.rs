//! Constant targets that a robot cannot reach, found before it moves.
//!
//! The program must give every number of the target as a constant, and none of them relative. A program that says EMG_OFF
//! is left alone: there a joint stops at its limit, and the program goes on. Whether a foot comes straight to a target within
//! reach is looked at where it is known to start: on the first pass, up to the first question.
//!
//! ```
//! use tip_sim::{Robot, reachability};
//! use tipc::code::Code;
//!
//! let robot = Robot::named("titan8").expect("it has a name");
//! let program = b"3.1\nToo far\nPTP F1 -2000 200 -200\nEND\n";
//! let mut loaded = tip_lint::load("far.prg", program, &robot.options());
//! reachability::warn(&mut loaded, &robot);
//! assert_eq!(loaded.diagnostics[0].code, Code::OutOfReach);
//! ```

mod start;

use crate::Robot;
use crate::message::Linting;
use crate::model::Miss;
use crate::special;
use start::Starts;
use tip_runtime::command::{Op, Target};
use tip_runtime::model::Point;
use tipc::Loaded;
use tipc::code::Code;
use tipc::diagnostic::Diagnostic;
use tipc::program::{Action, Argument, Mark, Operand, Program, Step};
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
    let mut starts = Starts::of(robot);
    let mut misses = Misses::of(robot);
    let mut found = Vec::new();
    for (statement, step) in loaded.module.steps().zip(program.steps()) {
        let start = starts.before(step);
        found.extend(warning(statement, step, &mut misses, start));
    }
    tip_lint::add(loaded, found);
}

impl Robot {
    /// Adds the warnings that only the robot of a program tells: targets out of reach, and SPECIALs that nothing answers.
    pub fn warn(&self, loaded: &mut Loaded) {
        warn(loaded, self);
        special::warn(loaded, self);
    }
}

/// Returns true if a joint at its limit is always an emergency.
fn stops_at_limits(program: &Program) -> bool {
    let clips = |step: &Step| matches!(step.action, Action::Command { op: Op::EmgOff, .. });
    !program.steps().iter().any(clips)
}

/// Returns the numbers of a command's target, if all are constants and absolute.
fn constants(arguments: &[Argument]) -> Option<Vec<f64>> {
    let constant = |argument: &Argument| match (argument.operand, argument.mark) {
        (Operand::Constant(number), Mark::None) => Some(number),
        _ => None,
    };
    arguments.iter().map(constant).collect()
}

/// Misses by target: a program may go to the same one again and again.
struct Misses<'a> {
    robot: &'a Robot,
    known: Vec<Known>,
}

/// A target, with the bits of its numbers, and what it misses.
struct Known {
    op: Op,
    target: Target,
    bits: Vec<u64>,
    miss: Option<Miss>,
}

/// Maximum number of targets that are remembered.
const REMEMBERED: usize = 100;

impl<'a> Misses<'a> {
    fn of(robot: &'a Robot) -> Self {
        let known = Vec::new();
        Misses { robot, known }
    }

    fn of_target(&mut self, op: Op, target: Target, values: &[f64]) -> Option<Miss> {
        let bits = values.iter().map(|value| value.to_bits());
        let mut known = self.known.iter();
        let is_it = |it: &&Known| {
            it.op == op && it.target == target && it.bits.iter().copied().eq(bits.clone())
        };
        if let Some(known) = known.find(is_it) {
            return known.miss;
        }
        let miss = self.robot.miss(op, target, values);
        if self.known.len() < REMEMBERED {
            let bits = bits.collect();
            self.known.push(Known {
                op,
                target,
                bits,
                miss,
            });
        }
        miss
    }
}

/// Returns the warning on a target, or on the straight path that leads there from `start`.
fn warning(
    statement: &Statement,
    step: &Step,
    misses: &mut Misses<'_>,
    start: Option<Point>,
) -> Option<Diagnostic> {
    let Action::Command {
        op: op @ (Op::Ptp | Op::PtpAngle),
        target,
        arguments,
        ..
    } = &step.action
    else {
        return None;
    };
    let values = constants(arguments)?;
    let Some(miss) = misses.of_target(*op, *target, &values) else {
        let end: Point = values.try_into().ok().filter(|_| *op == Op::Ptp)?;
        return on_the_path(statement, misses.robot, *target, start?, end);
    };
    let place = place(statement, miss);
    let (reason, help) = match miss {
        Miss::Turns {
            joint, by, limits, ..
        } => {
            let limit = if by < 0.0 { limits.min } else { limits.max };
            let reason = Linting::TurnsTooFar {
                joint,
                by: tenths(by.abs()),
                limit: tenths(limit),
            };
            let (min, max) = (tenths(limits.min), tenths(limits.max));
            (reason, Linting::TurnsFromTo { joint, min, max })
        }
        Miss::Ends { by } => {
            let by = tenths(by).max(0.1);
            let target = *target;
            (Linting::ComesNoNearer { target, by }, Linting::ChooseNearer)
        }
        Miss::Slides { axis, travel } => {
            let (min, max) = (tenths(travel.min), tenths(travel.max));
            (
                Linting::SlidesNotThere,
                Linting::SlidesFromTo { axis, min, max },
            )
        }
    };
    Some(Diagnostic::new(Code::OutOfReach, place, reason).help(help))
}

/// Number of pieces in which a straight path is checked.
const PIECES: u32 = 100;

/// Returns the first place of a straight path that is clearly out of reach.
fn on_the_path(
    statement: &Statement,
    robot: &Robot,
    target: Target,
    start: Point,
    end: Point,
) -> Option<Diagnostic> {
    let parts = (1..PIECES).map(|piece| f64::from(piece) / f64::from(PIECES));
    let mut places = parts.map(|part| [0, 1, 2].map(|k| start[k] + (end[k] - start[k]) * part));
    let bad = places.find(|place| {
        let miss = robot.miss(Op::Ptp, target, place);
        miss.is_some_and(is_clear)
    })?;
    let [x, y, z] = bad.map(tenths);
    let place = place(statement, Miss::Ends { by: 0.0 });
    let reason = Linting::LeavesReach { target, x, y, z };
    let finding = Diagnostic::new(Code::PathLeavesReach, place, reason);
    Some(finding.help(Linting::GoAround))
}

/// Returns true if a target is missed by more than the inexact start of a path explains.
fn is_clear(miss: Miss) -> bool {
    match miss {
        Miss::Turns { by, .. } => by.abs() > 2.0,
        Miss::Ends { by } => by > 5.0,
        Miss::Slides { .. } => true,
    }
}

/// Returns the number of the joint that misses its limit, if there is one for each joint; else all
/// numbers.
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

/// Rounds to a tenth, as people read it.
fn tenths(number: f64) -> f64 {
    (number * 10.0).round() / 10.0
}
