//! `--scene`: what surrounds the robot.

use super::choices::PlantName;
use super::error::Error;
use super::input;
use std::fmt;
use std::path::{Path, PathBuf};
use std::str::FromStr;
use tip_runtime::plant::Scene;
use tip_sim::{GraspsNothing, Robot};
use tipc::Loaded;

/// `NAME` or `FILE.toml`.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum SceneChoice {
    Named(Box<Scene>),
    File(PathBuf),
}

impl SceneChoice {
    /// The file that it is read from, if there is one.
    pub(super) fn file(&self) -> Option<&Path> {
        match self {
            SceneChoice::Named(_) => None,
            SceneChoice::File(path) => Some(path),
        }
    }

    /// A scene by its name, or by its path from the folder of another file.
    pub(super) fn beside(name: &str, other: &Path) -> Option<Self> {
        Some(match (name.parse().ok()?, other.parent()) {
            (SceneChoice::File(path), Some(folder)) => SceneChoice::File(folder.join(path)),
            (choice, _) => choice,
        })
    }
}

impl fmt::Display for SceneChoice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SceneChoice::Named(_) => f.write_str("cylinder"),
            SceneChoice::File(path) => path.display().fmt(f),
        }
    }
}

impl FromStr for SceneChoice {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let is_file = Path::new(text).extension().is_some_and(|end| end == "toml");
        match Scene::by_name(text) {
            Some(scene) => Ok(SceneChoice::Named(Box::new(scene))),
            None if is_file => Ok(SceneChoice::File(text.into())),
            None => Err("the scene is cylinder, or one of your own in a FILE.toml".to_owned()),
        }
    }
}

/// The scene that was asked for; without one, a level floor. The plant that was asked for wins over that of the scene.
///
/// # Errors
/// What is wrong with it.
pub(super) fn load(
    choice: Option<&SceneChoice>,
    plant: Option<PlantName>,
) -> Result<Scene, Box<Loaded>> {
    let mut scene = match choice {
        None => Scene::EMPTY,
        Some(SceneChoice::Named(scene)) => **scene,
        Some(SceneChoice::File(path)) => input::scene(path)?,
    };
    scene.plant = plant.map(PlantName::simulation).or(scene.plant);
    Ok(scene)
}

/// Puts a robot into a scene.
///
/// # Errors
/// It has objects, which a walking robot cannot grasp.
pub(super) fn around(robot: Robot, scene: &Scene) -> Result<Robot, Error> {
    let refused = |error: GraspsNothing| {
        Error::Usage(format!("{error}: a scene with objects needs --robot hand"))
    };
    robot.with_scene(scene).map_err(refused)
}
