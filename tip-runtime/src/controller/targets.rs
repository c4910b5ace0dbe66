//! Targets and operands of commands; legs and joints count from 1 in the language.

use crate::command::{Target, Value};
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

/// Returns the index of leg or joint `n`, from 0.
pub(super) fn index(n: u8) -> usize {
    usize::from(n).wrapping_sub(1)
}

/// Returns the entry of leg or joint `n`.
pub(super) fn leg_mut<T>(legs: &mut [T], n: u8) -> Result<&mut T, Fault> {
    legs.get_mut(index(n)).ok_or(Fault::Domain)
}

/// Returns the entries of the one leg, or of all legs, that a target names.
pub(super) fn feet<T>(legs: &mut [T], target: Target) -> Result<&mut [T], Fault> {
    match target {
        Target::All => Ok(legs),
        Target::Foot(n) => {
            let at = index(n);
            legs.get_mut(at..at.wrapping_add(1)).ok_or(Fault::Domain)
        }
        Target::None | Target::Floor | Target::Joint(..) => Err(Fault::Domain),
    }
}

/// Returns the number, from 1, of the leg or joint at `index`.
pub(super) fn number(index: usize) -> u8 {
    u8::try_from(index).map_or(u8::MAX, |index| index.saturating_add(1))
}

/// Returns `InvalidMode` if `is_locked`.
pub(super) fn unlocked(is_locked: bool) -> Result<(), Fault> {
    if is_locked {
        Err(Fault::InvalidMode)
    } else {
        Ok(())
    }
}

/// Returns the joint (from 0) that a target names, if it names one alone.
pub(super) fn joint_of(target: Target) -> Option<usize> {
    match target {
        Target::Joint(_, m) => Some(index(m)),
        Target::None | Target::All | Target::Floor | Target::Foot(_) => None,
    }
}
