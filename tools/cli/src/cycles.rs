//! `tipc cycles`: how many control cycles the parts of a program take.

use super::arguments::Cycles;
use super::checked::checked;
use super::choices::Format;
use super::error::Error;
use super::{Status, output};
use tipc::analysis::cycles::{self, Sampling};

/// Writes the counts of one program to standard output.
pub(super) fn cycles(arguments: &Cycles) -> Result<Status, Error> {
    let Some(checked) = checked(&arguments.file, &arguments.source) else {
        return Ok(Status::Failure);
    };
    let sampling = Sampling::of(checked.robot.robot());
    let program = &checked.program;
    let parts = cycles::parts(program, sampling);
    output::print(match arguments.source.message_format {
        Format::Human => cycles::human(program, &parts, sampling),
        Format::Short => cycles::short(program, &parts, sampling),
        Format::Json => cycles::json(program, &parts, sampling),
    })?;
    Ok(Status::Success)
}
