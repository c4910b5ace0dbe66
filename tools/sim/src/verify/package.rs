//! The package that is built: the user's program as Rust and as text, its robot, and a loop that answers requests.

use super::NotBuilt;
use super::Subject;
use super::project::Project;
use crate::robot::Robot;
use proc_macro2::{Ident, Span};
use quote::quote;
use std::error::Error;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::{fs, io};
use tip_runtime::record::AtomicFile;
use tipc::description::Description;
use tipc::emit;
use tipc::program::Program;

/// A cargo package that is still to be written: each file with its content.
pub(super) struct Package {
    name: String,
    files: Vec<(&'static str, Vec<u8>)>,
}

impl Package {
    /// Creates the package for one program on one robot in one scene.
    pub(super) fn new(subject: &Subject<'_>, project: &Project) -> Result<Self, NotBuilt> {
        let program = subject.program;
        let mut files = vec![
            ("src/source.prg", subject.source.to_vec()),
            ("src/program.rs", compiled(program)?.into_bytes()),
            ("src/main.rs", main(subject)?.into_bytes()),
        ];
        if let Some(description) = subject.description {
            files.push(("src/robot.rs", robot(description)?.into_bytes()));
        }
        let mut hasher = DefaultHasher::new();
        (&files, &project.runtime, &project.sim).hash(&mut hasher);
        let name = format!(
            "verify-{}-{:016x}",
            crate_name(program.source_name()),
            hasher.finish()
        );
        files.push(("Cargo.toml", manifest(&name, project).into_bytes()));
        Ok(Package { name, files })
    }

    /// Writes what is not there yet, so that cargo builds nothing twice; gives the manifest.
    pub(super) fn write(&self, project: &Project) -> Result<PathBuf, NotBuilt> {
        let folder = project.target.join(&self.name);
        let sources = folder.join("src");
        fs::create_dir_all(&sources).map_err(|error| cannot_write(&sources, &error))?;
        for (name, content) in &self.files {
            let path = folder.join(name);
            if fs::read(&path).ok().as_ref() != Some(content) {
                replace(&path, content)?;
            }
        }
        // The project's own versions of everything; a project without a lock file has none yet.
        if let Ok(lock) = fs::read(&project.lock) {
            replace(&folder.join("Cargo.lock"), &lock)?;
        }
        Ok(folder.join("Cargo.toml"))
    }
}

/// Returns the name of a package made of the characters that it may contain.
fn crate_name(source: &str) -> String {
    let stem = source.rsplit_once('.').map_or(source, |(stem, _)| stem);
    let plain = stem
        .chars()
        .map(|c| if c.is_ascii_alphanumeric() { c } else { '-' });
    plain.collect()
}

fn manifest(name: &str, project: &Project) -> String {
    let Project { runtime, sim, .. } = project;
    format!(
        r#"# Written by `tip verify`.
[package]
name = "{name}"
version = "0.0.0"
edition = "2024"
publish = false

[workspace]

[dependencies]
tip-runtime = {{ {runtime} }}
tip-sim = {{ {sim} }}

# What runs in control cycles is optimised. The rest only reads the program, and builds in half the time without.
[profile.release.package."*"]
opt-level = 0

[profile.release.package.tip-runtime]
opt-level = 3

[profile.release.package.tip-sim]
opt-level = 3

[profile.release.package.libm]
opt-level = 3
"#
    )
}

fn main(subject: &Subject<'_>) -> Result<String, NotBuilt> {
    let Subject {
        name: source,
        options,
        scene,
        ..
    } = subject;
    simulated(subject)?;
    let name = options.robot.name();
    let (module, robot) = match subject.description {
        None => (
            "",
            format!("Robot::named({name:?}).expect(\"tip knows it\")"),
        ),
        Some(_) => ("mod robot;\n", "Robot::of(&robot::ROBOT)".to_owned()),
    };
    let (version, encoding) = (options.tip_version, options.encoding);
    // A scene's debug form is Rust.
    Ok(format!(
        r#"//! Compiled code and interpreter, run by run as standard input asks for them. Written by `tip verify`.
#![allow(unused_imports)]

mod program;
{module}
use std::io;
use tip_runtime::plant::Shape::{{Box, Disc}};
use tip_runtime::plant::Simulation::{{Dynamic, QuasiStatic}};
use tip_runtime::plant::{{Block, Floor, Object, Scene}};
use tip_sim::Robot;
use tip_sim::lockstep::{{Lockstep, serve}};
use tip_sim::tipc::source::Encoding;
use tip_sim::tipc::{{Options, load}};

fn main() -> io::Result<()> {{
    let scene = {scene:?};
    let robot = {robot};
    let robot = robot.with_scene(&scene).expect("tip put it there already");
    let options = Options {{
        tip_version: {version:?},
        encoding: Encoding::{encoding:?},
        ..robot.options()
    }};
    let loaded = load({source:?}, include_bytes!("source.prg"), &options);
    let program = loaded.program.expect("tip loaded it already");
    let compiled = program::Verified::new();
    let lockstep = Lockstep::new(program, compiled, &robot).expect("both are for this robot");
    serve(lockstep, io::stdin().lock(), io::stdout().lock())
}}
"#
    ))
}

/// Returns the robot in its scene, as the package puts it there.
fn simulated(subject: &Subject<'_>) -> Result<Robot, NotBuilt> {
    let failed = |error: &dyn Error| NotBuilt::Failed(error.to_string());
    let robot = match subject.description {
        None => Robot::named(subject.options.robot.name()).map_err(|error| failed(&error))?,
        Some(description) => Robot::described(description),
    };
    let robot = robot.with_scene(&subject.scene);
    robot.map_err(|error| failed(&error))
}

fn compiled(program: &Program) -> Result<String, NotBuilt> {
    let text = emit::pretty(program, &spelling("Verified"));
    text.map_err(|error| unspeakable(program.source_name(), &error))
}

fn robot(description: &Description) -> Result<String, NotBuilt> {
    let text = description.pretty(&spelling("ROBOT"));
    text.map_err(|error| unspeakable(description.name(), &error))
}

fn spelling(name: &str) -> emit::Options {
    emit::Options {
        name: Some(Ident::new(name, Span::call_site())),
        visibility: quote!(pub(crate)),
        ..emit::Options::default()
    }
}

/// Writes a file, or leaves it as it was.
fn replace(path: &Path, content: &[u8]) -> Result<(), NotBuilt> {
    let written = AtomicFile::create(path).and_then(|mut file| {
        file.write_all(content)?;
        file.commit()
    });
    written.map_err(|error| cannot_write(path, &error))
}

fn cannot_write(path: &Path, error: &io::Error) -> NotBuilt {
    NotBuilt::CannotWrite {
        path: path.to_owned(),
        reason: error.to_string(),
    }
}

fn unspeakable(what: &str, error: &impl std::fmt::Display) -> NotBuilt {
    NotBuilt::Failed(format!("{what} cannot be spelt in Rust: {error}"))
}
