//! Programs from files, as a client asks for them.

use super::message::Launch;
use super::session::{Debuggee, Host};
use crate::choices::EncodingName;
use crate::input;
use crate::robot::RobotChoice;
use crate::scene::{self, SceneChoice};
use clap::ValueEnum;
use std::path::{Path, PathBuf};
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
        let robot = robot(launch, path, lang)?;
        let encoding = match &launch.encoding {
            Some(name) => EncodingName::from_str(name, true)?,
            None => EncodingName::Auto,
        };
        let options = Options {
            encoding: encoding.encoding(),
            ..robot.options()
        };
        let loaded = input::load(path, &options);
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

/// The robot in its scene.
fn robot(launch: &Launch, program: &Path, lang: Lang) -> Result<Robot, String> {
    let choice = launch.robot.as_deref().unwrap_or("titan8");
    let choice: RobotChoice = choice.parse().map_err(|error| format!("{error:?}"))?;
    let choice = match choice {
        RobotChoice::File(path) => RobotChoice::File(beside(program, path)),
        named @ RobotChoice::Named(_) => named,
    };
    let robot = choice.load().map_err(|loaded| findings(&loaded, lang))?;
    let robot = robot.simulated().map_err(|error| error.to_string())?;
    let scene = match launch.scene.as_deref().map(str::parse).transpose()? {
        None => Scene::EMPTY,
        Some(SceneChoice::Named(scene)) => *scene,
        Some(SceneChoice::File(path)) => {
            let scene = input::scene(&beside(program, path));
            scene.map_err(|loaded| findings(&loaded, lang))?
        }
    };
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
    let lines: Vec<String> = lines
        .map(|one| render::short(&loaded.source, one, lang))
        .collect();
    lines.join("\n")
}
