//! One line on standard error that is written over and over: how far a long run is, or how a run in real time is.

use super::super::report;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::{self, IsTerminal};
use std::time::{Duration, Instant};
use tip_runtime::console::Bars;

/// A run that is over before this needs no sign of life.
const FIRST: Duration = Duration::from_secs(1);
/// How often it is drawn: Hz.
const RATE: u8 = 5;
/// The clock is asked once in so many cycles.
const CYCLES: u64 = 64;

/// How far it is, with the bar graphs that the program shows; on a terminal only.
#[derive(Debug)]
pub(super) struct Progress {
    bar: ProgressBar,
    /// When it is drawn first, if it is to be drawn later.
    due: Option<Instant>,
    graphs: [String; 2],
}

impl Progress {
    /// Nothing at all.
    pub(super) fn hidden() -> Self {
        Progress {
            bar: ProgressBar::hidden(),
            due: None,
            graphs: Default::default(),
        }
    }

    /// Of a run that ends after `limit` cycles at the latest.
    pub(super) fn of(limit: Option<u64>) -> Self {
        let bar = ProgressBar::with_draw_target(limit, ProgressDrawTarget::hidden());
        bar.set_style(style(match limit {
            Some(_) => {
                "{prefix}{bar:20} cycle {pos} of {len}, {eta} left (Ctrl-C ends the run){msg}"
            }
            None => "{prefix}cycle {pos} (Ctrl-C ends the run){msg}",
        }));
        Progress {
            bar,
            due: io::stderr().is_terminal().then(|| Instant::now() + FIRST),
            graphs: Default::default(),
        }
    }

    /// Of a run in real time, for [`status`](Self::status).
    pub(super) fn live() -> Self {
        let target = ProgressDrawTarget::stderr_with_hz(2 * RATE);
        let bar = ProgressBar::with_draw_target(None, target);
        bar.set_style(style("{prefix}{wide_msg}"));
        Progress {
            bar,
            ..Progress::hidden()
        }
    }

    /// Shows a bar graph from now on.
    pub(super) fn show(&mut self, graph: u8, bars: Bars<'_>) {
        if let Some(shown) = self.graphs.get_mut(usize::from(graph)) {
            let gap = if bars.0.is_empty() { "" } else { " " };
            *shown = format!("{bars}{gap}");
            self.bar.set_prefix(self.graphs.concat());
        }
    }

    /// The run has come to `cycle`.
    pub(super) fn at(&mut self, cycle: u64) {
        if !cycle.is_multiple_of(CYCLES) {
            return;
        }
        if self.due.is_some_and(|due| Instant::now() >= due) {
            self.due = None;
            let target = ProgressDrawTarget::stderr_with_hz(RATE);
            self.bar.set_draw_target(target);
        }
        self.bar.set_position(cycle);
    }

    /// How it is now: in place of the line before on a terminal, else a line of its own.
    pub(super) fn status(&self, text: String) {
        if self.bar.is_hidden() {
            report::complain(&format!("{text}\n"));
        } else {
            self.bar.set_message(text);
        }
    }

    /// Whether the line of a long run is shown, and it is time to bring it up to date.
    pub(super) fn is_due(&self, cycle: u64) -> bool {
        cycle.is_multiple_of(CYCLES) && !self.bar.is_hidden()
    }

    /// Says what the run waits for, or nothing.
    pub(super) fn waits(&self, text: String) {
        self.bar.set_message(text);
    }

    /// Writes something else, and shows the line again below it.
    pub(super) fn above<T>(&self, write: impl FnOnce() -> T) -> T {
        self.bar.suspend(write)
    }

    /// Takes the line away for good.
    pub(super) fn close(&self) {
        self.bar.finish_and_clear();
    }
}

fn style(template: &str) -> ProgressStyle {
    let plain = ProgressStyle::default_bar();
    let style = ProgressStyle::with_template(template);
    style.unwrap_or(plain).progress_chars("=> ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_template_is_one() {
        for progress in [Progress::of(None), Progress::of(Some(9)), Progress::live()] {
            progress.status("ready".to_owned());
            assert_eq!(progress.above(|| 7), 7);
            progress.close();
        }
    }
}
