//! Warnings about constants that no step can use, because they are out of range or because an equation has no result
//! for them.

use super::resolve::Resolver;
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::language::commands::{Arguments, Limit, Values};
use crate::language::functions::{self, Operation};
use crate::message::phrase::Bounds;
use crate::message::{Calculating, Commanding};
use crate::program::{self, Argument, Arithmetic, Function};
use crate::robot::Robot;
use crate::source::Span;
use crate::syntax::{Equation, Expression, Operand, Word};
use tip_runtime::command::{TIMERS, Target};
use tip_runtime::model::Range;

impl Resolver<'_> {
    /// Warns of each constant out of the command's range.
    pub(super) fn warn_of_range(
        &mut self,
        name: &Word,
        form: Arguments,
        operands: &[Operand],
        values: &[Argument],
    ) {
        let judged = match form.values {
            // The z of a finger is ignored.
            Values::Three | Values::ThreeOrPos | Values::Position if self.robot.is_hand() => 2,
            _ => values.len(),
        };
        for (operand, value) in operands.iter().zip(values).take(judged) {
            if let program::Operand::Constant(value) = value.operand
                && let Some(bounds) = broken(form.limit, value, self.robot)
            {
                self.warn_of_bounds(name, operand.span, bounds);
                if self.names.edition.is_strict() {
                    // The step fails at the first such constant.
                    return;
                }
            }
        }
    }

    /// Warns of a constant limit outside the joint's own ones, or of two that leave no range between them.
    pub(super) fn warn_of_limits(
        &mut self,
        name: &Word,
        target: Target,
        operands: &[Operand],
        values: &[Argument],
    ) {
        let constant = |value: &Argument| match value.operand {
            program::Operand::Constant(value) => Some(value),
            _ => None,
        };
        let own = self.robot.limits(target);
        let mut pairs = operands.iter().zip(values);
        let outside = pairs.find_map(|(operand, value)| {
            let own = own.filter(|own| constant(value).is_some_and(|it| !own.contains(it)))?;
            let Range { min, max } = own;
            Some((operand.span, Bounds::FromTo { min, max }))
        });
        let reversed = || match (values, operands) {
            ([low, high], [_, operand]) if constant(low)? >= constant(high)? => Some((
                operand.span,
                Bounds::Above {
                    low: constant(low)?,
                },
            )),
            _ => None,
        };
        if let Some((location, bounds)) = outside.or_else(reversed) {
            self.warn_of_bounds(name, location, bounds);
        }
    }

    fn warn_of_bounds(&mut self, name: &Word, location: Span, bounds: Bounds) {
        let help = Commanding::Takes {
            command: name.node.clone(),
            bounds,
            robot: self.robot.name(),
        };
        let reason = Commanding::OutOfRange;
        self.report(Diagnostic::new(Code::OutOfRange, location, reason).help(help));
    }

    /// Warns of a constant for which an equation has no result, whatever its variables are.
    pub(super) fn warn_of_domain(&mut self, equation: &Equation) {
        if let Some((location, reason, help)) = self.impossible(equation) {
            self.report(Diagnostic::new(Code::OutOfRange, location, reason).help(help));
        }
    }

    /// Returns the location of such a constant, the reason, and the help.
    fn impossible(&self, equation: &Equation) -> Option<(Span, Calculating, Calculating)> {
        let constant = |operand: &Operand| self.names.constant(operand);
        let division = |divisor: &Operand| {
            let (reason, help) = (Calculating::DividedByZero, Calculating::DivideByAnother);
            (constant(divisor)? == 0.0).then_some((divisor.span, reason, help))
        };
        match &equation.value {
            Expression::Operand(divisor) if equation.update == Some(Arithmetic::Div) => {
                division(divisor)
            }
            Expression::Binary {
                operation: Arithmetic::Div,
                right,
                ..
            } => division(right),
            Expression::Function { name, operands } => {
                let operation = functions::find(&name.node, self.names.edition)?;
                outside(operation, operands, constant)
            }
            Expression::Operand(_) | Expression::Binary { .. } => None,
        }
    }
}

/// Finds a constant outside the domain of a function.
fn outside(
    operation: Operation,
    operands: &[Operand],
    constant: impl Fn(&Operand) -> Option<f64>,
) -> Option<(Span, Calculating, Calculating)> {
    let first = operands.first()?;
    let value = constant(first)?;
    let name = operation.word();
    match operation {
        Operation::Scalar(Function::Sqrt) if value < 0.0 => {
            let reason = Calculating::NoSquareRoot;
            Some((first.span, reason, Calculating::SqrtTakes))
        }
        Operation::Scalar(function @ (Function::Asin | Function::Acos | Function::Atan))
            if !(-1.0..=1.0).contains(&value) =>
        {
            let reason = Calculating::NoResult { function: name };
            let help = if function == Function::Atan {
                Calculating::TakesToOneOrRatio { function: name }
            } else {
                Calculating::TakesToOne { function: name }
            };
            Some((first.span, reason, help))
        }
        Operation::Atan2 => {
            let second = operands.get(1)?;
            let reason = Calculating::NoDirection;
            let help = Calculating::AnotherThanZero;
            let nowhere = value == 0.0 && constant(second)? == 0.0;
            nowhere.then(|| (first.span.to(second.span), reason, help))
        }
        _ => None,
    }
}

/// Returns the range that a value leaves.
fn broken(limit: Limit, value: f64, robot: Robot) -> Option<Bounds> {
    let outside = |value: f64, min: f64, max: f64| {
        (!Range::new(min, max).contains(value)).then_some(Bounds::FromTo { min, max })
    };
    let whole_outside = |min, max| outside(value.trunc(), min, max);
    let Range { min, max } = robot.facts().periods;
    match limit {
        Limit::Any | Limit::Angles => None,
        Limit::NotNegative => (value < 0.0).then_some(Bounds::NotNegative),
        Limit::Positive => (value <= 0.0).then_some(Bounds::Positive),
        Limit::Percent => (value <= 0.0 || value > 100.0).then_some(Bounds::Percent),
        Limit::Period => outside(value, min, max),
        Limit::Frequency => outside(value, 1000.0 / max, 1000.0 / min),
        Limit::Lamp => match robot.facts().lamps.checked_sub(1) {
            None => Some(Bounds::Nothing),
            Some(last) => whole_outside(0.0, f64::from(last)),
        },
        Limit::FloorType if robot.is_hand() => whole_outside(1.0, 2.0),
        Limit::FloorType | Limit::ObjectType => whole_outside(1.0, 3.0),
        Limit::Timer => whole_outside(0.0, f64::from(TIMERS - 1)),
        Limit::Steps => whole_outside(1.0, 255.0),
    }
}
