//! The console of a simulated run: keys of the terminal, messages line by line, log files.

use super::super::error::{Error, is_closed};
use super::super::interrupt;
use super::logs;
use super::progress::Progress;
use std::fmt::Display;
use std::io::{self, IsTerminal, Sink, Write};
use std::path::Path;
use tip_runtime::console::{Bars, Console, LogFiles, Terminal};
use tip_runtime::machine::Report;
use tip_runtime::printable::Printable;
use tip_runtime::record::{Dump, Sample};

/// Messages go to standard output as a record of the run, one a line.
#[derive(Debug)]
pub(super) struct Screen {
    keyboard: Option<Terminal<Sink>>,
    progress: Progress,
    shows_messages: bool,
    silent: bool,
    logs: Option<LogFiles<()>>,
    /// Why messages could not be shown.
    failure: Option<Error>,
}

impl Screen {
    /// With keys if standard input is a terminal, and messages if standard output is free for them.
    pub(super) fn new(
        progress: Progress,
        shows_messages: bool,
        logs: Option<LogFiles<()>>,
    ) -> Self {
        let keyboard = io::stdin()
            .is_terminal()
            .then(|| Terminal::on(io::sink(), false).report_interrupts());
        Screen {
            keyboard,
            progress,
            shows_messages,
            silent: false,
            logs,
            failure: None,
        }
    }

    /// The run has come to `cycle`.
    pub(super) fn at(&mut self, cycle: u64) {
        self.progress.at(cycle);
    }

    /// How a run in real time is.
    pub(super) fn status(&self, text: String) {
        self.progress.status(text);
    }

    /// Whether the line of a long run is shown, and due.
    pub(super) fn is_due(&self, cycle: u64) -> bool {
        self.progress.is_due(cycle)
    }

    /// Says in that line what the run waits for, or nothing.
    pub(super) fn waits(&self, text: String) {
        self.progress.waits(text);
    }

    /// Writes something above the line of progress.
    pub(super) fn above(&self, write: impl FnOnce()) {
        self.progress.above(write);
    }

    /// Gives the terminal back, so that reports of the end appear where they should, and completes the log files.
    pub(super) fn close(&mut self) -> Result<(), Error> {
        self.progress.close();
        self.keyboard = None;
        self.logs.as_mut().map_or(Ok(()), logs::finish)?;
        self.failure.take().map_or(Ok(()), Err)
    }
}

impl Console for Screen {
    fn key(&mut self, cycle: u64) -> Option<u8> {
        let keyboard = self.keyboard.as_mut()?;
        let key = keyboard.key(cycle);
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
        // No one reads the messages any more: the run has lost its audience.
        if let Err(error) = written {
            interrupt::request();
            if !is_closed(&error) {
                self.failure = Some(Error::cannot_write(Path::new("standard output"), error));
            }
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
