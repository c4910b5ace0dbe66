//! `tip serve`: serves a page with a live run to any number of viewers. The session belongs to one thread (`hub`); each connection
//! (`connections`) has its own.

mod connections;
mod hub;

use crate::Action;
use crate::arguments::RunArguments;
use crate::error::Error;
use crate::loader::Subject;
use crate::message::Using;
use crate::watch::Watch;
use crate::{Status, input, output, report, sticks};
use clap::Args;
use connections::Guard;
use hub::{Hub, HubEvent, HubSender};
use std::net::{SocketAddr, TcpListener};
use std::path::{Path, PathBuf};
use std::{fs, thread};
use tip_sim::Robot;
use tip_view::live::{Host, Session, Setup};
use tipc::embed::{LIMIT, open_file, read_stream};
use tipc::message::{Lang, Reading};

#[derive(Debug, Args)]
#[command(after_long_help = "Examples:
  tip serve walk.prg                          prints the address of the page
  tip serve --robot hand grasp.prg --scene scene.toml
  tip serve walk.prg --paused --events '10:key F'
  tip serve walk.prg --listen 0.0.0.0:8000    for other machines too

The page runs the program on the simulated robot in real time, or slower or faster. Keys, knobs,
halt and emergency stop reach the program. The run can be paused, stepped forward and back, and continued
from any cycle of its last five minutes. The program can be edited in the page, which shows its
errors and warnings, restarted, and saved to FILE. A change of FILE by another editor is run immediately.

Everyone with the address sees the same run and may do all that. The page is reachable from this
machine only, unless --listen is given. Ctrl-C ends the command.

Exit status: 130 ended by Ctrl-C, 1 the program does not load or the address cannot be used,
2 wrong usage.")]
pub(super) struct Serve {
    #[command(flatten)]
    pub(super) run: RunArguments,

    /// Address to listen on
    ///
    /// Port 0 selects a free one
    #[arg(long, value_name = "ADDRESS:PORT", default_value = "127.0.0.1:0")]
    listen: SocketAddr,

    /// Do not start the run until a viewer does
    #[arg(long)]
    paused: bool,

    /// Print only the address and errors
    #[arg(long, short)]
    quiet: bool,
}

impl Action for Serve {
    fn complete(&mut self) -> Result<(), Error> {
        self.run.complete(&self.run.file.clone()).map(drop)
    }

    fn execute(&self) -> Result<Status, Error> {
        serve(self)
    }
}

/// Serves the page until Ctrl-C.
fn serve(arguments: &Serve) -> Result<Status, Error> {
    let path = arguments.run.file.as_path();
    let lang = arguments.run.source.output_options.lang();
    if input::is_stream(path) {
        return Err(Error::usage(Using::ServeInput, lang));
    }
    let (session, file, robot) = arguments.session(path)?;
    let failed = |error: std::io::Error| Error::Failed(format!("{}: {error}", arguments.listen));
    let listener = TcpListener::bind(arguments.listen).map_err(failed)?;
    let own = listener.local_addr().map_err(failed)?;
    let guard = Guard::new(own).map_err(Error::Failed)?;
    let (hub, sender) = Hub::new(session, file, robot);
    output::print(format!("{}\n", guard.address()))?;
    if !arguments.quiet && !own.ip().is_loopback() {
        report::say(Using::ServeOthers, lang);
    }
    if !arguments.quiet {
        report::say(Using::ServeEnds, lang);
    }
    watch(path, sender.clone())?;
    connections::accept(listener, guard, sender);
    hub.run();
    Ok(Status::Interrupted)
}

impl Serve {
    /// Loads the program; returns its session, its file, and its robot.
    fn session(&self, path: &Path) -> Result<(Session, ServedFile, Robot), Error> {
        let source = &self.run.source;
        let place = input::real(path);
        let refusal = Using::ProcessRunsOnce { command: "serve" };
        let Subject { loaded, robot, .. } = self.run.load(path, self.quiet, refusal)?;
        let inputs = self.run.inputs.inputs(&robot);
        let events = match &loaded.program {
            Some(program) => sticks::let_rest(program, inputs.events),
            None => inputs.events,
        };
        let bytes = loaded.source.bytes();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let setup = Setup {
            options: source.options(robot.options().robot),
            events,
            rest: inputs.cycles,
            ..Setup::new(&name, &bytes, robot.clone())
        };
        let refused = |_| Error::Usage("an event is not possible for this program".to_owned());
        let mut session = Session::new(setup).map_err(refused)?;
        if !self.paused {
            session.play();
        }
        let file = ServedFile {
            path: place,
            known: bytes,
            lang: source.output_options.lang(),
        };
        Ok((session, file, robot))
    }
}

/// Reports each change of the file to the hub.
fn watch(path: &Path, hub: HubSender) -> Result<(), Error> {
    let watch = Watch::begin([path])?;
    thread::spawn(move || while watch.changed() && hub.send(HubEvent::FileChanged) {});
    Ok(())
}

/// The served file: the only one that is read or written. Links on the way to it were followed once; a link that takes its place
/// later is refused.
#[derive(Debug)]
pub(super) struct ServedFile {
    /// The path without links.
    path: PathBuf,
    /// The content that was last read or written: an edit of another program is never overwritten unseen.
    known: Vec<u8>,
    lang: Lang,
}

impl ServedFile {
    /// Returns the content of the file, unless a link has taken its place or that of a folder above it.
    fn content(&self) -> Result<Vec<u8>, Reading> {
        let file = open_file(&self.path)?;
        let opened = file.metadata().ok();
        // The opened file is compared with the entry afterwards, so that a link cannot replace it in between.
        let is_unlinked = fs::canonicalize(&self.path).is_ok_and(|real| real == self.path);
        let entry = fs::symlink_metadata(&self.path).ok();
        match opened.zip(entry) {
            Some((opened, entry)) if is_unlinked && output::is_one(&opened, &entry) => {
                read_stream(file, LIMIT)
            }
            _ => Err(Reading::Linked),
        }
    }
}

impl Host for ServedFile {
    fn write(&mut self, bytes: &[u8]) -> Result<(), String> {
        let lang = self.lang;
        let written = match self.content() {
            Ok(content) if content == self.known => {
                output::update(&self.path, &content, bytes, lang)
            }
            // Some editors move the file away first, and a link would be there.
            Err(Reading::NoFile) if fs::symlink_metadata(&self.path).is_err() => {
                output::replace(&self.path, bytes)
            }
            Ok(_) => return Err(Reading::Changed.in_lang(lang).to_string()),
            Err(reason) => return Err(reason.in_lang(lang).to_string()),
        };
        written.map_err(|error| error.text(lang))?;
        self.known = bytes.to_vec();
        Ok(())
    }

    fn read(&mut self) -> Result<Vec<u8>, String> {
        let read = self.content();
        self.known = read.map_err(|reason| reason.in_lang(self.lang).to_string())?;
        Ok(self.known.clone())
    }
}
