//! What the robot is called.

use super::section::{Found, Section};
use crate::robot::Robot;

/// The longest name, in characters.
const LONGEST: usize = 40;

/// The robot's name, if it is one.
pub(super) fn read<'a>(robot: Section<'a>, found: &mut Found) -> Option<&'a str> {
    let (place, name) = robot.text("name", found)?;
    let allowed = |c: char| c.is_alphanumeric() || " -_.".contains(c);
    let reason = if name.trim().is_empty() {
        "a robot needs a name".to_owned()
    } else if name.trim() != name {
        "a name neither begins nor ends with a blank".to_owned()
    } else if name.chars().count() > LONGEST {
        format!("a name has {LONGEST} characters at most")
    } else if let Some(other) = name.chars().find(|c| !allowed(*c)) {
        format!("{other:?} cannot stand in a name")
    } else if Robot::from_name(name).is_some() {
        "this is the name of a robot that the compiler knows itself".to_owned()
    } else {
        return Some(name);
    };
    robot.refuse("name", place, reason, found)
}
