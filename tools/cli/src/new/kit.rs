//! What a crate is made of that depends on its robot: the model, a motion, and what shows and tests it.

use super::{bend, gait};
use crate::choices::RobotName;
use crate::input;
use crate::message::Making;
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
    /// How far it walks at least: mm.
    pub(super) travel: f64,
    /// The results of trying it on the simulated robot, one per line.
    pub(super) tried: Vec<Making>,
}

impl Motion {
    fn walk(program: &str) -> Self {
        Motion {
            stem: "walk",
            program: program.to_owned(),
            main: include_str!("../../templates/main_walk.rs"),
            test: include_str!("../../templates/test_walk.rs"),
            travel: 500.0,
            tried: vec![],
        }
    }

    /// A gait for a robot that walks, if there is one; else one leg after the other bends.
    fn of(robot: &Robot) -> Self {
        if robot.anatomy().body.is_none() {
            return Motion::bend(robot, bend::TURN);
        }
        match gait::find(robot) {
            Ok(gait) => Motion {
                travel: (0.9 * gait.travel).floor(),
                tried: vec![match gait.has_mass {
                    true => Making::Walks {
                        travel: gait.travel.round(),
                    },
                    false => Making::WalksWithoutMass {
                        travel: gait.travel.round(),
                    },
                }],
                ..Motion::walk(&gait.program)
            },
            Err(reason) => {
                let small = bend::TURNS
                    .into_iter()
                    .map(|turn| Motion::bend(robot, turn));
                let falls = |motion: &Motion| bend::falls(&motion.program, robot);
                let motion = small.into_iter().find(|motion| falls(motion) == 0);
                let motion = motion.unwrap_or_else(|| Motion::bend(robot, bend::TURN));
                let falls = falls(&motion);
                Motion {
                    tried: vec![Making::NoGait { falls }, reason],
                    ..motion
                }
            }
        }
    }

    fn grasp() -> Self {
        Motion {
            stem: "grasp",
            program: include_str!("../../templates/motions/grasp.prg").to_owned(),
            main: include_str!("../../templates/main_grasp.rs"),
            test: include_str!("../../templates/test_grasp.rs"),
            travel: 0.0,
            tried: vec![],
        }
    }

    fn bend(robot: &Robot, turn: f64) -> Self {
        Motion {
            stem: "bend",
            program: bend::program(&robot.anatomy(), turn),
            main: include_str!("../../templates/main_walk.rs"),
            test: include_str!("../../templates/test_bend.rs"),
            travel: 0.0,
            tried: vec![],
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
                described(&name, bytes, Motion::of)
            }
            Choice::Robot(RobotChoice::Published(robot)) => {
                described(&robot.file(), robot.text.as_bytes().to_vec(), Motion::of)
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
