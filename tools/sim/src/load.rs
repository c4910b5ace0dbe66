//! Programs and robots from text.

use crate::interp::Interpreter;
use crate::robot::Robot;
use std::fmt;
use tip_runtime::model::Model;
use tipc::description::{self, Description, WithModel};
use tipc::message::Lang;
use tipc::{Loaded, published, render};

/// Loads the text of a program for a robot, to be run by the reference interpreter. `name` is its name in messages.
///
/// # Errors
/// All errors of the text.
pub fn load(name: &str, text: &str, robot: &Robot) -> Result<Interpreter, LoadError> {
    let mut loaded = tip_lint::load(name, text.as_bytes(), &robot.options());
    match loaded.program.take() {
        Some(program) => Ok(Interpreter::new(program)),
        None => Err(LoadError(Box::new(loaded))),
    }
}

/// A text that is not a program for this robot, or that describes no robot. Shown, it is one line for each diagnostic.
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
        let Loaded {
            source,
            diagnostics,
            ..
        } = &*self.0;
        let line = |diagnostic| render::short(source, diagnostic, Lang::English);
        let lines: Vec<String> = diagnostics
            .iter()
            .map(|diagnostic| line(diagnostic).trim_end().to_owned())
            .collect();
        f.write_str(&lines.join("\n"))
    }
}

impl std::error::Error for LoadError {}

impl Robot {
    /// Returns a walking robot from the text of its description (`docs/robots.md`).
    ///
    /// # Errors
    /// All errors of the text.
    pub fn from_description(toml: &str) -> Result<Self, LoadError> {
        let parsed = description::parse("robot.toml", toml.as_bytes());
        parsed
            .map(|robot| Self::described(&robot))
            .map_err(LoadError)
    }

    /// Returns one of the robots that are published.
    pub(crate) fn published(name: &str) -> Option<Self> {
        let description = published::find(name)?.read().ok()?;
        Some(Self::described(&description))
    }

    /// Returns a walking robot from a description that was read.
    pub fn described(description: &Description) -> Self {
        let robot = description.with_model(BuildRobot);
        robot.with_shapes(description.shapes())
    }
}

/// Makes a robot of a model of any size.
struct BuildRobot;

impl WithModel for BuildRobot {
    type Output = Robot;

    fn with<const L: usize, const J: usize>(self, model: &Model<L, J>) -> Robot {
        Robot::of(model)
    }
}
