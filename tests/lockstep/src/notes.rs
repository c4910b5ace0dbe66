//! What one side of a comparison notes of its run.

use std::fmt::{self, Display, Write as _};
use tip_runtime::command::{Command, Value};
use tip_runtime::hardware::JointCommand;
use tip_runtime::program::Program;
use tip_runtime::record::{Cycle, Sink};

/// A hash of words that goes on and on. Each word is taken in by a one-to-one map, so that one that differs is never lost
/// to those behind it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Hash(u64);

impl Hash {
    /// The odd constant of FxHash (the hash of the compiler rustc).
    const FACTOR: u64 = 0x517c_c1b7_2722_0a95;

    pub(crate) fn add(&mut self, word: u64) {
        self.0 = (self.0.rotate_left(5) ^ word).wrapping_mul(Self::FACTOR);
    }

    pub(crate) fn value(self) -> u64 {
        self.0
    }
}

impl fmt::Write for Hash {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        text.bytes().for_each(|byte| self.add(u64::from(byte)));
        Ok(())
    }
}

/// Hashes each cycle; on demand also in words.
#[derive(Debug)]
pub(crate) struct Notes {
    pub(crate) hash: Hash,
    /// How often each step came to its end.
    pub(crate) visits: Vec<u64>,
    /// The cycle under way in words, if they are wanted.
    pub(crate) words: Option<String>,
}

impl Notes {
    pub(crate) fn new(steps: usize) -> Self {
        Notes {
            hash: Hash::default(),
            visits: vec![0; steps],
            words: None,
        }
    }

    fn tell(&mut self, what: fmt::Arguments<'_>) {
        if let Some(words) = &mut self.words {
            writeln!(words, "  {what}").expect("writing to a string");
        }
    }

    fn variables(&mut self, program: &dyn Program) {
        for n in 0.. {
            let Some((name, value)) = program.scalar(n) else {
                break;
            };
            self.hash.add(value.map_or(u64::MAX, f64::to_bits));
            self.tell(format_args!("{name} is {value:?}"));
        }
    }

    fn joints(&mut self, cycle: &Cycle<'_>) {
        let mut kinds = 0;
        for (n, (command, angle)) in cycle.commands.iter().zip(cycle.angles).enumerate() {
            kinds = kinds * 2 + u64::from(matches!(command, JointCommand::Torque(_)));
            self.hash.add(command.value().to_bits());
            self.hash.add(angle.to_bits());
            self.tell(format_args!(
                "joint {n} is at {angle:?} and told {command:?}"
            ));
        }
        self.hash.add(kinds);
    }
}

impl Sink for Notes {
    fn begin(&mut self, program: &dyn Program) {
        if let Some(words) = &mut self.words {
            words.clear();
        }
        let at = program.at();
        self.tell(format_args!("step {at}, line {}", program.line(at)));
    }

    fn command(&mut self, command: &Command<'_>) {
        self.hash.add(command.op as u64 * 2 + u64::from(command.hs));
        write!(self.hash, "{}", command.target).expect("a hash takes every text");
        for value in command.values {
            self.hash.add(value.number().to_bits());
            self.hash
                .add(u64::from(matches!(value, Value::Relative(_))));
        }
        self.tell(format_args!("{command:?}"));
    }

    fn say(&mut self, text: &dyn Display) {
        write!(self.hash, "{text}").expect("a hash takes every text");
        self.tell(format_args!("says {text}"));
    }

    fn lamp(&mut self, device: u8, on: bool) {
        self.hash.add(u64::from(device) * 2 + u64::from(on));
        self.tell(format_args!("lamp {device} {on}"));
    }

    fn cycle(&mut self, cycle: &Cycle<'_>) {
        let next = cycle.next.map_or(u64::MAX, u64::from);
        self.hash.add(cycle.number);
        self.hash.add(u64::from(cycle.step));
        self.hash.add(next);
        self.tell(format_args!("next {:?}", cycle.next));
        self.variables(cycle.program);
        self.joints(cycle);
        // A step that waits is its own next one.
        if cycle.next != Some(cycle.step)
            && let Some(visits) = self.visits.get_mut(cycle.step as usize)
        {
            *visits += 1;
        }
    }
}
