//! The trace that a run keeps of itself, and several sinks for one cycle.

use std::fmt::Display;
use tip_runtime::command::Command;
use tip_runtime::program::Program;
use tip_runtime::record::{Cycle, Ending, JsonLines, Sink};

/// The records of the cycles so far.
#[derive(Clone, Debug)]
pub(crate) struct Trace {
    /// The writer of the record of a cycle, with the variables after the previous cycle.
    writer: JsonLines<String>,
    records: String,
}

/// The state of a trace at a cycle: its length, and its writer.
#[derive(Clone, Debug)]
pub(crate) struct TraceMark {
    writer: JsonLines<String>,
    length: usize,
}

impl Trace {
    pub(crate) fn new(with_state: bool) -> Self {
        Trace {
            writer: JsonLines::new(String::new(), with_state),
            records: String::new(),
        }
    }

    pub(crate) fn sink(&mut self) -> &mut dyn Sink {
        &mut self.writer
    }

    /// Appends the record of the last cycle.
    pub(crate) fn keep(&mut self) {
        self.records.push_str(self.writer.get_ref());
        self.writer.get_mut().clear();
    }

    /// Returns all records so far, and the last one if the run has ended.
    pub(crate) fn text(&self, ending: Option<Ending>, cycles: u64) -> String {
        let mut text = self.records.clone();
        if let Some(ending) = ending {
            text.push_str(&last_record(ending, cycles));
        }
        text
    }

    pub(crate) fn mark(&self) -> TraceMark {
        TraceMark {
            writer: self.writer.clone(),
            length: self.records.len(),
        }
    }

    pub(crate) fn restore(&mut self, mark: &TraceMark) {
        self.writer.clone_from(&mark.writer);
        self.records.truncate(mark.length);
    }
}

/// Returns the record after those of the cycles.
pub(crate) fn last_record(ending: Ending, cycles: u64) -> String {
    let mut writer = JsonLines::new(String::new(), false);
    writer.end(ending, cycles);
    writer.into_inner()
}

/// A sink that reports to two sinks.
struct Tee<'a>(&'a mut dyn Sink, &'a mut dyn Sink);

/// Calls a function with one sink for those that exist.
pub(crate) fn tee<T>(
    first: Option<&mut dyn Sink>,
    second: Option<&mut dyn Sink>,
    then: impl FnOnce(Option<&mut dyn Sink>) -> T,
) -> T {
    match (first, second) {
        (Some(first), Some(second)) => then(Some(&mut Tee(first, second))),
        (Some(first), None) => then(Some(first)),
        (None, second) => then(second),
    }
}

impl Sink for Tee<'_> {
    fn begin(&mut self, program: &dyn Program) {
        self.0.begin(program);
        self.1.begin(program);
    }

    fn command(&mut self, command: &Command<'_>) {
        self.0.command(command);
        self.1.command(command);
    }

    fn say(&mut self, text: &dyn Display) {
        self.0.say(text);
        self.1.say(text);
    }

    fn out(&mut self, text: &dyn Display) {
        self.0.out(text);
        self.1.out(text);
    }

    fn lamp(&mut self, device: u8, on: bool) {
        self.0.lamp(device, on);
        self.1.lamp(device, on);
    }

    fn cycle(&mut self, cycle: &Cycle<'_>) {
        self.0.cycle(cycle);
        self.1.cycle(cycle);
    }
}
