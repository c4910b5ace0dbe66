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

mod flag;
mod op;
mod port;
mod reading;
mod target;
#[cfg(test)]
mod tests;

pub use flag::Flag;
pub use op::Op;
pub use port::{KNOBS, Port};
pub use reading::{READING, Reading, TIMERS};
pub use target::Target;

use core::fmt;

/// The most legs, and the most joints on a leg, that the language can name (`F1…F9`, `J11…J99`).
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
    /// A number without a prefix; relative to the target in commands whose numbers are.
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
