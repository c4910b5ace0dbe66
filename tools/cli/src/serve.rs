//! `tip serve`: a page with a run that goes on, for as many viewers as look at it.

mod file;
mod guard;
mod head;
mod hub;
mod listen;
mod outbox;
mod reply;
mod viewer;

use super::error::Error;
use super::loader::Subject;
use super::plant::Ours;
use super::recorded::RecordedArguments;
use super::robot::ChosenRobot;
use super::watch::Watch;
use super::{Status, input, interrupt, output, project, report};
use crate::message::Using;
use clap::Args;
use file::ServedFile;
use guard::Guard;
use hub::{Hub, News, Post};
use std::net::SocketAddr;
use std::path::Path;
use std::thread;
use tip_view::live::{Session, Setup};

/// `tip serve`
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  tip serve walk.prg                          prints the address of the page
  tip serve --robot hand grasp.prg --scene scene.toml
  tip serve walk.prg --paused --events '10:key F'
  tip serve walk.prg --listen 0.0.0.0:8000    for other machines too

The page runs the program on the simulated robot in real time, or slower or faster. Keys, knobs,
halt and emergency stop reach the program. The run rests, steps forward and back, and goes on from
any cycle of its last five minutes. The program is edited in the page, with its findings in place,
run from the beginning, and saved to FILE. A change of FILE by another editor is run at once.

Everyone with the address sees the same run and may do all that. Only this machine reaches it,
unless --listen says otherwise. Ctrl-C ends it.

Exit status: 130 ended by Ctrl-C, 1 the program does not load or the address cannot be used,
2 wrong usage.")]
pub(super) struct Serve {
    #[command(flatten)]
    pub(super) recorded: RecordedArguments,

    /// The address to listen at; port 0 is any that is free
    #[arg(long, value_name = "ADDRESS:PORT", default_value = "127.0.0.1:0")]
    listen: SocketAddr,

    /// Do not run until someone asks for it
    #[arg(long)]
    paused: bool,

    /// Say nothing but the address and errors
    #[arg(long, short)]
    quiet: bool,
}

/// Serves the page until Ctrl-C.
pub(super) fn serve(arguments: &Serve) -> Result<Status, Error> {
    let path = arguments.recorded.file.as_path();
    let lang = arguments.recorded.source.shown.lang();
    if input::is_stream(path) {
        return Err(Error::Usage(Using::ServeInput.in_lang(lang).to_string()));
    }
    let Some((session, file, robot)) = arguments.session(path)? else {
        return Ok(Status::Failure);
    };
    let failed = |error: std::io::Error| Error::Failed(format!("{}: {error}", arguments.listen));
    let listener = listen::open(arguments.listen).map_err(failed)?;
    let own = listener.local_addr().map_err(failed)?;
    let guard = Guard::new(own).map_err(Error::Failed)?;
    let (hub, post) = Hub::new(session, file, robot);
    output::print(format!("{}\n", guard.address()))?;
    let says = |message: Using| report::complain(&format!("{}\n", message.in_lang(lang)));
    if !arguments.quiet && !own.ip().is_loopback() {
        says(Using::ServeOthers);
    }
    if !arguments.quiet {
        says(Using::ServeEnds);
    }
    watch(path, post.clone())?;
    listen::accept(listener, guard, post);
    hub.run();
    Ok(Status::Interrupted)
}

impl Serve {
    /// Returns the program on its robot, its file, and the choice of the robot; none if something was found, and reported.
    fn session(&self, path: &Path) -> Result<Option<(Session, ServedFile, ChosenRobot)>, Error> {
        let recorded = &self.recorded;
        let lang = recorded.source.shown.lang();
        let place = project::real(path);
        let Some(Subject {
            loaded,
            robot,
            chosen,
            ..
        }) = recorded.load(path, self.quiet, Ours::Again("serve"))?
        else {
            return Ok(None);
        };
        let inputs = recorded.inputs.inputs();
        let bytes = loaded.source.bytes();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let setup = Setup {
            options: recorded.source.options(robot.options().robot),
            events: inputs.events,
            rest: inputs.cycles,
            ..Setup::new(&name, &bytes, robot)
        };
        let refused = |_| Error::Usage("an event cannot happen to this program".to_owned());
        let mut session = Session::new(setup).map_err(refused)?;
        if !self.paused {
            session.play();
        }
        Ok(Some((session, ServedFile::new(place, bytes, lang), chosen)))
    }
}

/// Tells the hub of each change of the file.
fn watch(path: &Path, post: Post) -> Result<(), Error> {
    let watch = Watch::begin([path])?;
    thread::spawn(move || while watch.changed() && post.send(News::FileChanged) {});
    Ok(())
}

/// Whether the command is to end.
fn is_over() -> bool {
    interrupt::is_requested()
}
