//! `tip new`: makes a crate with a robot that moves, a test and settings for editors.

mod bend;
mod files;
mod gait;

use super::choices::OutputOptions;
use super::error::Error;
use super::setup::{RobotChoice, RobotParser, unknown_robot};
use super::{Status, input, output};
use crate::Action;
use crate::choices::Format;
use crate::message::{Making, Using};
use clap::Args;
use clap::builder::ValueParserFactory;
use files::{CratePath, Drives, File, Origin};
use std::fmt::Write as _;
use std::path::PathBuf;
use std::str::FromStr;
use tip_drives::described::{self as buses, Described};
use tip_drives::model::MODELS;
use tip_runtime::model::{Model as RobotModel, Range, generic, hand, titan8};
use tip_runtime::printable::Printable;
use tip_sim::Robot;
use tipc::language::Edition;
use tipc::message::{Lang, Other};
use tipc::{Loaded, description};

#[derive(Debug, Args)]
#[command(after_long_help = "Examples:
  tip new demo && cd demo && cargo run
  tip new grasper --robot hand
  tip new six --robot hexapod                 a description of six legs, to be changed
  tip new hexa --robot phantomx               a gait that sticks or keys steer, the fastest that is safe
  tip new demo --gait crawl                   one that lifts one foot at a time
  tip new ours --robot robots/ours.toml       a robot of your own (docs/robots.md)
  tip new demo --edition 3.2                  a program that may have threads (docs/language.md)
  tip new drives --hardware                   with src/hardware.rs, for drives of your own
  tip new hexa --robot phantomx --hardware    with a bus of servos in robot.toml (docs/drives.md)
  tip new demo --workspace ../tip             depend on this checkout of the project

Exit status: 0 if the crate is made, 1 if not: then nothing is written; 2 if NAME cannot be the name of a crate.")]
pub(super) struct New {
    /// The name of the crate, or the path of a new folder with that name
    #[arg(value_name = "NAME")]
    place: CratePath,

    /// The robot: hexapod, a name or a file
    ///
    /// A name that 'tip robot list' shows, or a description in a file
    #[arg(long, value_name = "NAME|FILE.toml", default_value = "titan8")]
    robot: Choice,

    /// The gait: crawl, wave, tripod or trot
    ///
    /// A program that walks as sticks or keys say, with numbers for this robot (docs/gaits.md). A described robot that
    /// can walk has the fastest gait that is safe
    #[arg(long, value_enum)]
    gait: Option<gait::Kind>,

    /// The edition, 3.1 or 3.2
    ///
    /// By default 3.2 for a gait, else 3.1
    #[arg(long, value_name = "NUMBER", value_parser = edition)]
    edition: Option<Edition>,

    /// Add a program for the real robot
    ///
    /// A described robot gets a bus of servos; others an implementation of Hardware to fill in
    #[arg(long)]
    hardware: bool,

    /// The checkout of this project to depend on
    ///
    /// By default the one that tip was built from, or the published crates
    #[arg(long, value_name = "FOLDER")]
    workspace: Option<PathBuf>,

    #[command(flatten)]
    pub(super) output_options: OutputOptions,
}

/// Parses the number of an edition.
fn edition(text: &str) -> Result<Edition, Using> {
    let number = text.parse::<f64>();
    let mut all = Edition::ALL.iter().copied();
    let edition = all.find(|edition| number == Ok(edition.number()));
    edition.ok_or_else(|| {
        let text = text.to_owned();
        Using::NoSuchEdition { text }
    })
}

impl Action for New {
    fn format(&self) -> Option<Format> {
        Some(self.output_options.message_format)
    }

    fn execute(&self) -> Result<Status, Error> {
        new(self)
    }
}

fn new(arguments: &New) -> Result<Status, Error> {
    let (place, lang) = (&arguments.place, arguments.output_options.lang());
    let failed = |reason: Making| Error::failed(reason, lang);
    let origin = Origin::find(arguments.workspace.as_deref(), place).map_err(failed)?;
    if arguments.gait.is_some()
        && arguments
            .edition
            .is_some_and(|edition| edition < Edition::V3_2)
    {
        return Err(failed(Making::GaitNeedsEdition));
    }
    let refused = Error::refused(arguments.output_options);
    let found = arguments
        .robot
        .template(arguments.gait, arguments.hardware)
        .map_err(refused)?;
    let template = found.map_err(failed)?;
    let template = template.in_edition(arguments.edition).map_err(failed)?;
    let hardware = arguments.hardware.then_some(match template.is_on_bus {
        true => Drives::Bus,
        false => Drives::Own,
    });
    let files = files::crate_files(place, &template, &origin, hardware);
    files::write_crate(place, &files).map_err(failed)?;
    output::print(made(place, &template, &files, &origin, hardware, lang))?;
    Ok(Status::Success)
}

/// Returns the report: files, their dependencies, results of trying the motion, and the next commands.
fn made(
    place: &CratePath,
    template: &Template,
    files: &[File],
    origin: &Origin,
    hardware: Option<Drives>,
    lang: Lang,
) -> String {
    let folder = Printable::line(place.folder().display()).to_string();
    let robot = Printable::line(&template.robot).to_string();
    let made = Making::Made {
        folder: folder.clone().into(),
        robot: robot.clone(),
    };
    let mut text = format!("{}\n", made.in_lang(lang));
    for file in files {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "  {}", file.name);
    }
    let _ = writeln!(text, "{}", origin.message().in_lang(lang));
    if hardware == Some(Drives::Own) {
        let _ = writeln!(text, "{}", Making::OwnDrives { robot }.in_lang(lang));
    }
    for tried in &template.motion.tried {
        let _ = writeln!(text, "{}", tried.in_lang(lang));
    }
    let next = Making::Next.in_lang(lang);
    let _ = writeln!(text, "{next}\n  cd {folder}");
    // Neither needs the other: the command that was installed may have come without a Rust toolchain.
    let motion = files.iter().find(|file| file.name.ends_with(".prg"));
    if let Some(motion) = motion {
        let _ = writeln!(text, "  tip serve {}", motion.name);
    }
    text.push_str("  cargo run\n");
    text
}

/// Replaces the placeholders of a text.
fn fill(text: &str, placeholders: &[(&str, &str)]) -> String {
    let fill_one =
        |text: String, (name, value): &(&str, &str)| text.replace(&format!("<<{name}>>"), value);
    placeholders.iter().fold(text.to_owned(), fill_one)
}

/// The description of the hexapod.
const HEXAPOD: &str = include_str!("../templates/hexapod.toml");
/// The name of the hexapod.
const HEXAPOD_NAME: &str = "hexapod";

/// The robot of the command line.
#[derive(Clone, Debug)]
enum Choice {
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
    type Err = Using;

    fn from_str(text: &str) -> Result<Self, Using> {
        match text.eq_ignore_ascii_case(HEXAPOD_NAME) {
            true => Ok(Choice::Hexapod),
            false => {
                let chosen = text.parse().map(Choice::Robot);
                let unknown = |_| unknown_robot(text, &[HEXAPOD_NAME]);
                chosen.map_err(unknown)
            }
        }
    }
}

/// A motion with the code that shows and tests it.
#[derive(Debug)]
struct Motion {
    /// The name of its file, without extension.
    stem: &'static str,
    program: String,
    main: &'static str,
    test: &'static str,
    /// Minimum travel, mm.
    travel: f64,
    /// True if sticks or keys steer it.
    is_steered: bool,
    /// The results of trying it on the simulated robot, one per line.
    tried: Vec<Making>,
    /// The only edition that it can be written in.
    only_edition: Option<Edition>,
    /// The file of the scene.
    scene: Option<SceneFile>,
}

/// The file of a scene.
#[derive(Clone, Copy, Debug)]
struct SceneFile {
    text: &'static str,
    /// True if the crate has the scene as a constant, too.
    is_in_code: bool,
}

impl Motion {
    fn walk(program: &str) -> Self {
        Motion {
            stem: "walk",
            program: program.to_owned(),
            main: include_str!("../templates/main_walk.rs"),
            test: include_str!("../templates/test_walk.rs"),
            travel: 500.0,
            is_steered: false,
            tried: vec![],
            only_edition: None,
            scene: None,
        }
    }

    /// Returns a gait for a robot that can walk, with servos of a speed (deg/s); else a motion that bends one leg after the other.
    ///
    /// # Errors
    /// The robot cannot walk by the gait that was asked for.
    fn of(robot: &Robot, kind: Option<gait::Kind>, speed: f64) -> Result<Self, Making> {
        match (gait::find(robot, kind, speed), kind) {
            (Ok(gait), _) => Ok(Motion::steered(&gait)),
            (Err(reason), Some(kind)) => Err(Making::NoSuchGait {
                robot: robot.name().to_owned(),
                gait: kind.to_string(),
                reason: Other::new(reason),
            }),
            (Err(_), None) if robot.description().body.is_none() => {
                Ok(Motion::bend(robot, bend::BEND_ANGLE))
            }
            (Err(reason), None) => {
                let small = bend::BEND_ANGLES
                    .into_iter()
                    .map(|turn| Motion::bend(robot, turn));
                let falls = |motion: &Motion| bend::count_falls(&motion.program, robot);
                let bending = small.into_iter().find(|motion| falls(motion) == 0);
                let bending = bending.unwrap_or_else(|| Motion::bend(robot, bend::BEND_ANGLE));
                let falls = falls(&bending);
                Ok(Motion {
                    tried: vec![Making::NoGait { falls }, reason],
                    ..bending
                })
            }
        }
    }

    fn steered(gait: &gait::Gait) -> Self {
        let [ahead, side, turn] = gait.speed.map(f64::round);
        let kind = gait.kind.to_string();
        let on_slope = (!gait.is_safe_on_slope).then_some(Making::FallsOnSlope);
        let walks = Making::Walks {
            gait: kind,
            ahead,
            side,
            turn,
        };
        let tried = [Some(walks), on_slope, Some(Making::Steer)];
        Motion {
            main: include_str!("../templates/main_gait.rs"),
            test: include_str!("../templates/test_gait.rs"),
            // 1000 cycles, with a reserve for starting.
            travel: (0.8 * gait.speed[0] * gait.cycle).floor(),
            is_steered: true,
            tried: tried.into_iter().flatten().collect(),
            only_edition: Some(Edition::V3_2),
            scene: gait.needs_mass().then_some(SceneFile {
                text: include_str!("../templates/scene_gait.toml"),
                is_in_code: false,
            }),
            ..Motion::walk(&gait.program)
        }
    }

    fn grasp() -> Self {
        Motion {
            stem: "grasp",
            program: include_str!("../templates/motions/grasp.prg").to_owned(),
            main: include_str!("../templates/main_grasp.rs"),
            test: include_str!("../templates/test_grasp.rs"),
            travel: 0.0,
            is_steered: false,
            tried: vec![],
            only_edition: None,
            scene: Some(SceneFile {
                text: include_str!("../templates/scene.toml"),
                is_in_code: true,
            }),
        }
    }

    fn bend(robot: &Robot, turn: f64) -> Self {
        Motion {
            stem: "bend",
            program: bend::program(&robot.description(), turn),
            test: include_str!("../templates/test_bend.rs"),
            travel: 0.0,
            ..Motion::walk("")
        }
    }
}

/// The parts of a new crate that depend on its robot.
#[derive(Debug)]
struct Template {
    motion: Motion,
    robot: String,
    /// Its description, unless the runtime has the robot.
    description: Option<Vec<u8>>,
    /// True if the description has a bus for the real robot.
    is_on_bus: bool,
    legs: usize,
    /// Joints of each leg.
    joints: usize,
}

impl Template {
    /// Returns the parts with the motion in an edition of the language: that which was asked for, or the first that has its words.
    ///
    /// # Errors
    /// The motion needs another edition.
    fn in_edition(mut self, asked: Option<Edition>) -> Result<Self, Making> {
        let edition = match (self.motion.only_edition, asked) {
            (Some(only), Some(asked)) if asked != only => return Err(Making::GaitNeedsEdition),
            (Some(only), _) => only,
            (None, asked) => asked.unwrap_or(Edition::V3_1),
        };
        if let Some((_, rest)) = self.motion.program.split_once('\n') {
            self.motion.program = format!("{edition}\n{rest}");
        }
        Ok(self)
    }
}

/// The parts of a crate, or the reason why the robot cannot walk by the gait that was asked for.
type Found = Result<Template, Making>;

impl Choice {
    /// Returns the parts for this robot, with a bus if the crate is for real hardware and its joints can be servos.
    ///
    /// # Errors
    /// The description has errors.
    fn template(&self, gait: Option<gait::Kind>, is_real: bool) -> Result<Found, Box<Loaded>> {
        let steered = |robot: &Robot, speed: f64| Motion::of(robot, gait, speed);
        let described = |name: &str, text: &[u8]| described(name, text, is_real, steered);
        match self {
            Choice::Hexapod => {
                let tripod = || Motion::walk(include_str!("../templates/motions/tripod.prg"));
                let motion = |robot: &Robot, speed: f64| match gait {
                    Some(_) => steered(robot, speed),
                    None => Ok(tripod()),
                };
                self::described(HEXAPOD_NAME, HEXAPOD.as_bytes(), is_real, motion)
            }
            Choice::Robot(RobotChoice::File(path)) => {
                let (name, bytes) = input::description_text(path)?;
                described(&name, &bytes)
            }
            Choice::Robot(RobotChoice::Published(robot)) => {
                described(&robot.file(), robot.text.as_bytes())
            }
            Choice::Robot(RobotChoice::Named(name)) => {
                let motion = |robot: &Robot| match (gait, name) {
                    (Some(_), _) => steered(robot, f64::INFINITY),
                    (None, tipc::Robot::Hand) => Ok(Motion::grasp()),
                    (None, _) => Ok(Motion::walk(include_str!("../templates/motions/walk.prg"))),
                };
                Ok(match name {
                    tipc::Robot::Hand => named(*name, &hand::MODEL, motion),
                    tipc::Robot::Generic => named(*name, &generic::MODEL, motion),
                    _ => named(*name, &titan8::MODEL, motion),
                })
            }
        }
    }
}

/// Returns the parts for a robot of the runtime.
fn named<const L: usize, const J: usize>(
    name: tipc::Robot,
    model: &RobotModel<L, J>,
    motion: impl Fn(&Robot) -> Result<Motion, Making>,
) -> Found {
    Ok(Template {
        motion: motion(&Robot::of(model))?,
        robot: name.name().to_owned(),
        description: None,
        is_on_bus: false,
        legs: L,
        joints: J,
    })
}

/// Returns the parts for a described robot. Its motion depends on the speed of its slowest drive, deg/s; infinite without drives.
fn described(
    name: &str,
    text: &[u8],
    is_real: bool,
    motion: impl Fn(&Robot, f64) -> Result<Motion, Making>,
) -> Result<Found, Box<Loaded>> {
    // Errors are reported with the lines of the user's text, before a bus is added to it.
    description::parse(name, text)?;
    let with_bus = is_real.then(|| with_bus(text)).flatten();
    let is_on_bus = with_bus.is_some();
    let text = with_bus.unwrap_or_else(|| text.to_owned());
    let description = description::parse(name, &text)?;
    let drives = description.bus().map_or(&[][..], |bus| &bus.drives);
    let speeds = drives.iter().map(|drive| drive.speed);
    let robot = Robot::described(&description);
    let parts = robot.description();
    let motion = motion(&robot, speeds.fold(f64::INFINITY, f64::min));
    Ok(motion.map(|motion| Template {
        motion,
        robot: robot.name().to_owned(),
        description: Some(text),
        is_on_bus,
        legs: parts.legs.len(),
        joints: parts.joints,
    }))
}

/// Speed of a drive whose servo is unknown, deg/s.
const DEFAULT_SPEED: f64 = 180.0;
/// The servo of robots that have no known one.
const SERVO: &str = "STS3215";
/// Published robots with other servos.
const KNOWN: [(&str, &str); 1] = [("phantomx", "AX-12")];

/// Returns a description with a bus, its own or a new one; `None` if the robot cannot be on one.
fn with_bus(text: &[u8]) -> Option<Vec<u8>> {
    let is_on_bus = |text: &[u8]| {
        let read = description::parse_for_servos("robot.toml", text, &buses::servos());
        read.is_ok_and(|description| Described::new(&description).is_ok())
    };
    let description = description::parse("robot.toml", text).ok()?;
    if description.bus().is_some() {
        return is_on_bus(text).then(|| text.to_owned());
    }
    let robot = Robot::described(&description);
    let known = KNOWN.iter().find(|(name, _)| *name == robot.name());
    let name = known.map_or(SERVO, |(_, servo)| *servo);
    let travel = buses::servos()
        .iter()
        .find(|servo| servo.name == name)
        .map(|servo| servo.travel);
    let model = MODELS.iter().find(|model| model.name == name);
    let fastest = model.map_or(DEFAULT_SPEED, |model| model.speed.floor());
    let travel = travel.unwrap_or(Range::new(-180.0, 180.0));
    let text = [text, bus(&robot, name, travel, fastest).as_bytes()].concat();
    is_on_bus(&text).then_some(text)
}

/// Returns the tables of a bus; `fastest` is the speed of its servos, deg/s: a drive is slowed down to 180 deg/s by default, and a gait
/// may need more.
fn bus(robot: &Robot, servo: &str, travel: Range, fastest: f64) -> String {
    let mut text = format!(
        "\n# The real robot: docs/drives.md. Replace what is here by what you built; `tip drives id` sets identities,
# `tip drives zero` finds signs and offsets.
[bus]
port = \"simulated\"   # later, for example, \"/dev/ttyUSB0\"
servo = \"{servo}\"
voltage = [9, 13]
"
    );
    let parts = robot.description();
    let mut id = 0;
    for (leg, limb) in (1..).zip(&parts.legs) {
        for (number, joint) in (1..).zip(&limb.joints) {
            id += 1;
            let Range { min, max } = joint.limits;
            let fits = |offset: f64| travel.contains(min + offset) && travel.contains(max + offset);
            // In the middle of the travel, unless the joint's zero can be there.
            let offset = if fits(0.0) {
                0.0
            } else {
                -((min + max) / 2.0).round()
            };
            // Writing to a String cannot fail.
            let _ = write!(
                text,
                "\n[[drive]]\njoint = \"J{leg}{number}\"\nid = {id}\nsign = 1\noffset = {offset}\nspeed = {fastest}\n"
            );
            if !fits(offset) {
                let half = (travel.max - travel.min) / 2.0 - 1.0;
                let (min, max) = (-offset - half, -offset + half);
                let _ = writeln!(
                    text,
                    "limits = [{:.0}, {:.0}]   # all that the servo can do",
                    min.ceil(),
                    max.floor()
                );
            }
        }
    }
    text
}
