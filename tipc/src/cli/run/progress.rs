//! A sign of life on standard error while a long run works.

use std::io::{self, IsTerminal, Write};
use std::time::{Duration, Instant};

/// A run that is over before this needs no sign of life.
const FIRST: Duration = Duration::from_secs(1);
/// How long a sign of life stands.
const EVERY: Duration = Duration::from_millis(200);
/// The clock is asked once in so many cycles.
const CYCLES: u64 = 64;

/// One line that is written over and over, on a terminal only.
#[derive(Debug)]
pub(super) struct Progress {
    enabled: bool,
    shown: bool,
    due: Instant,
    limit: Option<u64>,
}

impl Progress {
    /// Of a run that ends after `limit` cycles at the latest.
    pub(super) fn new(limit: Option<u64>) -> Self {
        Progress {
            enabled: io::stderr().is_terminal(),
            shown: false,
            due: Instant::now() + FIRST,
            limit,
        }
    }

    /// The run has come to `cycle`.
    pub(super) fn at(&mut self, cycle: u64) {
        if !self.enabled || !cycle.is_multiple_of(CYCLES) || Instant::now() < self.due {
            return;
        }
        self.due = Instant::now() + EVERY;
        self.shown = true;
        let _ = match self.limit {
            Some(limit) => write!(io::stderr(), "\r\x1b[2Kcycle {cycle} of {limit}"),
            None => write!(io::stderr(), "\r\x1b[2Kcycle {cycle} (Ctrl-C ends the run)"),
        };
    }

    /// Takes the line away, so that something else can be written.
    pub(super) fn clear(&mut self) {
        if self.shown {
            self.shown = false;
            let _ = write!(io::stderr(), "\r\x1b[2K");
        }
    }
}
