//! Programs from files, as a client asks for them.

use super::message::Launch;
use super::session::{Debuggee, Host};
use crate::choices::{EncodingName, PlantName};
use crate::input;
use crate::plant::{self, Ours, PlantChoice};
use crate::project::{self, Given};
use crate::robot::RobotChoice;
use crate::scene::{self, SceneChoice};
use crate::usage::Wrong;
use clap::ValueEnum;
use std::path::{Path, PathBuf};
use tip_lint::message::More;
use tip_runtime::plant::Scene;
use tip_sim::debug::Debugger;
use tip_sim::{Events, Robot};
use tipc::message::Lang;
use tipc::{Loaded, Options, render};

/// Loads programs from files.
pub(super) struct Files;

impl Host for Files {
    fn launch(&mut self, launch: &Launch, lang: Lang) -> Result<Debuggee, String> {
        let path = Path::new(&launch.program);
        let given = project::of(path).map_err(|loaded| findings(&loaded, lang))?;
        let robot = robot(launch, path, given.as_ref(), lang)?;
        let encoding = match &launch.encoding {
            Some(name) => EncodingName::from_str(name, true)?,
            None => given.and_then(|it| it.encoding).unwrap_or_default(),
        };
        let options = Options {
            encoding: encoding.encoding(),
            ..robot.options()
        };
        let loaded = input::load_file(path, &options);
        let Some(program) = loaded.program.clone() else {
            return Err(findings(&loaded, lang));
        };
        let events: Events = match &launch.events {
            Some(events) => events.parse().map_err(|error| format!("{error}"))?,
            None => Events::NONE,
        };
        let debugger = Debugger::new(program, &robot).map_err(|mismatch| mismatch.to_string())?;
        let debugger = debugger
            .with_events(&events)
            .map_err(|refused| refused.to_string())?;
        Ok(Debuggee {
            debugger,
            source: loaded.source,
            path: launch.program.clone(),
        })
    }
}

/// The robot in its scene; what the client leaves open is `given`.
fn robot(
    launch: &Launch,
    program: &Path,
    given: Option<&Given>,
    lang: Lang,
) -> Result<Robot, String> {
    let named = match &launch.robot {
        None => None,
        Some(name) => Some(
            match name.parse().map_err(|wrong: Wrong| wrong.text(lang))? {
                RobotChoice::File(path) => RobotChoice::File(beside(program, path)),
                named => named,
            },
        ),
    };
    let given_scene = given.and_then(|it| it.scene_for(named.as_ref()));
    let choice = named.or_else(|| given?.robot.clone()).unwrap_or_default();
    let robot = choice.load().map_err(|loaded| findings(&loaded, lang))?;
    let robot = robot.simulated().map_err(|error| error.to_string())?;
    let asked = launch.scene.as_deref().map(str::parse).transpose()?;
    let mut scene = match asked.or_else(|| given_scene.cloned()) {
        None => Scene::EMPTY,
        Some(SceneChoice::Named(scene)) => *scene,
        Some(SceneChoice::File(path)) => {
            let scene = input::scene(&beside(program, path));
            scene.map_err(|loaded| findings(&loaded, lang))?
        }
    };
    if let Some(name) = &launch.plant {
        let choice: PlantChoice = name.parse().map_err(|wrong: Wrong| wrong.text(lang))?;
        let plant = plant::ours(Some(&choice), Ours::Again("dap"), lang);
        let plant = plant.map_err(|error| error.to_string())?;
        scene.plant = plant.map(PlantName::simulation);
    }
    scene::around(robot, &scene).map_err(|error| error.to_string())
}

/// A file that is named from the program's folder, unless it is found as it is.
fn beside(program: &Path, path: PathBuf) -> PathBuf {
    match program.parent() {
        Some(folder) if path.is_relative() && !path.exists() => folder.join(path),
        _ => path,
    }
}

/// All that is wrong, one line each.
fn findings(loaded: &Loaded, lang: Lang) -> String {
    let lines = loaded.diagnostics.iter();
    let lines = lines.map(|one| render::short(&loaded.source, one, lang));
    let omitted = loaded.omitted.count();
    let more = (omitted > 0).then(|| More::from(omitted).in_lang(lang).to_string());
    let lines: Vec<String> = lines.chain(more).collect();
    lines.join("\n")
}
