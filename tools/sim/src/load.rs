//! Programs from text.

use crate::diagnostics;
use crate::interp::Interpreter;
use crate::robot::Robot;
use std::fmt;
use tipc::Loaded;

/// Loads the text of a program for a robot, to be run by the reference interpreter. `name` is how messages call it.
///
/// # Errors
/// Everything that is wrong with the text.
pub fn load(name: &str, text: &str, robot: &Robot) -> Result<Interpreter, LoadError> {
    let mut loaded = tip_lint::load(name, text.as_bytes(), &robot.options());
    match loaded.program.take() {
        Some(program) => Ok(Interpreter::new(program)),
        None => Err(LoadError(Box::new(loaded))),
    }
}

/// A text that is not a program for this robot. Shown, it is one line for each finding.
#[derive(Debug)]
pub struct LoadError(Box<Loaded>);

impl LoadError {
    /// Returns the diagnostics, each at its place in the text.
    pub fn loaded(&self) -> &Loaded {
        &self.0
    }
}

impl fmt::Display for LoadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        diagnostics::write(&self.0, f)
    }
}

impl std::error::Error for LoadError {}
