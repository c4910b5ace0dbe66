//! The robot of the command line: one with a name, or one with a description.

use super::choices::RobotName;
use super::error::Error;
use super::input;
use super::usage::Wrong;
use crate::message::Using;
use clap::ValueEnum;
use std::fmt;
use std::path::{Path, PathBuf};
use std::str::FromStr;
use tipc::description::Description;
use tipc::message::list::Each;
use tipc::published::{self, Published};
use tipc::{Loaded, Robot};

/// `NAME` or `FILE.toml`, as `--robot` has it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum RobotChoice {
    Named(RobotName),
    Published(&'static Published),
    File(PathBuf),
}

impl FromStr for RobotChoice {
    type Err = Wrong;

    fn from_str(text: &str) -> Result<Self, Wrong> {
        let is_file = Path::new(text).extension().is_some_and(|end| end == "toml");
        if let Ok(name) = RobotName::from_str(text, true) {
            Ok(RobotChoice::Named(name))
        } else if let Some(robot) = published::find(&text.to_lowercase()) {
            Ok(RobotChoice::Published(robot))
        } else if is_file {
            Ok(RobotChoice::File(text.into()))
        } else {
            Err(Wrong(no_robot(text)))
        }
    }
}

impl Default for RobotChoice {
    fn default() -> Self {
        RobotChoice::Named(RobotName::Titan8)
    }
}

impl fmt::Display for RobotChoice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            RobotChoice::Named(name) => f.write_str(name.robot().name()),
            RobotChoice::Published(robot) => f.write_str(robot.name),
            RobotChoice::File(path) => path.display().fmt(f),
        }
    }
}

/// How alike two names are of which one may be meant by the other, from 0 to 1.
const ALIKE: f64 = 0.75;

/// A name that no robot has.
fn no_robot(text: &str) -> Using {
    let values = RobotName::value_variants().iter();
    let names = values.filter_map(|name| Some(name.to_possible_value()?.get_name().to_owned()));
    let published = published::ALL.iter().map(|robot| robot.name.to_owned());
    let names: Vec<String> = names.chain(published).collect();
    let small = text.to_lowercase();
    let likeness = |name: &String| strsim::jaro_winkler(&small, name);
    let near = names
        .iter()
        .max_by(|a, b| likeness(a).total_cmp(&likeness(b)));
    let near = near.filter(|near| likeness(near) >= ALIKE).cloned();
    let (word, robots) = (text.to_owned(), Each(names));
    match near {
        Some(near) => Using::NearRobot { word, near, robots },
        None => Using::NoRobot { word, robots },
    }
}

/// A robot that is there to be used.
pub(super) enum ChosenRobot {
    Named(RobotName),
    Described(Box<Description>),
}

impl RobotChoice {
    /// The file that it is read from, if there is one.
    pub(super) fn file(&self) -> Option<&Path> {
        match self {
            RobotChoice::Named(_) | RobotChoice::Published(_) => None,
            RobotChoice::File(path) => Some(path),
        }
    }

    /// The same; a file that has no folder of its own is beside another one.
    pub(super) fn beside(self, other: Option<&Path>) -> Self {
        match (self, other.and_then(Path::parent)) {
            (RobotChoice::File(path), Some(folder)) => RobotChoice::File(folder.join(path)),
            (choice, _) => choice,
        }
    }

    /// Reads the description, if there is one.
    pub(super) fn load(&self) -> Result<ChosenRobot, Box<Loaded>> {
        match self {
            RobotChoice::Named(name) => Ok(ChosenRobot::Named(*name)),
            RobotChoice::Published(robot) => Ok(ChosenRobot::Described(Box::new(robot.read()?))),
            RobotChoice::File(path) => {
                let description = input::describe(path)?;
                Ok(ChosenRobot::Described(Box::new(description)))
            }
        }
    }
}

impl ChosenRobot {
    /// The robot before its first control cycle.
    pub(super) fn simulated(&self) -> Result<tip_sim::Robot, Error> {
        match self {
            ChosenRobot::Named(name) => tip_sim::Robot::named(name.robot().name())
                .map_err(|unknown| Error::Usage(unknown.to_string())),
            ChosenRobot::Described(description) => Ok(tip_sim::Robot::described(description)),
        }
    }

    /// What programs are checked for.
    pub(super) fn robot(&self) -> Robot {
        match self {
            ChosenRobot::Named(name) => name.robot(),
            ChosenRobot::Described(description) => description.robot(),
        }
    }
}
