//! Programs from text.

use crate::findings;
use crate::interp::Interpreter;
use crate::robot::Robot;
use std::fmt;
use tipc::Loaded;

/// Loads the text of a program for a robot, to be run by the reference interpreter. `name` is how messages call it.
///
/// # Errors
/// Everything that is wrong with the text.
pub fn load(name: &str, text: &str, robot: &Robot) -> Result<Interpreter, NotLoaded> {
    let mut loaded = tip_lint::load(name, text.as_bytes(), &robot.options());
    match loaded.program.take() {
        Some(program) => Ok(Interpreter::new(program)),
        None => Err(NotLoaded(Box::new(loaded))),
    }
}

/// A text that is not a program for this robot. Shown, it is one line for each finding.
#[derive(Debug)]
pub struct NotLoaded(Box<Loaded>);

impl NotLoaded {
    /// The findings, each at its place in the text.
    pub fn loaded(&self) -> &Loaded {
        &self.0
    }
}

impl fmt::Display for NotLoaded {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        findings::write(&self.0, f)
    }
}

impl std::error::Error for NotLoaded {}
