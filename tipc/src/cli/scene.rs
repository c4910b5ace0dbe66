//! `--scene`: what stands around the robot.

use super::error::Error;
use std::str::FromStr;
use tip_runtime::plant::{Floor, Scene};

/// A scene by its name.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct SceneChoice(Box<Scene>);

impl FromStr for SceneChoice {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        let scene = Scene::by_name(name).map(|scene| SceneChoice(Box::new(scene)));
        scene.ok_or_else(|| "the scenes are cylinder and nothing else".to_owned())
    }
}

/// The scene that was asked for; without one, a level floor.
pub(super) fn load(choice: Option<&SceneChoice>) -> Scene {
    choice.map_or(Scene::EMPTY, |SceneChoice(scene)| **scene)
}

/// What a walking robot uses of a scene.
///
/// # Errors
/// It has objects, which a walking robot cannot grasp.
pub(super) fn floor(scene: &Scene, robot: &str) -> Result<Floor, Error> {
    if scene.objects.iter().any(Option::is_some) {
        return Err(Error::Usage(format!(
            "{robot} grasps nothing: a scene with objects needs --robot hand"
        )));
    }
    Ok(scene.floor)
}
