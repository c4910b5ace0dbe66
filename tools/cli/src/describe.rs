//! `tip robot`: descriptions of robots.

mod export;
mod foot;
mod import;
mod list;

use super::choices::Format;
use super::error::Error;
use super::shown::Shown;
use super::{Status, input, output, report};
use clap::{Args, Subcommand};
use std::fmt::Write as _;
use std::path::PathBuf;
use tip_sim::{Anatomy, Robot};

/// What to do with a robot's description.
#[derive(Debug, Subcommand)]
pub(super) enum RobotVerb {
    /// List the robots that have a name
    List(list::List),
    /// Show what a robot has, and where the figures of a published one come from
    Show(list::Show),
    /// Report everything that is wrong with a description, or what the robot has
    Check(CheckRobot),
    /// Make a description of a URDF file
    Import(import::Import),
    /// Write a robot as URDF, or as a model of MuJoCo
    Export(export::Export),
}

/// `tip robot check`
#[derive(Debug, Args)]
#[command(after_help = "Example:
  tip robot check hexapod.toml

Exit status: 0 if the description can be used, 1 otherwise.")]
pub(super) struct CheckRobot {
    /// The description
    #[arg(value_name = "FILE.toml")]
    pub(super) file: PathBuf,

    #[command(flatten)]
    pub(super) shown: Shown,
}

/// Does what the command line says.
pub(super) fn robot(verb: &RobotVerb) -> Result<Status, Error> {
    match verb {
        RobotVerb::List(_) => list::list(),
        RobotVerb::Show(arguments) => list::show(arguments),
        RobotVerb::Check(arguments) => check(arguments),
        RobotVerb::Import(arguments) => import::import(arguments),
        RobotVerb::Export(arguments) => export::export(arguments),
    }
}

/// Shows every fault of a description, or what the robot has.
fn check(arguments: &CheckRobot) -> Result<Status, Error> {
    match input::describe(&arguments.file) {
        Ok(description) => {
            if arguments.shown.message_format == Format::Human {
                output::print(summary(&Robot::described(&description)))?;
            }
            Ok(Status::Success)
        }
        Err(loaded) => {
            report::check(&loaded, arguments.shown)?;
            Ok(Status::Failure)
        }
    }
}

/// What a robot has, in words.
fn summary(robot: &Robot) -> String {
    let Anatomy {
        body,
        forces,
        inverse,
        joints,
        feet,
        ..
    } = robot.anatomy();
    let standing = body.map_or("bolted down".to_owned(), |body| {
        format!("body of {} kg", body.mass)
    });
    let forces = forces.map_or(
        "no commands of torque, force and compliance".to_owned(),
        |forces| {
            format!(
                "torque up to {} {}",
                forces.torque_max,
                forces.unit.symbol()
            )
        },
    );
    let (name, legs) = (robot.name(), feet.len());
    let (of_legs, of_joints) = (report::plural(legs, "leg"), report::plural(joints, "joint"));
    let mut text = format!(
        "{name}: {of_legs} of {of_joints}, {standing}\n\
         F1 to F{legs}, J11 to J{legs}{joints}, members J1 to J{joints}; {forces}\n\
         inverse kinematics: {}\n\
         feet in the initial posture, in mm:\n",
        inverse.name()
    );
    for (number, foot) in (1..).zip(feet) {
        // Adding 0 makes of −0 a plain 0.
        let [x, y, z] = foot.map(|at| at + 0.0);
        // Writing to a String cannot fail.
        let _ = writeln!(text, "  F{number}  {x:.1} {y:.1} {z:.1}");
    }
    text
}
