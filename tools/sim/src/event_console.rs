//! The console of a run: it types the keys of events, and passes output to a listener.

use std::any::Any;
use std::collections::VecDeque;
use std::fmt::Display;
use tip_runtime::console::{Bars, Console};
use tip_runtime::machine::Report;
use tip_runtime::record::{Dump, Sample};

/// The keys that wait to be typed, and the listener of the output. A copy has only the keys, since listeners are not
/// part of a run.
#[derive(Default)]
pub(crate) struct EventConsole {
    /// Keys that are typed before those of the listener.
    due: VecDeque<u8>,
    listener: Option<Box<dyn Listener>>,
}

/// A console that can be returned as its own type.
pub(crate) trait Listener: Console + Any + Send {}

impl<C: Console + Send + 'static> Listener for C {}

impl EventConsole {
    /// Presses a key.
    pub(crate) fn press(&mut self, byte: u8) {
        self.due.push_back(byte);
    }

    pub(crate) fn listener(&self) -> Option<&dyn Any> {
        Some(self.listener.as_deref()?)
    }

    pub(crate) fn listener_mut(&mut self) -> Option<&mut dyn Any> {
        Some(self.listener.as_deref_mut()?)
    }

    /// Replaces the listener, and returns the previous one.
    pub(crate) fn replace(
        &mut self,
        listener: Option<Box<dyn Listener>>,
    ) -> Option<Box<dyn Listener>> {
        std::mem::replace(&mut self.listener, listener)
    }

    fn notify(&mut self, what: impl FnOnce(&mut dyn Listener)) {
        if let Some(listener) = self.listener.as_deref_mut() {
            what(listener);
        }
    }
}

impl Clone for EventConsole {
    fn clone(&self) -> Self {
        EventConsole {
            due: self.due.clone(),
            listener: None,
        }
    }
}

impl Console for EventConsole {
    fn key(&mut self, cycle: u64) -> Option<u8> {
        let next = self.due.pop_front();
        next.or_else(|| self.listener.as_deref_mut()?.key(cycle))
    }

    fn message(&mut self, text: &dyn Display) {
        self.notify(|listener| listener.message(text));
    }

    fn append(&mut self, text: &dyn Display) {
        self.notify(|listener| listener.append(text));
    }

    fn silent(&mut self, on: bool) {
        self.notify(|listener| listener.silent(on));
    }

    fn bars(&mut self, graph: u8, bars: Bars<'_>) {
        self.notify(|listener| listener.bars(graph, bars));
    }

    fn sample(&mut self, sample: &Sample<'_>) {
        self.notify(|listener| listener.sample(sample));
    }

    fn variables(&mut self, dump: &Dump<'_>) {
        self.notify(|listener| listener.variables(dump));
    }

    fn emergency(&mut self, report: &Report<'_>) {
        self.notify(|listener| listener.emergency(report));
    }

    fn ended(&mut self) {
        self.notify(|listener| listener.ended());
    }
}
