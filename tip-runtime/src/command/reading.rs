//! The special variables of edition 3.2: what a program reads of the robot and of its timers
//! without a command.

use super::{Target, Teach, UnknownWord};
use core::fmt;
use core::str::FromStr;

/// `@`: the first character of the words of special variables.
pub const READING: char = '@';

/// Number of timers of a program.
pub const TIMERS: u8 = 8;

/// First characters of the words of timers.
const TIMER: &str = "@TIMER";

/// A special variable. Its value is the one of the present cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Reading {
    /// `@TIMERn`: the time of timer n, 0…7, in ms.
    Timer(u8),
    /// `@AGL_J11`, `@POS_F1` and so on: what a TEACH_ command measures at a foot or joint.
    Measured(Teach, Target),
}

/// Each quantity that a special variable measures, with what its words begin with, and true if it is measured at joints too.
const QUANTITIES: [(Teach, &str, bool); 4] = [
    (Teach::Angle, "@AGL_", true),
    (Teach::Torque, "@TRQ_", true),
    (Teach::Position, "@POS_", false),
    (Teach::Force, "@FORCE_", false),
];

impl Reading {
    /// Returns one reading of each kind, in the order of the language's reference.
    pub const KINDS: [Reading; 7] = [
        Reading::Measured(Teach::Angle, Target::Joint(1, 1)),
        Reading::Measured(Teach::Torque, Target::Joint(1, 1)),
        Reading::Measured(Teach::Angle, Target::Foot(1)),
        Reading::Measured(Teach::Torque, Target::Foot(1)),
        Reading::Measured(Teach::Position, Target::Foot(1)),
        Reading::Measured(Teach::Force, Target::Foot(1)),
        Reading::Timer(0),
    ];

    /// Returns the part of the robot that is measured.
    pub const fn target(self) -> Option<Target> {
        match self {
            Reading::Timer(_) => None,
            Reading::Measured(_, target) => Some(target),
        }
    }

    /// Returns what the reading's word begins with; `F`, `J` and digits follow.
    pub const fn stem(self) -> &'static str {
        match self {
            Reading::Timer(_) => TIMER,
            Reading::Measured(Teach::Angle, _) => QUANTITIES[0].1,
            Reading::Measured(Teach::Torque, _) => QUANTITIES[1].1,
            Reading::Measured(Teach::Position, _) => QUANTITIES[2].1,
            Reading::Measured(Teach::Force, _) => QUANTITIES[3].1,
        }
    }
}

impl fmt::Display for Reading {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.stem())?;
        match self {
            Reading::Timer(number) => write!(f, "{number}"),
            Reading::Measured(_, target) => target.fmt(f),
        }
    }
}

impl FromStr for Reading {
    type Err = UnknownWord;

    /// Parses a word in capital letters, of any leg and joint that the language can name.
    fn from_str(word: &str) -> Result<Self, UnknownWord> {
        if let Some([digit @ b'0'..=b'7']) = word.strip_prefix(TIMER).map(str::as_bytes) {
            return Ok(Reading::Timer(digit - b'0'));
        }
        for (what, stem, of_joints) in QUANTITIES {
            let target = word.strip_prefix(stem).and_then(|word| word.parse().ok());
            match target {
                Some(target @ Target::Foot(_)) => return Ok(Reading::Measured(what, target)),
                Some(target @ Target::Joint(..)) if of_joints => {
                    return Ok(Reading::Measured(what, target));
                }
                _ => {}
            }
        }
        Err(UnknownWord)
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use super::{Reading, Target, Teach};
    use std::string::ToString;

    // clauses: 13.2
    #[test]
    fn a_special_variable_is_read_by_its_word() {
        let measured = Reading::Measured;
        for (word, reading) in [
            ("@TIMER0", Reading::Timer(0)),
            ("@TIMER7", Reading::Timer(7)),
            ("@AGL_J23", measured(Teach::Angle, Target::Joint(2, 3))),
            ("@AGL_F4", measured(Teach::Angle, Target::Foot(4))),
            ("@TRQ_J11", measured(Teach::Torque, Target::Joint(1, 1))),
            ("@TRQ_F1", measured(Teach::Torque, Target::Foot(1))),
            ("@POS_F9", measured(Teach::Position, Target::Foot(9))),
            ("@FORCE_F2", measured(Teach::Force, Target::Foot(2))),
        ] {
            assert_eq!(word.parse(), Ok(reading), "{word}");
            assert_eq!(reading.to_string(), word);
        }
        for word in [
            "TIMER0",
            "@TIMER",
            "@TIMER8",
            "@TIMER00",
            "@POS_J11",
            "@FORCE_J12",
            "@AGL_ALL",
            "@POS_FLOOR",
            "@AGL_F0",
            "@AGL_J1",
            "@AGL_",
            "@",
            "@@TIMER0",
            "@X",
        ] {
            assert!(word.parse::<Reading>().is_err(), "{word}");
        }
    }
}
