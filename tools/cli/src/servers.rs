//! The servers of `tip-ide` on standard input and output, and the files that they need: `tip lsp` and `tip dap`.

use super::Status;
use super::arguments::{InputArguments, RunArguments, SourceArguments};
use super::choices::{EncodingName, LangName, OutputOptions};
use super::error::{Error, diagnostics, is_closed};
use super::loader::{self, Subject};
use super::setup::{RobotChoice, SceneChoice};
use super::{embedded, explain, input, output, sarif};
use crate::Action;
use crate::message::Using;
use clap::{Args, ValueEnum};
use std::collections::HashMap;
use std::hint::black_box;
use std::io::{self, BufReader};
use std::path::{Path, PathBuf};
use std::rc::Rc;
use std::{env, fs};
use tip_ide::dap::{self, Debuggee, Launch, Launcher};
use tip_ide::lsp::{self, RobotConfig, Workspace};
use tip_ide::transport::Connection;
use tip_sim::debug::Debugger;
use tip_sim::event::EventError;
use tipc::diagnostic::Diagnostic;
use tipc::message::Lang;
use tipc::{Loaded, Options, render};

#[derive(Debug, Args)]
#[command(
    after_long_help = "Editors start it and use it through standard input and output: diagnostics with fixes while you type, hover,
definition, references, renaming, completion, signature help, inlay hints, folding, semantic tokens and formatting.
docs/editors.md shows how to set up VS Code, neovim, helix and emacs.

If your editor does not find tip: cargo installs it in ~/.cargo/bin, which may be missing from the PATH of an editor that is
started from the desktop. Write the full path of tip in the settings of the editor (tip.path in VS Code). The command to
install it, in a checkout of T.I.P., is cargo install --path tools/cli.

The robot is that of --robot, of the client's option 'robot', of the nearest tip.toml, or titan8, in this order.

Exit status: 0 after 'shutdown' and 'exit', 1 if the connection ends without them, 2 wrong usage."
)]
pub(super) struct Lsp {
    /// Use standard input and output (the default)
    #[arg(long)]
    stdio: bool,

    /// The robot of every program
    ///
    /// A name that 'tip robot list' shows, or a description in a file
    #[arg(long, value_name = "NAME|FILE.toml")]
    robot: Option<RobotChoice>,
}

/// Size of a block whose release stops glibc from returning memory to the kernel after each text, bytes.
const KEPT: usize = 16 << 20;

impl Action for Lsp {
    fn execute(&self) -> Result<Status, Error> {
        lsp(self)
    }
}

/// Serves one editor.
fn lsp(arguments: &Lsp) -> Result<Status, Error> {
    drop(black_box(Vec::<u8>::with_capacity(KEPT)));
    let connection = Connection::new(BufReader::new(io::stdin()), io::stdout());
    let files = Files {
        robot: arguments.robot.clone(),
        ..Files::default()
    };
    match lsp::serve(connection, files) {
        Ok(true) => Ok(Status::Success),
        Ok(false) => Ok(Status::Failure),
        Err(error) => Err(Error::Failed(format!("the editor is gone: {error}"))),
    }
}

/// The files of this machine, with what was read from them.
#[derive(Default)]
struct Files {
    /// The robot of `--robot`.
    robot: Option<RobotChoice>,
    configs: HashMap<String, Rc<RobotConfig>>,
    /// Warnings about the crates around programs, by program and `tip.toml`.
    crates: HashMap<(PathBuf, String), Option<Diagnostic>>,
    pages: HashMap<(String, Lang), Option<String>>,
}

impl Files {
    /// Returns the first robot that is given: by the command line, by settings, or by the nearest `tip.toml`.
    fn choice(
        &self,
        path: Option<&Path>,
        configured: Option<&str>,
        lang: Lang,
    ) -> Result<RobotChoice, String> {
        if let Some(choice) = &self.robot {
            return Ok(choice.clone());
        }
        if let Some(name) = configured {
            let choice: RobotChoice = name
                .parse()
                .map_err(|wrong: Using| wrong.in_lang(lang).to_string())?;
            return Ok(choice.relative_to(path));
        }
        let given = path.map_or(Ok(None), loader::settings);
        let given = given.map_err(|loaded| first_diagnostic(&loaded, lang))?;
        Ok(given.and_then(|given| given.robot).unwrap_or_default())
    }
}

impl Workspace for Files {
    fn robot(
        &mut self,
        path: Option<&Path>,
        configured: Option<&str>,
        lang: Lang,
    ) -> Rc<RobotConfig> {
        let (choice, error) = match self.choice(path, configured, lang) {
            Ok(choice) => (choice, None),
            Err(error) => (RobotChoice::default(), Some(error)),
        };
        let key = format!("{choice:?} {error:?} {lang:?}");
        if let Some(config) = self.configs.get(&key) {
            return Rc::clone(config);
        }
        let config = Rc::new(config(&choice, error, lang));
        self.configs.insert(key, Rc::clone(&config));
        config
    }

    fn other_robot(&mut self, path: &Path, configured: Option<&str>) -> Option<Diagnostic> {
        if self.robot.is_some() || configured.is_some() {
            return None;
        }
        let given = loader::settings(path).ok().flatten()?;
        let key = (path.to_owned(), given.to_string());
        let warning = || embedded::warning(path, &given.file, given.robot.as_ref()?);
        self.crates.entry(key).or_insert_with(warning).clone()
    }

    fn page(&mut self, code: &str, lang: Lang) -> Option<String> {
        let key = (code.to_owned(), lang);
        let page = self
            .pages
            .entry(key)
            .or_insert_with(|| write_page(code, lang));
        page.clone()
    }

    fn encoding(&mut self, path: &Path) -> Option<String> {
        let given = loader::settings(path).ok().flatten()?;
        given.encoding.map(EncodingName::name)
    }

    #[cfg(unix)]
    fn is_running(&mut self, process: u32) -> bool {
        use rustix::io::Errno;
        use rustix::process::{Pid, test_kill_process};
        let process = i32::try_from(process).ok().and_then(Pid::from_raw);
        // A process of another user refuses signals.
        process.is_some_and(|process| test_kill_process(process) != Err(Errno::SRCH))
    }

    #[cfg(not(unix))]
    fn is_running(&mut self, _: u32) -> bool {
        true
    }

    fn invalidate(&mut self) {
        self.configs.clear();
        self.crates.clear();
    }
}

/// Returns the chosen robot; if it cannot be loaded, the default one with the error.
fn config(choice: &RobotChoice, error: Option<String>, lang: Lang) -> RobotConfig {
    match choice.load() {
        Ok(robot) => RobotConfig {
            options: Options {
                robot: robot.robot(),
                ..Options::default()
            },
            robot: robot.simulated().ok(),
            error,
        },
        Err(loaded) => RobotConfig {
            error: Some(first_diagnostic(&loaded, lang)),
            ..config(&RobotChoice::default(), None, lang)
        },
    }
}

/// Returns the first diagnostic of a file, in one line.
fn first_diagnostic(loaded: &Loaded, lang: Lang) -> String {
    let first = loaded.diagnostics.first();
    first.map_or_else(String::new, |first| {
        let line = render::short(&loaded.source, first, lang);
        line.trim_end().to_owned()
    })
}

/// Writes the page about a code to the cache of this user; returns its address.
fn write_page(code: &str, lang: Lang) -> Option<String> {
    let text = explain::page(code, lang)?;
    let language = lang.pick("en", "ja");
    let version = env!("CARGO_PKG_VERSION");
    let folder = cache()?.join("tip").join(version).join(language);
    let path = folder.join(format!("{code}.md"));
    if fs::read(&path).ok().as_deref() != Some(text.as_bytes()) {
        fs::create_dir_all(&folder).ok()?;
        fs::write(&path, text).ok()?;
    }
    Some(sarif::uri(path.to_str()?))
}

/// Returns the folder of cached files.
fn cache() -> Option<PathBuf> {
    let named = |name: &str| {
        env::var_os(name)
            .map(PathBuf::from)
            .filter(|path| path.is_absolute())
    };
    named("XDG_CACHE_HOME")
        .or_else(|| named("LOCALAPPDATA"))
        .or_else(|| Some(named("HOME")?.join(".cache")))
}

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

impl Action for Dap {
    fn execute(&self) -> Result<Status, Error> {
        dap(self)
    }
}

/// Serves a client until it disconnects.
fn dap(_: &Dap) -> Result<Status, Error> {
    let connection = Connection::new(BufReader::new(io::stdin()), io::stdout());
    match dap::serve(connection, Programs) {
        Ok(()) => Ok(Status::Success),
        Err(error) if is_closed(&error) => Ok(Status::Success),
        Err(error) => Err(Error::Failed(format!(
            "the client cannot be answered: {error}"
        ))),
    }
}

/// Loads programs from files.
struct Programs;

impl Launcher for Programs {
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
            .with_events(&run.inputs.inputs(&robot).events)
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
    let wrong = |wrong: Using| wrong.in_lang(lang).to_string();
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
