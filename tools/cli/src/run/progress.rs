//! A sign of life on standard error while a long run works, with the bar graphs that the program shows.

use std::io::{self, IsTerminal, Write};
use std::time::{Duration, Instant};
use tip_runtime::console::Bars;

/// A run that is over before this needs no sign of life.
const FIRST: Duration = Duration::from_secs(1);
/// How long a sign of life is shown.
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
    graphs: [String; 2],
}

impl Progress {
    /// Of a run that ends after `limit` cycles at the latest.
    pub(super) fn new(limit: Option<u64>) -> Self {
        Progress {
            enabled: io::stderr().is_terminal(),
            shown: false,
            due: Instant::now() + FIRST,
            limit,
            graphs: Default::default(),
        }
    }

    /// Keeps a bar graph for the next sign of life.
    pub(super) fn show(&mut self, graph: u8, bars: Bars<'_>) {
        if let (true, Some(shown)) = (self.enabled, self.graphs.get_mut(usize::from(graph))) {
            let gap = if bars.0.is_empty() { "" } else { " " };
            *shown = format!("{bars}{gap}");
        }
    }

    /// The run has come to `cycle`.
    pub(super) fn at(&mut self, cycle: u64) {
        if !self.enabled || !cycle.is_multiple_of(CYCLES) || Instant::now() < self.due {
            return;
        }
        self.due = Instant::now() + EVERY;
        self.shown = true;
        let [first, second] = &self.graphs;
        let _ = write!(io::stderr(), "\r\x1b[2K{first}{second}cycle {cycle}");
        let _ = match self.limit {
            Some(limit) => write!(io::stderr(), " of {limit}"),
            None => write!(io::stderr(), " (Ctrl-C ends the run)"),
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
