//! Compares the compiled code of a program text with the interpreter: cargo builds both into a process of their own,
//! with the runtime of a project. `tip verify` uses this and [`search::verify`].
//!
//! ```no_run
//! use tip_sim::verify::{Project, Subject};
//! use tip_sim::{Inputs, Robot, search, tipc};
//!
//! let source = std::fs::read("walk.prg")?;
//! let options = Robot::named("titan8")?.options();
//! let program = tip_lint::load("walk.prg", &source, &options).program.ok_or("it does not load")?;
//! let subject = Subject::new("walk.prg", &source, options, &program);
//! let mut engines = Project::find(None)?.engines(&subject)?;
//! match search::verify(&mut engines, &program, &Inputs::default(), 256) {
//!     Ok((coverage, None)) => println!("{} runs agree", coverage.runs()),
//!     Ok((_, Some(shortest))) => println!("they differ: {}", shortest.inputs),
//!     Err(failed) => println!("{failed:?}"),
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! [`search::verify`]: crate::search::verify
#![allow(clippy::disallowed_methods, reason = "packages are written for cargo")]

mod package;
mod project;

pub use project::{Project, VERSION};

use crate::event::Inputs;
use crate::lockstep::{Answer, LIMIT};
use crate::process_group::ProcessGroup;
use crate::search;
use package::Package;
use std::error::Error;
use std::fmt;
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{ChildStdin, Command, Stdio};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::thread;
use std::time::{Duration, Instant};
use tip_runtime::plant::Scene;
use tipc::Options;
use tipc::description::Description;
use tipc::program::Program;

/// A program that loads, on a robot in its surroundings.
#[derive(Clone, Copy, Debug)]
pub struct Subject<'a> {
    pub(crate) name: &'a str,
    pub(crate) source: &'a [u8],
    pub(crate) options: Options,
    pub(crate) program: &'a Program,
    pub(crate) description: Option<&'a Description>,
    pub(crate) scene: Scene,
}

impl<'a> Subject<'a> {
    /// Creates the program of these bytes; `name` and `options` are those that it was loaded with.
    /// The robot has a name, or [a description](Self::on).
    pub fn new(name: &'a str, source: &'a [u8], options: Options, program: &'a Program) -> Self {
        Subject {
            name,
            source,
            options,
            program,
            description: None,
            scene: Scene::EMPTY,
        }
    }

    /// Sets the robot to that of a description.
    #[must_use]
    pub fn on(self, description: &'a Description) -> Self {
        Subject {
            description: Some(description),
            ..self
        }
    }

    /// Sets the scene. One with objects is for a hand.
    #[must_use]
    pub fn with_scene(self, scene: Scene) -> Self {
        Subject { scene, ..self }
    }
}

impl Project {
    /// Builds both engines of a program, and starts them. Cargo talks to the user itself.
    ///
    /// # Errors
    /// The robot cannot use the scene, the package cannot be written or built, or it does not start.
    pub fn engines(&self, subject: &Subject<'_>) -> Result<Engines, NotBuilt> {
        let package = Package::new(subject, self)?;
        let manifest = package.write(self)?;
        Engines::start(&self.build(&manifest)?)
    }
}

/// Time limit of a run, to which a time for each of its cycles is added.
const PATIENCE: Duration = Duration::from_secs(60);
const PATIENCE_PER_CYCLE: Duration = Duration::from_millis(1);

/// Time between two checks that the answer is still wanted.
const POLL_INTERVAL: Duration = Duration::from_millis(100);

/// Both engines, in a process of their own.
#[derive(Debug)]
pub struct Engines {
    process: ProcessGroup,
    requests: ChildStdin,
    answers: Receiver<String>,
    given_up: fn() -> bool,
}

impl Engines {
    /// Starts an executable that answers as [`lockstep::serve`](crate::lockstep::serve) does.
    ///
    /// # Errors
    /// The executable does not start.
    pub fn start(executable: &Path) -> Result<Self, NotBuilt> {
        let cannot = |reason: &dyn std::fmt::Display| {
            NotBuilt::Failed(format!("{} does not start: {reason}", executable.display()))
        };
        let mut command = Command::new(executable);
        command.stdin(Stdio::piped()).stdout(Stdio::piped());
        let mut process = ProcessGroup::start(&mut command).map_err(|error| cannot(&error))?;
        let child = process.child();
        let pipes = child.stdin.take().zip(child.stdout.take());
        let (requests, output) = pipes.ok_or_else(|| cannot(&"it has no pipes"))?;
        let (sender, answers) = mpsc::channel();
        thread::spawn(move || {
            let lines = BufReader::new(output).lines().map_while(Result::ok);
            // Sending fails if the receiver is gone, which needs no further answers.
            let _ = lines.into_iter().try_for_each(|line| sender.send(line));
        });
        Ok(Engines {
            process,
            requests,
            answers,
            given_up: || false,
        })
    }

    /// Sets a condition that ends the wait for an answer, for example after Ctrl-C.
    #[must_use]
    pub fn given_up_if(mut self, given_up: fn() -> bool) -> Self {
        self.given_up = given_up;
        self
    }

    /// Returns the next answer, if it comes in time and the wait is not cancelled.
    fn answer(&self, patience: Duration) -> Result<String, RecvTimeoutError> {
        let begin = Instant::now();
        loop {
            let left = patience.saturating_sub(begin.elapsed());
            match self.answers.recv_timeout(left.min(POLL_INTERVAL)) {
                Err(RecvTimeoutError::Timeout) if !left.is_zero() && !(self.given_up)() => {}
                answer => return answer,
            }
        }
    }
}

impl search::Engines for Engines {
    type Error = NotBuilt;

    fn ask(&mut self, inputs: &Inputs) -> Result<Answer, NotBuilt> {
        // If the process has ended, the missing answer shows that.
        let _ = writeln!(self.requests, "{inputs}").and_then(|()| self.requests.flush());
        let cycles = u32::try_from(inputs.cycles.unwrap_or(LIMIT)).unwrap_or(u32::MAX);
        let patience = PATIENCE.saturating_add(PATIENCE_PER_CYCLE.saturating_mul(cycles));
        let broken =
            |what: String| NotBuilt::Failed(format!("{what} in a run with the inputs `{inputs}`"));
        match self.answer(patience) {
            Ok(line) => serde_json::from_str(&line)
                .map_err(|error| broken(format!("'{line}' is not an answer ({error})"))),
            Err(RecvTimeoutError::Timeout) => {
                let seconds = patience.as_secs();
                Err(broken(format!(
                    "the engines did not answer for {seconds} s"
                )))
            }
            Err(RecvTimeoutError::Disconnected) => {
                let status = self.process.child().wait();
                let status =
                    status.map_or_else(|error| error.to_string(), |status| status.to_string());
                Err(broken(format!("the engines' process ended ({status})")))
            }
        }
    }
}

/// The reason why both engines cannot run.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum NotBuilt {
    /// There is no Cargo project.
    NoProject {
        /// The reason.
        reason: String,
        /// Output of cargo, line by line.
        said: String,
    },
    /// Another program or the system fails.
    Failed(String),
    /// A file cannot be written.
    CannotWrite {
        /// The file.
        path: PathBuf,
        /// The reason.
        reason: String,
    },
}

impl fmt::Display for NotBuilt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NotBuilt::NoProject { reason, .. } | NotBuilt::Failed(reason) => f.write_str(reason),
            NotBuilt::CannotWrite { path, reason } => {
                write!(f, "{} cannot be written: {reason}", path.display())
            }
        }
    }
}

impl Error for NotBuilt {}
