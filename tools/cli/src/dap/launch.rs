//! Programs from files, as a client asks for them.

use super::message::Launch;
use super::session::{Debuggee, Host};
use crate::arguments::{InputArguments, SourceArguments};
use crate::choices::EncodingName;
use crate::input;
use crate::loader::{self, NotLoaded, Subject};
use crate::plant::Ours;
use crate::robot::RobotChoice;
use crate::scene::SceneChoice;
use crate::usage::Wrong;
use clap::ValueEnum;
use std::path::{Path, PathBuf};
use tip_lint::message::More;
use tip_sim::debug::Debugger;
use tip_sim::event::EventError;
use tipc::message::Lang;
use tipc::{Loaded, Options, render};

/// Loads programs from files.
pub(super) struct Files;

impl Host for Files {
    fn launch(&mut self, launch: &Launch, lang: Lang) -> Result<Debuggee, String> {
        let path = Path::new(&launch.program);
        if input::is_stream(path) {
            // The client is at the other end of it.
            return Err(findings(&input::load_file(path, &Options::default()), lang));
        }
        let (mut source, mut inputs) = arguments(launch, path, lang)?;
        let given = source.complete_run(path, &mut inputs);
        given.map_err(|loaded| findings(&loaded, lang))?;
        let subject = loader::load(path, &source, &inputs, Some(Ours::Again("dap")));
        let Subject { loaded, robot, .. } = subject.map_err(|refused| match refused {
            NotLoaded::Found(loaded) => findings(&loaded, lang),
            NotLoaded::Failed(error) => error.to_string(),
        })?;
        let found = findings(&loaded, lang);
        let Some(program) = loaded.program else {
            return Err(found);
        };
        let debugger = Debugger::new(program, &robot).map_err(|mismatch| mismatch.to_string())?;
        let debugger = debugger
            .with_events(&inputs.inputs().events)
            .map_err(|refused| refused.text(lang))?;
        Ok(Debuggee {
            debugger,
            source: loaded.source,
            path: launch.program.clone(),
            warnings: found,
        })
    }
}

/// The arguments of a command line that asks for the same; files are found from the program's folder, too.
fn arguments(
    launch: &Launch,
    program: &Path,
    lang: Lang,
) -> Result<(SourceArguments, InputArguments), String> {
    let wrong = |wrong: Wrong| wrong.text(lang);
    let robot = parsed(&launch.robot)
        .map_err(wrong)?
        .map(|robot| match robot {
            RobotChoice::File(path) => RobotChoice::File(beside(program, path)),
            named => named,
        });
    let scene = parsed(&launch.scene)?.map(|scene| match scene {
        SceneChoice::File(path) => SceneChoice::File(beside(program, path)),
        named => named,
    });
    let encoding = launch.encoding.as_ref();
    let encoding = encoding.map(|name| EncodingName::from_str(name, true));
    let events = parsed(&launch.events).map_err(|error: EventError| error.to_string())?;
    let plant = parsed(&launch.plant).map_err(wrong)?;
    let inputs = InputArguments::of_client(events, scene, plant);
    let source = SourceArguments::of_client(robot, encoding.transpose()?, lang);
    Ok((source, inputs))
}

fn parsed<T: std::str::FromStr>(text: &Option<String>) -> Result<Option<T>, T::Err> {
    text.as_deref().map(str::parse).transpose()
}

/// A file that is named from the program's folder, unless it is found as it is.
fn beside(program: &Path, path: PathBuf) -> PathBuf {
    match program.parent() {
        Some(folder) if path.is_relative() && !path.exists() => folder.join(path),
        _ => path,
    }
}

/// All that is wrong, one line each.
fn findings(loaded: &Loaded, lang: Lang) -> String {
    let lines = loaded.diagnostics.iter();
    let lines = lines.map(|one| render::short(&loaded.source, one, lang));
    let omitted = loaded.omitted.count();
    let more = (omitted > 0).then(|| More::from(omitted).in_lang(lang).to_string());
    let lines: Vec<String> = lines.chain(more).collect();
    lines.join("\n")
}
