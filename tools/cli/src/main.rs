//! The command `tip`: a module for each command or family of commands, and the modules that they share.
#![forbid(unsafe_code)]

mod arguments;
mod check;
mod choices;
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
use clap::{FromArgMatches, Parser, Subcommand};
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
  tip serve walk.prg                 run it live in a web page, with keys, knobs and an editor
  tip verify walk.prg                compare its compiled code with the interpreter
  tip migrate old.prg -o walk.prg    migrate an older program to version 3.1
  tip explain E205                   explain the code of an error or warning
  tip lsp                            start the language server, as editors do
  tip robot check hexapod.toml       check the description of your robot

'tip help COMMAND' shows examples of each command.
Exit status: 0 done, 1 the program does not load, does not verify or has a denied warning, or a file cannot be written,
2 wrong usage, 3 emergency stop, 4 a fall with --deny falls, 130 interrupted (by SIGTERM 143,
by SIGHUP 129)."
)]
struct Arguments {
    #[command(subcommand)]
    verb: Verb,
}

/// The commands.
#[derive(Debug, Subcommand)]
enum Verb {
    /// Make a crate with a robot that moves, a test and editor settings
    New(new::New),
    /// Check programs and report all errors and warnings
    Check(check::Check),
    /// Run a program on the simulated robot
    Run(run::Run),
    /// Format programs in the standard style
    Fmt(translate::Fmt),
    /// Write the log of a run for other tools: MCAP or CSV
    Log(record::Log),
    /// Draw diagrams of a run: SVG
    Plot(record::Plot),
    /// Write a program in another form
    Emit(translate::Emit),
    /// Count the control cycles that the parts of a program take
    Cycles(translate::Cycles),
    /// Compare a program's compiled code with the reference interpreter
    Verify(verify::Verify),
    /// Run a program many times over ranges of values
    Sweep(sweep::Sweep),
    /// Write a page that replays a run, or compares two, in 3-D
    View(record::View),
    /// Run a program live in a web page, with controls and an editor
    Serve(serve::Serve),
    /// Debug a program in the terminal, forwards and backwards
    Debug(debug::Debug),
    /// Start the debug adapter for editors (Debug Adapter Protocol)
    Dap(servers::Dap),
    /// Migrate a program of an older version to version 3.1
    Migrate(translate::Migrate),
    /// Explain a code such as E205, with a wrong and a right program
    Explain(explain::Explain),
    /// Start the language server for editors
    Lsp(servers::Lsp),
    /// Print a completion script for a shell
    Completions(help::Completions),
    /// Write manual pages
    Man(help::Man),
    /// Find, name, zero, move and watch the servos of a real robot
    #[command(subcommand)]
    Drives(drives::DrivesVerb),
    /// Measure how late control cycles start on this machine
    Jitter(drives::realtime::Jitter),
    /// Work with robots and their descriptions
    #[command(subcommand)]
    Robot(robot::RobotVerb),
}

impl Verb {
    /// Returns the format of diagnostics, for commands that write no document.
    fn format(&self) -> Option<Format> {
        let output_options = match self {
            Verb::Run(arguments) => arguments.run.source.output_options,
            Verb::Fmt(arguments) => arguments.output_options,
            Verb::Sweep(arguments) => arguments.run.source.output_options,
            Verb::Emit(arguments) => arguments.source.output_options,
            Verb::Cycles(arguments) => arguments.source.output_options,
            Verb::Verify(arguments) => arguments.run.source.output_options,
            Verb::Migrate(arguments) => arguments.output_options,
            Verb::New(arguments) => arguments.output_options,
            Verb::Robot(robot::RobotVerb::Check(arguments)) => arguments.output_options,
            Verb::Robot(robot::RobotVerb::Show(arguments)) => arguments.output_options,
            _ => return None,
        };
        Some(output_options.message_format)
    }
}

impl Verb {
    /// Completes the options from the nearest `tip.toml`; commands for several programs do so for each of them.
    ///
    /// # Errors
    /// The `tip.toml` has errors.
    fn complete(&mut self) -> Result<(), Error> {
        match self {
            Verb::Run(run::Run {
                run,
                hardware,
                quiet,
                ..
            }) => {
                if let Some(file) = hardware {
                    run.source.robot = Some(setup::RobotChoice::File(file.clone()));
                }
                let given = run.complete(&run.file.clone())?;
                if let Some(given) = given.filter(|_| !*quiet) {
                    report::complain(&format!("{given}\n"));
                }
            }
            Verb::Verify(verify::Verify { run, .. })
            | Verb::Sweep(sweep::Sweep { run, .. })
            | Verb::Debug(debug::Debug { run })
            | Verb::Log(record::Log { run, .. })
            | Verb::Plot(record::Plot { run, .. })
            | Verb::Serve(serve::Serve { run, .. }) => {
                run.complete(&run.file.clone())?;
            }
            Verb::View(it) => {
                let program = it.program(&it.run.file);
                it.run.complete(&program)?;
            }
            Verb::Emit(translate::Emit { file, source, .. })
            | Verb::Cycles(translate::Cycles { file, source }) => {
                source.complete(file)?;
            }
            _ => {}
        }
        Ok(())
    }
}

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
    /// The robot fell, which `--deny falls` forbids.
    Fell = 4,
    /// Ctrl-C; other signals have statuses of their own.
    Interrupted = 130,
}

/// Runs the command of the command line.
fn main() -> ExitCode {
    let matches = help::command(usage::lang()).try_get_matches();
    let arguments = matches.and_then(|matches| Arguments::from_arg_matches(&matches));
    let mut arguments = match arguments {
        Ok(arguments) => arguments,
        Err(error) => {
            usage::report(&error);
            return exit(if error.use_stderr() {
                Status::Usage
            } else {
                Status::Success
            });
        }
    };
    let completed = arguments.verb.complete();
    let outcome = completed.and_then(|()| match &arguments.verb {
        verb if verb.format() == Some(Format::Sarif) => {
            Err(Error::Usage("only tip check writes SARIF".to_owned()))
        }
        Verb::New(arguments) => new::new(arguments),
        Verb::Check(arguments) => check::check(arguments),
        Verb::Run(arguments) => run::run(arguments),
        Verb::Fmt(arguments) => translate::fmt(arguments),
        Verb::Log(arguments) => record::log(arguments),
        Verb::Plot(arguments) => record::plot(arguments),
        Verb::Emit(arguments) => translate::emit(arguments),
        Verb::Cycles(arguments) => translate::cycles(arguments),
        Verb::Verify(arguments) => verify::verify(arguments),
        Verb::Sweep(arguments) => sweep::sweep(arguments),
        Verb::View(arguments) => record::view(arguments),
        Verb::Serve(arguments) => serve::serve(arguments),
        Verb::Debug(arguments) => debug::debug(arguments),
        Verb::Dap(arguments) => servers::dap(arguments),
        Verb::Migrate(arguments) => translate::migrate(arguments),
        Verb::Explain(arguments) => explain::explain(arguments),
        Verb::Lsp(arguments) => servers::lsp(arguments),
        Verb::Completions(arguments) => help::completions(arguments),
        Verb::Man(arguments) => help::man(arguments),
        Verb::Drives(verb) => drives::drives(verb),
        Verb::Jitter(arguments) => drives::realtime::jitter(arguments),
        Verb::Robot(verb) => robot::robot(verb),
    });
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
