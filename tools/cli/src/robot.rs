//! `tip robot`: lists, shows, checks, imports and exports robots.

use crate::Action;
use crate::choices::{Format, LangName, OutputOptions};
use crate::error::Error;
use crate::message::{Using, Weight};
use crate::setup::{RobotChoice, SceneChoice, in_scene, load_scene};
use crate::{Status, choices, input, output, report};
use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, Subcommand, ValueEnum};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use tip_runtime::printable::Printable;
use tip_sim::import::{self, Foot, Forward};
use tip_sim::{Robot, RobotDescription, mjcf, urdf};
use tipc::embed::LIMIT;
use tipc::message::Lang;
use tipc::published;

/// The command `tip robot`.
#[derive(Debug, Args)]
pub(super) struct RobotArguments {
    #[command(subcommand)]
    verb: RobotVerb,
}

/// The commands of `tip robot`.
#[derive(Debug, Subcommand)]
enum RobotVerb {
    /// List the robots that have a name
    List(List),
    /// Show what a robot has, and the sources of a published one
    Show(Show),
    /// Check a description, and show what the robot has
    Check(CheckRobot),
    /// Make a description from a URDF or MJCF file
    Import(Import),
    /// Write a robot as URDF, or as a model of MuJoCo
    Export(Export),
}

#[derive(Debug, Args)]
#[command(after_long_help = "Example:
  tip robot check hexapod.toml

Exit status: 0 if the description can be used, 1 otherwise.")]
pub(super) struct CheckRobot {
    /// The description
    #[arg(value_name = "FILE.toml")]
    pub(super) file: PathBuf,

    #[command(flatten)]
    pub(super) output_options: OutputOptions,
}

impl Action for RobotArguments {
    fn format(&self) -> Option<Format> {
        match &self.verb {
            RobotVerb::Check(arguments) => Some(arguments.output_options.message_format),
            RobotVerb::Show(arguments) => Some(arguments.output_options.message_format),
            RobotVerb::List(_) | RobotVerb::Import(_) | RobotVerb::Export(_) => None,
        }
    }

    fn execute(&self) -> Result<Status, Error> {
        match &self.verb {
            RobotVerb::List(_) => list(),
            RobotVerb::Show(arguments) => show(arguments),
            RobotVerb::Check(arguments) => check(arguments),
            RobotVerb::Import(arguments) => import(arguments),
            RobotVerb::Export(arguments) => export(arguments),
        }
    }
}

/// Reports all errors of a description, or the properties of the robot.
fn check(arguments: &CheckRobot) -> Result<Status, Error> {
    match input::describe(&arguments.file) {
        Ok(description) => {
            if arguments.output_options.message_format == Format::Human {
                let robot = Robot::described(&description);
                let mut text = summary(&robot);
                if let Some(pairs) = import::not_compared(robot.distances().left_out()) {
                    let lang = arguments.output_options.lang();
                    // Writing to a String cannot fail.
                    let _ = writeln!(text, "{}", pairs.in_lang(lang));
                }
                output::print(text)?;
            }
            Ok(Status::Success)
        }
        Err(loaded) => {
            report::check(&loaded, arguments.output_options)?;
            Ok(Status::Failure)
        }
    }
}

/// Returns the properties of a robot.
fn summary(robot: &Robot) -> String {
    let RobotDescription {
        body,
        forces,
        inverse,
        joints,
        feet,
        ..
    } = robot.description();
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
        let [x, y, z] = foot.map(|at| report::fixed(at, 1));
        // Writing to a String cannot fail.
        let _ = writeln!(text, "  F{number}  {x} {y} {z}");
    }
    text
}

#[derive(Debug, Args)]
#[command(after_long_help = "Examples:
  tip robot list
  tip run march.prg --robot phantomx    wherever a robot is chosen, any of these names is

docs/robots.md says where the figures come from.")]
pub(crate) struct List {}

#[derive(Debug, Args)]
#[command(after_long_help = "Examples:
  tip robot show titan8
  tip robot show a1                 with its figures and where they come from
  tip robot show a1 > mine.toml     a description to be changed

Exit status: 0 if there is such a robot and its description can be used, 1 otherwise.")]
pub(crate) struct Show {
    /// The robot: a name or a file
    ///
    /// A name that 'tip robot list' shows, or a description in a file
    #[arg(value_name = "NAME|FILE.toml")]
    robot: RobotChoice,

    #[command(flatten)]
    pub(crate) output_options: OutputOptions,
}

/// The robots that need no description.
const BUILT_IN: [(&str, &str); 3] = [
    ("titan8", "TITAN VIII, the quadruped"),
    ("hand", "Hiroshima Hand"),
    ("generic", "Every generic command, on TITAN VIII's geometry"),
];

/// Prints the names of robots with their descriptions.
fn list() -> Result<Status, Error> {
    let published = published::ALL.iter();
    let published = published.map(|robot| (robot.name, robot.summary()));
    let mut text = String::new();
    for (name, what) in BUILT_IN.into_iter().chain(published) {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "{name:<10}  {what}");
    }
    output::print(text)?;
    Ok(Status::Success)
}

/// Prints the properties of a robot; of a published one also its description, so that the output is a description.
fn show(arguments: &Show) -> Result<Status, Error> {
    let robot = match arguments.robot.load() {
        Ok(robot) => robot.simulated()?,
        Err(loaded) => {
            report::check(&loaded, arguments.output_options)?;
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

/// The value of one `--foot`.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Feet(pub(super) Vec<Foot>);

/// Parses feet separated by commas: each a link, or `LINK=X,Y,Z`.
pub(super) fn feet(text: &str) -> Result<Feet, Using> {
    let wrong = || Using::NotAFoot {
        text: text.to_owned(),
    };
    let mut words = text.split(',');
    let mut feet = Vec::new();
    while let Some(word) = words.next() {
        let foot = match word.split_once('=') {
            None => Some(Foot::from(word)),
            Some((link, x)) => coordinates([Some(x), words.next(), words.next()]).map(|at| Foot {
                link: link.to_owned(),
                at,
            }),
        };
        feet.push(
            foot.filter(|foot| !foot.link.is_empty())
                .ok_or_else(wrong)?,
        );
    }
    Ok(Feet(feet))
}

/// Parses three finite numbers.
fn coordinates(words: [Option<&str>; 3]) -> Option<[f64; 3]> {
    let mut at = [0.0; 3];
    for (place, word) in at.iter_mut().zip(words) {
        *place = word?
            .trim()
            .parse()
            .ok()
            .filter(|it: &f64| it.is_finite())?;
    }
    Some(at)
}

#[derive(Debug, Args)]
#[command(
    after_long_help = "Each chain of revolute or continuous joints (hinges in MJCF) from the base to a last link becomes a leg; fixed joints are merged.
The foot of a URDF file is the link at the end, on a fixed joint; that of an MJCF file is a site called foot, toe or tip, else the last
sphere, else the end of the last capsule; or what --foot says. A report on standard error lists what was assumed and what was dropped.
A CHAIN is named by one of its joints or links, or by what only its first joint's name has: FL for FL_hip_joint.

Examples:
  tip robot import quadruped.urdf -o quadruped.toml
  tip robot import dog.urdf --order FL,FR,RL,RR --skip head_pan_joint --stand 280 -o dog.toml
  tip robot import go2.xml -o go2.toml             a model of MuJoCo
  tip robot import dog.urdf --forward -y -o dog.toml
  tip robot import arm.urdf --foot hand=0.05,0,0.12 -o arm.toml
  tip robot import - -o dog.toml     from standard input, such as what xacro writes

Exit status: 0 if the description is written, 1 otherwise."
)]
pub(super) struct Import {
    /// The URDF or MJCF file; '-' is standard input
    ///
    /// xacro has to be expanded first; an MJCF file includes files below its folder
    #[arg(value_name = "FILE.urdf|FILE.xml")]
    file: PathBuf,

    /// A link to use as the foot of its chain
    ///
    /// Instead of the last one; '=X,Y,Z' gives a position in its frame, in m; separate several with commas
    #[arg(long, value_name = "LINK[=X,Y,Z]", value_parser = feet)]
    foot: Vec<Feet>,

    /// Leave out a chain, such as an arm
    ///
    /// Separate several with commas
    #[arg(long, value_name = "CHAIN", value_delimiter = ',')]
    skip: Vec<String>,

    /// The chains that become F1, F2, …
    ///
    /// Separated by commas; by default in order of position, front to rear and left before right
    #[arg(long, value_name = "CHAIN", value_delimiter = ',')]
    order: Vec<String>,

    /// The axis of the file that points up, if not z
    ///
    /// Forward is x, or -z where x points up
    #[arg(long, value_enum, value_name = "x|y|z")]
    up: Option<Up>,

    /// The axis that points forward, if not x
    ///
    /// Where names of legs contradict their places, the report names the axis that agrees
    #[arg(
        long,
        value_parser = forward(),
        value_name = "x|y|z|-x|-y|-z",
        allow_hyphen_values = true
    )]
    forward: Option<Forward>,

    /// Start with the feet this many mm below
    ///
    /// Below the robot frame, with the body level; by default joints start in the middle of their limits
    #[arg(long, value_name = "HEIGHT", value_parser = height)]
    stand: Option<f64>,

    /// Write to a file instead of standard output
    #[arg(short, long, value_name = "OUT.toml")]
    out: Option<PathBuf>,

    /// The language of the report; else the locale's
    #[arg(long, value_enum, value_name = "en|ja")]
    lang: Option<LangName>,
}

/// An axis of the file.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum Up {
    X,
    Y,
    Z,
}

impl Up {
    fn axis(self) -> import::Up {
        match self {
            Up::X => import::Up::X,
            Up::Y => import::Up::Y,
            Up::Z => import::Up::Z,
        }
    }
}

/// Returns the parser of a direction.
fn forward() -> impl TypedValueParser<Value = Forward> {
    let names = PossibleValuesParser::new(Forward::ALL.map(|(name, _)| name));
    names.map(|text| {
        let mut all = Forward::ALL.into_iter();
        let found = all.find(|(name, _)| *name == text);
        found.map_or(Forward::X, |(_, forward)| forward)
    })
}

/// Parses a height, mm.
fn height(text: &str) -> Result<f64, Using> {
    let number = text.trim().parse().ok();
    let height = number.filter(|height: &f64| height.is_finite() && *height > 0.0);
    height.ok_or_else(|| Using::NotAHeight {
        text: text.to_owned(),
    })
}

/// Imports a URDF or MJCF file; errors are reported to standard error.
fn read_model(path: &Path, options: &import::ImportOptions, lang: Lang) -> Option<import::Import> {
    let read = input::read(path, LIMIT).map_err(|reason| reason.in_lang(lang).to_string());
    let imported = read.and_then(|bytes| {
        let name = match input::is_stream(path) {
            true => input::name(path).into(),
            false => path.file_name().unwrap_or_default().to_string_lossy(),
        };
        let text = import::decode(&bytes);
        let imported = text.and_then(|text| import::import_with(&name, &text, options));
        imported.map_err(|refused| refused.message().in_lang(lang).to_string())
    });
    let complain = |reason: &String| {
        let error = Weight::Error.in_lang(lang);
        let (name, reason) = (Printable::line(input::name(path)), Printable::line(reason));
        report::complain(&format!("{error}: {name}: {reason}\n"));
    };
    imported.inspect_err(complain).ok()
}

/// Writes the description; the report goes to standard error.
fn import(arguments: &Import) -> Result<Status, Error> {
    let path = &arguments.file;
    let choices = import::ImportOptions {
        feet: arguments
            .foot
            .iter()
            .flat_map(|feet| feet.0.clone())
            .collect(),
        skip: arguments.skip.clone(),
        order: arguments.order.clone(),
        up: arguments.up.map(Up::axis),
        forward: arguments.forward,
        folder: input::folder(path),
        stand: arguments.stand,
    };
    let lang = choices::lang(arguments.lang);
    let Some(imported) = read_model(path, &choices, lang) else {
        return Ok(Status::Failure);
    };
    output::write(arguments.out.as_deref(), &[path], &imported.toml)?;
    let name = Printable::line(input::name(path));
    for line in &imported.report {
        let line = line.in_lang(lang);
        report::complain(&format!("{name}: {}\n", Printable::line(line)));
    }
    Ok(Status::Success)
}

#[derive(Debug, Args)]
#[command(
    after_long_help = "The joints are J11, J12, …, each link is link11, link12, …, the feet are F1, F2, …; base_link is the robot frame, with x
forward, y left and z up. A robot that is bolted down hangs on the link world. A slider becomes prismatic joints to the link floor.
A model of MuJoCo has the same names, x to the right and y forward; its motors take the angles that joints are commanded (rad).

Examples:
  tip robot export --urdf -o titan8.urdf
  tip robot export --urdf --robot hexapod.toml -o hexapod.urdf
  tip robot export --mjcf --scene steps.toml -o titan8.xml

Exit status: 0 if the file is written, 1 otherwise."
)]
pub(super) struct Export {
    /// Write URDF
    ///
    /// Boxes, cylinders and spheres are its shapes
    #[arg(long, required_unless_present = "mjcf")]
    urdf: bool,

    /// Write a model of MuJoCo (MJCF)
    ///
    /// With motors, contacts and the scene
    #[arg(long, conflicts_with = "urdf")]
    mjcf: bool,

    /// The scene: cylinder, or a file
    ///
    /// cylinder is an object under a hand
    #[arg(long, value_name = "NAME|FILE.toml", conflicts_with = "urdf")]
    scene: Option<SceneChoice>,

    /// The robot: a name or a file
    ///
    /// A name that 'tip robot list' shows, a description, or a URDF or MJCF file to normalise
    #[arg(long, value_name = "NAME|FILE", default_value = "titan8")]
    robot: RobotChoice,

    /// Write to a file instead of standard output
    #[arg(short, long, value_name = "OUT")]
    out: Option<PathBuf>,

    #[command(flatten)]
    output_options: OutputOptions,
}

fn export(arguments: &Export) -> Result<Status, Error> {
    let refused = Error::refused(arguments.output_options);
    let robot = arguments.robot.load().map_err(&refused)?.simulated()?;
    let text = match arguments.mjcf {
        false => urdf::export(&robot),
        true => {
            let scene = load_scene(arguments.scene.as_ref(), None).map_err(&refused)?;
            mjcf::export(&in_scene(robot, &scene)?)
        }
    };
    let scene = arguments.scene.as_ref().and_then(SceneChoice::file);
    let files: Vec<&Path> = arguments.robot.file().into_iter().chain(scene).collect();
    output::write(arguments.out.as_deref(), &files, text)?;
    Ok(Status::Success)
}

#[cfg(test)]
mod tests {
    use super::feet;
    use tip_sim::import::Foot;

    #[test]
    fn links_and_places_on_them_stand_side_by_side() {
        let foot = |link: &str, at| Foot {
            link: link.to_owned(),
            at,
        };
        let read = |text: &str| feet(text).ok().map(|feet| feet.0);
        assert_eq!(read("toe"), Some(vec![foot("toe", [0.0; 3])]));
        assert_eq!(
            read("l=0.1,-2e-3,0,r,m=1, 2 ,3"),
            Some(vec![
                foot("l", [0.1, -0.002, 0.0]),
                foot("r", [0.0; 3]),
                foot("m", [1.0, 2.0, 3.0]),
            ])
        );
        for wrong in [
            "",
            "toe,",
            "l=",
            "l=1",
            "l=1,2",
            "l=1,2,r",
            "l=1,2,inf",
            "=1,2,3",
        ] {
            assert_eq!(read(wrong), None, "{wrong}");
        }
    }
}
