//! The crate around a program: for which robot its macros and its build script compile it, where `tip.toml` says something
//! else.

mod sites;

use super::project::shown;
use super::robot::RobotChoice;
use crate::message::Linting;
use sites::{Said, Site};
use std::fs;
use std::path::{Path, PathBuf};
use tipc::code::Code;
use tipc::diagnostic::Diagnostic;
use tipc::embed::{LIMIT, read_file};
use tipc::source::Span;

/// As many sources of a crate are looked through.
const MOST_SOURCES: usize = 1_000;
/// Longer ones are not: MiB.
const LONGEST: usize = 1;
/// Folders below `src` that are looked into.
const DEPTH: usize = 16;

/// The warning that the crate compiles the program for another robot than the `tip.toml` at `project` gives it, and nowhere for that one. What
/// cannot be read for certain says nothing.
pub(super) fn warning(program: &Path, project: &Path, robot: &RobotChoice) -> Option<Diagnostic> {
    let found = differing(program, robot)?;
    let project = project.display().to_string();
    let place = Span::new(0, 0);
    let reason = Linting::CompiledForAnother {
        project: project.clone().into(),
        given: robot.to_string(),
        source: found.source.into(),
        other: found.robot,
    };
    let help = Linting::SayOneRobot {
        project: project.into(),
    };
    Some(Diagnostic::new(Code::OtherRobot, place, reason).help(help))
}

/// A place that compiles the program for another robot.
struct Other {
    /// File and line.
    source: String,
    robot: String,
}

fn differing(program: &Path, robot: &RobotChoice) -> Option<Other> {
    let program = fs::canonicalize(program).ok()?;
    let mut folders = program.ancestors().skip(1);
    let package = folders.find(|folder| folder.join("Cargo.toml").is_file())?;
    let mut first = None;
    for source in sources(package) {
        let Some(text) = text(&source) else { continue };
        let is_script = source.parent() == Some(package);
        let sites = if is_script {
            sites::of_script(&text)
        } else {
            sites::of_macros(&text)
        };
        let beside = source.parent().unwrap_or(package);
        for site in sites
            .iter()
            .filter(|site| names(site, &program, &[beside, package]))
        {
            let compiled = choice(&site.robot, &[beside, package])?;
            if is_same(&compiled, robot) {
                return None;
            }
            first.get_or_insert_with(|| Other {
                source: format!("{}:{}", shown(&source).display(), site.line),
                robot: compiled.to_string(),
            });
        }
    }
    first
}

/// The build script and what is below `src`.
fn sources(package: &Path) -> Vec<PathBuf> {
    let mut found = vec![package.join("build.rs")];
    collect(&package.join("src"), DEPTH, &mut found);
    found
}

fn collect(folder: &Path, depth: usize, found: &mut Vec<PathBuf>) {
    let Ok(entries) = fs::read_dir(folder) else {
        return;
    };
    let mut paths: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    paths.sort();
    for path in paths {
        let is_folder = path.symlink_metadata().is_ok_and(|it| it.is_dir());
        if found.len() >= MOST_SOURCES {
            return;
        } else if is_folder && depth > 0 {
            collect(&path, depth - 1, found);
        } else if path.extension().is_some_and(|end| end == "rs") {
            found.push(path);
        }
    }
}

fn text(source: &Path) -> Option<String> {
    String::from_utf8(read_file(source, LONGEST).ok()?).ok()
}

/// Whether a site means the program: the first folder that has its file counts, as for the macro.
fn names(site: &Site, program: &Path, folders: &[&Path]) -> bool {
    let candidates = folders.iter().map(|folder| folder.join(&site.program));
    let mut files = candidates.filter_map(|file| fs::canonicalize(file).ok());
    files.next().is_some_and(|file| file == program)
}

/// The robot of a site.
fn choice(said: &Said, folders: &[&Path]) -> Option<RobotChoice> {
    match said {
        Said::Named(name) => name.parse().ok(),
        Said::File(path) => {
            let candidates = folders.iter().map(|folder| folder.join(path));
            let mut files = candidates.filter(|file| file.is_file());
            files.next().map(|file| RobotChoice::File(shown(&file)))
        }
        Said::Unclear => None,
    }
}

fn is_same(one: &RobotChoice, other: &RobotChoice) -> bool {
    match (one.file(), other.file()) {
        (Some(one), Some(other)) => {
            let text = |path| read_file(path, LIMIT).ok();
            text(one) == text(other)
        }
        _ => one == other,
    }
}
