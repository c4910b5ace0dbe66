//! Several sinks for one cycle.

use std::fmt::Display;
use tip_runtime::command::Command;
use tip_runtime::program::Program;
use tip_runtime::record::{Cycle, Sink};

/// Tells two sinks the same.
pub(crate) struct Both<'a>(pub(crate) &'a mut dyn Sink, pub(crate) &'a mut dyn Sink);

/// The sinks that there are, as one.
pub(crate) fn both<T>(
    first: Option<&mut dyn Sink>,
    second: Option<&mut dyn Sink>,
    then: impl FnOnce(Option<&mut dyn Sink>) -> T,
) -> T {
    match (first, second) {
        (Some(first), Some(second)) => then(Some(&mut Both(first, second))),
        (Some(first), None) => then(Some(first)),
        (None, second) => then(second),
    }
}

impl Sink for Both<'_> {
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

    fn lamp(&mut self, device: u8, on: bool) {
        self.0.lamp(device, on);
        self.1.lamp(device, on);
    }

    fn cycle(&mut self, cycle: &Cycle<'_>) {
        self.0.cycle(cycle);
        self.1.cycle(cycle);
    }
}
