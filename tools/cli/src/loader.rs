//! The loader: the program that a command uses, the robot that it is for, and the scene around the robot.

use super::arguments::{InputArguments, SourceArguments};
use super::error::Error;
use super::setup::{BuiltInOnly, ChosenRobot, PlantChoice, built_in_plant, in_scene, load_scene};
use super::{embedded, input, report};
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

/// A loaded program with its diagnostics.
pub(super) struct Subject {
    /// The module; it has no program if there are errors.
    pub(super) loaded: Loaded,
    /// The robot that it was checked for.
    pub(super) chosen: ChosenRobot,
    /// The robot in its scene.
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
    /// The warnings about it, which were reported.
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

/// Loads the program at `path` for a command that runs it; `why` is the reason of a command that takes only the built-in plants.
pub(super) fn load(
    path: &Path,
    source: &SourceArguments,
    inputs: &InputArguments,
    why: Option<BuiltInOnly>,
) -> Result<Subject, NotLoaded> {
    let lang = source.output_options.lang();
    let plant = inputs.plant.as_ref();
    let ours = match why {
        Some(why) => built_in_plant(plant, why, lang)?,
        None => plant.and_then(PlantChoice::name),
    };
    let chosen = source.robot().load()?;
    let scene = load_scene(inputs.scene.as_ref(), ours)?;
    let plain = chosen.simulated()?;
    let robot = in_scene(plain.clone(), &scene)?;
    let events = inputs.inputs().events;
    if let Some(port) = events.ports().find(|port| !robot.has_input(*port)) {
        return Err(usage(Refused::NoInput(port).text(lang)).into());
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
        scene,
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

/// Reports the diagnostics of a command that reports them once; `None` if a file cannot be used.
pub(super) fn reported(
    subject: Result<Subject, NotLoaded>,
    source: &SourceArguments,
    quiet: bool,
) -> Result<Option<Subject>, Error> {
    match subject {
        Ok(subject) => {
            if subject.loaded.program.is_none() || !quiet {
                report::diagnostics(&subject.loaded, source.output_options);
            }
            Ok(Some(subject))
        }
        Err(NotLoaded::Found(loaded)) => {
            report::diagnostics(&loaded, source.output_options);
            Ok(None)
        }
        Err(NotLoaded::Failed(error)) => Err(error),
    }
}

/// Reports the diagnostics; `None` if there is no program without errors.
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
