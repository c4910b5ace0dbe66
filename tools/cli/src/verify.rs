//! `tipc verify`: compiled code against the reference interpreter, on searched or given inputs.

mod certificate;
mod engines;
mod events;
mod finding;
mod levers;
mod package;
mod project;
mod random;
mod search;
mod shrink;
mod tally;

use super::arguments::Verify;
use super::checked::checked;
use super::error::Error;
use super::{Status, output, scene};
use certificate::certificate;
use engines::Engines;
use finding::finding;
use package::Package;
use project::Project;
use search::Search;
use tally::{Came, Tally};

/// Builds the program, runs both engines, and prints a certificate, or the shortest input on which they differ.
pub(super) fn verify(arguments: &Verify) -> Result<Status, Error> {
    let Some(checked) = checked(&arguments.file, &arguments.source) else {
        return Ok(Status::Failure);
    };
    let format = arguments.source.message_format;
    let Some(scene) = scene::load(arguments.inputs.scene.as_ref(), format) else {
        return Ok(Status::Failure);
    };
    let project = Project::find(arguments.manifest_path.as_deref())?;
    let package = Package::new(arguments, &checked, &scene, &project)?;
    let executable = project.build(&package.write(&project)?)?;
    let mut engines = Engines::start(&executable)?;
    let mut tally = Tally::new(&checked.program);
    let inputs = arguments.inputs.inputs();
    let diverging = if inputs.happen() {
        match tally.run(&mut engines, &inputs)? {
            Came::Diverged(diverging) => Some(diverging),
            Came::Agreed { .. } => None,
        }
    } else {
        let search = Search::new(&mut engines, &mut tally, inputs.cycles);
        search.run(&checked.program, arguments.runs)?
    };
    match diverging {
        None => {
            output::print(certificate(
                &checked,
                &project,
                arguments.inputs.scene.as_ref(),
                &tally,
            ))?;
            Ok(Status::Success)
        }
        Some(diverging) => {
            let shortest = shrink::shrink(&mut engines, diverging)?;
            output::print(finding(&checked, &shortest))?;
            Ok(Status::Failure)
        }
    }
}
