//! The event flags of conditions (T.I.P. 3.1 §6-2).

use super::{Target, UnknownWord};
use core::fmt;
use core::str::FromStr;

/// An event flag of a condition (T.I.P. 3.1 §6-2).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Flag {
    /// A stop of the program at the next good moment was requested.
    HaltRequest,
    /// The keyboard buffer is not empty.
    KbHit,
    /// The target has arrived within the JUST tolerance.
    Inpos(Target),
    /// The target has arrived within the NEAR tolerance.
    Near(Target),
    /// `SPECIAL_FLAG0…9`, set by native code.
    Special(u8),
    /// The palm touches (Hiroshima Hand).
    Antenna,
}

impl Flag {
    /// Returns the flag's word, or its prefix where a target or a digit follows.
    pub const fn stem(self) -> &'static str {
        match self {
            Flag::HaltRequest => "HALT_REQUEST",
            Flag::KbHit => "KB_HIT",
            Flag::Inpos(_) => "INPOS_",
            Flag::Near(_) => "NEAR_",
            Flag::Special(_) => "SPECIAL_FLAG",
            Flag::Antenna => "ANTENNA_ON",
        }
    }

    /// Returns the alternative prefix of the flag's word.
    pub const fn other_stem(self) -> Option<&'static str> {
        match self {
            Flag::Inpos(_) => Some("IN_POS_"),
            _ => None,
        }
    }

    /// Returns the target whose arrival the flag signals.
    pub const fn target(self) -> Option<Target> {
        match self {
            Flag::Inpos(target) | Flag::Near(target) => Some(target),
            _ => None,
        }
    }
}

impl fmt::Display for Flag {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.stem())?;
        match self {
            Flag::Inpos(target) | Flag::Near(target) => write!(f, "{target}"),
            Flag::Special(number) => write!(f, "{number}"),
            Flag::HaltRequest | Flag::KbHit | Flag::Antenna => Ok(()),
        }
    }
}

impl FromStr for Flag {
    type Err = UnknownWord;

    /// Parses a name in capital letters, in either spelling. The slider is refused: it has no
    /// arrival.
    fn from_str(word: &str) -> Result<Self, UnknownWord> {
        let behind = |of: Flag| {
            let other = || word.strip_prefix(of.other_stem()?);
            word.strip_prefix(of.stem()).or_else(other)
        };
        let awaited = |word: &str| match word.parse()? {
            Target::Floor => Err(UnknownWord),
            target => Ok(target),
        };
        if let Some(target) = behind(Flag::Inpos(Target::All)) {
            return awaited(target).map(Flag::Inpos);
        }
        if let Some(target) = behind(Flag::Near(Target::All)) {
            return awaited(target).map(Flag::Near);
        }
        match behind(Flag::Special(0)).map(str::as_bytes) {
            Some([digit @ b'0'..=b'9']) => Ok(Flag::Special(digit - b'0')),
            _ => [Flag::HaltRequest, Flag::KbHit, Flag::Antenna]
                .into_iter()
                .find(|flag| flag.stem() == word)
                .ok_or(UnknownWord),
        }
    }
}
