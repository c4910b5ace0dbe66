//! `tip serve`: serves a page with a live run to any number of viewers. The session belongs to one thread (`hub`); each connection
//! (`connections`) has its own, and so has the control cycle of a robot on servos (`hardware`). For the table of a sweep it serves the
//! page of the table, and a replay of each run that is asked for.

mod connections;
mod controls;
mod hardware;
mod hub;
pub(crate) mod lesson;
pub(crate) mod place;

use crate::Action;
use crate::arguments::RunArguments;
use crate::error::Error;
use crate::loader::Subject;
use crate::message::Using;
use crate::setup::RobotChoice;
use crate::watch::Watch;
use crate::{Status, input, interrupt, output, report, sticks, sweep};
use clap::Args;
use connections::{Content, Table};
use hub::{Hub, HubEvent, HubSender, LiveSession, Outbox};
use place::{OWN, Place};
use std::net::SocketAddr;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;
use std::{fs, thread};
use tip_sim::Robot;
use tip_view::live::{CheckedText, ClientRequest, Host, Session, Setup, UncheckedText, Viewer};
use tipc::embed::{LIMIT, open_file, read_stream};
use tipc::message::{Lang, Reading};

#[derive(Debug, Args)]
#[command(after_long_help = "Examples:
  tip serve walk.prg                          prints the address of the page
  tip serve --robot hand grasp.prg --scene scene.toml
  tip serve walk.prg --paused --events '10:key F'
  tip serve walk.prg --listen 0.0.0.0:8000    for other machines too
  tip serve walk.prg --hardware robot.toml    drives a real robot from the page
  tip serve runs.csv                          the table of a sweep, whose runs open in the page

The page runs the program on the simulated robot in real time, or slower or faster. Keys, knobs,
halt and emergency stop reach the program. The run can be paused, stepped forward and back, and continued
from any cycle of its last five minutes. The program can be edited in the page, which shows its
errors and warnings, restarted, and saved to FILE. A change of FILE by another editor is run immediately.

Everyone with the address sees the same run and may do all that. The page is reachable from this
machine only, unless --listen is given. Ctrl-C ends the command.

With --hardware the run goes forward only. One page drives, while its button is held; the emergency stop is for all.
A page that falls silent pauses the robot, then asks the program to halt, and then stops the robot
(docs/drives.md).

Exit status: 130 ended by Ctrl-C, 1 the program does not load, the address cannot be used or a servo
does not answer, 2 wrong usage.")]
pub(super) struct Serve {
    #[command(flatten)]
    pub(super) run: RunArguments,

    /// Address to listen on
    ///
    /// Port 0 selects a free one
    #[arg(long, value_name = "ADDRESS:PORT", default_value = OWN)]
    listen: SocketAddr,

    /// Do not start the run until a viewer does
    #[arg(long)]
    paused: bool,

    /// Run on a real robot, driven from the page
    ///
    /// Its description has [bus] and [[drive]] (docs/drives.md)
    #[arg(
        long,
        value_name = "FILE.toml",
        conflicts_with_all = ["robot", "plant", "scene", "cycles", "paused"]
    )]
    hardware: Option<PathBuf>,

    /// The robot's serial port, or 'simulated'
    ///
    /// 'simulated' needs no hardware. By default the port is that of the description
    #[arg(long, value_name = "PORT", requires = "hardware")]
    port: Option<String>,

    /// Write the trace of the run, with its motion
    ///
    /// Each run from the start replaces it. `tip view` shows it beside a simulated run
    #[arg(long, value_name = "OUT.jsonl", requires = "hardware")]
    trace: Option<PathBuf>,

    /// Use SCHED_FIFO and lock the memory
    #[arg(long, requires = "hardware", hide_short_help = true)]
    fifo: bool,

    /// Print only the address and errors
    #[arg(long, short)]
    quiet: bool,
}

impl Action for Serve {
    fn complete(&mut self) -> Result<(), Error> {
        // A table names its program and robot itself.
        if sweep::is_table(&self.run.file) {
            return Ok(());
        }
        if let Some(file) = &self.hardware {
            self.run.source.robot = Some(RobotChoice::File(file.clone()));
        }
        self.run.complete(&self.run.file.clone()).map(drop)
    }

    fn execute(&self) -> Result<Status, Error> {
        serve(self)
    }
}

/// Serves the page until Ctrl-C.
fn serve(arguments: &Serve) -> Result<Status, Error> {
    let path = arguments.run.file.as_path();
    if input::is_stream(path) {
        let lang = arguments.run.source.output_options.lang();
        return Err(Error::usage(Using::ServeInput, lang));
    }
    let own = [
        ("--hardware", arguments.hardware.is_some()),
        ("--paused", arguments.paused),
    ];
    let own = own.into_iter().find(|(_, is_given)| *is_given);
    if sweep::is_table_of(&arguments.run, own.map(|(option, _)| option))? {
        return table(arguments, path);
    }
    match &arguments.hardware {
        Some(hardware) => {
            let (follower, prepared, robot) = hardware::prepare(arguments, hardware)?;
            let place = Place::bind(arguments.listen)?;
            let controls = Arc::clone(&prepared.controls);
            let (hub, sender) = Hub::new(follower, robot, Some(controls));
            open(place, arguments, sender)?;
            let control = prepared.start();
            hub.run();
            Ok(control.end())
        }
        None => {
            let (simulated, robot) = arguments.session(path)?;
            let place = Place::bind(arguments.listen)?;
            let (hub, sender) = Hub::new(simulated, robot, None);
            open(place, arguments, sender)?;
            hub.run();
            Ok(Status::Interrupted)
        }
    }
}

/// Largest time until the server of a table notices Ctrl-C.
const TICK: Duration = Duration::from_millis(50);

/// Serves the page of a table, and its runs, until Ctrl-C.
fn table(arguments: &Serve, path: &Path) -> Result<Status, Error> {
    let lang = arguments.run.source.output_options.lang();
    // A table that has no page is refused before its address is printed.
    sweep::page(path, true, lang)?;
    interrupt::catch();
    let place = Place::bind(arguments.listen)?;
    announce(&place, arguments, Using::ServeRuns)?;
    let table = Table::new(path.to_owned(), lang);
    connections::accept(place.listener, place.guard, Content::Table(table));
    while !interrupt::is_requested() {
        thread::sleep(TICK);
    }
    Ok(Status::Interrupted)
}

/// Prints the address of a page, and lets viewers in.
fn open(place: Place, arguments: &Serve, sender: HubSender) -> Result<(), Error> {
    announce(&place, arguments, Using::ServeOthers)?;
    watch(&arguments.run.file, sender.clone())?;
    connections::accept(place.listener, place.guard, Content::Run(sender));
    Ok(())
}

/// Prints the address, and a message about what anyone who knows it can do.
fn announce(place: &Place, arguments: &Serve, others: Using) -> Result<(), Error> {
    let lang = arguments.run.source.output_options.lang();
    output::print(format!("{}\n", place.guard.address()))?;
    if !place.guard.is_local() {
        match arguments.hardware {
            Some(_) => report::say(Using::ServeDrives, lang),
            None if arguments.quiet => {}
            None => report::say(others, lang),
        }
    }
    if !arguments.quiet {
        place.invite();
        report::say(Using::ServeEnds, lang);
    }
    Ok(())
}

impl Serve {
    /// Loads the program; returns its session and its robot.
    fn session(&self, path: &Path) -> Result<(Simulated, Robot), Error> {
        let (subject, setup, file) = self.subject(path)?;
        let events = match &subject.loaded.program {
            Some(program) => sticks::let_rest(program, setup.events),
            None => setup.events,
        };
        let refused = |_| Error::Usage("an event is not possible for this program".to_owned());
        let mut session = Session::new(Setup { events, ..setup }).map_err(refused)?;
        if !self.paused {
            session.play();
        }
        session.hand_over();
        Ok((Simulated { session, file }, subject.robot))
    }

    /// Loads the program; returns it with the setup of its session, and its file.
    fn subject(&self, path: &Path) -> Result<(Subject, Setup, ServedFile), Error> {
        let source = &self.run.source;
        let place = input::real(path);
        let refusal = Using::ProcessRunsOnce { command: "serve" };
        let subject = self.run.load(path, self.quiet, refusal)?;
        let inputs = self.run.inputs.inputs(&subject.robot);
        let bytes = subject.loaded.source.bytes();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let robot = subject.robot.clone();
        let setup = Setup {
            options: source.options(robot.options().robot),
            events: inputs.events,
            rest: inputs.cycles,
            ..Setup::new(&name, &bytes, robot)
        };
        let file = ServedFile {
            path: place,
            known: bytes,
            lang: source.output_options.lang(),
        };
        Ok((subject, setup, file))
    }
}

/// The session of a simulated robot, with the file of its program.
struct Simulated {
    session: Session,
    file: ServedFile,
}

impl LiveSession for Simulated {
    fn advance(&mut self, elapsed: Duration, goes_on: &dyn Fn() -> bool) {
        self.session
            .advance(elapsed.as_secs_f64() * 1000.0, goes_on);
    }

    fn ask(&mut self, _: &Outbox, asked: &ClientRequest) -> Option<String> {
        self.session.ask(asked, &mut self.file)
    }

    fn update(&self, _: &Outbox, viewer: &mut Viewer) -> Option<String> {
        self.session.update(viewer)
    }

    fn unchecked(&mut self) -> Option<UncheckedText> {
        self.session.unchecked()
    }

    fn checked(&mut self, reading: CheckedText) {
        self.session.checked(reading);
    }

    fn file_changed(&mut self) {
        if let Ok(bytes) = self.file.read() {
            self.session.file_changed(&bytes);
        }
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
