//! SPECIAL commands that a robot does not answer by itself, found before it runs. Code that is compiled for a robot of its
//! owner is not judged: native code may answer there.
//!
//! ```
//! use tip_sim::{Robot, special};
//! use tipc::code::Code;
//!
//! let robot = Robot::named("titan8").expect("it has a name");
//! let program = b"3.1\nNot answered\nSPECIAL 30\nEND\n";
//! let mut loaded = tip_lint::load("sway.prg", program, &robot.options());
//! special::warn(&mut loaded, &robot);
//! assert_eq!(loaded.diagnostics[0].code, Code::Unanswered);
//! ```

use crate::Robot;
use crate::message::Linting;
use tipc::Loaded;
use tipc::code::Code;
use tipc::diagnostic::Diagnostic;
use tipc::message::list::List;
use tipc::program::{Action, Argument, Op, Operand};
use tipc::syntax::StatementKind;

/// Adds a warning to what was found for each SPECIAL that nothing answers.
pub fn warn(loaded: &mut Loaded, robot: &Robot) {
    let (Some(program), Some(answers)) = (&loaded.program, robot.answers()) else {
        return;
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
        let number = number(arguments)?;
        let is_own = answers.iter().any(|own| f64::from(*own) == number);
        let StatementKind::Command { arguments, .. } = &statement.kind else {
            return None;
        };
        let place = arguments.first()?.span;
        (!is_own).then(|| Diagnostic::new(Code::Unanswered, place, reason(robot, answers)))
    });
    let found = found.map(|one| one.help(Linting::OwnNative)).collect();
    tip_lint::add(loaded, found);
}

/// Returns the number of a SPECIAL, which is a constant.
fn number(arguments: &[Argument]) -> Option<f64> {
    match arguments.first()?.operand {
        Operand::Constant(number) => Some(number),
        Operand::Scalar { .. } | Operand::Reading { .. } => None,
    }
}

fn reason(robot: &Robot, answers: &[u8]) -> Linting {
    let robot = robot.name();
    match answers {
        [] => Linting::AnswersNone { robot },
        _ => Linting::AnswersOthers {
            robot,
            numbers: List(answers.iter().map(u8::to_string).collect()),
        },
    }
}
