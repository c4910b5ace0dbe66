//! `tipc robot`: descriptions of robots.

use super::choices::Format;
use super::error::Error;
use super::shown::Shown;
use super::{Status, input, output, report};
use clap::{Args, Subcommand};
use std::fmt::Write as _;
use std::fs;
use std::path::PathBuf;
use tip_runtime::printable::Printable;
use tip_sim::{Anatomy, Robot, urdf};

/// What to do with a robot's description.
#[derive(Debug, Subcommand)]
pub(super) enum RobotVerb {
    /// Report everything that is wrong with a description, or what the robot has
    Check(CheckRobot),
    /// Make a description of a URDF file
    Import(Import),
}

/// `tipc robot check`
#[derive(Debug, Args)]
#[command(after_help = "Example:
  tipc robot check hexapod.toml

Exit status: 0 if the description can be used, 1 otherwise.")]
pub(super) struct CheckRobot {
    /// The description
    #[arg(value_name = "FILE.toml")]
    pub(super) file: PathBuf,

    #[command(flatten)]
    pub(super) shown: Shown,
}

/// `tipc robot import`
#[derive(Debug, Args)]
#[command(
    after_help = "Each chain of revolute or continuous joints from the base to a last link becomes a leg; fixed joints are merged. The
foot is the link at the end, on a fixed joint. A report on standard error lists what was assumed and what was dropped.

Example:
  tipc robot import quadruped.urdf -o quadruped.toml

Exit status: 0 if the description is written, 1 otherwise."
)]
pub(super) struct Import {
    /// The URDF file; xacro has to be expanded first
    #[arg(value_name = "FILE.urdf")]
    pub(super) file: PathBuf,

    /// Write to a file instead of standard output
    #[arg(short, long, value_name = "OUT.toml")]
    pub(super) out: Option<PathBuf>,
}

/// Does what the command line says.
pub(super) fn robot(verb: &RobotVerb) -> Result<Status, Error> {
    match verb {
        RobotVerb::Check(arguments) => check(arguments),
        RobotVerb::Import(arguments) => import(arguments),
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
        |forces| format!("torque up to {} {:?}", forces.torque_max, forces.unit),
    );
    let (name, legs) = (robot.name(), feet.len());
    let (of_legs, of_joints) = (report::plural(legs, "leg"), report::plural(joints, "joint"));
    let mut text = format!(
        "{name}: {of_legs} of {of_joints}, {standing}\n\
         F1 to F{legs}, J11 to J{legs}{joints}, members J1 to J{joints}; {forces}\n\
         inverse kinematics: {inverse:?}\n\
         feet in the initial posture, in mm:\n"
    );
    for (number, foot) in (1..).zip(feet) {
        // Adding 0 makes of −0 a plain 0.
        let [x, y, z] = foot.map(|at| at + 0.0);
        // Writing to a String cannot fail.
        let _ = writeln!(text, "  F{number}  {x:.1} {y:.1} {z:.1}");
    }
    text
}

/// Writes the description that a URDF file makes; the report goes to standard error.
fn import(arguments: &Import) -> Result<Status, Error> {
    let path = &arguments.file;
    let name = Printable::line(path.display());
    let read = fs::read(path).map_err(|reason| reason.to_string());
    let text = read.map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
    let imported = text.and_then(|text| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        urdf::import(&name, &text).map_err(|reason| reason.to_string())
    });
    let imported = match imported {
        Ok(imported) => imported,
        Err(reason) => {
            report::complain(&format!("error: {name}: {}\n", Printable::line(reason)));
            return Ok(Status::Failure);
        }
    };
    match &arguments.out {
        Some(out) => {
            output::refuse_inputs(out, &[path])?;
            output::replace(out, &imported.toml)?;
        }
        None => output::print(&imported.toml)?,
    }
    for line in &imported.report {
        report::complain(&format!("{name}: {}\n", Printable::line(line)));
    }
    Ok(Status::Success)
}
