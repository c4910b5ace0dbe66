//! `tip log`: a run as a file that the field's viewers and tables read.

use super::error::Error;
use super::plant::Ours;
use super::recorded::RecordedArguments;
use super::{Status, output, report};
use clap::Args;
use std::io::{self, Cursor};
use std::path::{Path, PathBuf};
use tip_sim::urdf;
use tip_view::Pace;

/// `tip log`
#[derive(Debug, Args)]
#[command(
    after_help = "run.mcap holds the robot and its frames, joint states, forces, trails, objects, and what the program did: step and line,
flags, messages, variables. Foxglove and Rerun show it. run.csv has a row for each cycle. docs/logs.md lists topics and columns.

Examples:
  tip log walk.prg -o walk.mcap
  tip log grasp.prg --robot hand --scene scene.toml -o grasp.csv --every 10

A run that has no end is recorded for ten minutes of the robot's time, or until it has waited for a minute without a motion;
--cycles sets another end.

Exit status: as for 'tip run'."
)]
pub(super) struct Log {
    #[command(flatten)]
    pub(super) recorded: RecordedArguments,

    /// The file; its ending says what it is
    #[arg(short, long, value_name = "OUT.mcap|OUT.csv")]
    out: PathBuf,

    /// Keep the motion of one cycle in so many; without it MCAP has 50 Hz at most, CSV each cycle
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    every: Option<u64>,
}

/// What a file is.
#[derive(Clone, Copy)]
enum Kind {
    Mcap,
    Csv,
}

impl Kind {
    fn of(path: &Path) -> Result<Self, Error> {
        match path.extension().and_then(|ending| ending.to_str()) {
            Some("mcap") => Ok(Kind::Mcap),
            Some("csv") => Ok(Kind::Csv),
            _ => Err(Error::Usage(
                "a log is a file that ends in .mcap or .csv".to_owned(),
            )),
        }
    }

    fn pace(self, every: Option<u64>) -> Pace {
        match (self, every) {
            (_, Some(cycles)) => Pace::Every(cycles),
            (Kind::Mcap, None) => Pace::Smooth,
            (Kind::Csv, None) => Pace::Every(1),
        }
    }
}

/// Runs the program, and writes what it did.
pub(super) fn log(arguments: &Log) -> Result<Status, Error> {
    let (out, kind) = (&arguments.out, Kind::of(&arguments.out)?);
    output::refuse_inputs(out, &arguments.recorded.files())?;
    let Some(recorded) = arguments
        .recorded
        .record(kind.pace(arguments.every), Ours::Recorded("log"))?
    else {
        return Ok(Status::Failure);
    };
    let recording = &recorded.recording;
    let mut bytes = Vec::new();
    let written: io::Result<()> = match kind {
        Kind::Mcap => recording.mcap(&urdf::export(&recorded.robot), Cursor::new(&mut bytes)),
        Kind::Csv => recording.csv(&mut bytes),
    };
    written.map_err(|reason| Error::cannot_write(out, reason))?;
    output::replace(out, &bytes)?;
    let (cycles, frames) = (recording.cycles, recording.frames.len());
    report::complain(&format!(
        "{}: {cycles} cycles, the motion of {frames} of them, {}\n",
        out.display(),
        recording.outcome
    ));
    Ok(recorded.status())
}
