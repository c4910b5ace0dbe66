//! Constants that a command refuses at run time.

use super::resolve::Resolver;
use crate::codes::Code;
use crate::commands::{Arguments, Limit, Values};
use crate::diagnostic::Diagnostic;
use crate::program::{Argument, Operand};
use crate::robot::Robot;
use crate::syntax::{self, Word};
use tip_runtime::model::Range;

impl Resolver<'_> {
    /// Warns of each constant out of the command's range.
    pub(super) fn warn_of_range(
        &mut self,
        name: &Word,
        form: Arguments,
        operands: &[syntax::Operand],
        values: &[Argument],
    ) {
        let judged = match form.values {
            // The z of a finger is ignored.
            Values::Three | Values::Position if self.robot.is_hand() => 2,
            _ => values.len(),
        };
        for (operand, value) in operands.iter().zip(values).take(judged) {
            if let Operand::Constant(value) = value.operand
                && let Some(range) = broken(form.limit, value, self.robot)
            {
                let help = format!("{} takes {range} on {}", name.node, self.robot.name());
                let reason = "out of range";
                self.report(Diagnostic::new(Code::OutOfRange, operand.span, reason).help(help));
            }
        }
    }
}

/// The range that a value leaves, in words.
fn broken(limit: Limit, value: f64, robot: Robot) -> Option<String> {
    let outside =
        |range: Range| (!range.contains(value)).then(|| format!("{} to {}", range.min, range.max));
    match limit {
        Limit::Any => None,
        Limit::NotNegative => (value < 0.0).then(|| "0 or more".to_owned()),
        Limit::Positive => (value <= 0.0).then(|| "more than 0".to_owned()),
        Limit::Percent => {
            (value <= 0.0 || value > 100.0).then(|| "more than 0, up to 100".to_owned())
        }
        Limit::Period => outside(robot.facts().periods),
        Limit::Frequency => {
            let Range { min, max } = robot.facts().periods;
            outside(Range::new(1000.0 / max, 1000.0 / min))
        }
        Limit::Lamp => match robot.facts().lamps.checked_sub(1) {
            None => Some("nothing".to_owned()),
            Some(last) => {
                let fitted = Range::new(0.0, f64::from(last)).contains(value.trunc());
                (!fitted).then(|| format!("0 to {last}"))
            }
        },
        Limit::FloorType => {
            let types = if robot.is_hand() { 2.0 } else { 3.0 };
            let known = Range::new(1.0, types).contains(value.trunc());
            (!known).then(|| format!("1 to {types}"))
        }
        Limit::ObjectType => {
            let known = Range::new(1.0, 3.0).contains(value.trunc());
            (!known).then(|| "1 to 3".to_owned())
        }
    }
}
