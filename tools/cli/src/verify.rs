//! `tipc verify`: compiled code against the reference interpreter, on searched or given inputs.

mod certificate;
mod finding;
mod watched;

use super::arguments::{InputArguments, SourceArguments};
use super::error::Error;
use super::loader::{checked, load};
use super::plant::Ours;
use super::robot::ChosenRobot;
use super::usage::positive;
use super::{Status, interrupt, output};
use crate::message::Using;
use certificate::certificate;
use clap::Args;
use finding::finding;
use std::path::PathBuf;
use tip_sim::search::{self, Failed};
use tip_sim::verify::{Project, Subject};
use watched::{Watched, building, interrupted_building};

/// `tipc verify`
#[derive(Debug, Args)]
#[command(
    after_help = "The program is compiled by tipc and cargo, in release mode, with the tip-runtime of your project. Compiled code and
interpreter run side by side on two simulated robots; every record must be the same, floats by bits. Without inputs
tipc makes many runs: it searches for keys, sensor readings and halt requests that lead to new steps and branches,
and always tries the same ones. What no run reached is listed. If the engines differ, the shortest inputs are shown.

Examples:
  tipc verify walk.prg
  tipc verify walk.prg --keys 300:F,400:Q    these inputs only
  tipc verify march.prg --robot hexapod.toml --cycles 2000 --runs 1000
  tipc verify walk.prg --manifest-path controller/Cargo.toml

Exit status: 0 both agree, 1 they differ, or the program does not load or build, 2 wrong usage,
130 interrupted."
)]
pub(super) struct Verify {
    /// The program
    pub(super) file: PathBuf,

    #[command(flatten)]
    pub(super) source: SourceArguments,

    #[command(flatten)]
    pub(super) inputs: InputArguments,

    /// How many runs a search makes
    #[arg(long, value_name = "N", default_value = "256", value_parser = positive, allow_negative_numbers = true)]
    pub(super) runs: u64,

    /// The Cargo.toml of the project whose tip-runtime is used, if not that of the current folder
    #[arg(long, value_name = "Cargo.toml")]
    pub(super) manifest_path: Option<PathBuf>,
}

/// Builds the program, runs both engines, and prints a certificate, or the shortest input on which they differ.
pub(super) fn verify(arguments: &Verify) -> Result<Status, Error> {
    interrupt::catch();
    let lang = arguments.source.shown.lang();
    let inputs = arguments.inputs.inputs();
    if let Some(0) = inputs.cycles {
        let text = "--cycles 0".to_owned();
        let reason = Using::NotPositive { text };
        return Err(Error::Usage(reason.in_lang(lang).to_string()));
    }
    let (file, source) = (&arguments.file, &arguments.source);
    let loaded = load(file, source, &arguments.inputs, Some(Ours::Again("verify")));
    let Some(checked) = checked(loaded, source)? else {
        return Ok(Status::Failure);
    };
    let project = Project::find(arguments.manifest_path.as_deref())?;
    let name = arguments.file.display().to_string();
    let source = checked.source.bytes();
    let options = arguments.source.options(checked.robot.robot());
    let subject = Subject::new(&name, &source, options, &checked.program).with_scene(checked.scene);
    let subject = match &checked.robot {
        ChosenRobot::Named(_) => subject,
        ChosenRobot::Described(description) => subject.on(description),
    };
    building();
    let built = project.engines(&subject).map_err(Error::from);
    let built = built.map_err(interrupted_building)?;
    let runs = if inputs.events.is_empty() {
        arguments.runs
    } else {
        1
    };
    let mut engines = Watched::new(built.given_up_if(interrupt::is_requested), runs);
    let compared = search::verify(&mut engines, &checked.program, &inputs, arguments.runs);
    drop(engines);
    let (coverage, diverging) = compared.map_err(|failed| match failed {
        Failed::Refused(reason) => Error::Usage(reason),
        Failed::Engines(error) => error,
    })?;
    match diverging {
        None => {
            output::print(certificate(
                &checked,
                &project,
                &arguments.inputs,
                &coverage,
            ))?;
            Ok(Status::Success)
        }
        Some(shortest) => {
            output::print(finding(&checked, &shortest))?;
            Ok(Status::Failure)
        }
    }
}
