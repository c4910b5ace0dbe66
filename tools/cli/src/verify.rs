//! `tipc verify`: compiled code against the reference interpreter, on searched or given inputs.

mod certificate;
mod engines;
mod finding;
mod package;
mod project;

use super::arguments::Verify;
use super::checked::checked;
use super::error::Error;
use super::{Status, output, scene};
use certificate::certificate;
use engines::Engines;
use finding::finding;
use package::Package;
use project::Project;
use tip_sim::search::{self, Failed};

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
    let inputs = arguments.inputs.inputs();
    let compared = search::verify(&mut engines, &checked.program, &inputs, arguments.runs);
    let (tally, diverging) = compared.map_err(|failed| match failed {
        Failed::Refused(reason) => Error::Usage(reason),
        Failed::Engines(error) => error,
    })?;
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
        Some(shortest) => {
            output::print(finding(&checked, &shortest))?;
            Ok(Status::Failure)
        }
    }
}
