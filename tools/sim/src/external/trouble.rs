//! What may be wrong with a plant that is another process.

use super::line::{CYCLE, HELLO, LONGEST, NUMBER, VERSION};
use crate::message::Simulating;
use std::fmt;
use std::time::Duration;
use tip_runtime::printable::Printable;
use tipc::message::{Lang, Text};

/// Which line an answer is to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Head {
    /// The first one.
    Hello,
    /// That of a control cycle.
    Cycle(u64),
}

impl fmt::Display for Head {
    /// As the line begins.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Head::Hello => f.write_str(HELLO),
            Head::Cycle(number) => write!(f, "{CYCLE} {NUMBER}={number}"),
        }
    }
}

/// How a process ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ended {
    /// By itself, with this status.
    Exit(i32),
    /// By a signal.
    Killed,
    /// It goes on, but has closed its standard output.
    Closed,
}

/// What is wrong with an external plant.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
#[expect(missing_docs, reason = "the fields are what the messages name")]
pub enum Trouble {
    /// An answer takes too long.
    NoAnswer { to: Head, within: Duration },
    /// The process ended before it answered.
    Ended { to: Head, ended: Ended },
    /// An answer has no end.
    TooLong { to: Head },
    /// An answer is not UTF-8.
    NotText { to: Head },
    /// A line that does not begin as an answer.
    Garbage {
        to: Head,
        line: String,
        begins: &'static str,
    },
    /// A word that is not `KEY=VALUES` with a key of this answer.
    Word { to: Head, word: String },
    /// A key that occurs twice.
    Twice { to: Head, key: &'static str },
    /// A key that is needed.
    Missing { to: Head, key: &'static str },
    /// Another version of the protocol.
    Version { found: String },
    /// The answer to another cycle.
    Cycle { to: Head, found: String },
    /// Too few numbers, or too many.
    Count {
        to: Head,
        key: &'static str,
        wanted: usize,
        found: usize,
    },
    /// Not a number.
    NotNumber {
        to: Head,
        key: &'static str,
        place: String,
        word: String,
    },
    /// Infinite, or not a number by name.
    NotFinite {
        to: Head,
        key: &'static str,
        place: String,
    },
    /// The run is a copy of one that has a process.
    Copy,
}

impl Trouble {
    /// The word of the emergency stop.
    pub fn word(&self) -> &'static str {
        match self {
            Trouble::NoAnswer { .. } => "plant: no answer",
            Trouble::Ended { .. } => "plant: ended",
            Trouble::Copy => "plant: a copy has no process",
            Trouble::Version { .. } => "plant: other version",
            Trouble::Cycle { .. } => "plant: answer to another cycle",
            Trouble::NotFinite { .. } => "plant: answer is not finite",
            Trouble::TooLong { .. }
            | Trouble::NotText { .. }
            | Trouble::Garbage { .. }
            | Trouble::Word { .. }
            | Trouble::Twice { .. }
            | Trouble::Missing { .. }
            | Trouble::Count { .. }
            | Trouble::NotNumber { .. } => "plant: wrong answer",
        }
    }

    /// What is wrong, and where, as a message.
    pub fn message(&self) -> Simulating {
        let head = |to: &Head| Text::from(to.to_string());
        let text = |said: &String| Printable::line(said).to_string();
        match self {
            Trouble::NoAnswer { to, within } => Simulating::NoAnswer {
                to: head(to),
                seconds: within.as_secs_f64().to_string().into(),
            },
            Trouble::Ended { to, ended } => {
                let to = head(to);
                match ended {
                    Ended::Exit(status) => Simulating::Exited {
                        to,
                        status: status.to_string().into(),
                    },
                    Ended::Killed => Simulating::Killed { to },
                    Ended::Closed => Simulating::Closed { to },
                }
            }
            Trouble::TooLong { to } => Simulating::TooLong {
                to: head(to),
                bytes: LONGEST.to_string().into(),
            },
            Trouble::NotText { to } => Simulating::NotText { to: head(to) },
            Trouble::Garbage { to, line, begins } => Simulating::NotAnswer {
                to: head(to),
                line: text(line),
                begins,
            },
            Trouble::Word { to, word } => Simulating::UnknownWord {
                to: head(to),
                word: text(word),
            },
            Trouble::Twice { to, key } => Simulating::Twice { to: head(to), key },
            Trouble::Missing { to, key } => Simulating::Missing { to: head(to), key },
            Trouble::Version { found } => Simulating::OtherVersion {
                found: text(found),
                version: VERSION.to_string().into(),
            },
            Trouble::Cycle { to, found } => Simulating::OtherCycle {
                to: head(to),
                found: text(found),
            },
            Trouble::Count {
                to,
                key,
                wanted,
                found,
            } => Simulating::OtherCount {
                to: head(to),
                key,
                wanted: wanted.to_string().into(),
                found: found.to_string().into(),
            },
            Trouble::NotNumber {
                to,
                key,
                place,
                word,
            } => Simulating::NotNumber {
                to: head(to),
                key,
                place: place.clone().into(),
                word: text(word),
            },
            Trouble::NotFinite { to, key, place } => Simulating::NotFinite {
                to: head(to),
                key,
                place: place.clone().into(),
            },
            Trouble::Copy => Simulating::Copy,
        }
    }
}

impl fmt::Display for Trouble {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.message().in_lang(Lang::English).fmt(f)
    }
}

impl std::error::Error for Trouble {}
