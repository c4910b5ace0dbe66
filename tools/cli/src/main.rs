//! The command `tipc`: its commands, one file each, and what they share.
#![forbid(unsafe_code)]

mod arguments;
mod check;
mod checked;
mod choices;
mod cycles;
mod describe;
mod emit;
mod error;
mod input;
mod migrate;
mod output;
mod place;
mod report;
mod robot;
mod run;
mod scene;
mod verify;

use arguments::{Arguments, RobotVerb, Verb};
use clap::Parser;
use std::process::ExitCode;

/// How the process ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Status {
    /// Everything went well: END, EXIT or LIMIT of a run.
    Success = 0,
    /// A program does not load or does not verify, or a file cannot be written.
    Failure = 1,
    /// The command line asks for something that does not exist.
    Usage = 2,
    /// Emergency stop.
    Emergency = 3,
    /// Ctrl-C.
    Interrupted = 130,
}

/// Does what the command line says.
fn main() -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => {
            // A closed output is no reason to fail over help.
            let _ = error.print();
            return exit(if error.use_stderr() {
                Status::Usage
            } else {
                Status::Success
            });
        }
    };
    let outcome = match &arguments.verb {
        Verb::Check(arguments) => check::check(arguments),
        Verb::Run(arguments) => run::run(arguments),
        Verb::Emit(arguments) => emit::emit(arguments),
        Verb::Cycles(arguments) => cycles::cycles(arguments),
        Verb::Verify(arguments) => verify::verify(arguments),
        Verb::Migrate(arguments) => migrate::migrate(arguments),
        Verb::Robot(RobotVerb::Check(arguments)) => describe::check(arguments),
        Verb::Robot(RobotVerb::Import(arguments)) => describe::import(arguments),
    };
    exit(outcome.unwrap_or_else(|error| {
        report::error(&error);
        error.status()
    }))
}

fn exit(status: Status) -> ExitCode {
    ExitCode::from(status as u8)
}
