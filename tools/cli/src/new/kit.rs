//! What a crate is made of that depends on its robot: the model, a motion, and what shows and tests it.

use super::bend;
use crate::choices::RobotName;
use crate::input;
use crate::robot::RobotChoice;
use crate::usage::Wrong;
use std::str::FromStr;
use tip_runtime::model::{Model as RobotModel, hand, titan8};
use tip_sim::Robot;
use tipc::Loaded;

/// The description of six legs that comes with this command.
const HEXAPOD: &str = include_str!("../../templates/hexapod.toml");
/// How it is asked for.
const HEXAPOD_NAME: &str = "hexapod";

/// The robot of the command line.
#[derive(Clone, Debug)]
pub(super) enum Choice {
    Robot(RobotChoice),
    Hexapod,
}

impl FromStr for Choice {
    type Err = Wrong;

    fn from_str(text: &str) -> Result<Self, Wrong> {
        match text.eq_ignore_ascii_case(HEXAPOD_NAME) {
            true => Ok(Choice::Hexapod),
            false => text.parse().map(Choice::Robot),
        }
    }
}

/// A motion, and what shows and tests it.
#[derive(Debug)]
pub(super) struct Motion {
    /// What its file is called.
    pub(super) stem: &'static str,
    pub(super) program: String,
    pub(super) main: &'static str,
    pub(super) test: &'static str,
}

impl Motion {
    fn walk(program: &str) -> Self {
        Motion {
            stem: "walk",
            program: program.to_owned(),
            main: include_str!("../../templates/main_walk.rs"),
            test: include_str!("../../templates/test_walk.rs"),
        }
    }

    fn grasp() -> Self {
        Motion {
            stem: "grasp",
            program: include_str!("../../templates/motions/grasp.prg").to_owned(),
            main: include_str!("../../templates/main_grasp.rs"),
            test: include_str!("../../templates/test_grasp.rs"),
        }
    }

    fn bend(robot: &Robot) -> Self {
        Motion {
            stem: "bend",
            program: bend::program(&robot.anatomy()),
            main: include_str!("../../templates/main_walk.rs"),
            test: include_str!("../../templates/test_bend.rs"),
        }
    }
}

/// The parts.
#[derive(Debug)]
pub(super) struct Kit {
    pub(super) motion: Motion,
    pub(super) robot: String,
    /// Its description, unless the runtime has the robot.
    pub(super) description: Option<Vec<u8>>,
    pub(super) legs: usize,
    /// Of each leg.
    pub(super) joints: usize,
    /// What surrounds it, as a file.
    pub(super) scene: Option<&'static str>,
}

impl Choice {
    /// The parts for this robot.
    ///
    /// # Errors
    /// What is wrong with its description.
    pub(super) fn kit(&self) -> Result<Kit, Box<Loaded>> {
        let walk = || Motion::walk(include_str!("../../templates/motions/walk.prg"));
        let tripod = || Motion::walk(include_str!("../../templates/motions/tripod.prg"));
        match self {
            Choice::Hexapod => {
                let kit = |_: &Robot| tripod();
                described(HEXAPOD_NAME, HEXAPOD.as_bytes().to_vec(), kit)
            }
            Choice::Robot(RobotChoice::File(path)) => {
                let (name, bytes) = input::bytes(path)?;
                described(&name, bytes, Motion::bend)
            }
            Choice::Robot(RobotChoice::Published(robot)) => {
                described(&robot.file(), robot.text.as_bytes().to_vec(), Motion::bend)
            }
            Choice::Robot(RobotChoice::Named(name)) => Ok(match name {
                RobotName::Titan8 | RobotName::Generic => named(*name, &titan8::MODEL, walk()),
                RobotName::Hand => Kit {
                    scene: Some(include_str!("../../templates/scene.toml")),
                    ..named(*name, &hand::MODEL, Motion::grasp())
                },
            }),
        }
    }
}

/// The parts for a robot of the runtime.
fn named<const L: usize, const J: usize>(
    name: RobotName,
    _: &RobotModel<L, J>,
    motion: Motion,
) -> Kit {
    Kit {
        motion,
        robot: name.robot().name().to_owned(),
        description: None,
        legs: L,
        joints: J,
        scene: None,
    }
}

/// The parts for a described robot.
fn described(
    name: &str,
    description: Vec<u8>,
    motion: impl Fn(&Robot) -> Motion,
) -> Result<Kit, Box<Loaded>> {
    let robot = Robot::described(&tipc::description::parse(name, &description)?);
    let anatomy = robot.anatomy();
    Ok(Kit {
        motion: motion(&robot),
        robot: robot.name().to_owned(),
        description: Some(description),
        legs: anatomy.legs.len(),
        joints: anatomy.joints,
        scene: None,
    })
}
