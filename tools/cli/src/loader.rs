//! The loader: the program that a command uses, the robot that it is for, and the scene around the robot.

use super::arguments::{RunArguments, SourceArguments};
use super::choices::OutputOptions;
use super::error::Error;
use super::setup::{ChosenRobot, PlantChoice, in_scene, load_scene};
use super::{embedded, input, report};
use crate::message::Using;
use std::fmt;
use std::path::Path;
use tip_runtime::plant::Scene;
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
    pub(super) scene: Scene,
}

/// Loads the program at `path` for a command that does not run it.
pub(super) fn check(path: &Path, source: &SourceArguments) -> Result<Subject, Error> {
    let chosen = source.load_robot()?;
    let robot = chosen.simulated()?;
    Ok(Subject {
        loaded: judged(path, source, &robot),
        chosen,
        robot,
        scene: Scene::EMPTY,
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
    let ours = plant.and_then(PlantChoice::name);
    if let (Some(PlantChoice::Process(..)), Some(refusal)) = (plant, refusal) {
        return Err(Error::usage(refusal, lang));
    }
    let chosen = source.load_robot()?;
    let refused = Error::refused(source.output_options);
    let scene = load_scene(inputs.scene.as_ref(), ours).map_err(refused)?;
    let plain = chosen.simulated()?;
    let robot = in_scene(plain.clone(), &scene)?;
    let events = inputs.inputs().events;
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
