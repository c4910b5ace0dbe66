//! Robots from descriptions.

use crate::diagnostics;
use crate::robot::Robot;
use std::fmt;
use tip_runtime::model::Model;
use tipc::description::{self, Description, WithModel};
use tipc::{Loaded, published};

impl Robot {
    /// Returns a walking robot from the text of its description (`docs/robots.md`).
    ///
    /// # Errors
    /// Everything that is wrong with the text.
    pub fn description(toml: &str) -> Result<Self, DescriptionError> {
        let parsed = description::parse("robot.toml", toml.as_bytes());
        parsed
            .map(|robot| Self::described(&robot))
            .map_err(DescriptionError)
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

/// A text that describes no robot. Shown, it is one line for each fault.
#[derive(Debug)]
pub struct DescriptionError(Box<Loaded>);

impl DescriptionError {
    /// Returns the faults, each at its place in the text.
    pub fn loaded(&self) -> &Loaded {
        &self.0
    }
}

impl fmt::Display for DescriptionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        diagnostics::write(&self.0, f)
    }
}

impl std::error::Error for DescriptionError {}
