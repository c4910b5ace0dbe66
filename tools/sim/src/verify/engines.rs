//! The process in which both engines run: it may die or hang, and then says so by name.

use super::error::NotBuilt;
use crate::apart::Apart;
use crate::event::Inputs;
use crate::lockstep::{Answer, LIMIT};
use crate::search;
use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{ChildStdin, Command, Stdio};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::thread;
use std::time::{Duration, Instant};

/// A run may take this long, and so much more for each of its cycles.
const PATIENCE: Duration = Duration::from_secs(60);
const PATIENCE_PER_CYCLE: Duration = Duration::from_millis(1);

/// How soon it is noticed that nobody waits for the answer any more.
const NAP: Duration = Duration::from_millis(100);

/// Both engines, in a process of their own.
#[derive(Debug)]
pub struct Engines {
    process: Apart,
    requests: ChildStdin,
    answers: Receiver<String>,
    given_up: fn() -> bool,
}

impl Engines {
    /// Starts an executable that answers as [`lockstep::serve`](crate::lockstep::serve) does.
    ///
    /// # Errors
    /// It does not start.
    pub fn start(executable: &Path) -> Result<Self, NotBuilt> {
        let cannot = |reason: &dyn std::fmt::Display| {
            NotBuilt::Failed(format!("{} does not start: {reason}", executable.display()))
        };
        let mut command = Command::new(executable);
        command.stdin(Stdio::piped()).stdout(Stdio::piped());
        let mut process = Apart::start(&mut command).map_err(|error| cannot(&error))?;
        let child = process.child();
        let pipes = child.stdin.take().zip(child.stdout.take());
        let (requests, output) = pipes.ok_or_else(|| cannot(&"it has no pipes"))?;
        let (sender, answers) = mpsc::channel();
        thread::spawn(move || {
            let lines = BufReader::new(output).lines().map_while(Result::ok);
            // When no one listens any more, no one misses the rest.
            let _ = lines.into_iter().try_for_each(|line| sender.send(line));
        });
        Ok(Engines {
            process,
            requests,
            answers,
            given_up: || false,
        })
    }

    /// A run ends without an answer as soon as this is true: after Ctrl-C, say.
    #[must_use]
    pub fn given_up_if(mut self, given_up: fn() -> bool) -> Self {
        self.given_up = given_up;
        self
    }

    /// The next answer, if it comes in time and nobody gives it up.
    fn answer(&self, patience: Duration) -> Result<String, RecvTimeoutError> {
        let begin = Instant::now();
        loop {
            let left = patience.saturating_sub(begin.elapsed());
            match self.answers.recv_timeout(left.min(NAP)) {
                Err(RecvTimeoutError::Timeout) if !left.is_zero() && !(self.given_up)() => {}
                answer => return answer,
            }
        }
    }
}

impl search::Engines for Engines {
    type Error = NotBuilt;

    fn ask(&mut self, inputs: &Inputs) -> Result<Answer, NotBuilt> {
        // A process that is gone shows when its answer is missing.
        let _ = writeln!(self.requests, "{inputs}").and_then(|()| self.requests.flush());
        let cycles = u32::try_from(inputs.cycles.unwrap_or(LIMIT)).unwrap_or(u32::MAX);
        let patience = PATIENCE.saturating_add(PATIENCE_PER_CYCLE.saturating_mul(cycles));
        let broken =
            |what: String| NotBuilt::Failed(format!("{what} in a run with the inputs `{inputs}`"));
        match self.answer(patience) {
            Ok(line) => line.parse().map_err(broken),
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
