//! `tip.toml` beside programs: the robot, the encoding and the scene that options leave open. The nearest one counts.

use super::arguments::{InputArguments, SourceArguments};
use super::choices::EncodingName;
use super::input;
use super::robot::RobotChoice;
use super::scene::SceneChoice;
use std::path::{Path, PathBuf, absolute};
use std::{env, fmt, fs};
use tipc::Loaded;

/// How the file is called.
const NAME: &str = "tip.toml";

/// What a `tip.toml` gives a program.
#[derive(Clone, Debug)]
pub(super) struct Given {
    /// The file that gives it.
    file: PathBuf,
    pub(super) robot: Option<RobotChoice>,
    pub(super) encoding: Option<EncodingName>,
    pub(super) scene: Option<SceneChoice>,
}

/// What the nearest `tip.toml` gives the program at `path`; nothing if there is none.
///
/// # Errors
/// What is wrong with it.
pub(super) fn of(path: &Path) -> Result<Option<Given>, Box<Loaded>> {
    given(path, Path::exists)
}

/// The same, where `is_there` says whether a file that it names is there.
fn given(path: &Path, is_there: fn(&Path) -> bool) -> Result<Option<Given>, Box<Loaded>> {
    let Some((program, folder)) = nearest(path) else {
        return Ok(None);
    };
    let file = shown(&folder.join(NAME));
    let project = input::project(&file, |named| is_there(&folder.join(named)))?;
    let names = program.strip_prefix(&folder).unwrap_or(&program).iter();
    let names: Vec<_> = names.map(|name| name.to_string_lossy()).collect();
    let said = project.of(&names.join("/"));
    let beside = |choice: RobotChoice| choice.beside(Some(&file));
    let given = Given {
        robot: said.robot.and_then(|name| name.parse().ok()).map(beside),
        encoding: said.encoding.map(EncodingName::of),
        scene: said.scene.and_then(|name| SceneChoice::beside(name, &file)),
        file,
    };
    Ok(Some(given).filter(Given::is_something))
}

/// The files that decide what the program at `path` is given: every `tip.toml` that may stand above it, and the description that
/// the nearest one names.
pub(super) fn files(path: &Path) -> Vec<PathBuf> {
    let program = real(path);
    let projects = program.ancestors().skip(1).map(|folder| folder.join(NAME));
    // What is not there yet may come.
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
    // `..` stays in it: where it leads to is known to the system only.
    absolute(path).map_or_else(|_| path.to_owned(), |path| resolve(&path))
}

/// A path as people write it: from the folder that they are in.
pub(super) fn shown(path: &Path) -> PathBuf {
    let here = env::current_dir().and_then(fs::canonicalize).ok();
    let inside = here.and_then(|here| path.strip_prefix(here).ok().map(Path::to_owned));
    inside.unwrap_or_else(|| path.to_owned())
}

impl SourceArguments {
    /// Takes what options leave open from the nearest `tip.toml`, and returns what that gives.
    ///
    /// # Errors
    /// What is wrong with it.
    pub(super) fn complete(&mut self, program: &Path) -> Result<Option<Given>, Box<Loaded>> {
        let mut given = of(program)?;
        if let Some(given) = &mut given {
            given.scene = given.scene_for(self.robot.as_ref()).cloned();
            complete(&mut self.robot, &mut given.robot);
            complete(&mut self.encoding, &mut given.encoding);
        }
        Ok(given.filter(Given::is_something))
    }

    /// The same for a run, which has surroundings.
    ///
    /// # Errors
    /// What is wrong with it.
    pub(super) fn complete_run(
        &mut self,
        program: &Path,
        inputs: &mut InputArguments,
    ) -> Result<Option<Given>, Box<Loaded>> {
        let mut given = self.complete(program)?;
        if let Some(given) = &mut given {
            complete(&mut inputs.scene, &mut given.scene);
        }
        Ok(given.filter(Given::is_something))
    }
}

/// Takes what an option leaves open; what the option says is not given.
fn complete<T: Clone>(option: &mut Option<T>, given: &mut Option<T>) {
    match option {
        Some(_) => *given = None,
        None => option.clone_from(given),
    }
}

impl Given {
    /// The file that gives it.
    pub(super) fn file(&self) -> &Path {
        &self.file
    }

    /// The scene, unless an option names another robot than the one that it is around.
    pub(super) fn scene_for(&self, option: Option<&RobotChoice>) -> Option<&SceneChoice> {
        let both = self.robot.as_ref().zip(option);
        let is_other = both.is_some_and(|(own, option)| own != option);
        self.scene.as_ref().filter(|_| !is_other)
    }

    fn is_something(&self) -> bool {
        self.robot.is_some() || self.encoding.is_some() || self.scene.is_some()
    }
}

impl fmt::Display for Given {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let robot = self.robot.as_ref().map(|robot| format!("robot {robot}"));
        let encoding = self.encoding.map(|it| format!("encoding {}", it.name()));
        let scene = self.scene.as_ref().map(|scene| format!("scene {scene}"));
        let given: Vec<String> = [robot, encoding, scene].into_iter().flatten().collect();
        write!(f, "{}: {}", self.file.display(), given.join(", "))
    }
}
