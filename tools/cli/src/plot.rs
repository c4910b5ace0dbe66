//! `tip plot`: a run as diagrams.

use super::error::Error;
use super::plant::Ours;
use super::recorded::RecordedArguments;
use super::{Status, output};
use clap::{Args, ValueEnum};
use std::path::PathBuf;
use tip_view::{Diagram, Pace};

/// `tip plot`
#[derive(Debug, Args)]
#[command(
    after_help = "The diagrams have units on their axes and are readable on light and dark grounds; --lang ja titles them in Japanese.

Examples:
  tip plot walk.prg -o walk.svg
  tip plot walk.prg -o gait.svg --of gait --of forces

Exit status: as for 'tip run'."
)]
pub(super) struct Plot {
    #[command(flatten)]
    pub(super) recorded: RecordedArguments,

    /// The file
    #[arg(short, long, value_name = "OUT.svg")]
    out: PathBuf,

    /// What is drawn, from top to bottom; everything without it
    #[arg(long, value_name = "WHAT", value_enum)]
    of: Vec<What>,
}

/// Diagrams by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum What {
    /// Which feet carry the robot, or which fingertips touch something
    Gait,
    /// Where the feet go: mm
    Feet,
    /// The angle of each joint: deg
    Angles,
    /// What each motor gives: N·m or mN·m
    Torques,
    /// The load of each foot, or the force of each fingertip: N
    Forces,
}

impl What {
    fn diagram(self) -> Diagram {
        match self {
            What::Gait => Diagram::Gait,
            What::Feet => Diagram::Feet,
            What::Angles => Diagram::Angles,
            What::Torques => Diagram::Torques,
            What::Forces => Diagram::Forces,
        }
    }
}

/// Runs the program, and draws what it did.
pub(super) fn plot(arguments: &Plot) -> Result<Status, Error> {
    let out = &arguments.out;
    output::refuse_inputs(out, &arguments.recorded.files())?;
    let Some(recorded) = arguments
        .recorded
        .record(Pace::Smooth, Ours::Recorded("plot"))?
    else {
        return Ok(Status::Failure);
    };
    let diagrams: Vec<Diagram> = match arguments.of.as_slice() {
        [] => Diagram::ALL.into(),
        some => some.iter().map(|what| what.diagram()).collect(),
    };
    let lang = arguments.recorded.source.shown.lang();
    let drawn = recorded.recording.plot(&diagrams, lang);
    let text = drawn.map_err(|reason| Error::cannot_write(out, reason))?;
    output::replace(out, text)?;
    Ok(recorded.status())
}
