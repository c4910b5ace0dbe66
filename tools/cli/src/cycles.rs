//! `tip cycles`: how many control cycles the parts of a program take.

use super::arguments::SourceArguments;
use super::choices::Format;
use super::error::Error;
use super::loader::{check, checked};
use super::{Status, output};
use clap::Args;
use std::path::PathBuf;
use tip_lint::cycles::{self, Sampling};

/// `tip cycles`
#[derive(Debug, Args)]
#[command(
    after_help = "For each subroutine, each turn of a loop, and each stretch from a label to the next: the least and the
most control cycles, and the time at the robot's standard sampling time. One step is one cycle. A step that
waits counts as the least that it can take, and its part is marked 'waits'. 'or more' marks a part without a bound.

Examples:
  tip cycles walk.prg
  tip cycles --message-format json walk.prg   one object a line, for tools

Exit status: 0 if the program loads, 1 otherwise."
)]
pub(super) struct Cycles {
    /// The program
    pub(super) file: PathBuf,

    #[command(flatten)]
    pub(super) source: SourceArguments,
}

/// Writes the counts of one program to standard output.
pub(super) fn cycles(arguments: &Cycles) -> Result<Status, Error> {
    let source = &arguments.source;
    let Some(checked) = checked(check(&arguments.file, source), source)? else {
        return Ok(Status::Failure);
    };
    let sampling = Sampling::of(checked.robot.robot());
    let program = &checked.program;
    let parts = cycles::parts(program, sampling);
    output::print(match arguments.source.shown.message_format {
        Format::Human | Format::Sarif => cycles::human(program, &parts, sampling),
        Format::Short => cycles::short(program, &parts, sampling),
        Format::Json => cycles::json(program, &parts, sampling),
    })?;
    Ok(Status::Success)
}
