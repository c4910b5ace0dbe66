//! The vocabulary of robot commands: commands, targets, values, inputs and event flags.
//!
//! Each word is spelled here and nowhere else: `Display` writes a word of the language, `FromStr`
//! reads it.
//!
//! ```
//! use tip_runtime::command::{Flag, Op, Port, Target, Value};
//!
//! assert_eq!("J23".parse(), Ok(Target::Joint(2, 3)));
//! assert_eq!("PTP_ANGLE".parse(), Ok(Op::PtpAngle));
//! assert_eq!(Port::Knob(1).to_string(), "VR1");
//! assert_eq!(Flag::Inpos(Target::Foot(4)).to_string(), "INPOS_F4");
//! assert_eq!(Value::Relative(10.0).to_string(), "R10.0");
//! ```

mod op;

pub use op::Op;

use core::fmt;
use core::ops::Range;
use core::str::FromStr;

/// Maximum number of legs, and of joints on a leg, that the language can name (`F1…F9`, `J11…J99`).
pub const MAX: usize = 9;

/// `R`: the value after it is relative to the current state.
pub const RELATIVE: &str = "R";

/// `A`: the value after it is absolute.
pub const ABSOLUTE: &str = "A";

/// `HS`: the motion is not limited in its acceleration.
pub const FAST: &str = "HS";

/// `CHAR_`: the prefix of the names of the language's constants.
pub const CONSTANT: &str = "CHAR_";

/// The error for a text that names nothing of the requested kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct UnknownWord;

impl fmt::Display for UnknownWord {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("unknown word")
    }
}

impl core::error::Error for UnknownWord {}

/// One evaluated operand of a command.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// A number without a prefix. It is relative to the target in commands of relative motion.
    Absolute(f64),
    /// A number after `R`.
    Relative(f64),
    /// A number after `A` in a command whose other numbers are relative to the target: an absolute
    /// value.
    Fixed(f64),
}

impl Value {
    /// Returns the number as the operand gave it.
    pub const fn number(self) -> f64 {
        match self {
            Value::Absolute(number) | Value::Relative(number) | Value::Fixed(number) => number,
        }
    }
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Value::Absolute(number) | Value::Fixed(number) => write!(f, "{number:?}"),
            Value::Relative(number) => write!(f, "{RELATIVE}{number:?}"),
        }
    }
}

/// A command with its operands evaluated. A struct operand is given as its members.
#[derive(Clone, Copy, Debug)]
pub struct Command<'a> {
    /// The command word.
    pub op: Op,
    /// `HS`: without acceleration limit.
    pub hs: bool,
    /// The target of the command.
    pub target: Target,
    /// Its operands in order; omitted ones are absent.
    pub values: &'a [Value],
}

/// The state of a command; a pending one is polled again in the next cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Poll {
    /// The program goes on to the next step.
    Done,
    /// The program stays on this step.
    Pending,
}

/// The quantity that a teaching command measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Teach {
    /// Position of a foot or joint: X, Y, Z in mm.
    Position,
    /// Joint angles in degrees.
    Angle,
    /// Joint torques in the robot's torque unit.
    Torque,
    /// Contact force at a fingertip or second joint: X, Y, Z in N.
    Force,
}

/// The target of a command. Legs and joints count from 1, as in the language.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Target {
    /// No target.
    None,
    /// `ALL`.
    All,
    /// `FLOOR`: the slider of the Hiroshima Hand.
    Floor,
    /// `Fn`: a foot or finger.
    Foot(u8),
    /// `Jnm`: joint m of leg n.
    Joint(u8, u8),
}

impl Target {
    /// Returns the target's word, or its prefix: digits follow `F` and `J`.
    pub const fn stem(self) -> &'static str {
        match self {
            Target::None => "",
            Target::All => "ALL",
            Target::Floor => "FLOOR",
            Target::Foot(_) => "F",
            Target::Joint(..) => "J",
        }
    }
}

impl fmt::Display for Target {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.stem())?;
        match self {
            Target::None | Target::All | Target::Floor => Ok(()),
            Target::Foot(leg) => write!(f, "{leg}"),
            Target::Joint(leg, joint) => write!(f, "{leg}{joint}"),
        }
    }
}

impl FromStr for Target {
    type Err = UnknownWord;

    /// Parses a name in capital letters, of any leg and joint that the language can name.
    fn from_str(word: &str) -> Result<Self, UnknownWord> {
        let digits = |of: Target| word.strip_prefix(of.stem()).map(str::as_bytes);
        match (digits(Target::Foot(1)), digits(Target::Joint(1, 1))) {
            (Some([leg @ b'1'..=b'9']), _) => Ok(Target::Foot(leg - b'0')),
            (_, Some([leg @ b'1'..=b'9', joint @ b'1'..=b'9'])) => {
                Ok(Target::Joint(leg - b'0', joint - b'0'))
            }
            _ => [Target::All, Target::Floor]
                .into_iter()
                .find(|target| target.stem() == word)
                .ok_or(UnknownWord),
        }
    }
}

/// Number of potentiometers of the control box.
pub const KNOBS: usize = 3;
/// The channel of `VR1`; `VR2` and `VR3` follow (T.I.P. 3.1 §7-8-1).
const FIRST_KNOB: u8 = 13;

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

    /// Returns the named input of a channel; other inputs as they are. Channels with joints and open ones have none.
    pub const fn by_name(self) -> Self {
        match self {
            Port::Channel(channel) if channel >= FIRST_KNOB => Port::Knob(channel - FIRST_KNOB + 1),
            port => port,
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

/// An event flag of a condition (T.I.P. 3.1 §6-2).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Flag {
    /// The program was requested to stop at its next good moment.
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

/// Each quantity that a special variable measures, with the prefix of its words, and true if it is measured at joints
/// too.
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

    /// Returns the prefix of the reading's word; `F`, `J` and digits follow.
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

    use super::*;
    use core::fmt::{Debug, Display};
    use std::string::ToString;

    /// Asserts that `thing` prints as `word` and is parsed from it.
    fn is_spelled<T: Copy + Debug + Display + FromStr + PartialEq>(thing: T, word: &str) {
        assert_eq!(thing.to_string(), word);
        assert_eq!(word.parse::<T>().ok(), Some(thing), "{word}");
    }

    fn is_refused<T: Debug + FromStr>(words: &[&str]) {
        for word in words {
            let read = word.parse::<T>().ok();
            assert!(read.is_none(), "{word}: {read:?}");
        }
    }

    #[test]
    fn targets_are_feet_joints_all_and_the_slider() {
        is_spelled(Target::All, "ALL");
        is_spelled(Target::Floor, "FLOOR");
        for leg in 1..=9 {
            is_spelled(Target::Foot(leg), &["F", &leg.to_string()].concat());
            for joint in 1..=9 {
                let digits = (10 * leg + joint).to_string();
                is_spelled(Target::Joint(leg, joint), &["J", &digits].concat());
            }
        }
        is_refused::<Target>(&[
            "", "F", "F0", "F10", "J1", "J10", "J01", "J111", "f1", "all", "ALL ", "FLOORS",
        ]);
        assert_eq!(Target::None.to_string(), "");
    }

    // clauses: 7.32
    #[test]
    fn inputs_are_knobs_soles_joints_and_the_feeler() {
        for (port, word) in [
            (Port::Knob(1), "VR1"),
            (Port::Knob(3), "VR3"),
            (Port::Paw(1), "PAW1"),
            (Port::Paw(4), "PAW4"),
            (Port::Joint(4, 3), "J43"),
            (Port::Antenna, "ANTENNA"),
        ] {
            is_spelled(port, word);
        }
        is_refused::<Port>(&[
            "",
            "VR",
            "VR0",
            "VR4",
            "VR11",
            "PAW0",
            "PAW5",
            "J1",
            "J10",
            "F1",
            "ALL",
            "ANTENNA1",
            "ANTENNA_ON",
            "13",
            "vr1",
        ]);
        assert_eq!(Port::Channel(13).to_string(), "13");
    }

    #[test]
    fn every_named_input_is_read_from_its_word() {
        let kinds = [
            Port::Channel(0),
            Port::Joint(1, 1),
            Port::Knob(1),
            Port::Paw(1),
            Port::Antenna,
        ];
        let words: std::vec::Vec<_> = kinds
            .into_iter()
            .flat_map(Port::named)
            .inspect(|port| is_spelled(*port, &port.to_string()))
            .map(|port| port.to_string())
            .collect();
        let expected = [
            "VR1", "VR2", "VR3", "PAW1", "PAW2", "PAW3", "PAW4", "ANTENNA",
        ];
        assert_eq!(words, expected);
    }

    #[test]
    fn flags_name_what_they_await() {
        for (flag, word) in [
            (Flag::HaltRequest, "HALT_REQUEST"),
            (Flag::KbHit, "KB_HIT"),
            (Flag::Antenna, "ANTENNA_ON"),
            (Flag::Inpos(Target::All), "INPOS_ALL"),
            (Flag::Inpos(Target::Foot(9)), "INPOS_F9"),
            (Flag::Near(Target::Joint(1, 1)), "NEAR_J11"),
            (Flag::Special(0), "SPECIAL_FLAG0"),
            (Flag::Special(9), "SPECIAL_FLAG9"),
        ] {
            is_spelled(flag, word);
        }
        is_refused::<Flag>(&[
            "",
            "INPOS",
            "INPOS_",
            "INPOS_FLOOR",
            "NEAR_FLOOR",
            "INPOS_5",
            "NEAR_",
            "SPECIAL_FLAG",
            "SPECIAL_FLAG10",
            "SPECIAL_FLAGF1",
            "ANTENNA",
            "KB_HITS",
            "kb_hit",
        ]);
    }

    #[test]
    fn every_command_is_read_from_its_name() {
        for op in Op::ALL {
            is_spelled(*op, op.name());
        }
        assert_eq!("PTP".parse(), Ok(Op::Ptp));
        is_refused::<Op>(&["", "ptp", "PTP ", "WAIT_IN_POS"]);
    }

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
