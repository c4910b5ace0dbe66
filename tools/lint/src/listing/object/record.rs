//! One step of TIP.OBJ.

use super::slot::{Slot, target_name};
use std::fmt::Write;
use tip_runtime::command::Target;

/// A command, its target and its arguments.
#[derive(Debug)]
pub(super) struct Record {
    command: String,
    target: String,
    arguments: Vec<Slot>,
}

impl Record {
    /// A command without target and arguments.
    pub(super) fn new(command: impl Into<String>) -> Self {
        Record {
            command: command.into(),
            target: target_name(Target::None),
            arguments: Vec::new(),
        }
    }

    /// The same with this target.
    pub(super) fn to(self, target: String) -> Self {
        Record { target, ..self }
    }

    /// The same with another argument after the others.
    pub(super) fn with(mut self, argument: Slot) -> Self {
        self.arguments.push(argument);
        self
    }

    /// Its lines, with `count` arguments.
    pub(super) fn text(&self, number: usize, count: usize) -> String {
        let arguments = || {
            let empty = std::iter::repeat(&Slot::NONE);
            (1..=count).zip(self.arguments.iter().chain(empty))
        };
        let mut out = format!("[{number}Line]\n");
        // Writing to a string cannot fail.
        let _ = writeln!(out, "Cmd      = {}", self.command);
        let _ = writeln!(out, "Target   = {}", self.target);
        for (place, slot) in arguments() {
            let _ = writeln!(out, "ArgType {place} = {}", slot.kind);
        }
        for (place, slot) in arguments() {
            let _ = writeln!(out, "ArgValue{place} = {:.6}", slot.value);
        }
        out
    }
}
