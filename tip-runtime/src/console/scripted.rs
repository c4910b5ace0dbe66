//! A console whose keys come from a script, and one that records what it is shown.

use super::Console;
use crate::emergency::Report;
use crate::record::{Dump, Sample, TitanLog};
use core::fmt::Display;
use std::string::{String, ToString};
use std::vec::Vec;

/// The byte of the ESC key: a halt request.
const ESCAPE: u8 = 0x1B;

/// A console that types keys at given cycles and records what it is shown.
#[derive(Clone, Debug, Default)]
pub struct Scripted {
    keys: Vec<(u64, u8)>,
    typed: usize,
    inner: Transcript,
}

impl Scripted {
    /// Types each byte of `keys` before the step of its cycle. Several bytes for one cycle keep their order.
    pub fn new(mut keys: Vec<(u64, u8)>) -> Self {
        keys.sort_by_key(|(cycle, _)| *cycle);
        Scripted {
            keys,
            ..Scripted::default()
        }
    }

    /// Requests a halt before the step of `cycle`.
    #[must_use]
    pub fn halt(mut self, cycle: u64) -> Self {
        let place = self.keys.partition_point(|(at, _)| *at <= cycle);
        self.keys.insert(place, (cycle, ESCAPE));
        self
    }

    /// Returns what was shown.
    pub fn inner(&self) -> &Transcript {
        &self.inner
    }
}

impl Console for Scripted {
    fn key(&mut self, cycle: u64) -> Option<u8> {
        match self.keys.get(self.typed) {
            Some((at, byte)) if *at <= cycle => {
                self.typed += 1;
                Some(*byte)
            }
            _ => None,
        }
    }

    fn message(&mut self, text: &dyn Display) {
        self.inner.message(text);
    }

    fn append(&mut self, text: &dyn Display) {
        self.inner.append(text);
    }

    fn silent(&mut self, on: bool) {
        self.inner.silent(on);
    }

    fn sample(&mut self, sample: &Sample<'_>) {
        self.inner.sample(sample);
    }

    fn variables(&mut self, dump: &Dump<'_>) {
        self.inner.variables(dump);
    }

    fn emergency(&mut self, report: &Report<'_>) {
        self.inner.emergency(report);
    }

    fn ended(&mut self) {
        self.inner.ended();
    }
}

/// A console that records everything that is reported to it, in order of arrival.
#[derive(Clone, Debug, Default)]
pub struct Transcript {
    /// The messages; an empty one cleared the line.
    pub messages: Vec<String>,
    /// The text of FOUT.LOG.
    pub appended: String,
    /// Each change of SILENT.
    pub silent: Vec<bool>,
    /// The rows of TITAN.LOG.
    pub log: TitanLog,
    /// The texts of OUTPUT_VARIABLES.
    pub variables: Vec<String>,
    /// The text of EMG.log.
    pub emergency: Option<String>,
    /// Number of times that the program's end was reported.
    pub ended: u32,
}

impl Console for Transcript {
    fn message(&mut self, text: &dyn Display) {
        self.messages.push(text.to_string());
    }

    fn append(&mut self, text: &dyn Display) {
        self.appended.push_str(&text.to_string());
    }

    fn silent(&mut self, on: bool) {
        self.silent.push(on);
    }

    fn sample(&mut self, sample: &Sample<'_>) {
        self.log.push(sample);
    }

    fn variables(&mut self, dump: &Dump<'_>) {
        self.variables.push(dump.to_string());
    }

    fn emergency(&mut self, report: &Report<'_>) {
        self.emergency = Some(report.to_string());
    }

    fn ended(&mut self) {
        self.ended += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    // clauses: 2.23
    #[test]
    fn keys_come_at_their_cycle_in_the_order_given() {
        let mut console = Scripted::new(std::vec![(5, b'c'), (2, b'b'), (2, b'a')]).halt(2);
        assert_eq!(console.key(1), None);
        let at_two: Vec<_> = (0..4).map(|_| console.key(2)).collect();
        assert_eq!(at_two, [Some(b'b'), Some(b'a'), Some(0x1B), None]);
        assert_eq!(console.key(9), Some(b'c'));
    }
}
