//! Compiler, reference interpreter, runtime and plants as a page without a server needs them: the session that `tip serve`
//! serves, and traces.

#[cfg(target_arch = "wasm32")]
mod exports;

use serde::{Deserialize, Serialize};
use serde_json::json;
use std::fmt::Display;
use tip_runtime::plant::Scene;
use tip_sim::{Events, Interpreter, Limit, Robot, Run};
use tip_view::live::{NoFile, Session, Setup, Viewer};
use tipc::Loaded;
use tipc::description::{parse, parse_scene};
use tipc::message::Lang;

/// Program that runs while the requested text has errors.
const NOTHING: &str = "3.1\n\nEND\n";

/// A session and the one page that looks at it; nothing at first.
#[derive(Debug, Default)]
pub struct Playground {
    session: Option<Session>,
    viewer: Viewer,
}

impl Playground {
    /// Replaces the session by the one that `wanted` describes, a [`Wanted`] in JSON, and starts its run. A text with errors is
    /// shown in the editor, and runs when they are corrected.
    ///
    /// # Errors
    /// A message for users if the session cannot be made. The present session continues then.
    pub fn open(&mut self, wanted: &str) -> Result<(), String> {
        let wanted: Wanted = serde_json::from_str(wanted).map_err(said)?;
        let bench = wanted.bench()?;
        let name = &wanted.program.name;
        let text = wanted.program.text.as_deref().unwrap_or_default();
        let setup = |text: &str| Setup {
            events: bench.events.clone(),
            ..Setup::new(name, text.as_bytes(), bench.robot.clone())
        };
        let impossible = |_| "an event cannot happen to this robot".to_owned();
        let mut session = match bench.loaded.program {
            Some(_) => Session::new(setup(text)).map_err(impossible)?,
            None => {
                let mut session = Session::new(setup(NOTHING)).map_err(impossible)?;
                let edit = json!({ "do": "edit", "text": text, "base": 1, "by": "" });
                session.request(&edit.to_string(), &mut NoFile);
                session
            }
        };
        session.play();
        self.session = Some(session);
        self.viewer = Viewer::default();
        Ok(())
    }

    /// Advances the session by the time that has passed for the page, ms, as long as `goes_on` returns true.
    pub fn advance(&mut self, elapsed: f64, goes_on: impl FnMut() -> bool) {
        if let Some(session) = &mut self.session {
            session.advance(elapsed, goes_on);
        }
    }

    /// Does what the page asks for, and answers; nothing without a session.
    pub fn request(&mut self, request: &str) -> Option<String> {
        let session = self.session.as_mut()?;
        Some(session.request(request, &mut NoFile))
    }

    /// Returns the updates that the page has not received, or none.
    pub fn update(&mut self) -> Option<String> {
        self.session.as_ref()?.update(&mut self.viewer)
    }
}

/// The trace of a run as `tip run --trace --trace-state` writes it, of a [`Wanted`] in JSON.
///
/// # Errors
/// It cannot run, in words for people.
pub fn trace(wanted: &str) -> Result<String, String> {
    let wanted: Wanted = serde_json::from_str(wanted).map_err(said)?;
    let bench = wanted.bench()?;
    let program = bench.loaded.program.ok_or("there is no program")?;
    let run = Run::new(Interpreter::new(program), bench.robot).map_err(said)?;
    let run = run.with_trace(true).with_events(&bench.events);
    let mut run = run.map_err(said)?;
    run.to_end(wanted.cycles.map_or(Limit::NONE, Limit::cycles));
    Ok(run.trace())
}

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
