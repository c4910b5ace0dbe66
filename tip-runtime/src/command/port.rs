//! The analogue inputs.

use super::{MAX, Target, UnknownWord};
use core::fmt;
use core::ops::Range;
use core::str::FromStr;

/// Number of potentiometers of the control box.
pub const KNOBS: usize = 3;

/// Number of soles whose pressure sensor has a name.
const PAWS: u8 = 4;

/// An analogue input, read in volts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Port {
    /// A channel of the A/D board, 0…15.
    Channel(u8),
    /// `VR1…VR3`: the potentiometers of the control box.
    Knob(u8),
    /// `Jnm`: a joint's potentiometer.
    Joint(u8, u8),
    /// `PAW1…PAW4`: the pressure sensor of a sole.
    Paw(u8),
    /// `ANTENNA`: the feeler (TITAN VIII) or palm touch (Hiroshima Hand).
    Antenna,
}

impl Port {
    /// Returns the input's word, or its prefix where digits follow; a channel has only its number.
    pub const fn stem(self) -> &'static str {
        match self {
            Port::Channel(_) => "",
            Port::Knob(_) => "VR",
            Port::Joint(leg, joint) => Target::Joint(leg, joint).stem(),
            Port::Paw(_) => "PAW",
            Port::Antenna => "ANTENNA",
        }
    }

    /// Returns the joint of a joint potentiometer.
    pub const fn joint(self) -> Option<Target> {
        match self {
            Port::Joint(leg, joint) => Some(Target::Joint(leg, joint)),
            _ => None,
        }
    }

    /// Maximum number of inputs of a robot that are neither channels nor joints.
    pub const INPUTS: usize = Port::Antenna.places().end;

    /// Returns the index range of all inputs of the kind of `self`; empty for channels and joints.
    pub const fn places(self) -> Range<usize> {
        let (first, count) = match self {
            Port::Channel(_) | Port::Joint(..) => (0, 0),
            Port::Knob(_) => (0, KNOBS),
            Port::Paw(_) => (Port::Knob(1).places().end, MAX),
            Port::Antenna => (Port::Paw(1).places().end, 1),
        };
        Range {
            start: first,
            end: first + count,
        }
    }

    /// Returns the index of this input; `None` for a channel, a joint, or a number that no robot
    /// has.
    pub fn place(self) -> Option<usize> {
        let number = match self {
            Port::Channel(_) | Port::Joint(..) => return None,
            Port::Knob(number) | Port::Paw(number) => number,
            Port::Antenna => 1,
        };
        self.places().nth(usize::from(number).checked_sub(1)?)
    }

    /// Iterates over the named inputs of the kind of `self`, except joints.
    pub fn named(self) -> impl Iterator<Item = Port> {
        let count = match self {
            Port::Channel(_) | Port::Joint(..) => 0,
            Port::Knob(_) => KNOBS as u8,
            Port::Paw(_) => PAWS,
            Port::Antenna => 1,
        };
        (1..=count).map(move |number| match self {
            Port::Knob(_) => Port::Knob(number),
            Port::Paw(_) => Port::Paw(number),
            other => other,
        })
    }
}

impl fmt::Display for Port {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.stem())?;
        match self {
            Port::Channel(number) | Port::Knob(number) | Port::Paw(number) => {
                write!(f, "{number}")
            }
            Port::Joint(leg, joint) => write!(f, "{leg}{joint}"),
            Port::Antenna => Ok(()),
        }
    }
}

impl FromStr for Port {
    type Err = UnknownWord;

    /// Parses a name in capital letters. Channels are refused: a bare number names no input.
    fn from_str(word: &str) -> Result<Self, UnknownWord> {
        let numbered = |kind: Port, last: u8| match word.strip_prefix(kind.stem())?.as_bytes() {
            [digit @ b'1'..=b'9'] if digit - b'0' <= last => Some(digit - b'0'),
            _ => None,
        };
        if let Some(knob) = numbered(Port::Knob(1), KNOBS as u8) {
            return Ok(Port::Knob(knob));
        }
        if let Some(paw) = numbered(Port::Paw(1), PAWS) {
            return Ok(Port::Paw(paw));
        }
        match word.parse() {
            Ok(Target::Joint(leg, joint)) => Ok(Port::Joint(leg, joint)),
            _ if word == Port::Antenna.stem() => Ok(Port::Antenna),
            _ => Err(UnknownWord),
        }
    }
}
