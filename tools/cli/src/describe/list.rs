//! `tip robot list` and `tip robot show`: the robots that have a name.

use super::summary;
use crate::Status;
use crate::choices::RobotName;
use crate::error::Error;
use crate::robot::RobotChoice;
use crate::shown::Shown;
use crate::{output, report};
use clap::{Args, ValueEnum};
use std::fmt::Write as _;
use tipc::published;

/// `tip robot list`
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  tip robot list
  tip run march.prg --robot phantomx    wherever a robot is chosen, any of these names is

docs/robots.md says where the figures come from.")]
pub(crate) struct List {}

/// `tip robot show`
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  tip robot show titan8
  tip robot show a1                 with its figures and where they come from
  tip robot show a1 > mine.toml     a description to be changed

Exit status: 0 if there is such a robot and its description can be used, 1 otherwise.")]
pub(crate) struct Show {
    /// The robot: a name that 'tip robot list' shows, or a description
    #[arg(value_name = "NAME|FILE.toml")]
    robot: RobotChoice,

    #[command(flatten)]
    pub(crate) shown: Shown,
}

/// Prints each name and what robot has it.
pub(super) fn list() -> Result<Status, Error> {
    let values = RobotName::value_variants().iter();
    let values = values.filter_map(ValueEnum::to_possible_value);
    let named = values.map(|value| {
        let what = value.get_help().map(ToString::to_string);
        (value.get_name().to_owned(), what.unwrap_or_default())
    });
    let published = published::ALL.iter();
    let published = published.map(|robot| (robot.name.to_owned(), robot.summary().to_owned()));
    let mut text = String::new();
    for (name, what) in named.chain(published) {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "{name:<10}  {what}");
    }
    output::print(text)?;
    Ok(Status::Success)
}

/// Prints what a robot has; of a published one also its description, so that the whole is one.
pub(super) fn show(arguments: &Show) -> Result<Status, Error> {
    let robot = match arguments.robot.load() {
        Ok(robot) => robot.simulated()?,
        Err(loaded) => {
            report::check(&loaded, arguments.shown)?;
            return Ok(Status::Failure);
        }
    };
    let has = summary(&robot);
    let text = match &arguments.robot {
        RobotChoice::Published(robot) => {
            let has: String = has.lines().map(|line| format!("# {line}\n")).collect();
            format!("{}\n{has}", robot.text)
        }
        _ => has,
    };
    output::print(text)?;
    Ok(Status::Success)
}
