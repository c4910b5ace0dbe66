//! The command `tip`: its commands, one file each, and what they share.
#![forbid(unsafe_code)]

mod arguments;
mod check;
mod choices;
mod cycles;
mod dap;
mod debug;
mod deny;
mod describe;
mod embedded;
mod emit;
mod error;
mod explain;
mod fix;
mod fmt;
mod help;
mod input;
mod interrupt;
mod loader;
mod log;
mod lsp;
mod message;
mod migrate;
mod new;
mod output;
mod plant;
mod plot;
mod project;
mod recorded;
mod report;
mod robot;
mod run;
mod sarif;
mod scene;
mod serve;
mod shell;
mod shown;
mod usage;
mod verify;
mod view;
mod watch;

use choices::Format;
use clap::{FromArgMatches, Parser, Subcommand};
use error::Error;
use shown::Shown;
use std::process::ExitCode;
use tipc::Loaded;

/// Compiler, checker and simulator for T.I.P. 3.1 robot programs.
#[derive(Debug, Parser)]
#[command(
    name = "tip",
    version,
    arg_required_else_help = true,
    after_help = "A first session:
  tip new demo                       make a crate whose robot moves at once
  tip check walk.prg                 report all its errors at once
  tip check --fix walk.prg           put right what is certain
  tip run walk.prg                   run it on the simulated TITAN VIII
  tip fmt walk.prg                   lay it out in the one style
  tip log walk.prg -o walk.mcap      write what it did, for Foxglove, Rerun or a table
  tip plot walk.prg -o walk.svg      draw what it did
  tip emit rust walk.prg -o walk.rs  write it as Rust source
  tip cycles walk.prg                count the control cycles of its parts
  tip view walk.prg                  write walk.html, a page that replays the run
  tip serve walk.prg                 run it live in a page, with keys and knobs, and edit it there
  tip verify walk.prg                compare its compiled code with the interpreter
  tip migrate old.prg -o walk.prg    turn an older program into version 3.1
  tip explain E205                   say what the code of a finding means
  tip lsp                            serve an editor, which starts it
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

/// What to do.
#[derive(Debug, Subcommand)]
enum Verb {
    /// Make a crate whose robot moves at once, with a test and an editor's configuration
    New(new::New),
    /// Report everything that is wrong with programs
    Check(check::Check),
    /// Run a program on the simulated robot
    Run(run::Run),
    /// Lay programs out in the one style
    Fmt(fmt::Fmt),
    /// Write what a run did as a log for other tools: MCAP or CSV
    Log(log::Log),
    /// Draw what a run did as diagrams: SVG
    Plot(plot::Plot),
    /// Write a program in another form
    Emit(emit::Emit),
    /// Count the control cycles that the parts of a program take
    Cycles(cycles::Cycles),
    /// Compare a program's compiled code with the reference interpreter
    Verify(verify::Verify),
    /// Write a page that replays a run: the robot in 3-D beside its program
    View(view::View),
    /// Run a program live in a page, where it is steered and edited
    Serve(serve::Serve),
    /// Debug a program on the terminal, forwards and backwards
    Debug(debug::Debug),
    /// Serve a debugger to editors: the Debug Adapter Protocol
    Dap(dap::Dap),
    /// Turn a program of an older version into one of version 3.1
    Migrate(migrate::Migrate),
    /// Say what the code of a finding means, with a wrong and a right program
    Explain(explain::Explain),
    /// Serve an editor: the language server
    Lsp(lsp::Lsp),
    /// Print what a shell completes the command line with
    Completions(shell::Completions),
    /// Write the pages of man
    Man(shell::Man),
    /// Descriptions of robots
    #[command(subcommand)]
    Robot(describe::RobotVerb),
}

impl Verb {
    /// The form of findings that it is asked for, if it is one of those that write no document.
    fn format(&self) -> Option<Format> {
        let shown = match self {
            Verb::Run(arguments) => arguments.source.shown,
            Verb::Fmt(arguments) => arguments.shown,
            Verb::Emit(arguments) => arguments.source.shown,
            Verb::Cycles(arguments) => arguments.source.shown,
            Verb::Verify(arguments) => arguments.source.shown,
            Verb::Migrate(arguments) => arguments.shown,
            Verb::New(arguments) => arguments.shown,
            Verb::Robot(describe::RobotVerb::Check(arguments)) => arguments.shown,
            Verb::Robot(describe::RobotVerb::Show(arguments)) => arguments.shown,
            _ => return None,
        };
        Some(shown.message_format)
    }
}

impl Verb {
    /// Takes what options leave open from the nearest `tip.toml`; of commands for several programs each takes its own.
    ///
    /// # Errors
    /// What is wrong with it, and how to show that.
    fn complete(&mut self) -> Result<(), (Box<Loaded>, Shown)> {
        let (file, source, inputs, says) = match self {
            Verb::Run(it) => (&it.file, &mut it.source, Some(&mut it.inputs), !it.quiet),
            Verb::Verify(it) => (&it.file, &mut it.source, Some(&mut it.inputs), false),
            Verb::Emit(it) => (&it.file, &mut it.source, None, false),
            Verb::Cycles(it) => (&it.file, &mut it.source, None, false),
            Verb::Debug(it) => (&it.file, &mut it.source, Some(&mut it.inputs), false),
            Verb::Log(log::Log { recorded: it, .. })
            | Verb::Plot(plot::Plot { recorded: it, .. })
            | Verb::Serve(serve::Serve { recorded: it, .. }) => {
                (&it.file, &mut it.source, Some(&mut it.inputs), false)
            }
            Verb::View(it) => {
                let recorded = &mut it.recorded;
                let file = it.program.as_ref().unwrap_or(&recorded.file);
                (
                    file,
                    &mut recorded.source,
                    Some(&mut recorded.inputs),
                    false,
                )
            }
            _ => return Ok(()),
        };
        let shown = source.shown;
        let given = match inputs {
            Some(inputs) => source.complete_run(file, inputs),
            None => source.complete(file),
        };
        let given = given.map_err(|loaded| (loaded, shown))?;
        if let Some(given) = given.filter(|_| says) {
            report::complain(&format!("{given}\n"));
        }
        Ok(())
    }
}

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
    /// The robot fell, which `--deny falls` forbids.
    Fell = 4,
    /// Ctrl-C; other signals have statuses of their own.
    Interrupted = 130,
}

/// Does what the command line says.
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
    if let Err((loaded, shown)) = arguments.verb.complete() {
        report::findings(&loaded, shown);
        return exit(Status::Failure);
    }
    let outcome = match &arguments.verb {
        verb if verb.format() == Some(Format::Sarif) => Err(Error::Usage(
            "tip check writes SARIF, no other command does".to_owned(),
        )),
        Verb::New(arguments) => new::new(arguments),
        Verb::Check(arguments) => check::check(arguments),
        Verb::Run(arguments) => run::run(arguments),
        Verb::Fmt(arguments) => fmt::fmt(arguments),
        Verb::Log(arguments) => log::log(arguments),
        Verb::Plot(arguments) => plot::plot(arguments),
        Verb::Emit(arguments) => emit::emit(arguments),
        Verb::Cycles(arguments) => cycles::cycles(arguments),
        Verb::Verify(arguments) => verify::verify(arguments),
        Verb::View(arguments) => view::view(arguments),
        Verb::Serve(arguments) => serve::serve(arguments),
        Verb::Debug(arguments) => debug::debug(arguments),
        Verb::Dap(arguments) => dap::dap(arguments),
        Verb::Migrate(arguments) => migrate::migrate(arguments),
        Verb::Explain(arguments) => explain::explain(arguments),
        Verb::Lsp(arguments) => lsp::lsp(arguments),
        Verb::Completions(arguments) => shell::completions(arguments),
        Verb::Man(arguments) => shell::man(arguments),
        Verb::Robot(verb) => describe::robot(verb),
    };
    exit(outcome.unwrap_or_else(|error| {
        report::error(&error);
        error.status()
    }))
}

fn exit(status: Status) -> ExitCode {
    ExitCode::from(match status {
        Status::Interrupted => interrupt::status(),
        _ => status as u8,
    })
}
