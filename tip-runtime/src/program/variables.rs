//! A program's variables by their names, for whoever runs it.

use super::Program;
use crate::command::CONSTANT;
use core::fmt;

/// The reason why a variable cannot be read or set by that name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum VariableError {
    /// The program has no variable of that name; a struct has only members, such as `P.X`.
    Unknown,
    /// The name is a constant of the language.
    Constant,
    /// The value is infinite or is not a number.
    NotFinite,
}

impl fmt::Display for VariableError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            VariableError::Unknown => "the program has no variable of that name",
            VariableError::Constant => "that name is a constant",
            VariableError::NotFinite => "a variable holds finite numbers only",
        })
    }
}

impl core::error::Error for VariableError {}

/// Returns the value of a variable.
pub(super) fn get<P: Program + ?Sized>(
    program: &P,
    name: &str,
) -> Result<Option<f64>, VariableError> {
    let (_, value) = find(program, name)?;
    Ok(value)
}

/// Assigns a variable.
pub(super) fn set<P: Program + ?Sized>(
    program: &mut P,
    name: &str,
    value: f64,
) -> Result<(), VariableError> {
    let index = settable(program, name, value)?;
    program.set_scalar(index, value);
    Ok(())
}

/// Returns the index of a variable that can have a value.
pub(super) fn settable<P: Program + ?Sized>(
    program: &P,
    name: &str,
    value: f64,
) -> Result<usize, VariableError> {
    let (index, _) = find(program, name)?;
    match value.is_finite() {
        true => Ok(index),
        false => Err(VariableError::NotFinite),
    }
}

/// Returns index and value of the scalar of that name.
fn find<P: Program + ?Sized>(
    program: &P,
    name: &str,
) -> Result<(usize, Option<f64>), VariableError> {
    let mut index = 0;
    while let Some((scalar, value)) = program.scalar(index) {
        if scalar.eq_ignore_ascii_case(name) {
            return Ok((index, value));
        }
        index += 1;
    }
    let start = name.get(..CONSTANT.len());
    match start.is_some_and(|start| start.eq_ignore_ascii_case(CONSTANT)) {
        true => Err(VariableError::Constant),
        false => Err(VariableError::Unknown),
    }
}

#[cfg(test)]
mod tests;
