//! The parts of a new crate that depend on its robot: the model, a motion, and the code that shows and tests it.

use super::motion;
use crate::choices::RobotName;
use crate::input;
use crate::message::Making;
use crate::setup::{RobotChoice, RobotParser, unknown_robot};
use crate::usage::BadValue;
use clap::builder::ValueParserFactory;
use std::str::FromStr;
use tip_runtime::model::{Model as RobotModel, hand, titan8};
use tip_sim::Robot;
use tipc::Loaded;
use tipc::language::Edition;

/// The description of the hexapod.
const HEXAPOD: &str = include_str!("../../templates/hexapod.toml");
/// The name of the hexapod.
const HEXAPOD_NAME: &str = "hexapod";

/// The robot of the command line.
#[derive(Clone, Debug)]
pub(super) enum Choice {
    Robot(RobotChoice),
    Hexapod,
}

impl ValueParserFactory for Choice {
    type Parser = RobotParser<Self>;

    fn value_parser() -> Self::Parser {
        RobotParser::new(&[HEXAPOD_NAME])
    }
}

impl FromStr for Choice {
    type Err = BadValue;

    fn from_str(text: &str) -> Result<Self, BadValue> {
        match text.eq_ignore_ascii_case(HEXAPOD_NAME) {
            true => Ok(Choice::Hexapod),
            false => {
                let chosen = text.parse().map(Choice::Robot);
                let unknown = |_| BadValue(unknown_robot(text, &[HEXAPOD_NAME]));
                chosen.map_err(unknown)
            }
        }
    }
}

/// A motion with the code that shows and tests it.
#[derive(Debug)]
pub(super) struct Motion {
    /// The name of its file, without extension.
    pub(super) stem: &'static str,
    pub(super) program: String,
    pub(super) main: &'static str,
    pub(super) test: &'static str,
    /// Minimum travel, mm.
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

    /// Returns a gait for a robot that can walk; else a motion that bends one leg after the other.
    fn of(robot: &Robot) -> Self {
        if robot.anatomy().body.is_none() {
            return Motion::bend(robot, motion::BEND_ANGLE);
        }
        match motion::find_gait(robot) {
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
                let small = motion::BEND_ANGLES
                    .into_iter()
                    .map(|turn| Motion::bend(robot, turn));
                let falls = |motion: &Motion| motion::count_falls(&motion.program, robot);
                let bending = small.into_iter().find(|motion| falls(motion) == 0);
                let bending = bending.unwrap_or_else(|| Motion::bend(robot, motion::BEND_ANGLE));
                let falls = falls(&bending);
                Motion {
                    tried: vec![Making::NoGait { falls }, reason],
                    ..bending
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
            program: motion::bend_program(&robot.anatomy(), turn),
            main: include_str!("../../templates/main_walk.rs"),
            test: include_str!("../../templates/test_bend.rs"),
            travel: 0.0,
            tried: vec![],
        }
    }
}

/// The parts of a new crate that depend on its robot.
#[derive(Debug)]
pub(super) struct Template {
    pub(super) motion: Motion,
    pub(super) robot: String,
    /// Its description, unless the runtime has the robot.
    pub(super) description: Option<Vec<u8>>,
    pub(super) legs: usize,
    /// Joints of each leg.
    pub(super) joints: usize,
    /// The file of the scene.
    pub(super) scene: Option<&'static str>,
}

impl Template {
    /// Returns the parts with the motion in an edition of the language; its words are of every edition.
    pub(super) fn in_edition(mut self, edition: Edition) -> Self {
        if let Some((_, rest)) = self.motion.program.split_once('\n') {
            self.motion.program = format!("{edition}\n{rest}");
        }
        self
    }
}

impl Choice {
    /// Returns the parts for this robot.
    ///
    /// # Errors
    /// The description has errors.
    pub(super) fn template(&self) -> Result<Template, Box<Loaded>> {
        let walk = || Motion::walk(include_str!("../../templates/motions/walk.prg"));
        let tripod = || Motion::walk(include_str!("../../templates/motions/tripod.prg"));
        match self {
            Choice::Hexapod => {
                let template = |_: &Robot| tripod();
                described(HEXAPOD_NAME, HEXAPOD.as_bytes().to_vec(), template)
            }
            Choice::Robot(RobotChoice::File(path)) => {
                let (name, bytes) = input::description(path)?;
                described(&name, bytes, Motion::of)
            }
            Choice::Robot(RobotChoice::Published(robot)) => {
                described(&robot.file(), robot.text.as_bytes().to_vec(), Motion::of)
            }
            Choice::Robot(RobotChoice::Named(name)) => Ok(match name {
                RobotName::Titan8 | RobotName::Generic => named(*name, &titan8::MODEL, walk()),
                RobotName::Hand => Template {
                    scene: Some(include_str!("../../templates/scene.toml")),
                    ..named(*name, &hand::MODEL, Motion::grasp())
                },
            }),
        }
    }
}

/// Returns the parts for a robot of the runtime.
fn named<const L: usize, const J: usize>(
    name: RobotName,
    _: &RobotModel<L, J>,
    motion: Motion,
) -> Template {
    Template {
        motion,
        robot: name.robot().name().to_owned(),
        description: None,
        legs: L,
        joints: J,
        scene: None,
    }
}

/// Returns the parts for a described robot.
fn described(
    name: &str,
    description: Vec<u8>,
    motion: impl Fn(&Robot) -> Motion,
) -> Result<Template, Box<Loaded>> {
    let robot = Robot::described(&tipc::description::parse(name, &description)?);
    let anatomy = robot.anatomy();
    Ok(Template {
        motion: motion(&robot),
        robot: robot.name().to_owned(),
        description: Some(description),
        legs: anatomy.legs.len(),
        joints: anatomy.joints,
        scene: None,
    })
}
