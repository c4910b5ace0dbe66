//! Name of the robot.

use super::section::{Found, Section};
use crate::message::{Describing, Letter};
use crate::robot::Robot;

/// The longest name, in characters.
const LONGEST: usize = 40;

/// Reads the robot's name, if it is one.
pub(super) fn read<'a>(robot: Section<'a>, found: &mut Found) -> Option<&'a str> {
    let (location, name) = robot.text("name", found)?;
    let allowed = |c: char| c.is_alphanumeric() || " -_.".contains(c);
    let reason = if name.trim().is_empty() {
        Describing::NeedsName
    } else if name.trim() != name {
        Describing::BlankAtEnd
    } else if name.chars().count() > LONGEST {
        Describing::NameTooLong { most: LONGEST }
    } else if let Some(character) = name.chars().find(|c| !allowed(*c)) {
        Describing::NotInName {
            character: Letter(character),
        }
    } else if Robot::from_name(name).is_some() {
        Describing::KnownRobot
    } else {
        return Some(name);
    };
    robot.refuse("name", location, reason, found)
}
