//! `tipc check`: reports everything that is wrong with programs.

use super::arguments::SourceArguments;
use super::error::Error;
use super::{Status, input, report};
use clap::Args;
use std::path::PathBuf;

/// `tipc check`
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  tipc check walk.prg turn.prg
  tipc check --robot hand grasp.prg
  tipc check --robot hexapod.toml march.prg   a robot of your own (docs/robots.md)
  tipc check --message-format json walk.prg   one object a line, on standard output
  tipc check --message-format short *.prg     FILE:LINE:COLUMN: error[E205]: REASON (TIP_ERR:...)
  tipc check - < walk.prg                     from standard input
  tipc check --lang ja walk.prg               reasons and helps in Japanese

Exit status: 0 if every program loads (warnings do not count), 1 otherwise.")]
pub(super) struct Check {
    /// The programs; '-' is standard input
    #[arg(value_name = "FILE", required = true)]
    pub(super) files: Vec<PathBuf>,

    #[command(flatten)]
    pub(super) source: SourceArguments,
}

/// Checks each file; one that does not load makes the whole command fail.
pub(super) fn check(arguments: &Check) -> Result<Status, Error> {
    let shown = arguments.source.shown;
    let robot = match arguments.source.robot.load() {
        Ok(robot) => robot.robot(),
        Err(loaded) => {
            report::check(&loaded, shown)?;
            return Ok(Status::Failure);
        }
    };
    let options = arguments.source.options(robot);
    let mut status = Status::Success;
    let mut total = report::Total::default();
    for file in &arguments.files {
        let loaded = input::load(file, &options);
        report::check(&loaded, shown)?;
        total.add(&loaded);
        if loaded.program.is_none() {
            status = Status::Failure;
        }
    }
    total.report(shown);
    Ok(status)
}
