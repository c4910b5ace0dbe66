//! The console of a run: keys of the terminal, messages, log files, a line of progress or status, and the pace of `--realtime`.

use crate::drives::realtime::{Histogram, wait_until};
use crate::error::{Error, is_closed};
use crate::message::{Figure, Running};
use crate::report::{RATE, progress_style};
use crate::run::files::finish;
use crate::run::summary::{line, status, tenths};
use crate::sticks::Sticks;
use crate::{interrupt, report};
use indicatif::{ProgressBar, ProgressDrawTarget};
use std::fmt::Display;
use std::io::{self, IsTerminal, Sink, Write};
use std::path::Path;
use std::time::{Duration, Instant};
use tip_runtime::console::{Bars, Console, LogFiles, Terminal};
use tip_runtime::machine::Report;
use tip_runtime::printable::Printable;
use tip_runtime::realtime::Pacer;
use tip_runtime::record::{Dump, Sample};
use tip_sim::{Event, Run, WaitDetector};
use tipc::message::Lang;
use tipc::source::Source;

/// The console of a run. Messages go to standard output, one a line.
#[derive(Debug)]
pub(super) struct Screen {
    keyboard: Option<Terminal<Sink>>,
    pub(super) progress: Progress,
    shows_messages: bool,
    silent: bool,
    logs: Option<LogFiles<()>>,
    /// Sticks that keys move, if the program reads any.
    sticks: Option<Sticks>,
    /// The error of the first message that could not be written.
    failure: Option<Error>,
}

impl Screen {
    /// Returns a console with keys, and messages if standard output is free for them.
    pub(super) fn new(
        keyboard: Option<Terminal<Sink>>,
        progress: Progress,
        shows_messages: bool,
        logs: Option<LogFiles<()>>,
    ) -> Self {
        Screen {
            keyboard,
            progress,
            shows_messages,
            silent: false,
            logs,
            sticks: None,
            failure: None,
        }
    }

    /// Removes the line of progress.
    pub(super) fn clear(&mut self) {
        self.progress.close();
    }

    /// Lets keys move sticks from now on.
    pub(super) fn steer(&mut self) {
        self.sticks = self.keyboard.is_some().then(Sticks::new);
    }

    /// Returns the sticks that have moved, with their readings.
    fn moved(&mut self) -> Vec<Event> {
        let sticks = self.sticks.as_mut();
        sticks.map_or(vec![], |sticks| sticks.moved(Instant::now()))
    }

    /// Returns the number of texts that FOUT.LOG had no room for.
    pub(super) fn dropped(&self) -> u64 {
        self.logs.as_ref().map_or(0, LogFiles::dropped)
    }

    /// Releases the terminal, so that the reports of the end appear where they should, and completes the log files.
    pub(super) fn close(&mut self) -> Result<(), Error> {
        self.clear();
        self.keyboard = None;
        self.logs.as_mut().map_or(Ok(()), finish)?;
        self.failure.take().map_or(Ok(()), Err)
    }
}

impl Console for Screen {
    fn key(&mut self, cycle: u64) -> Option<u8> {
        let keyboard = self.keyboard.as_mut()?;
        let key = match &mut self.sticks {
            Some(sticks) => {
                sticks.press(Instant::now(), || keyboard.pressed());
                sticks.key()
            }
            None => keyboard.key(cycle),
        };
        if keyboard.interrupted() {
            interrupt::request();
        }
        key
    }

    fn message(&mut self, text: &dyn Display) {
        if !self.shows_messages || self.silent {
            return;
        }
        let text = Printable::message(text).to_string();
        if text.is_empty() {
            return;
        }
        let written = self.progress.above(|| {
            let mut out = io::stdout().lock();
            writeln!(out, "{text}").and_then(|()| out.flush())
        });
        // Nobody reads the messages any more: the run ends.
        if let Err(error) = written {
            interrupt::request();
            if !is_closed(&error) {
                self.failure = Some(Error::cannot_write(Path::new("standard output"), error));
            }
        }
    }

    fn append(&mut self, text: &dyn Display) {
        if let Some(logs) = &mut self.logs {
            logs.append(text);
        }
    }

    fn silent(&mut self, on: bool) {
        self.silent = on;
    }

    fn bars(&mut self, graph: u8, bars: Bars<'_>) {
        self.progress.show(graph, bars);
    }

    fn sample(&mut self, sample: &Sample<'_>) {
        if let Some(logs) = &mut self.logs {
            logs.sample(sample);
        }
    }

    fn variables(&mut self, dump: &Dump<'_>) {
        if let Some(logs) = &mut self.logs {
            logs.variables(dump);
        }
    }

    fn emergency(&mut self, report: &Report<'_>) {
        if let Some(logs) = &mut self.logs {
            logs.emergency(report);
        }
    }
}

/// Time before a line of progress is drawn.
const FIRST: Duration = Duration::from_secs(1);
/// Number of control cycles between two looks at the clock.
const CYCLES: u64 = 64;

/// The line of progress with the bar graphs of the program, on a terminal only.
#[derive(Debug)]
pub(super) struct Progress {
    bar: ProgressBar,
    /// The time of the first drawing, if that is later.
    due: Option<Instant>,
    graphs: [String; 2],
}

impl Progress {
    /// Returns a line that is never drawn.
    pub(super) fn hidden() -> Self {
        Progress {
            bar: ProgressBar::hidden(),
            due: None,
            graphs: Default::default(),
        }
    }

    /// Returns the line of a run that ends after `limit` cycles at the latest.
    pub(super) fn of(limit: Option<u64>) -> Self {
        let bar = ProgressBar::with_draw_target(limit, ProgressDrawTarget::hidden());
        bar.set_style(progress_style(match limit {
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

    /// Returns the line of a run in real time, for [`status`](Self::status).
    pub(super) fn live() -> Self {
        let target = ProgressDrawTarget::stderr_with_hz(2 * RATE);
        let bar = ProgressBar::with_draw_target(None, target);
        bar.set_style(progress_style("{prefix}{wide_msg}"));
        Progress {
            bar,
            ..Progress::hidden()
        }
    }

    /// Shows a bar graph.
    pub(super) fn show(&mut self, graph: u8, bars: Bars<'_>) {
        if let Some(shown) = self.graphs.get_mut(usize::from(graph)) {
            let gap = if bars.0.is_empty() { "" } else { " " };
            *shown = format!("{bars}{gap}");
            self.bar.set_prefix(self.graphs.concat());
        }
    }

    /// Updates the progress.
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

    /// Shows the status: instead of the last one on a terminal, else on a new line.
    pub(super) fn status(&self, text: String) {
        if self.bar.is_hidden() {
            report::complain(&format!("{text}\n"));
        } else {
            self.bar.set_message(text);
        }
    }

    /// Returns true if the line is visible and due.
    pub(super) fn is_due(&self, cycle: u64) -> bool {
        cycle.is_multiple_of(CYCLES) && !self.bar.is_hidden()
    }

    /// Shows what the run waits for, or nothing.
    pub(super) fn waits(&self, text: String) {
        self.bar.set_message(text);
    }

    /// Writes something else, and draws the line again below it.
    pub(super) fn above<T>(&self, write: impl FnOnce() -> T) -> T {
        self.bar.suspend(write)
    }

    /// Removes the line.
    pub(super) fn close(&self) {
        self.bar.finish_and_clear();
    }
}

/// Time between two lines of status, on a terminal and elsewhere.
const ON_TERMINAL: Duration = Duration::from_millis(100);
const ELSEWHERE: Duration = Duration::from_secs(1);

/// The pace and the status of a run in real time.
#[derive(Debug)]
pub(super) struct Live {
    pacer: Pacer,
    /// The time of the next status; `None` if it is not shown.
    due: Option<Instant>,
    every: Duration,
    jitter: Histogram,
    lang: Lang,
}

impl Live {
    /// Starts the clock, and prints a legend of keys unless `quiet`.
    pub(super) fn begin(quiet: bool, has_sticks: bool, lang: Lang) -> Self {
        if !quiet {
            let keys = match io::stdin().is_terminal() {
                true => Running::Keys,
                false => Running::NoKeys,
            };
            report::say(keys, lang);
            if has_sticks && io::stdin().is_terminal() {
                report::say(Running::Sticks, lang);
            }
        }
        let every = if io::stderr().is_terminal() {
            ON_TERMINAL
        } else {
            ELSEWHERE
        };
        Live {
            pacer: Pacer::start(),
            due: (!quiet).then(|| Instant::now() + every),
            every,
            jitter: Histogram::default(),
            lang,
        }
    }

    /// Shows the status, and waits until the cycle is over.
    pub(super) fn after(&mut self, run: &mut Run, waits: &WaitDetector, source: &Source) {
        let moved = run.console_mut::<Screen>().map_or(vec![], Screen::moved);
        for event in moved {
            // A robot that lacks the input reads what it reads.
            let _ = run.add(event.at(run.cycles()));
        }
        if self.due.is_some_and(|due| Instant::now() >= due) {
            self.due = Some(Instant::now() + self.every);
            let text = status(run, waits.now(run).as_ref(), source, self.lang);
            if let Some(screen) = run.console_mut::<Screen>() {
                screen.progress.status(text);
            }
        }
        let over = self.pacer.due(run.period());
        self.jitter.add(wait_until(over));
    }

    /// Returns how late cycles started.
    pub(super) fn jitter(&self) -> &Histogram {
        &self.jitter
    }

    /// Returns the line about the pace for the summary.
    pub(super) fn pace(&self, lang: Lang) -> String {
        let pace = match self.pacer.overruns() {
            0 => Running::InTime,
            late => Running::Late {
                late: late.to_string(),
                all: self.pacer.cycles().to_string(),
                worst: tenths(self.pacer.worst().as_secs_f64() * 1000.0),
            },
        };
        line(Figure::Pace, pace.in_lang(lang), lang)
    }
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
