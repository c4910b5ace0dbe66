//! `N =+1` where `N += 1` was meant.

use super::LintContext;
use crate::message::Linting;
use tipc::code::Code;
use tipc::diagnostic::{Diagnostic, Diagnostics};
use tipc::source::Span;
use tipc::syntax::{Equation, Expression, OperandKind, StatementKind};

/// Warns of `N =+ 1`. The blanks give it away: one before `=`, none behind it. `N = +1` and `N=+1` are what they look
/// like.
pub(super) fn warn(context: &LintContext<'_>, found: &mut Diagnostics) {
    for statement in context.module.steps() {
        if let StatementKind::Equation(equation) = &statement.kind
            && let Some(sign) = swapped(context.source.text(), equation)
        {
            let name = context.source.slice(equation.target.span);
            let number = context
                .source
                .slice(Span::new(sign + 1, statement.span.end));
            let reason = Linting::AssignsSigned {
                number: number.into(),
            };
            let help = Linting::MeantUpdate {
                name: name.into(),
                number: number.into(),
            };
            let location = Span::new(equation.operator.start, sign + 1);
            found.push(Diagnostic::new(Code::SwappedSigns, location, reason).help(help));
        }
    }
}

/// Returns the location of the plus.
fn swapped(text: &str, equation: &Equation) -> Option<usize> {
    let Expression::Operand(value) = &equation.value else {
        return None;
    };
    let operator = equation.operator;
    let is_number = matches!(value.kind, OperandKind::Number(_));
    let follows = value.span.start == operator.end && text[operator.end..].starts_with('+');
    let is_apart = equation.target.span.end < operator.start;
    (equation.update.is_none() && is_number && follows && is_apart).then_some(operator.end)
}
