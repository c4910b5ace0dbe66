//! `tip.toml`: the robot, the encoding and the scene that options leave open. The nearest file counts.

use super::arguments::{RunArguments, SourceArguments};
use super::choices::{EncodingName, name};
use super::error::Error;
use super::input;
use super::setup::{RobotChoice, SceneChoice};
use std::path::{Path, PathBuf, absolute};
use std::{env, fmt, fs};
use tipc::Loaded;

/// The name of the file.
const NAME: &str = "tip.toml";

/// The settings that a `tip.toml` gives a program.
#[derive(Clone, Debug)]
pub(super) struct Settings {
    /// The `tip.toml`.
    file: PathBuf,
    pub(super) robot: Option<RobotChoice>,
    pub(super) encoding: Option<EncodingName>,
    pub(super) scene: Option<SceneChoice>,
}

/// Returns the settings of the nearest `tip.toml` for the program at `path`; `None` if there are none.
///
/// # Errors
/// The `tip.toml` has errors.
pub(super) fn of(path: &Path) -> Result<Option<Settings>, Box<Loaded>> {
    given(path, Path::exists)
}

/// Returns the settings; `is_there` returns true if a file that they name exists.
fn given(path: &Path, is_there: fn(&Path) -> bool) -> Result<Option<Settings>, Box<Loaded>> {
    let Some((program, folder)) = nearest(path) else {
        return Ok(None);
    };
    let file = display_path(&folder.join(NAME));
    let project = input::project(&file, |named| is_there(&folder.join(named)))?;
    let names = program.strip_prefix(&folder).unwrap_or(&program).iter();
    let names: Vec<_> = names.map(|name| name.to_string_lossy()).collect();
    let found = project.of(&names.join("/"));
    let resolve = |choice: RobotChoice| choice.relative_to(Some(&file));
    let settings = Settings {
        robot: found.robot.and_then(|name| name.parse().ok()).map(resolve),
        encoding: found.encoding.map(EncodingName::of),
        scene: found
            .scene
            .and_then(|name| SceneChoice::relative_to(name, &file)),
        file,
    };
    Ok(Some(settings).filter(Settings::is_some))
}

/// Returns the files that settings depend on: every `tip.toml` that may exist above the program, and the description that the
/// nearest one names.
pub(super) fn files(path: &Path) -> Vec<PathBuf> {
    let program = real(path);
    let projects = program.ancestors().skip(1).map(|folder| folder.join(NAME));
    // A file that does not exist may be created later.
    let given = given(path, |_| true).ok().flatten();
    let robot = given.and_then(|given| given.robot);
    let description = robot.and_then(|robot| robot.file().map(Path::to_owned));
    projects.chain(description).collect()
}

/// Returns the program's real path, and the nearest folder above it with a `tip.toml`, which may turn out to be unusable.
fn nearest(path: &Path) -> Option<(PathBuf, PathBuf)> {
    let program = real(path);
    let mut folders = program.ancestors().skip(1);
    let folder = folders.find(|folder| folder.join(NAME).symlink_metadata().is_ok())?;
    Some((program.clone(), folder.to_owned()))
}

/// Returns the path without links and `..`, as the system finds the file. As much of it as exists counts; a stream is in the
/// working directory.
pub(super) fn real(path: &Path) -> PathBuf {
    fn resolve(path: &Path) -> PathBuf {
        let missing = || Some(resolve(path.parent()?).join(path.file_name()?));
        let found = fs::canonicalize(path).ok().or_else(missing);
        found.unwrap_or_else(|| path.to_owned())
    }
    if input::is_stream(path) {
        let here = env::current_dir().unwrap_or_default();
        return resolve(&here).join("-");
    }
    // `..` is kept: only the system can resolve it.
    absolute(path).map_or_else(|_| path.to_owned(), |path| resolve(&path))
}

/// Returns a path relative to the working directory if it is inside.
pub(super) fn display_path(path: &Path) -> PathBuf {
    let here = env::current_dir().and_then(fs::canonicalize).ok();
    let inside = here.and_then(|here| path.strip_prefix(here).ok().map(Path::to_owned));
    inside.unwrap_or_else(|| path.to_owned())
}

impl SourceArguments {
    /// Completes the options from the nearest `tip.toml`; returns the settings that it used.
    ///
    /// # Errors
    /// The `tip.toml` has errors.
    pub(super) fn complete(&mut self, program: &Path) -> Result<Option<Settings>, Error> {
        let mut given = of(program).map_err(Error::refused(self.output_options))?;
        if let Some(given) = &mut given {
            given.scene = given.scene_for(self.robot.as_ref()).cloned();
            complete(&mut self.robot, &mut given.robot);
            complete(&mut self.encoding, &mut given.encoding);
        }
        let robot = |given: &Settings| Some((given.file.clone(), given.robot.clone()?));
        self.given = given.as_ref().and_then(robot);
        Ok(given.filter(Settings::is_some))
    }
}

impl RunArguments {
    /// Completes the options of a run, which also has a scene.
    ///
    /// # Errors
    /// The `tip.toml` has errors.
    pub(super) fn complete(&mut self, program: &Path) -> Result<Option<Settings>, Error> {
        let mut given = self.source.complete(program)?;
        if let Some(given) = &mut given {
            complete(&mut self.inputs.scene, &mut given.scene);
        }
        Ok(given.filter(Settings::is_some))
    }
}

/// Completes an option; a setting that the option overrides is dropped.
fn complete<T: Clone>(option: &mut Option<T>, given: &mut Option<T>) {
    match option {
        Some(_) => *given = None,
        None => option.clone_from(given),
    }
}

impl Settings {
    /// The `tip.toml`.
    pub(super) fn file(&self) -> &Path {
        &self.file
    }

    /// Returns the scene, unless an option names another robot than the settings do.
    pub(super) fn scene_for(&self, option: Option<&RobotChoice>) -> Option<&SceneChoice> {
        let both = self.robot.as_ref().zip(option);
        let is_other = both.is_some_and(|(own, option)| own != option);
        self.scene.as_ref().filter(|_| !is_other)
    }

    fn is_some(&self) -> bool {
        self.robot.is_some() || self.encoding.is_some() || self.scene.is_some()
    }
}

impl fmt::Display for Settings {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let robot = self.robot.as_ref().map(|robot| format!("robot {robot}"));
        let encoding = self.encoding.map(|it| format!("encoding {}", name(it)));
        let scene = self.scene.as_ref().map(|scene| format!("scene {scene}"));
        let given: Vec<String> = [robot, encoding, scene].into_iter().flatten().collect();
        write!(f, "{}: {}", self.file.display(), given.join(", "))
    }
}
