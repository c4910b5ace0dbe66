//! The loader: the program that a command uses, the robot that it is for, and the scene around the robot.

use super::arguments::{InputArguments, SourceArguments};
use super::error::Error;
use super::plant::{self, Ours, PlantChoice};
use super::robot::ChosenRobot;
use super::{embedded, input, report, scene};
use std::fmt;
use std::path::Path;
use tip_runtime::plant::Scene;
use tip_sim::{Events, Interpreter, Refused, Robot, Run};
use tipc::Loaded;
use tipc::diagnostic::Diagnostic;
use tipc::message::Lang;
use tipc::program::Program;
use tipc::source::Source;
use tipc::syntax::Module;

/// A program as it was read, with all that is found in it.
pub(super) struct Subject {
    /// It has no program if there are errors.
    pub(super) loaded: Loaded,
    /// The robot that it was checked for.
    pub(super) chosen: ChosenRobot,
    /// That robot in its scene.
    pub(super) robot: Robot,
    pub(super) scene: Scene,
}

/// A program without errors.
pub(super) struct Checked {
    pub(super) robot: ChosenRobot,
    pub(super) scene: Scene,
    pub(super) program: Program,
    pub(super) source: Source,
    pub(super) module: Module,
    /// The warnings about it, already reported.
    pub(super) diagnostics: Vec<Diagnostic>,
}

/// A reason why there is no [`Subject`].
pub(super) enum NotLoaded {
    /// The description of the robot, or the scene, has errors.
    Found(Box<Loaded>),
    Failed(Error),
}

impl From<Box<Loaded>> for NotLoaded {
    fn from(loaded: Box<Loaded>) -> Self {
        NotLoaded::Found(loaded)
    }
}

impl From<Error> for NotLoaded {
    fn from(error: Error) -> Self {
        NotLoaded::Failed(error)
    }
}

/// Loads the program at `path` for a command that does not run it.
pub(super) fn check(path: &Path, source: &SourceArguments) -> Result<Subject, NotLoaded> {
    let chosen = source.robot().load()?;
    let robot = chosen.simulated()?;
    Ok(Subject {
        loaded: judged(path, source, &robot),
        chosen,
        robot,
        scene: Scene::EMPTY,
    })
}

/// Loads the program at `path` for a command that runs it; `why` says why the command takes our plants alone, if it does.
pub(super) fn load(
    path: &Path,
    source: &SourceArguments,
    inputs: &InputArguments,
    why: Option<Ours>,
) -> Result<Subject, NotLoaded> {
    let lang = source.shown.lang();
    let plant = inputs.plant.as_ref();
    let ours = match why {
        Some(why) => plant::ours(plant, why, lang)?,
        None => plant.and_then(PlantChoice::name),
    };
    let chosen = source.robot().load()?;
    let scene = scene::load(inputs.scene.as_ref(), ours)?;
    let plain = chosen.simulated()?;
    let robot = scene::around(plain.clone(), &scene)?;
    let events = inputs.inputs().events;
    if let Some(port) = events.ports().find(|port| !robot.has_input(*port)) {
        return Err(usage(Refused::NoInput(port).text(lang)).into());
    }
    // What is found does not depend on the scene.
    let loaded = judged(path, source, &plain);
    let is_ours = ours.is_some() || plant.is_none();
    if let Some(program) = loaded.program.as_ref().filter(|_| is_ours) {
        accept(&events, program, &robot, lang)?;
    }
    Ok(Subject {
        loaded,
        chosen,
        robot,
        scene,
    })
}

/// Reads a program, and adds the warnings that only its robot and the crate around its file tell.
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

/// Reports what was found in the files of a command that reports it once; `None` if one of them cannot be used.
pub(super) fn reported(
    subject: Result<Subject, NotLoaded>,
    source: &SourceArguments,
    quiet: bool,
) -> Result<Option<Subject>, Error> {
    match subject {
        Ok(subject) => {
            if subject.loaded.program.is_none() || !quiet {
                report::findings(&subject.loaded, source.shown);
            }
            Ok(Some(subject))
        }
        Err(NotLoaded::Found(loaded)) => {
            report::findings(&loaded, source.shown);
            Ok(None)
        }
        Err(NotLoaded::Failed(error)) => Err(error),
    }
}

/// Reports what was found; `None` if there is no program without errors.
pub(super) fn checked(
    subject: Result<Subject, NotLoaded>,
    source: &SourceArguments,
) -> Result<Option<Checked>, Error> {
    let Some(subject) = reported(subject, source, false)? else {
        return Ok(None);
    };
    let Loaded {
        source,
        module,
        program,
        diagnostics,
        ..
    } = subject.loaded;
    Ok(program.map(|program| Checked {
        robot: subject.chosen,
        scene: subject.scene,
        program,
        source,
        module,
        diagnostics,
    }))
}
