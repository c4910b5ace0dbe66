//! `tip robot export`: a robot in a form that other tools read.

use super::import::{self, is_urdf};
use super::{Status, output, report};
use crate::error::Error;
use crate::robot::RobotChoice;
use crate::scene::{self, SceneChoice};
use crate::shown::Shown;
use crate::usage::Wrong;
use clap::Args;
use std::path::{Path, PathBuf};
use std::str::FromStr;
use tip_sim::{Robot, mjcf, urdf};

/// `tip robot export`
#[derive(Debug, Args)]
#[command(
    after_help = "The joints are J11, J12, …, each link is link11, link12, …, the feet are F1, F2, …; base_link is the robot frame, with x
forward, y left and z up. A robot that is bolted down hangs on the link world. A slider becomes prismatic joints to the link floor.
A model of MuJoCo has the same names, x to the right and y forward; its motors take the angles that joints are commanded (rad).

Examples:
  tip robot export --urdf -o titan8.urdf
  tip robot export --urdf --robot hexapod.toml -o hexapod.urdf
  tip robot export --mjcf --scene steps.toml -o titan8.xml

Exit status: 0 if the file is written, 1 otherwise."
)]
pub(crate) struct Export {
    /// Write URDF, with boxes, cylinders and spheres for its shapes
    #[arg(long, required_unless_present = "mjcf")]
    urdf: bool,

    /// Write a model of MuJoCo (MJCF), with motors, contacts and what surrounds the robot
    #[arg(long, conflicts_with = "urdf")]
    mjcf: bool,

    /// What surrounds the robot: cylinder, an object under a hand, or a scene of your own
    #[arg(long, value_name = "NAME|FILE.toml", conflicts_with = "urdf")]
    scene: Option<SceneChoice>,

    /// The robot: a name that 'tip robot list' shows, a description, or a URDF file that is to be made regular
    #[arg(
        long,
        value_name = "NAME|FILE.toml|FILE.urdf",
        default_value = "titan8"
    )]
    robot: Model,

    /// Write to a file instead of standard output
    #[arg(short, long, value_name = "OUT")]
    out: Option<PathBuf>,

    #[command(flatten)]
    shown: Shown,
}

/// Where the robot comes from.
#[derive(Clone, Debug)]
enum Model {
    Robot(RobotChoice),
    Urdf(PathBuf),
}

impl FromStr for Model {
    type Err = Wrong;

    fn from_str(text: &str) -> Result<Self, Wrong> {
        match is_urdf(Path::new(text)) {
            true => Ok(Model::Urdf(text.into())),
            false => text.parse().map(Model::Robot),
        }
    }
}

/// Writes the robot.
pub(super) fn export(arguments: &Export) -> Result<Status, Error> {
    let Some(robot) = robot(arguments)? else {
        return Ok(Status::Failure);
    };
    let text = match arguments.mjcf {
        false => urdf::export(&robot),
        true => match scene::load(arguments.scene.as_ref(), None) {
            Ok(scene) => mjcf::export(&scene::around(robot, &scene)?),
            Err(loaded) => {
                report::findings(&loaded, arguments.shown);
                return Ok(Status::Failure);
            }
        },
    };
    match &arguments.out {
        Some(out) => {
            let robot = match &arguments.robot {
                Model::Robot(choice) => choice.file(),
                Model::Urdf(path) => Some(path.as_path()),
            };
            let scene = arguments.scene.as_ref().and_then(SceneChoice::file);
            let files: Vec<&Path> = robot.into_iter().chain(scene).collect();
            output::refuse_inputs(out, &files)?;
            output::replace(out, text)?;
        }
        None => output::print(text)?,
    }
    Ok(Status::Success)
}

/// The robot; none if something was found in its file, and reported.
fn robot(arguments: &Export) -> Result<Option<Robot>, Error> {
    match &arguments.robot {
        Model::Robot(choice) => match choice.load() {
            Ok(robot) => Ok(Some(robot.simulated()?)),
            Err(loaded) => {
                report::findings(&loaded, arguments.shown);
                Ok(None)
            }
        },
        Model::Urdf(path) => {
            let options = urdf::ImportOptions::default();
            let Some(imported) = import::read(path, &options, arguments.shown.lang()) else {
                return Ok(None);
            };
            let robot = Robot::description(&imported.toml);
            robot.map(Some).map_err(|bad| Error::Usage(bad.to_string()))
        }
    }
}
