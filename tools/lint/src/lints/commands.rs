//! Commands that do less than they seem to: a pause that is none, `R` before one number of three, a SPECIAL that nobody
//! answers.

use super::LintContext;
use crate::message::Linting;
use tip_runtime::command::{ABSOLUTE, RELATIVE, Target};
use tipc::code::Code;
use tipc::diagnostic::{Diagnostic, Diagnostics};
use tipc::language::commands::{self, Form};
use tipc::program::{Action, Op};
use tipc::syntax::{self, OperandKind, StatementKind};

pub(super) fn warn(context: &LintContext<'_>, found: &mut Diagnostics) {
    let keeps_period = context
        .program
        .steps()
        .iter()
        .all(|step| !sets_period(&step.action));
    for (statement, step) in context.module.steps().zip(context.program.steps()) {
        let StatementKind::Command {
            name, arguments, ..
        } = &statement.kind
        else {
            continue;
        };
        let diagnostic = match &step.action {
            Action::Command { op: Op::Sleep, .. } if keeps_period => {
                short_sleep(context, arguments)
            }
            Action::Command { .. } => relative_first(&name.node, arguments),
            _ => None,
        };
        found.extend(diagnostic);
    }
}

/// Returns true if the robot's standard sampling time may not be the one in force.
fn sets_period(action: &Action) -> bool {
    let Action::Command { op, .. } = action else {
        return false;
    };
    matches!(op, Op::SetSamplingTime | Op::SetSamplingFreq)
}

/// Returns a pause in seconds where milliseconds are meant. 0 is how to say one cycle.
fn short_sleep(context: &LintContext<'_>, arguments: &[syntax::Operand]) -> Option<Diagnostic> {
    let operand = arguments.first()?;
    let OperandKind::Number(time) = operand.kind else {
        return None;
    };
    let period = context.robot.facts().period;
    (0.0 < time && time < period).then(|| {
        let reason = Linting::OneCycle { period };
        Diagnostic::new(Code::ShortSleep, operand.span, reason).help(Linting::Milliseconds)
    })
}

/// `R` before the first number only. `R 0` in front is how to keep one coordinate, unless 0 follows as well: `A` before another number shows that
/// the author knows that `R` is for one.
fn relative_first(name: &str, arguments: &[syntax::Operand]) -> Option<Diagnostic> {
    let takes_marks = commands::find(name).is_some_and(|command| match command.form {
        Form::Robot(form) => form.relative && !form.from_target,
        _ => false,
    });
    let is = |operand: &&syntax::Operand, flag: &str| matches!(&operand.kind, OperandKind::Name(name) if name == flag);
    let first = arguments
        .iter()
        .position(|operand| is(&operand, RELATIVE))?;
    let (mark, numbers) = arguments[first..].split_first()?;
    let marked = |operand: &syntax::Operand| is(&operand, RELATIVE) || is(&operand, ABSOLUTE);
    let is_zero = |operand: &syntax::Operand| matches!(operand.kind, OperandKind::Number(0.0));
    let stays = is_zero(numbers.first()?) && !numbers.get(1).is_some_and(is_zero);
    let is_target = |operand: &syntax::Operand| matches!(&operand.kind, OperandKind::Name(name) if name.parse::<Target>().is_ok());
    let leads = arguments[..first].last().is_some_and(is_target);
    if !takes_marks || !leads || stays || numbers.len() < 2 || numbers.iter().any(marked) {
        return None;
    }
    let location = mark.span.to(numbers[0].span);
    let diagnostic = Diagnostic::new(Code::RelativeFirst, location, Linting::OthersAbsolute);
    Some(diagnostic.help(Linting::MarkEach))
}
