//! The loader: the program that a command uses, the robot that it is for, and the scene around the robot. The nearest `tip.toml`
//! gives the robot, the encoding and the scene that options leave open.

use super::arguments::{RunArguments, SourceArguments};
use super::choices::{EncodingName, OutputOptions};
use super::error::Error;
use super::setup::{ChosenRobot, PlantChoice, RobotChoice, SceneChoice, in_scene, load_scene};
use super::{embedded, input, report};
use crate::message::Using;
use std::fmt;
use std::path::{Path, PathBuf};
use tip_sim::{Events, Interpreter, Refused, Robot, Run};
use tipc::Loaded;
use tipc::message::Lang;
use tipc::program::Program;

/// A loaded program with its diagnostics.
pub(super) struct Subject {
    /// The module; it has no program if there are errors.
    pub(super) loaded: Loaded,
    /// The robot that it was checked for.
    pub(super) chosen: ChosenRobot,
    /// The robot in its scene.
    pub(super) robot: Robot,
}

/// Loads the program at `path` for a command that does not run it.
pub(super) fn check(path: &Path, source: &SourceArguments) -> Result<Subject, Error> {
    let chosen = source.load_robot()?;
    let robot = chosen.simulated()?;
    Ok(Subject {
        loaded: judged(path, source, &robot),
        chosen,
        robot,
    })
}

/// Loads the program at `path` for a command that runs it; `refusal` is the message of a command that takes only the built-in
/// plants.
pub(super) fn load(
    path: &Path,
    run: &RunArguments,
    refusal: Option<Using>,
) -> Result<Subject, Error> {
    let RunArguments { source, inputs, .. } = run;
    let lang = source.output_options.lang();
    let plant = inputs.plant.as_ref();
    let ours = plant.and_then(PlantChoice::simulation);
    if let (Some(PlantChoice::Process(..)), Some(refusal)) = (plant, refusal) {
        return Err(Error::usage(refusal, lang));
    }
    let chosen = source.load_robot()?;
    let refused = Error::refused(source.output_options);
    let scene = load_scene(inputs.scene.as_ref(), ours).map_err(refused)?;
    let plain = chosen.simulated()?;
    let robot = in_scene(plain.clone(), &scene)?;
    let events = inputs.inputs(&robot).events;
    if let Some(port) = events.ports().find(|port| !robot.has_input(*port)) {
        return Err(usage(Refused::NoInput(port).text(lang)));
    }
    // The diagnostics do not depend on the scene.
    let loaded = judged(path, source, &plain);
    let is_ours = ours.is_some() || plant.is_none();
    if let Some(program) = loaded.program.as_ref().filter(|_| is_ours) {
        accept(&events, program, &robot, lang)?;
    }
    Ok(Subject {
        loaded,
        chosen,
        robot,
    })
}

/// Reads a program, and adds the warnings that depend on its robot and on the crate around its file.
fn judged(path: &Path, source: &SourceArguments, robot: &Robot) -> Loaded {
    let mut loaded = input::load(path, &source.options(robot.options().robot));
    warn(&mut loaded, path, source, robot);
    loaded
}

/// Adds the warnings that only the robot of a program and the crate around its file tell.
pub(super) fn warn(loaded: &mut Loaded, path: &Path, source: &SourceArguments, robot: &Robot) {
    robot.warn(loaded);
    let given = source.given.as_ref();
    let other = given.and_then(|(file, robot)| embedded::warning(path, file, robot));
    tip_lint::add(loaded, other.into_iter().collect());
}

/// Refuses events that cannot happen to a program on its robot.
fn accept(events: &Events, program: &Program, robot: &Robot, lang: Lang) -> Result<(), Error> {
    if events.is_empty() {
        return Ok(());
    }
    let run = Run::new(Interpreter::new(program.clone()), robot.clone()).map_err(usage)?;
    run.with_events(events)
        .map(drop)
        .map_err(|refused| usage(refused.text(lang)))
}

fn usage(reason: impl fmt::Display) -> Error {
    Error::Usage(reason.to_string())
}

/// Reports the warnings about a program unless `quiet`, and returns the program.
///
/// # Errors
/// The program has errors.
pub(super) fn sound(
    subject: Subject,
    output_options: OutputOptions,
    quiet: bool,
) -> Result<(Subject, Program), Error> {
    let Some(program) = subject.loaded.program.clone() else {
        return Err(Error::Refused(Box::new(subject.loaded), output_options));
    };
    if !quiet {
        report::diagnostics(&subject.loaded, output_options);
    }
    Ok((subject, program))
}

/// The name of the file of settings.
const NAME: &str = "tip.toml";

/// The settings that a `tip.toml` gives a program.
#[derive(Clone, Debug)]
pub(super) struct Settings {
    /// The `tip.toml`.
    pub(super) file: PathBuf,
    pub(super) robot: Option<RobotChoice>,
    pub(super) encoding: Option<EncodingName>,
    pub(super) scene: Option<SceneChoice>,
}

/// Returns the settings of the nearest `tip.toml` for the program at `path`; `None` if there are none.
///
/// # Errors
/// The `tip.toml` has errors.
pub(super) fn settings(path: &Path) -> Result<Option<Settings>, Box<Loaded>> {
    given(path, Path::exists)
}

/// Returns the settings; `is_there` returns true if a file that they name exists.
fn given(path: &Path, is_there: fn(&Path) -> bool) -> Result<Option<Settings>, Box<Loaded>> {
    let Some((program, folder)) = nearest(path) else {
        return Ok(None);
    };
    let file = input::display_path(&folder.join(NAME));
    let project = input::project(&file, |named| is_there(&folder.join(named)))?;
    let names = program.strip_prefix(&folder).unwrap_or(&program).iter();
    let names: Vec<_> = names.map(|name| name.to_string_lossy()).collect();
    let found = project.of(&names.join("/"));
    let resolve = |choice: RobotChoice| choice.relative_to(Some(&file));
    let settings = Settings {
        robot: found.robot.and_then(|name| name.parse().ok()).map(resolve),
        encoding: found.encoding.map(EncodingName::of),
        scene: found
            .scene
            .and_then(|name| SceneChoice::relative_to(name, &file)),
        file,
    };
    Ok(Some(settings).filter(Settings::is_some))
}

/// Returns the files that settings depend on: every `tip.toml` that may exist above the program, and the description that the
/// nearest one names.
pub(super) fn settings_files(path: &Path) -> Vec<PathBuf> {
    let program = input::real(path);
    let projects = program.ancestors().skip(1).map(|folder| folder.join(NAME));
    // A file that does not exist may be created later.
    let given = given(path, |_| true).ok().flatten();
    let robot = given.and_then(|given| given.robot);
    let description = robot.and_then(|robot| robot.file().map(Path::to_owned));
    projects.chain(description).collect()
}

/// Returns the program's real path, and the nearest folder above it with a `tip.toml`, which may turn out to be unusable.
fn nearest(path: &Path) -> Option<(PathBuf, PathBuf)> {
    let program = input::real(path);
    let mut folders = program.ancestors().skip(1);
    let folder = folders.find(|folder| folder.join(NAME).symlink_metadata().is_ok())?;
    Some((program.clone(), folder.to_owned()))
}

impl SourceArguments {
    /// Completes the options from the nearest `tip.toml`; returns the settings that it used.
    ///
    /// # Errors
    /// The `tip.toml` has errors.
    pub(super) fn complete(&mut self, program: &Path) -> Result<Option<Settings>, Error> {
        let mut given = settings(program).map_err(Error::refused(self.output_options))?;
        if let Some(given) = &mut given {
            given.scene = given.scene_for(self.robot.as_ref()).cloned();
            complete(&mut self.robot, &mut given.robot);
            complete(&mut self.encoding, &mut given.encoding);
        }
        let robot = |given: &Settings| Some((given.file.clone(), given.robot.clone()?));
        self.given = given.as_ref().and_then(robot);
        Ok(given.filter(Settings::is_some))
    }
}

impl RunArguments {
    /// Completes the options of a run, which also has a scene.
    ///
    /// # Errors
    /// The `tip.toml` has errors.
    pub(super) fn complete(&mut self, program: &Path) -> Result<Option<Settings>, Error> {
        let mut given = self.source.complete(program)?;
        if let Some(given) = &mut given {
            complete(&mut self.inputs.scene, &mut given.scene);
        }
        Ok(given.filter(Settings::is_some))
    }
}

/// Completes an option; a setting that the option overrides is dropped.
fn complete<T: Clone>(option: &mut Option<T>, given: &mut Option<T>) {
    match option {
        Some(_) => *given = None,
        None => option.clone_from(given),
    }
}

impl Settings {
    /// Returns the scene, unless an option names another robot than the settings do.
    fn scene_for(&self, option: Option<&RobotChoice>) -> Option<&SceneChoice> {
        let both = self.robot.as_ref().zip(option);
        let is_other = both.is_some_and(|(own, option)| own != option);
        self.scene.as_ref().filter(|_| !is_other)
    }

    fn is_some(&self) -> bool {
        self.robot.is_some() || self.encoding.is_some() || self.scene.is_some()
    }
}

impl fmt::Display for Settings {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let robot = self.robot.as_ref().map(|robot| format!("robot {robot}"));
        let encoding = self.encoding.map(|it| format!("encoding {}", it.name()));
        let scene = self.scene.as_ref().map(|scene| format!("scene {scene}"));
        let given: Vec<String> = [robot, encoding, scene].into_iter().flatten().collect();
        write!(f, "{}: {}", self.file.display(), given.join(", "))
    }
}
