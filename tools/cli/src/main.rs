//! The command `tip`: a module for each command or family of commands, and the modules that they share.
#![forbid(unsafe_code)]

mod arguments;
mod check;
mod choices;
mod commands;
mod compare;
mod debug;
mod drives;
mod embedded;
mod error;
mod explain;
mod help;
mod input;
mod interrupt;
mod loader;
mod message;
mod new;
mod output;
mod playground;
mod record;
mod report;
mod robot;
mod run;
mod sarif;
mod serve;
mod servers;
mod setup;
mod sticks;
mod sweep;
mod translate;
mod usage;
mod verify;
mod watch;

use choices::Format;
use clap::{Args, Parser};
use error::Error;
use std::process::ExitCode;

/// Compiler, checker and simulator for T.I.P. 3.1 robot programs.
#[derive(Debug, Parser)]
#[command(
    name = "tip",
    version,
    arg_required_else_help = true,
    after_long_help = "A first session:
  tip new demo                       make a crate with a robot that moves
  cd demo/motions
  tip check walk.prg                 report all errors and warnings
  tip check --fix walk.prg           apply certain fixes
  tip run walk.prg                   run it on the simulated TITAN VIII
  tip fmt walk.prg                   format it in the standard style
  tip log walk.prg -o walk.mcap      write the log of a run, for Foxglove, Rerun or a table
  tip plot walk.prg -o walk.svg      draw diagrams of a run
  tip emit rust walk.prg -o walk.rs  write it as Rust source
  tip cycles walk.prg                count the control cycles of its parts
  tip sweep walk.prg --vary STRIDE=160..240/20 -o runs.csv
                                     run it with each of these strides
  tip view walk.prg                  write walk.html, a page that replays the run
  tip compare walk.prg faster.prg    compare the figures of two runs
  tip serve walk.prg                 run it live in a web page, with keys, knobs and an editor
  tip verify walk.prg                compare its compiled code with the interpreter
  tip migrate old.prg -o walk.prg    migrate an older program to version 3.1
  tip explain E205                   explain the code of an error or warning
  tip lsp                            start the language server, as editors do
  tip robot check hexapod.toml       check the description of your robot

'tip help COMMAND' shows examples of each command.
Exit status: 0 done, 1 the program does not load, does not verify or has a denied warning, or a file cannot be written,
2 wrong usage, 3 emergency stop, 4 a fall or a collision that --deny names, or a condition of --fail-if, 130 interrupted
(by SIGTERM 143, by SIGHUP 129)."
)]
struct Arguments {}

/// The exit status.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Status {
    /// Success: END, EXIT or LIMIT of a run.
    Success = 0,
    /// A program does not load or does not verify, or a file cannot be written.
    Failure = 1,
    /// The command line asks for something that does not exist.
    Usage = 2,
    /// Emergency stop.
    Emergency = 3,
    /// The robot fell or two of its parts met, which `--deny` forbids, or a condition of `--fail-if` holds.
    Fell = 4,
    /// Ctrl-C; other signals have statuses of their own.
    Interrupted = 130,
}

/// The arguments of a command, and what the command does with them.
trait Action: Args {
    /// Completes the options from the nearest `tip.toml`; commands for several programs do so for each of them.
    ///
    /// # Errors
    /// The `tip.toml` has errors.
    fn complete(&mut self) -> Result<(), Error> {
        Ok(())
    }

    /// Returns the format of diagnostics, for commands that write no document.
    fn format(&self) -> Option<Format> {
        None
    }

    /// Executes the command.
    ///
    /// # Errors
    /// The reason why the command did not do what it was asked.
    fn execute(&self) -> Result<Status, Error>;
}

/// Runs the command of the command line.
fn main() -> ExitCode {
    tip_drives::operator::let_writes_fail();
    let matches = match help::command(usage::lang()).try_get_matches() {
        Ok(matches) => matches,
        Err(error) => {
            usage::report(&error);
            return exit(if error.use_stderr() {
                Status::Usage
            } else {
                Status::Success
            });
        }
    };
    let outcome = commands::execute_command(&matches);
    exit(outcome.unwrap_or_else(|error| {
        report::error(&error, usage::lang());
        error.status()
    }))
}

fn exit(status: Status) -> ExitCode {
    ExitCode::from(match status {
        Status::Interrupted => interrupt::status(),
        _ => status as u8,
    })
}
