//! The console of a run: types its keys, and hashes what it is shown.

use crate::notes::Hash;
use crate::script::{Event, Happening};
use std::fmt::{Display, Write as _};
use tip_runtime::console::{Bars, Console};
use tip_runtime::machine::Report;
use tip_runtime::record::Sample;

pub(crate) struct Typist<'s> {
    events: &'s [Event],
    pub(crate) shown: Hash,
}

impl<'s> Typist<'s> {
    pub(crate) fn new(events: &'s [Event]) -> Self {
        Typist {
            events,
            shown: Hash::default(),
        }
    }

    fn show(&mut self, text: &dyn Display) {
        write!(self.shown, "{text}").expect("a hash takes every text");
    }
}

impl Console for Typist<'_> {
    fn key(&mut self, cycle: u64) -> Option<u8> {
        while let Some(((_, happening), later)) = self
            .events
            .split_first()
            .filter(|((at, _), _)| *at <= cycle)
        {
            self.events = later;
            if let Happening::Key(byte) = happening {
                return Some(*byte);
            }
        }
        None
    }

    fn silent(&mut self, on: bool) {
        self.shown.add(u64::from(on));
    }

    fn bars(&mut self, graph: u8, bars: Bars<'_>) {
        self.shown.add(u64::from(graph));
        bars.0
            .iter()
            .for_each(|share| self.shown.add(share.to_bits()));
    }

    fn sample(&mut self, sample: &Sample<'_>) {
        self.shown.add(sample.cycle);
        self.shown.add(sample.time.to_bits());
        let sensed = [sample.torques, sample.paws, sample.knobs, &[sample.antenna]];
        sensed
            .concat()
            .iter()
            .for_each(|value| self.shown.add(value.to_bits()));
    }

    fn variables(&mut self, dump: &dyn Display) {
        self.show(dump);
    }

    fn emergency(&mut self, report: &Report<'_>) {
        self.show(report);
    }

    fn ended(&mut self) {
        self.shown.add(u64::MAX);
    }
}
