//! One engine on a simulated robot of its own.

use super::Evidence;
use crate::run::Run;
use crate::trace::tee;
use std::fmt::{self, Display, Write as _};
use tip_runtime::command::{Command, Value};
use tip_runtime::console::{Bars, Console};
use tip_runtime::hardware::JointCommand;
use tip_runtime::machine::Report;
use tip_runtime::program::Program;
use tip_runtime::record::{Cycle, Dump, Ending, JsonLines, Sample, Sink};
use tipc::program::StepId;

/// A run, and the record of its cycles.
pub(super) struct Side {
    run: Run,
    record: CycleRecord,
    ending: Option<Ending>,
}

enum CycleRecord {
    /// The record of the last cycle.
    Record(Box<JsonLines<String>>),
    Hash(HashedCycles),
}

impl CycleRecord {
    /// Returns the sink that a cycle is written to.
    fn sink(&mut self) -> &mut dyn Sink {
        match self {
            CycleRecord::Record(record) => record.as_mut(),
            CycleRecord::Hash(notes) => notes,
        }
    }
}

impl Side {
    /// Creates a run before its first cycle.
    pub(super) fn new(run: Run, evidence: Evidence) -> Self {
        let (run, record) = match evidence {
            Evidence::Records => {
                let record = Box::new(JsonLines::new(String::new(), true));
                (run, CycleRecord::Record(record))
            }
            Evidence::Hashes => (
                run.with_console(Shown::default()),
                CycleRecord::Hash(HashedCycles::default()),
            ),
        };
        Side {
            run,
            record,
            ending: None,
        }
    }

    /// Runs a cycle, unless `limit` cycles are used up, and reports it to `sink`. Returns the ending if the run has
    /// ended.
    pub(super) fn cycle(&mut self, limit: u64, sink: Option<&mut dyn Sink>) -> Option<Ending> {
        if let CycleRecord::Record(record) = &mut self.record {
            record.get_mut().clear();
        }
        self.ending = if self.run.cycles() >= limit {
            Some(Ending::Limit)
        } else {
            tee(Some(self.record.sink()), sink, |sink| {
                self.run.advance(sink)
            });
            self.run.ending()
        };
        if let (CycleRecord::Record(record), Some(ending)) = (&mut self.record, self.ending) {
            record.end(ending, self.run.cycles());
        }
        self.ending
    }

    /// Returns true if it equals the other side.
    pub(super) fn equals(&self, other: &Side) -> bool {
        let is_same = match (&self.record, &other.record) {
            (CycleRecord::Record(one), CycleRecord::Record(other)) => {
                one.get_ref() == other.get_ref()
            }
            (CycleRecord::Hash(one), CycleRecord::Hash(other)) => one.hash == other.hash,
            _ => false,
        };
        is_same && self.ending == other.ending && self.shown() == other.shown()
    }

    /// Returns the output of the console.
    fn shown(&self) -> Option<&Shown> {
        self.run.console()
    }

    /// Returns a hash of all cycles so far; 0 if records are compared.
    pub(super) fn hash(&self) -> u64 {
        match &self.record {
            CycleRecord::Record(_) => 0,
            CycleRecord::Hash(notes) => notes.hash.value(),
        }
    }

    /// Runs a cycle, and returns what happens in it.
    pub(super) fn in_words(&mut self, limit: u64) -> String {
        self.record = CycleRecord::Hash(HashedCycles::in_words());
        self.cycle(limit, None);
        let words = match &mut self.record {
            CycleRecord::Record(_) => None,
            CycleRecord::Hash(notes) => notes.words.take(),
        };
        let words = words.unwrap_or_default();
        match self.ending {
            Some(Ending::Emergency(emergency)) => format!("{words}  {emergency}\n"),
            Some(ending) => format!("{words}  {ending:?}\n"),
            None => format!("{words}  Running\n"),
        }
    }

    pub(super) fn run(&self) -> &Run {
        &self.run
    }

    /// Returns the number of control cycles whose step ran without a fault.
    pub(super) fn cycles(&self) -> u64 {
        self.run.cycles()
    }

    /// Returns the step of the `n`th record of the last cycle, or the one that failed behind it.
    pub(super) fn step(&self, n: usize) -> StepId {
        let ran = self.run.steps().get(n).map(|step| step.from.step);
        let failed = || self.run.emergency().map(|emergency| emergency.step);
        ran.or_else(failed)
            .unwrap_or_else(|| self.run.program().at())
    }
}

/// Returns the number of equal records at the start of a cycle, and the first records that differ.
pub(super) fn first_difference(interpreted: &Side, compiled: &Side) -> (usize, [String; 2]) {
    let lines = |side: &Side| -> Vec<String> {
        let CycleRecord::Record(record) = &side.record else {
            return Vec::new();
        };
        record.get_ref().lines().map(str::to_owned).collect()
    };
    let (left, right) = (lines(interpreted), lines(compiled));
    let same = left.iter().zip(&right).take_while(|(a, b)| a == b).count();
    let at = |lines: &[String]| {
        let line = lines.get(same).map(String::as_str);
        line.unwrap_or("(no record)").to_owned()
    };
    (same, [at(&left), at(&right)])
}

/// A running hash of words. Each word changes it by a one-to-one map, so that later words never hide a difference.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Hash(u64);

impl Hash {
    /// The odd constant of FxHash (the hash of the compiler rustc).
    const FACTOR: u64 = 0x517c_c1b7_2722_0a95;

    pub(super) fn add(&mut self, word: u64) {
        self.0 = (self.0.rotate_left(5) ^ word).wrapping_mul(Self::FACTOR);
    }

    pub(super) fn value(self) -> u64 {
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
#[derive(Debug, Default)]
pub(super) struct HashedCycles {
    pub(super) hash: Hash,
    /// The present cycle in words, if they are wanted.
    pub(super) words: Option<String>,
    /// True if more steps of the present cycle may follow.
    goes_on: bool,
}

impl HashedCycles {
    /// Creates a hash that also writes each cycle in words.
    pub(super) fn in_words() -> Self {
        HashedCycles {
            words: Some(String::new()),
            ..HashedCycles::default()
        }
    }

    fn note(&mut self, what: fmt::Arguments<'_>) {
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
            self.note(format_args!("{name} is {value:?}"));
        }
    }

    fn joints(&mut self, cycle: &Cycle<'_>) {
        let mut kinds = 0;
        for (n, (command, angle)) in cycle
            .sample
            .commands
            .iter()
            .zip(cycle.sample.angles)
            .enumerate()
        {
            kinds = kinds * 2 + u64::from(matches!(command, JointCommand::Torque(_)));
            self.hash.add(command.value().to_bits());
            self.hash.add(angle.to_bits());
            self.note(format_args!(
                "joint {n} is at {angle:?} and told {command:?}"
            ));
        }
        self.hash.add(kinds);
    }
}

impl Sink for HashedCycles {
    fn begin(&mut self, program: &dyn Program) {
        if let (Some(words), false) = (&mut self.words, self.goes_on) {
            words.clear();
        }
        self.goes_on = true;
        let at = program.at();
        self.note(format_args!("step {at}, line {}", program.line(at)));
    }

    fn command(&mut self, command: &Command<'_>) {
        self.hash.add(command.op as u64 * 2 + u64::from(command.hs));
        write!(self.hash, "{}", command.target).expect("a hash takes every text");
        for value in command.values {
            self.hash.add(value.number().to_bits());
            self.hash.add(match value {
                Value::Absolute(_) => 0,
                Value::Relative(_) => 1,
                Value::Fixed(_) => 2,
            });
        }
        self.note(format_args!("{command:?}"));
    }

    fn say(&mut self, text: &dyn Display) {
        write!(self.hash, "{text}").expect("a hash takes every text");
        self.note(format_args!("says {text}"));
    }

    fn out(&mut self, text: &dyn Display) {
        write!(self.hash, "{text}").expect("a hash takes every text");
        self.note(format_args!("appends {text}"));
    }

    fn lamp(&mut self, device: u8, on: bool) {
        self.hash.add(u64::from(device) * 2 + u64::from(on));
        self.note(format_args!("lamp {device} {on}"));
    }

    fn cycle(&mut self, cycle: &Cycle<'_>) {
        let next = cycle.next.map_or(u64::MAX, u64::from);
        self.hash.add(cycle.sample.cycle);
        self.hash.add(u64::from(cycle.step));
        self.hash.add(next);
        self.note(format_args!("next {:?}", cycle.next));
        if let Some(thread) = cycle.thread {
            write!(self.hash, "{thread}").expect("a hash takes every text");
            self.note(format_args!("thread {thread}"));
        }
        self.variables(cycle.program);
        if cycle.last {
            self.joints(cycle);
            self.goes_on = false;
        }
    }
}

/// Hashes what a console is shown.
#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct Shown(Hash);

impl Shown {
    fn show(&mut self, text: &dyn Display) {
        write!(self.0, "{text}").expect("a hash takes every text");
    }
}

impl Console for Shown {
    fn append(&mut self, text: &dyn Display) {
        self.show(text);
    }

    fn silent(&mut self, on: bool) {
        self.0.add(u64::from(on));
    }

    fn bars(&mut self, graph: u8, bars: Bars<'_>) {
        self.0.add(u64::from(graph));
        bars.0.iter().for_each(|share| self.0.add(share.to_bits()));
    }

    fn sample(&mut self, sample: &Sample<'_>) {
        self.0.add(sample.cycle);
        self.0.add(sample.time.to_bits());
        let sensed = [sample.torques, sample.paws, sample.knobs, &[sample.antenna]];
        sensed
            .concat()
            .iter()
            .for_each(|value| self.0.add(value.to_bits()));
    }

    fn variables(&mut self, dump: &Dump<'_>) {
        self.show(dump);
    }

    fn emergency(&mut self, report: &Report<'_>) {
        self.show(report);
    }

    fn ended(&mut self) {
        self.0.add(u64::MAX);
    }
}
