//! The state of a program during a recording, from its log.

use std::collections::BTreeSet;
use tip_sim::IssuedCommand;
use tip_view::{LogEntry, Occurrence, Recording};

/// State of a program after some entries of the log.
pub(crate) struct ProgramState<'a> {
    recording: &'a Recording,
    step: Option<u32>,
    /// The last command, and its cycle.
    pub(crate) command: Option<(u64, &'a IssuedCommand)>,
    pub(crate) message: &'a str,
    /// The lamps that are on.
    pub(crate) lamps: BTreeSet<u8>,
    /// Value of each variable, once it has one.
    pub(crate) values: Vec<Option<f64>>,
    /// Number of falls.
    pub(crate) falls: u32,
}

impl<'a> ProgramState<'a> {
    /// Returns the state before the first cycle.
    pub(crate) fn new(recording: &'a Recording) -> Self {
        ProgramState {
            recording,
            step: None,
            command: None,
            message: "",
            lamps: BTreeSet::new(),
            values: vec![None; recording.script.scalars.len()],
            falls: 0,
        }
    }

    /// Takes the next entry of the log.
    pub(crate) fn take(&mut self, entry: &'a LogEntry) {
        match &entry.what {
            Occurrence::Step(step) => self.step = Some(*step),
            Occurrence::Command(command) => self.command = Some((entry.cycle, command)),
            Occurrence::Message(text) => self.message = text,
            Occurrence::Lamp(lamp, true) => {
                self.lamps.insert(*lamp);
            }
            Occurrence::Lamp(lamp, false) => {
                self.lamps.remove(lamp);
            }
            Occurrence::Assigned { scalar, value } => {
                if let Some(slot) = self.values.get_mut(*scalar) {
                    *slot = Some(*value);
                }
            }
            Occurrence::Fall { count, .. } => self.falls = *count,
            _ => {}
        }
    }

    /// Returns the step that ran in a cycle, whose entries were taken last; none after the end of the program.
    pub(crate) fn step(&self, cycle: u64) -> Option<u32> {
        self.step.filter(|_| cycle < self.recording.cycles)
    }

    /// Returns the source line of that step, from 1.
    pub(crate) fn line(&self, cycle: u64) -> Option<u32> {
        let step = self.step(cycle)?;
        self.recording.script.lines.get(step as usize).copied()
    }
}
