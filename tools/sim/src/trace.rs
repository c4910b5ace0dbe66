//! The trace that a run keeps of itself.

use tip_runtime::record::{Ending, JsonLines, Sink};

/// Records of the cycles so far, which only grow.
#[derive(Clone, Debug)]
pub(crate) struct Trace {
    /// Writes the record of one cycle; knows the variables after the one before.
    writer: JsonLines<String>,
    records: String,
}

/// A trace at some cycle: how long it was, and what its writer knew.
#[derive(Clone, Debug)]
pub(crate) struct Mark {
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

    /// A cycle is over.
    pub(crate) fn keep(&mut self) {
        self.records.push_str(self.writer.get_ref());
        self.writer.get_mut().clear();
    }

    /// All records so far, and the last one if the run has ended.
    pub(crate) fn text(&self, ending: Option<Ending>, cycles: u64) -> String {
        let mut text = self.records.clone();
        if let Some(ending) = ending {
            text.push_str(&last_record(ending, cycles));
        }
        text
    }

    pub(crate) fn mark(&self) -> Mark {
        Mark {
            writer: self.writer.clone(),
            length: self.records.len(),
        }
    }

    pub(crate) fn restore(&mut self, mark: &Mark) {
        self.writer.clone_from(&mark.writer);
        self.records.truncate(mark.length);
    }
}

/// The record after those of the cycles.
pub(crate) fn last_record(ending: Ending, cycles: u64) -> String {
    let mut writer = JsonLines::new(String::new(), false);
    writer.end(ending, cycles);
    writer.into_inner()
}
