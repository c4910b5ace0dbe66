//! From the operands of a motion to numbers.

use crate::command::Value;
use crate::fault::Fault;

/// The way in which a REL_ command and a plain one read their operands.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Base {
    /// Each operand has a mark of its own; relative ones count from the measured value.
    Operand,
    /// All but those after `A` count from the current target, or else from the measured value; all zero stops a move.
    Target,
}

pub(super) fn is_zero(values: &[Value]) -> bool {
    values.iter().all(|value| value.number() == 0.0)
}

/// Returns the operands, relative ones counted from `base`.
pub(super) fn resolve<const N: usize>(
    values: &[Value; N],
    base: [f64; N],
) -> Result<[f64; N], Fault> {
    let mut resolved = base;
    for (resolved, value) in resolved.iter_mut().zip(values) {
        *resolved = crate::ops::finite(match value {
            Value::Absolute(number) | Value::Fixed(number) => *number,
            Value::Relative(number) => *resolved + number,
        })?;
    }
    Ok(resolved)
}

/// Returns the operands, all counted from `base` but those after `A`.
pub(super) fn sum<const N: usize>(values: &[Value; N], base: [f64; N]) -> Result<[f64; N], Fault> {
    let counted = values.map(|value| match value {
        Value::Absolute(number) => Value::Relative(number),
        Value::Relative(_) | Value::Fixed(_) => value,
    });
    resolve(&counted, base)
}

/// Returns the operands as the command reads them, counted from `from`.
pub(super) fn resolve_from<const N: usize>(
    values: &[Value; N],
    from: [f64; N],
    base: Base,
) -> Result<[f64; N], Fault> {
    match base {
        Base::Operand => resolve(values, from),
        Base::Target => sum(values, from),
    }
}
