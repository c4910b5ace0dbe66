//! The setup of a run as options name it: `--robot`, `--scene` and `--plant`.

use crate::choices::robot_names;
use crate::error::Error;
use crate::message::Using;
use crate::{input, report};
use clap::builder::{PossibleValue, StringValueParser, TypedValueParser, ValueParserFactory};
use clap::{Arg, Command};
use std::ffi::OsStr;
use std::fmt;
use std::marker::PhantomData;
use std::path::{Path, PathBuf};
use std::str::FromStr;
use tip_runtime::plant::{Scene, Simulation};
use tip_sim::{ExternalPlant, GraspsNothing};
use tipc::description::Description;
use tipc::message::list::Each;
use tipc::published::{self, Published};
use tipc::{Loaded, Robot};

/// The value of `--robot`: `NAME`, `FILE.toml`, `FILE.urdf` or `FILE.xml` of MuJoCo.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum RobotChoice {
    Named(Robot),
    Published(&'static Published),
    File(PathBuf),
}

impl FromStr for RobotChoice {
    type Err = Using;

    fn from_str(text: &str) -> Result<Self, Using> {
        let path = Path::new(text);
        let is_toml = path.extension().is_some_and(|end| end == "toml");
        let is_file = is_toml || input::is_model(path);
        let is_named = |robot: &&Robot| robot.name().eq_ignore_ascii_case(text);
        if let Some(robot) = Robot::ALL.iter().find(is_named) {
            Ok(RobotChoice::Named(*robot))
        } else if let Some(robot) = published::find(&text.to_lowercase()) {
            Ok(RobotChoice::Published(robot))
        } else if is_file {
            Ok(RobotChoice::File(text.into()))
        } else {
            Err(unknown_robot(text, &[]))
        }
    }
}

impl Default for RobotChoice {
    fn default() -> Self {
        RobotChoice::Named(Robot::Titan8)
    }
}

impl fmt::Display for RobotChoice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            RobotChoice::Named(robot) => f.write_str(robot.name()),
            RobotChoice::Published(robot) => f.write_str(robot.name),
            RobotChoice::File(path) => path.display().fmt(f),
        }
    }
}

/// The parser of values that may be the name of a robot. Shells complete the names; other values are files.
#[derive(Clone, Debug)]
pub(super) struct RobotParser<T> {
    /// Names that only this command has.
    others: &'static [&'static str],
    parsed: PhantomData<T>,
}

impl<T> RobotParser<T> {
    pub(super) fn new(others: &'static [&'static str]) -> Self {
        RobotParser {
            others,
            parsed: PhantomData,
        }
    }
}

impl<T> TypedValueParser for RobotParser<T>
where
    T: FromStr<Err = Using> + Clone + Send + Sync + 'static,
{
    type Value = T;

    fn parse_ref(
        &self,
        command: &Command,
        arg: Option<&Arg>,
        value: &OsStr,
    ) -> Result<T, clap::Error> {
        let parser = StringValueParser::new().try_map(|text| text.parse::<T>());
        parser.parse_ref(command, arg, value)
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        let names = robot_names(self.others).into_iter();
        Some(Box::new(names.map(PossibleValue::new)))
    }
}

impl ValueParserFactory for RobotChoice {
    type Parser = RobotParser<Self>;

    fn value_parser() -> Self::Parser {
        RobotParser::new(&[])
    }
}

/// Minimum similarity of a suggested name, from 0 to 1.
const MIN_SIMILARITY: f64 = 0.75;

/// Returns the message about an unknown robot, where there are `others` too.
pub(super) fn unknown_robot(text: &str, others: &[&'static str]) -> Using {
    let names: Vec<String> = robot_names(others).into_iter().map(str::to_owned).collect();
    let small = text.to_lowercase();
    let similarity = |name: &String| strsim::jaro_winkler(&small, name);
    let near = names
        .iter()
        .max_by(|a, b| similarity(a).total_cmp(&similarity(b)));
    let near = near
        .filter(|near| similarity(near) >= MIN_SIMILARITY)
        .cloned();
    let (word, robots) = (text.to_owned(), Each(names));
    match near {
        Some(near) => Using::NearRobot { word, near, robots },
        None => Using::NoRobot { word, robots },
    }
}

/// A loaded robot.
pub(super) enum ChosenRobot {
    Named(Robot),
    Described(Box<Description>),
}

impl RobotChoice {
    /// Returns the file that it is read from, if there is one.
    pub(super) fn file(&self) -> Option<&Path> {
        match self {
            RobotChoice::Named(_) | RobotChoice::Published(_) => None,
            RobotChoice::File(path) => Some(path),
        }
    }

    /// Returns the choice with its path relative to the folder of another file.
    pub(super) fn relative_to(self, other: Option<&Path>) -> Self {
        match (self, other.and_then(Path::parent)) {
            (RobotChoice::File(path), Some(folder)) => RobotChoice::File(folder.join(path)),
            (choice, _) => choice,
        }
    }

    /// Reads the description, if there is one.
    pub(super) fn load(&self) -> Result<ChosenRobot, Box<Loaded>> {
        match self {
            RobotChoice::Named(robot) => Ok(ChosenRobot::Named(*robot)),
            RobotChoice::Published(robot) => Ok(ChosenRobot::Described(Box::new(robot.read()?))),
            RobotChoice::File(path) => {
                let description = input::describe(path)?;
                Ok(ChosenRobot::Described(Box::new(description)))
            }
        }
    }
}

impl ChosenRobot {
    /// Returns the robot for a simulation.
    pub(super) fn simulated(&self) -> Result<tip_sim::Robot, Error> {
        match self {
            ChosenRobot::Named(robot) => tip_sim::Robot::named(robot.name())
                .map_err(|unknown| Error::Usage(unknown.to_string())),
            ChosenRobot::Described(description) => Ok(tip_sim::Robot::described(description)),
        }
    }

    /// Returns the robot that programs are checked for.
    pub(super) fn robot(&self) -> Robot {
        match self {
            ChosenRobot::Named(robot) => *robot,
            ChosenRobot::Described(description) => description.robot(),
        }
    }
}

/// The value of `--scene`: `NAME` or `FILE.toml`.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum SceneChoice {
    Named(Box<Scene>),
    File(PathBuf),
}

impl SceneChoice {
    /// Returns the file that it is read from, if there is one.
    pub(super) fn file(&self) -> Option<&Path> {
        match self {
            SceneChoice::Named(_) => None,
            SceneChoice::File(path) => Some(path),
        }
    }

    /// Returns a scene by its name, or by its path from the folder of another file.
    pub(super) fn relative_to(name: &str, other: &Path) -> Option<Self> {
        Some(match (name.parse().ok()?, other.parent()) {
            (SceneChoice::File(path), Some(folder)) => SceneChoice::File(folder.join(path)),
            (choice, _) => choice,
        })
    }
}

impl fmt::Display for SceneChoice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SceneChoice::Named(_) => f.write_str("cylinder"),
            SceneChoice::File(path) => path.display().fmt(f),
        }
    }
}

impl FromStr for SceneChoice {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let is_file = Path::new(text).extension().is_some_and(|end| end == "toml");
        match Scene::by_name(text) {
            Some(scene) => Ok(SceneChoice::Named(Box::new(scene))),
            None if is_file => Ok(SceneChoice::File(text.into())),
            None => Err("the scene must be cylinder, or a FILE.toml of your own".to_owned()),
        }
    }
}

/// Loads the chosen scene, or a level floor. A plant of the command line overrides that of the scene.
///
/// # Errors
/// The scene has errors.
pub(super) fn load_scene(
    choice: Option<&SceneChoice>,
    plant: Option<Simulation>,
) -> Result<Scene, Box<Loaded>> {
    let mut scene = match choice {
        None => Scene::EMPTY,
        Some(SceneChoice::Named(scene)) => **scene,
        Some(SceneChoice::File(path)) => input::scene(path)?,
    };
    scene.plant = plant.or(scene.plant);
    Ok(scene)
}

/// Puts a robot into a scene.
///
/// # Errors
/// The scene has objects, which a walking robot cannot grasp.
pub(super) fn in_scene(robot: tip_sim::Robot, scene: &Scene) -> Result<tip_sim::Robot, Error> {
    let refused = |error: GraspsNothing| {
        Error::Usage(format!("{error}: a scene with objects needs --robot hand"))
    };
    robot.with_scene(scene).map_err(refused)
}

/// The prefix of a process.
const EXEC: &str = "exec:";

/// The value of `--plant`: a built-in plant, or a process.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum PlantChoice {
    BuiltIn(Simulation),
    /// A program and its arguments.
    Process(String, Vec<String>),
}

impl FromStr for PlantChoice {
    type Err = Using;

    /// Parses the value. A command is split into words like in a shell: blanks, quotes and backslashes count, nothing else does.
    fn from_str(text: &str) -> Result<Self, Using> {
        if let Some(command) = text.strip_prefix(EXEC) {
            let words = shlex::split(command).unwrap_or_default();
            return match words.split_first() {
                Some((program, arguments)) if !program.is_empty() => {
                    Ok(PlantChoice::Process(program.clone(), arguments.to_vec()))
                }
                _ => Err(Using::NoProcess {
                    command: command.to_owned(),
                }),
            };
        }
        let names = Simulation::NAMES.iter();
        let is_named = |(name, _): &&(&str, Simulation)| name.eq_ignore_ascii_case(text);
        match names.clone().find(is_named) {
            Some((_, simulation)) => Ok(PlantChoice::BuiltIn(*simulation)),
            None => Err(Using::NoPlant {
                word: text.to_owned(),
                plants: Each(names.map(|(name, _)| (*name).to_owned()).collect()),
            }),
        }
    }
}

impl PlantChoice {
    /// Returns the built-in plant, if it is one.
    pub(super) fn simulation(&self) -> Option<Simulation> {
        match self {
            PlantChoice::BuiltIn(simulation) => Some(*simulation),
            PlantChoice::Process(..) => None,
        }
    }

    /// Returns the process, if it is one; its standard error goes to that of the command.
    pub(super) fn process(&self) -> Option<ExternalPlant> {
        match self {
            PlantChoice::BuiltIn(_) => None,
            PlantChoice::Process(program, arguments) => {
                let plant = ExternalPlant::new(program, arguments);
                Some(plant.with_listener(|line| report::complain(&format!("{line}\n"))))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(text: &str) -> Option<Vec<String>> {
        match text.parse() {
            Ok(PlantChoice::Process(program, arguments)) => {
                Some([vec![program], arguments].concat())
            }
            _ => None,
        }
    }

    #[test]
    fn a_command_is_split_as_a_shell_splits_it() {
        let split = |text| words(text).unwrap_or_default();
        assert_eq!(split("exec:python3 sim.py"), ["python3", "sim.py"]);
        assert_eq!(
            split("exec:  sim  'a b' \"c d\"e f\\ g ''"),
            ["sim", "a b", "c de", "f g", ""]
        );
        // No shell expands the words.
        assert_eq!(
            split("exec:sim $HOME *.xml | cat"),
            ["sim", "$HOME", "*.xml", "|", "cat"]
        );
        for none in ["exec:", "exec:  ", "exec:sim 'a", "exec:''", "exec"] {
            assert_eq!(words(none), None, "{none}");
        }
    }

    #[test]
    fn our_plants_have_their_names() {
        let plant = |text: &str| text.parse::<PlantChoice>().ok()?.simulation();
        assert_eq!(plant("dynamic"), Some(Simulation::Dynamic));
        assert_eq!(plant("Quasi-Static"), Some(Simulation::QuasiStatic));
        assert_eq!(plant("dynamics"), None);
    }
}
