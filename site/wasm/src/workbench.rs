//! The robot in its scene, the program for it, and what happens to them.

use crate::ask::{Ask, Text};
use std::fmt::Display;
use tip_runtime::plant::Scene;
use tip_sim::{Events, Robot};
use tipc::Loaded;
use tipc::description::{parse, parse_scene};

/// All that a question is about.
pub struct Workbench {
    /// The program, or what is wrong with it.
    pub loaded: Loaded,
    /// The robot in its scene.
    pub robot: Robot,
    /// What happens from outside.
    pub events: Events,
}

/// Why there is no workbench.
pub enum Missing {
    /// A description has errors.
    Found(Box<Loaded>),
    /// There is no robot or scene of that name, or one does not go with the other, or an event is misspelt.
    Wrong(String),
}

impl Workbench {
    /// What a question is about.
    ///
    /// # Errors
    /// Something of it is missing.
    pub fn of(ask: &Ask) -> Result<Self, Missing> {
        let robot = robot(&ask.robot)?;
        let scene = ask.scene.as_ref().map_or(Ok(Scene::EMPTY), scene)?;
        let robot = robot.with_scene(&scene).map_err(wrong)?;
        let events = ask.events.parse().map_err(wrong)?;
        let text = ask.program.text.as_deref().unwrap_or_default();
        let loaded = tipc::load(&ask.program.name, text.as_bytes(), &robot.options());
        Ok(Workbench {
            loaded,
            robot,
            events,
        })
    }
}

fn robot(robot: &Text) -> Result<Robot, Missing> {
    match &robot.text {
        Some(text) => {
            let description = parse(&robot.name, text.as_bytes()).map_err(Missing::Found)?;
            Ok(Robot::described(&description))
        }
        None => Robot::named(&robot.name).map_err(wrong),
    }
}

fn scene(scene: &Text) -> Result<Scene, Missing> {
    match &scene.text {
        Some(text) => parse_scene(&scene.name, text.as_bytes()).map_err(Missing::Found),
        None => Scene::by_name(&scene.name)
            .ok_or_else(|| Missing::Wrong(format!("there is no scene {}", scene.name))),
    }
}

fn wrong(error: impl Display) -> Missing {
    Missing::Wrong(error.to_string())
}
