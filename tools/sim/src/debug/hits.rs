//! How often a breakpoint is passed before it stops a run.

use crate::message::Debugging;
use std::fmt;
use std::str::FromStr;

/// Which passes of a breakpoint stop a run, counted from its start. As text: `5` or `== 5`, `> 5`, `>= 5`, `% 5`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hits {
    /// This one alone.
    Only(u64),
    /// This one and those after it.
    From(u64),
    /// Every so many.
    Each(u64),
}

impl Hits {
    /// Returns true if pass `n`, counted from 1, stops a run.
    pub fn has(self, n: u64) -> bool {
        match self {
            Hits::Only(only) => n == only,
            Hits::From(first) => n >= first,
            Hits::Each(each) => n.is_multiple_of(each),
        }
    }
}

/// A text that does not say which passes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NotHits(pub(super) String);

impl NotHits {
    pub(super) fn message(&self) -> Debugging {
        Debugging::NoCountOfHits {
            text: self.0.clone().into(),
        }
    }
}

impl fmt::Display for NotHits {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.message().fmt(f)
    }
}

impl std::error::Error for NotHits {}

impl FromStr for Hits {
    type Err = NotHits;

    fn from_str(text: &str) -> Result<Self, NotHits> {
        let text = text.trim();
        let digits = text.find(|char: char| char.is_ascii_digit());
        let (sign, number) = text.split_at(digits.unwrap_or(text.len()));
        let hits = number.parse().ok().and_then(|n: u64| match sign.trim() {
            "" | "=" | "==" => Some(Hits::Only(n)),
            ">=" => Some(Hits::From(n)),
            ">" => Some(Hits::From(n.saturating_add(1))),
            "%" if n > 0 => Some(Hits::Each(n)),
            _ => None,
        });
        hits.ok_or_else(|| NotHits(text.to_owned()))
    }
}
