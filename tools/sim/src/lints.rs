//! Lints of a program that need its robot: constant targets that it cannot reach (W122, W127) or where it hits itself (W138),
//! and SPECIAL commands that it does not answer (W123).
//!
//! A target is checked if all of its numbers are absolute constants. A program with EMG_OFF is not checked: there a
//! joint stops at its limit, and the program goes on. A straight path to a target within reach, and a target of
//! REL_PTP, are checked while the place of the foot is known: from the start of the program to its first condition or
//! jump.
//!
//! SPECIAL is not checked on a robot whose owner has native code that may answer it.

mod self_collision;

use crate::Robot;
use crate::message::Linting;
use crate::model::Miss;
use std::collections::HashMap;
use tip_runtime::command::{Op, Target};
use tip_runtime::model::{Point, Range};
use tipc::Loaded;
use tipc::code::Code;
use tipc::diagnostic::Diagnostic;
use tipc::message::Message;
use tipc::message::list::List;
use tipc::program::{Action, Argument, Mark, Operand, Program, Step};
use tipc::source::Span;
use tipc::syntax::{OperandKind, Statement, StatementKind};

impl Robot {
    /// Adds the warnings that need the robot: targets out of reach or where it hits itself, and SPECIALs that nothing
    /// answers.
    ///
    /// ```
    /// use tip_sim::Robot;
    /// use tipc::code::Code;
    ///
    /// let robot = Robot::named("titan8").expect("it has a name");
    /// let program = b"3.1\nToo far\nPTP F1 -2000 200 -200\nSPECIAL 30\nEND\n";
    /// let mut loaded = tip_lint::load("far.prg", program, &robot.options());
    /// robot.warn(&mut loaded);
    /// let codes: Vec<Code> = loaded.diagnostics.iter().map(|found| found.code).collect();
    /// assert_eq!(codes, [Code::OutOfReach, Code::Unanswered]);
    /// ```
    pub fn warn(&self, loaded: &mut Loaded) {
        warn_of_targets(loaded, self);
        self_collision::warn(loaded, self);
        warn_of_specials(loaded, self);
    }
}

/// Adds a warning for each target that the robot cannot reach.
fn warn_of_targets(loaded: &mut Loaded, robot: &Robot) {
    let stops_at_limits = |program: &&Program| stops_at_limits(program);
    let Some(program) = loaded.program.as_ref().filter(stops_at_limits) else {
        return;
    };
    let mut starts = Starts::of(robot);
    let known = HashMap::new();
    let mut misses = Misses { robot, known };
    let mut found = Vec::new();
    for (statement, step) in loaded.module.steps().zip(program.steps()) {
        let start = starts.before(step);
        found.extend(warning(statement, step, &mut misses, start));
    }
    tip_lint::add(loaded, found);
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

/// The misses of targets, kept since a program may use a target many times.
struct Misses<'a> {
    robot: &'a Robot,
    /// The misses that are known, by target and the bits of its numbers.
    known: HashMap<(Op, Target, Vec<u64>), Option<Miss>>,
}

impl Misses<'_> {
    fn of_target(&mut self, op: Op, target: Target, values: &[f64]) -> Option<Miss> {
        let bits = values.iter().map(|value| value.to_bits()).collect();
        let known = self.known.entry((op, target, bits));
        *known.or_insert_with(|| self.robot.miss(op, target, values, &[]))
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
        op: op @ (Op::Ptp | Op::PtpAngle | Op::RelPtp),
        target,
        arguments,
        ..
    } = &step.action
    else {
        return None;
    };
    let values = constants(arguments)?;
    if *op == Op::RelPtp {
        let (start, by): (Point, Point) = (start?, values.try_into().ok()?);
        let end = [0, 1, 2].map(|k| start[k] + by[k]);
        let miss = misses.of_target(Op::Ptp, *target, &end);
        return miss
            .filter(|miss| is_clear(*miss))
            .map(|miss| out_of_reach(statement, *target, miss));
    }
    let Some(miss) = misses.of_target(*op, *target, &values) else {
        let end: Point = values.try_into().ok().filter(|_| *op == Op::Ptp)?;
        return on_the_path(statement, misses.robot, *target, start?, end);
    };
    Some(out_of_reach(statement, *target, miss))
}

/// Returns the warning on a target that is missed.
fn out_of_reach(statement: &Statement, target: Target, miss: Miss) -> Diagnostic {
    let place = place(statement, miss);
    let (reason, help) = reason(target, miss);
    Diagnostic::new(Code::OutOfReach, place, reason).help(help)
}

/// Returns the reason and the help of a target that is missed.
fn reason(target: Target, miss: Miss) -> (Linting, Linting) {
    match miss {
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
            (Linting::ComesNoNearer { target, by }, Linting::ChooseNearer)
        }
        Miss::Slides { axis, travel } => {
            let (min, max) = (tenths(travel.min), tenths(travel.max));
            (
                Linting::SlidesNotThere,
                Linting::SlidesFromTo { axis, min, max },
            )
        }
    }
}

impl Robot {
    /// Returns the reason why the target of a PTP or PTP_ANGLE (mm or deg) is out of reach, and the help, in the words
    /// of the warning. `limits` are the working limits of all joints, leg by leg. Returns `None` for a target within
    /// reach.
    pub fn reason_out_of_reach(
        &self,
        op: Op,
        target: Target,
        values: &[f64],
        limits: &[Range],
    ) -> Option<(Message, Message)> {
        let miss = self.miss(op, target, values, limits)?;
        Some(match reason(target, miss) {
            // A warning is shown at its target. This text is shown alone, so it names the target.
            (Linting::ComesNoNearer { target, by }, help) => {
                (Linting::CannotReach { target, by }.into(), help.into())
            }
            (reason, help) => (reason.into(), help.into()),
        })
    }
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
        let miss = robot.miss(Op::Ptp, target, place, &[]);
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

/// Returns the location of the number of the joint that exceeds its limit, if each joint has one; else of all numbers.
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

/// The known places of a foot, mm.
#[derive(Clone, Copy, Default)]
struct Foot {
    /// The place where it rests.
    rests: Option<Point>,
    /// The place of its target.
    goes: Option<Point>,
}

/// Returns true if an action changes no target of a joint, and the next step runs after it.
fn keeps_targets(action: &Action) -> bool {
    match action {
        Action::Nothing
        | Action::SetScalar { .. }
        | Action::SetStruct { .. }
        | Action::Message { .. } => true,
        Action::Command { op, .. } => matches!(
            op,
            Op::Sleep
                | Op::WaitNear
                | Op::LampOn
                | Op::LampOff
                | Op::LogStart
                | Op::LogStop
                | Op::SetVMax
                | Op::SetAMax
                | Op::SetVMaxRate
                | Op::SetAMaxRate
        ),
        _ => false,
    }
}

/// The known places of all feet before a step.
struct Starts {
    /// `None` after the first condition or jump, and after a command that may move anything.
    feet: Option<Vec<Foot>>,
}

impl Starts {
    /// Creates the places in the initial posture. They are unknown for legs without a closed form, whose posture
    /// depends on their path.
    fn of(robot: &Robot) -> Self {
        let description = robot.description();
        if !description.inverse.is_closed() {
            return Starts { feet: None };
        }
        let rests = |at: Point| Foot {
            rests: Some(at),
            goes: None,
        };
        let feet = description.feet.into_iter().map(rests);
        Starts {
            feet: Some(feet.collect()),
        }
    }

    /// Returns the start of the foot that a step moves, if it is known, and applies the effect of the step.
    fn before(&mut self, step: &Step) -> Option<Point> {
        let feet = self.feet.as_mut()?;
        if keeps_targets(&step.action) {
            return None;
        }
        let Action::Command {
            op,
            target,
            arguments,
            ..
        } = &step.action
        else {
            self.feet = None;
            return None;
        };
        match (op, target) {
            (Op::Ptp, Target::Foot(leg)) => {
                let foot = feet.get_mut(usize::from(*leg).checked_sub(1)?)?;
                let start = foot.rests.take();
                foot.goes = constants(arguments).and_then(|to| to.try_into().ok());
                start
            }
            // The end of its motion is not computed: only the places of the other feet stay known.
            (Op::RelPtp, Target::Foot(leg)) => {
                let foot = feet.get_mut(usize::from(*leg).checked_sub(1)?)?;
                std::mem::take(foot).rests
            }
            (Op::WaitInpos, Target::Foot(leg)) => {
                let foot = feet.get_mut(usize::from(*leg).checked_sub(1)?)?;
                foot.arrive();
                None
            }
            (Op::WaitInpos, Target::All) => {
                feet.iter_mut().for_each(Foot::arrive);
                None
            }
            _ => {
                self.feet = None;
                None
            }
        }
    }
}

impl Foot {
    /// Moves its place of rest to its target.
    fn arrive(&mut self) {
        self.rests = self.rests.or(self.goes.take());
    }
}

/// Adds a warning for each SPECIAL that nothing answers.
fn warn_of_specials(loaded: &mut Loaded, robot: &Robot) {
    let (Some(program), Some(answers)) = (&loaded.program, robot.answers()) else {
        return;
    };
    let name = robot.name();
    let reason = match answers {
        [] => Linting::AnswersNone { robot: name },
        _ => Linting::AnswersOthers {
            robot: name,
            numbers: List(answers.iter().map(u8::to_string).collect()),
        },
    };
    let steps = loaded.module.steps().zip(program.steps());
    let found = steps.filter_map(|(statement, step)| {
        let Action::Command {
            op: Op::Special,
            arguments,
            ..
        } = &step.action
        else {
            return None;
        };
        // Its first argument is a constant, the number. The others may be anything.
        let Operand::Constant(number) = arguments.first()?.operand else {
            return None;
        };
        let is_answered = answers.iter().any(|own| f64::from(*own) == number);
        let StatementKind::Command { arguments, .. } = &statement.kind else {
            return None;
        };
        let place = arguments.first()?.span;
        let finding = Diagnostic::new(Code::Unanswered, place, reason.clone());
        (!is_answered).then(|| finding.help(Linting::OwnNative))
    });
    let found = found.collect();
    tip_lint::add(loaded, found);
}
