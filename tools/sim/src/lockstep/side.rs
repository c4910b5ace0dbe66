//! One engine on a simulated robot of its own.

use super::Evidence;
use super::notes::{Notes, Shown};
use crate::interp::Interpreter;
use crate::run::Run;
use crate::trace::both;
use tip_lint::spots::Place;
use tip_runtime::record::JsonLines;
use tip_runtime::record::{Ending, Sink};

/// A run, and what is noted of it.
pub(super) struct Side {
    run: Run,
    tape: Tape,
    ending: Option<Ending>,
}

enum Tape {
    /// What the last cycle left.
    Record(Box<JsonLines<String>>),
    Hash(Notes),
}

impl Tape {
    /// What a cycle is written to.
    fn sink(&mut self) -> &mut dyn Sink {
        match self {
            Tape::Record(record) => record.as_mut(),
            Tape::Hash(notes) => notes,
        }
    }
}

impl Side {
    /// A run before its first cycle.
    pub(super) fn new(run: Run, evidence: Evidence) -> Self {
        let (run, tape) = match evidence {
            Evidence::Records => {
                let record = Box::new(JsonLines::new(String::new(), true));
                (run, Tape::Record(record))
            }
            Evidence::Hashes => (
                run.with_console(Shown::default()),
                Tape::Hash(Notes::default()),
            ),
        };
        Side {
            run,
            tape,
            ending: None,
        }
    }

    /// Runs a cycle, unless `limit` are used up, reports it to `sink`, and returns whether that was the end.
    pub(super) fn cycle(&mut self, limit: u64, sink: Option<&mut dyn Sink>) -> Option<Ending> {
        if let Tape::Record(record) = &mut self.tape {
            record.get_mut().clear();
        }
        self.ending = if self.run.cycles() >= limit {
            Some(Ending::Limit)
        } else {
            both(Some(self.tape.sink()), sink, |sink| self.run.advance(sink));
            self.run.ending()
        };
        if let (Tape::Record(record), Some(ending)) = (&mut self.tape, self.ending) {
            record.end(ending, self.run.cycles());
        }
        self.ending
    }

    /// Whether it equals the other side.
    pub(super) fn equals(&self, other: &Side) -> bool {
        let is_same = match (&self.tape, &other.tape) {
            (Tape::Record(one), Tape::Record(other)) => one.get_ref() == other.get_ref(),
            (Tape::Hash(one), Tape::Hash(other)) => one.hash == other.hash,
            _ => false,
        };
        is_same && self.ending == other.ending && self.shown() == other.shown()
    }

    /// The same of what the console was shown.
    fn shown(&self) -> Option<&Shown> {
        self.run.console()
    }

    /// A hash of everything so far; 0 if there is none.
    pub(super) fn hash(&self) -> u64 {
        match &self.tape {
            Tape::Record(_) => 0,
            Tape::Hash(notes) => notes.hash.value(),
        }
    }

    /// Runs a cycle, and returns what happens in it.
    pub(super) fn in_words(&mut self, limit: u64) -> String {
        self.tape = Tape::Hash(Notes::in_words());
        self.cycle(limit, None);
        let words = match &mut self.tape {
            Tape::Record(_) => None,
            Tape::Hash(notes) => notes.words.take(),
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

    /// Control cycles whose step ran without a fault.
    pub(super) fn cycles(&self) -> u64 {
        self.run.cycles()
    }

    /// Where the interpreter is; compiled code gives its step only.
    pub(super) fn place(&self) -> Place {
        match self.run.engine::<Interpreter>() {
            Some(interpreter) => interpreter.place(),
            None => Place {
                step: self.run.program().at(),
                not_taken: false,
            },
        }
    }
}

/// The first records that differ; the last cycle has two.
pub(super) fn first_difference(interpreted: &Side, compiled: &Side) -> [String; 2] {
    let lines = |side: &Side| -> Vec<String> {
        let Tape::Record(record) = &side.tape else {
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
    [at(&left), at(&right)]
}
