//! The robot in its scene, the program for it, and what happens to them.

use serde::{Deserialize, Serialize};
use std::fmt::Display;
use tip_runtime::plant::Scene;
use tip_sim::{Events, Robot};
use tipc::Loaded;
use tipc::description::{parse, parse_scene};
use tipc::message::Lang;

/// Request of a page to run a program.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct Wanted {
    /// The program.
    pub program: Text,
    /// `titan8`, `hand`, `generic`, or a description.
    #[serde(default = "Wanted::titan8")]
    pub robot: Text,
    /// A scene by name or as a description; without one, a level floor.
    #[serde(default)]
    pub scene: Option<Text>,
    /// Events, in the form of `--events`.
    #[serde(default)]
    pub events: String,
    /// After how many cycles a traced run ends that does not end before.
    #[serde(default)]
    pub cycles: Option<u64>,
}

/// A file, or the name of something that needs none.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, Serialize)]
pub struct Text {
    /// File name for diagnostics.
    pub name: String,
    /// Contents of the file; `None` if the name is enough.
    #[serde(default)]
    pub text: Option<String>,
}

/// All that a run needs.
#[derive(Clone, Debug)]
pub struct Bench {
    /// The program, or what is wrong with it.
    pub loaded: Loaded,
    /// The robot in its scene.
    pub robot: Robot,
    /// Events of the run.
    pub events: Events,
}

impl Wanted {
    fn titan8() -> Text {
        Text {
            name: "titan8".to_owned(),
            text: None,
        }
    }

    /// The robot, the program for it and what happens to both.
    ///
    /// # Errors
    /// A description has errors, or there is no robot or scene of that name, or one does not go with the other, or an event
    /// is misspelt.
    pub fn bench(&self) -> Result<Bench, String> {
        let robot = robot(&self.robot)?;
        let scene = self.scene.as_ref().map_or(Ok(Scene::EMPTY), scene)?;
        let robot = robot.with_scene(&scene).map_err(said)?;
        let events = self.events.parse().map_err(said)?;
        let text = self.program.text.as_deref().unwrap_or_default();
        let loaded = tip_lint::load(&self.program.name, text.as_bytes(), &robot.options());
        Ok(Bench {
            loaded,
            robot,
            events,
        })
    }
}

fn robot(robot: &Text) -> Result<Robot, String> {
    match &robot.text {
        Some(text) => {
            let description = parse(&robot.name, text.as_bytes()).map_err(found)?;
            Ok(Robot::described(&description))
        }
        None => Robot::named(&robot.name).map_err(said),
    }
}

fn scene(scene: &Text) -> Result<Scene, String> {
    match &scene.text {
        Some(text) => parse_scene(&scene.name, text.as_bytes()).map_err(found),
        None => {
            Scene::by_name(&scene.name).ok_or_else(|| format!("there is no scene {}", scene.name))
        }
    }
}

/// Returns the diagnostics of a description, one line each.
fn found(loaded: Box<Loaded>) -> String {
    let lines = loaded.diagnostics.iter().map(|diagnostic| {
        let (line, column) = loaded.source.line_column(diagnostic.span.start);
        let text = diagnostic.headline(Lang::English);
        format!("{}:{line}:{column}: {text}", loaded.source.name())
    });
    lines.collect::<Vec<_>>().join("\n")
}

fn said(error: impl Display) -> String {
    error.to_string()
}
