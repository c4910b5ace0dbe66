//! `tip dap`: the debug adapter of `tip-ide` on standard input and output, and the loading of programs for it.

use super::Status;
use super::arguments::{InputArguments, RunArguments, SourceArguments};
use super::choices::{EncodingName, LangName, OutputOptions};
use super::error::{Error, diagnostics, is_closed};
use super::loader::{self, Subject};
use super::setup::{RobotChoice, SceneChoice};
use super::usage::BadValue;
use super::{input, output};
use crate::message::Using;
use clap::{Args, ValueEnum};
use std::io::{self, BufReader};
use std::path::{Path, PathBuf};
use tip_ide::dap::{self, Debuggee, Launch, Launcher};
use tip_ide::transport::Connection;
use tip_sim::debug::Debugger;
use tip_sim::event::EventError;
use tipc::Options;
use tipc::message::Lang;

/// `tip dap`
#[derive(Debug, Args)]
#[command(
    after_long_help = "Editors start it; it uses the Debug Adapter Protocol on standard input and output.
A launch has the same settings as the options of 'tip run':

  { \"request\": \"launch\", \"program\": \"walk.prg\", \"robot\": \"titan8\", \"scene\": \"cylinder\",
    \"events\": \"10:key F, 300:VR1=8\", \"stopOnEntry\": true, \"stopOnFall\": true }

In the console of the debugger: an expression such as STRIDE + 5 or STRIDE > 80, N = 5, key F,
VR1=8, halt, to 300 (a cycle). See docs/debugging.md."
)]
pub(super) struct Dap {}

/// Serves a client until it disconnects.
pub(super) fn dap(_: &Dap) -> Result<Status, Error> {
    let connection = Connection::new(BufReader::new(io::stdin()), io::stdout());
    match dap::serve(connection, Files) {
        Ok(()) => Ok(Status::Success),
        Err(error) if is_closed(&error) => Ok(Status::Success),
        Err(error) => Err(Error::Failed(format!(
            "the client cannot be answered: {error}"
        ))),
    }
}

/// Loads programs from files.
struct Files;

impl Launcher for Files {
    fn is_same_file(&self, one: &str, other: &str) -> bool {
        output::is_same(Path::new(one), Path::new(other))
    }

    fn launch(&mut self, launch: &Launch, lang: Lang) -> Result<Debuggee, String> {
        let path = Path::new(&launch.program);
        if input::is_stream(path) {
            // It is the connection to the client.
            return Err(diagnostics(
                &input::load_file(path, &Options::default()),
                lang,
            ));
        }
        let mut run = arguments(launch, path, lang)?;
        let refusal = Using::ProcessRunsOnce { command: "dap" };
        let subject = run
            .complete(path)
            .and_then(|_| loader::load(path, &run, Some(refusal)));
        let Subject { loaded, robot, .. } = subject.map_err(|error| error.text(lang))?;
        let found = diagnostics(&loaded, lang);
        let Some(program) = loaded.program else {
            return Err(found);
        };
        let debugger = Debugger::new(program, &robot).map_err(|mismatch| mismatch.to_string())?;
        let debugger = debugger
            .with_events(&run.inputs.inputs().events)
            .map_err(|refused| refused.text(lang))?;
        Ok(Debuggee {
            debugger,
            source: loaded.source,
            path: launch.program.clone(),
            warnings: found,
        })
    }
}

/// Converts a launch to arguments of the command line. Files are also found from the folder of the program.
fn arguments(launch: &Launch, program: &Path, lang: Lang) -> Result<RunArguments, String> {
    let wrong = |wrong: BadValue| wrong.text(lang);
    let robot = parsed(&launch.robot)
        .map_err(wrong)?
        .map(|robot| match robot {
            RobotChoice::File(path) => RobotChoice::File(from_program(program, path)),
            named => named,
        });
    let scene = parsed(&launch.scene)?.map(|scene| match scene {
        SceneChoice::File(path) => SceneChoice::File(from_program(program, path)),
        named => named,
    });
    let encoding = launch.encoding.as_ref();
    let encoding = encoding.map(|name| EncodingName::from_str(name, true));
    let events = parsed(&launch.events).map_err(|error: EventError| error.to_string())?;
    let plant = parsed(&launch.plant).map_err(wrong)?;
    Ok(RunArguments {
        file: program.to_owned(),
        source: SourceArguments {
            robot,
            tip_version: None,
            encoding: encoding.transpose()?,
            output_options: OutputOptions::of(LangName::of(lang)),
            given: None,
        },
        inputs: InputArguments {
            events,
            scene,
            plant,
            ..InputArguments::default()
        },
    })
}

fn parsed<T: std::str::FromStr>(text: &Option<String>) -> Result<Option<T>, T::Err> {
    text.as_deref().map(str::parse).transpose()
}

/// Returns the path of a file, from the folder of the program unless it exists as it is.
fn from_program(program: &Path, path: PathBuf) -> PathBuf {
    match program.parent() {
        Some(folder) if path.is_relative() && !path.exists() => folder.join(path),
        _ => path,
    }
}
