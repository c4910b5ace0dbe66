//! The command line, and the help that teaches it.

mod inputs;

pub(super) use inputs::InputArguments;

use super::choices::{EncodingName, Form, Format};
use super::robot::RobotChoice;
use clap::{Args, Parser, Subcommand};
use std::path::PathBuf;
use tipc::{Options, Robot};

/// Compiler, checker and simulator for T.I.P. 3.1 robot programs.
#[derive(Debug, Parser)]
#[command(
    name = "tipc",
    version,
    arg_required_else_help = true,
    after_help = "A first session:
  tipc check walk.prg                 what is wrong with it, all at once
  tipc run walk.prg                   run it on the simulated TITAN VIII
  tipc emit rust walk.prg -o walk.rs  the same program as Rust source
  tipc cycles walk.prg                how many control cycles its parts take
  tipc verify walk.prg                that its compiled code does what the interpreter does
  tipc migrate old.prg -o walk.prg    an older program as one of version 3.1
  tipc robot check hexapod.toml       what a robot of your own has

'tipc help run' and its like show examples of each command.
Exit status: 0 done, 1 the program does not load or does not verify, or a file cannot be written,
2 wrong usage, 3 emergency stop, 130 interrupted."
)]
pub(super) struct Arguments {
    #[command(subcommand)]
    pub(super) verb: Verb,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub(super) enum Verb {
    /// Report everything that is wrong with programs
    Check(Check),
    /// Run a program on the simulated robot
    Run(Run),
    /// Write a program in another form
    Emit(Emit),
    /// Count the control cycles that the parts of a program take
    Cycles(Cycles),
    /// Compare a program's compiled code with the reference interpreter
    Verify(Verify),
    /// Turn a program of an older version into one of version 3.1
    Migrate(Migrate),
    /// Descriptions of robots
    #[command(subcommand)]
    Robot(RobotVerb),
}

/// What to do with a robot's description.
#[derive(Debug, Subcommand)]
pub(super) enum RobotVerb {
    /// Report everything that is wrong with a description, or what the robot has
    Check(CheckRobot),
    /// Make a description of a URDF file
    Import(Import),
}

/// `tipc robot check`
#[derive(Debug, Args)]
#[command(after_help = "Example:
  tipc robot check hexapod.toml

Exit status: 0 if the description can be used, 1 otherwise.")]
pub(super) struct CheckRobot {
    /// The description
    #[arg(value_name = "FILE.toml")]
    pub(super) file: PathBuf,

    /// How faults are shown: snippets for people, or lines for tools
    #[arg(long, value_enum, default_value = "human")]
    pub(super) message_format: Format,
}

/// `tipc robot import`
#[derive(Debug, Args)]
#[command(
    after_help = "Each chain of revolute or continuous joints from the base to a last link becomes a leg; fixed joints are merged. The
foot is the link at the end, on a fixed joint. A report on standard error tells what was assumed and what was dropped.

Example:
  tipc robot import quadruped.urdf -o quadruped.toml

Exit status: 0 if the description is written, 1 otherwise."
)]
pub(super) struct Import {
    /// The URDF file; xacro has to be expanded first
    #[arg(value_name = "FILE.urdf")]
    pub(super) file: PathBuf,

    /// Write to a file instead of standard output
    #[arg(short, long, value_name = "OUT.toml")]
    pub(super) out: Option<PathBuf>,
}

/// How a source file is to be read. Every command takes these.
#[derive(Debug, Args)]
pub(super) struct SourceArguments {
    /// The robot that the program is for: titan8, hand, generic, or a description
    #[arg(long, value_name = "NAME|FILE.toml", default_value = "titan8")]
    pub(super) robot: RobotChoice,

    /// The version of the language that line 1 must name
    #[arg(long, value_name = "NUMBER", default_value = "3.1", value_parser = version_number)]
    tip_version: f64,

    /// How the file spells text; auto takes UTF-8 if it is valid, else Shift_JIS
    #[arg(long, value_enum, default_value = "auto")]
    encoding: EncodingName,

    /// How findings are shown: snippets for people, or lines for tools
    #[arg(long, value_enum, default_value = "human")]
    pub(super) message_format: Format,
}

impl SourceArguments {
    /// What the compiler is told.
    pub(super) fn options(&self, robot: Robot) -> Options {
        Options {
            robot,
            tip_version: self.tip_version,
            encoding: self.encoding.encoding(),
        }
    }
}

/// `tipc check`
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  tipc check walk.prg turn.prg
  tipc check --robot hand grasp.prg
  tipc check --robot hexapod.toml march.prg   a robot of your own (docs/robots.md)
  tipc check --message-format json walk.prg   one object a line, on standard output
  tipc check --message-format short *.prg     FILE:LINE:COLUMN: error: TIP_ERR:...

Exit status: 0 if every program loads (warnings do not count), 1 otherwise.")]
pub(super) struct Check {
    /// The programs
    #[arg(value_name = "FILE", required = true)]
    pub(super) files: Vec<PathBuf>,

    #[command(flatten)]
    pub(super) source: SourceArguments,
}

/// `tipc run`
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  tipc run walk.prg                             until END; messages on standard output
  tipc run walk.prg --cycles 500 --trace -      500 control cycles, the trace on standard output
  tipc run walk.prg --halt 300                  HALT_REQUEST is true from cycle 300 on
  tipc run ask.prg --keys '10:y,25:0x2C'        Y before cycle 10, a comma before cycle 25
  tipc run march.prg --robot hexapod.toml
  tipc run sense.prg --sensor VR1=8@300 --sensor PAW1=2.5@0
  tipc run --robot hand grasp.prg --scene cylinder
  tipc run walk.prg --out-dir logs              TITAN.LOG, EMG.log and the others go to logs/

One cycle is one step of the program: 20 ms of the robot's time, 2 ms of the hand's, unless the
program sets another. On a terminal keys reach the program as they are pressed, RETURN is the
emergency stop and ESC the halt request; Ctrl-C ends the run and completes its files,
a second one ends a run that is stuck.

Exit status: 0 END, EXIT or --cycles used up, 1 the program does not load, 2 wrong usage,
3 emergency stop, 130 interrupted.")]
pub(super) struct Run {
    /// The program
    pub(super) file: PathBuf,

    #[command(flatten)]
    pub(super) source: SourceArguments,

    #[command(flatten)]
    pub(super) inputs: InputArguments,

    /// Write the trace, one JSON object a line, to a file, or to standard output for '-'
    #[arg(long, value_name = "OUT.jsonl|-")]
    pub(super) trace: Option<PathBuf>,

    /// End each record of the trace with a hash of what the robot was told and measured
    #[arg(long)]
    pub(super) trace_state: bool,

    /// Write the log files of the language into this folder
    #[arg(long, value_name = "DIR")]
    pub(super) out_dir: Option<PathBuf>,
}

/// `tipc emit`
#[derive(Debug, Args)]
#[command(after_help = "Forms:
  rust     one state for each step, as the macros and build scripts compile it
  formal   FORMAL.TMP: the program step by step, comments and layout gone
  label    LABEL.TMP: every label and the number of its step
  obj      TIP.OBJ: every step as command, target and arguments with their types
  warning  WARNING.LOG: the warnings, one a line

Examples:
  tipc emit rust walk.prg -o walk.rs
  tipc emit label walk.prg")]
pub(super) struct Emit {
    /// Which form
    #[arg(value_enum)]
    pub(super) form: Form,

    /// The program
    pub(super) file: PathBuf,

    /// Write to a file instead of standard output
    #[arg(short, long, value_name = "OUT")]
    pub(super) out: Option<PathBuf>,

    #[command(flatten)]
    pub(super) source: SourceArguments,
}

/// `tipc cycles`
#[derive(Debug, Args)]
#[command(
    after_help = "For each subroutine, each turn of a loop, and each stretch from a label to the next: the least and the
most control cycles, and the time at the robot's standard sampling time. One step is one cycle. A step that
waits counts as the least that it can take, and its part 'waits'. 'or more' stands where nothing bounds a part.

Examples:
  tipc cycles walk.prg
  tipc cycles --message-format json walk.prg   one object a line, for tools

Exit status: 0 if the program loads, 1 otherwise."
)]
pub(super) struct Cycles {
    /// The program
    pub(super) file: PathBuf,

    #[command(flatten)]
    pub(super) source: SourceArguments,
}

/// `tipc verify`
#[derive(Debug, Args)]
#[command(
    after_help = "The program is compiled by tipc and cargo, in release mode, with the tip-runtime of your project. Compiled code and
interpreter run side by side on two simulated robots; every record must be the same, floats by bits. Without inputs
many runs are made: keys, sensors and halt requests are searched that lead to steps and branches not reached yet,
always the same ones. What is left is listed. Where the engines differ, the shortest inputs are shown.

Examples:
  tipc verify walk.prg
  tipc verify walk.prg --keys 300:F,400:Q    these inputs only
  tipc verify march.prg --robot hexapod.toml --cycles 2000 --runs 1000
  tipc verify walk.prg --manifest-path controller/Cargo.toml

Exit status: 0 both agree, 1 they differ, or the program does not load or build, 2 wrong usage."
)]
pub(super) struct Verify {
    /// The program
    pub(super) file: PathBuf,

    #[command(flatten)]
    pub(super) source: SourceArguments,

    #[command(flatten)]
    pub(super) inputs: InputArguments,

    /// How many runs a search makes
    #[arg(long, value_name = "N", default_value = "256")]
    pub(super) runs: u64,

    /// The Cargo.toml of the project whose tip-runtime is used, if not that of the current folder
    #[arg(long, value_name = "Cargo.toml")]
    pub(super) manifest_path: Option<PathBuf>,
}

/// `tipc migrate`
#[derive(Debug, Args)]
#[command(
    after_help = "Programs of versions 1.0 to 3.0, and those that say 4.0, become programs of version 3.1: declarations,
renamed commands, changed forms. Comments, layout, encoding and the order of the steps are kept.
Every change is reported with its line. What the text does not decide is asked; then nothing is written.

Examples:
  tipc migrate old.prg -o new.prg
  tipc migrate old.prg > new.prg                        the new program on standard output
  tipc migrate --message-format short old.prg -o new.prg   FILE:LINE:COLUMN: change: ...

Exit status: 0 if the new program is written, 1 if there is a question or a file cannot be read or written."
)]
pub(super) struct Migrate {
    /// The older program
    #[arg(value_name = "OLD")]
    pub(super) file: PathBuf,

    /// Write to a file instead of standard output
    #[arg(short, long, value_name = "NEW")]
    pub(super) out: Option<PathBuf>,

    /// How the file spells text; auto takes UTF-8 if it is valid, else Shift_JIS
    #[arg(long, value_enum, default_value = "auto")]
    pub(super) encoding: EncodingName,

    /// How the report on standard error is written: for people, or lines for tools
    #[arg(long, value_enum, default_value = "human")]
    pub(super) message_format: Format,
}

fn version_number(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(number) if f64::is_finite(number) && number > 0.0 => Ok(number),
        _ => Err("a version is a number such as 3.1".to_owned()),
    }
}
