//! The records of a run: the trace, TITAN.LOG, the dump of variables.
//!
//! ```
//! use tip_runtime::hardware::JointCommand;
//! use tip_runtime::record::{Ending, state_hash};
//!
//! // It shows the last bit of every joint.
//! let commands = [JointCommand::at(90.0)];
//! let hash = state_hash(&commands, &[90.0]);
//! assert_eq!(hash, state_hash(&commands, &[90.0]));
//! assert_ne!(hash, state_hash(&commands, &[90.0_f64.next_up()]));
//! # #[cfg(feature = "std")] {
//! use tip_runtime::record::JsonLines;
//!
//! let mut trace = JsonLines::new(String::new(), true);
//! trace.end(Ending::Limit, 250);
//! assert_eq!(trace.into_inner(), "{\"end\":\"LIMIT\",\"cycles\":250}\n");
//! # }
//! # let _ = Ending::Limit;
//! ```

#[cfg(feature = "std")]
mod json_lines;
#[cfg(feature = "std")]
mod output;
#[cfg(feature = "std")]
mod titan_log;

#[cfg(feature = "std")]
pub use json_lines::JsonLines;
#[cfg(feature = "std")]
pub use json_lines::MotionRecord;
#[cfg(feature = "std")]
pub use output::AtomicFile;
#[cfg(feature = "std")]
pub use output::Stream;
#[cfg(feature = "std")]
pub use titan_log::TitanLog;

use crate::command::Command;
use crate::emergency::Emergency;
use crate::hardware::JointCommand;
use crate::printable::Printable;
use crate::program::{End, Program};
use core::fmt::{self, Display};

/// One step that ran to its end without a fault, and its control cycle.
#[derive(Clone, Copy)]
#[non_exhaustive]
pub struct Cycle<'a> {
    /// Number of records of the cycle before this one.
    pub sub: u32,
    /// True in the last record of the cycle.
    pub last: bool,
    /// The thread that ran the step; `None` for the main program.
    pub thread: Option<&'a str>,
    /// The step that ran.
    pub step: u32,
    /// The step that the program or thread runs next; `None` after END and EXIT, and at the end of a thread.
    pub next: Option<u32>,
    /// The program after the step, for its variables.
    pub program: &'a dyn Program,
    /// The cycle's number and time, with its measurements and commands.
    pub sample: Sample<'a>,
}

/// A recorder of a run, step by step. For each step [`begin`](Self::begin) comes before it and
/// [`cycle`](Self::cycle) after it, with the other calls in between; a failing step has no
/// [`cycle`](Self::cycle). The last step of a control cycle, of most programs the only one, is recorded
/// when the robot has moved on.
pub trait Sink {
    /// Records that a step is about to run.
    fn begin(&mut self, program: &dyn Program) {
        let _ = program;
    }

    /// Records an accepted robot command: called in the first cycle of the command only.
    fn command(&mut self, command: &Command<'_>) {
        let _ = command;
    }

    /// Records a message; an empty one cleared the line.
    fn say(&mut self, text: &dyn Display) {
        let _ = text;
    }

    /// Records the text that F_MESSAGE appended.
    fn out(&mut self, text: &dyn Display) {
        let _ = text;
    }

    /// Records the switching of a lamp.
    fn lamp(&mut self, device: u8, on: bool) {
        let _ = (device, on);
    }

    /// Records the end of a step.
    fn cycle(&mut self, cycle: &Cycle<'_>) {
        let _ = cycle;
    }
}

/// The end of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ending {
    /// The program ended itself.
    Program(End),
    /// Someone pressed Ctrl-C.
    Interrupted,
    /// The requested number of cycles was reached.
    Limit,
    /// Emergency stop.
    Emergency(Emergency),
}

/// The measurements and commands of a cycle: a row of TITAN.LOG. Joints come leg by leg.
#[derive(Clone, Copy, Debug)]
pub struct Sample<'a> {
    /// The program's cycle, from 0.
    pub cycle: u64,
    /// Time at which the sensors were sampled, from the program's start, ms.
    pub time: f64,
    /// Number of joints of each leg.
    pub joints_per_leg: usize,
    /// Measured angles, deg.
    pub angles: &'a [f64],
    /// Commands sent, deg, or the robot's torque unit.
    pub commands: &'a [JointCommand],
    /// Measured torques in the robot's torque unit; empty for a robot without torque sensors.
    pub torques: &'a [f64],
    /// `PAW1…`: V.
    pub paws: &'a [f64],
    /// `VR1…`: V.
    pub knobs: &'a [f64],
    /// `ANTENNA`: V.
    pub antenna: f64,
}

/// The scalars of a program, one a line in declaration order: name, tab, value; `unassigned` in
/// place of a missing value. A heading `# cycle N, step N, line N` goes before.
#[derive(Clone, Copy)]
pub struct Dump<'a> {
    /// The program.
    pub program: &'a dyn Program,
    /// The cycle of the request.
    pub cycle: u64,
    /// The step of the request.
    pub step: u32,
}

impl fmt::Display for Dump<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Dump {
            program,
            cycle,
            step,
        } = self;
        let line = program.line(*step);
        writeln!(f, "# cycle {cycle}, step {step}, line {line}")?;
        for index in 0.. {
            let Some((name, value)) = program.scalar(index) else {
                break;
            };
            let name = Printable::line(name);
            match value {
                Some(value) => writeln!(f, "{name}\t{value:?}")?,
                None => writeln!(f, "{name}\tunassigned")?,
            }
        }
        Ok(())
    }
}

/// The offset basis of FNV-1a.
const OFFSET: u64 = 0xCBF2_9CE4_8422_2325;
/// The prime of FNV-1a.
const PRIME: u64 = 0x0000_0100_0000_01B3;

/// Returns the 64-bit FNV-1a hash over the bits (little endian) of each joint's command and
/// measured angle, joint by joint (Fowler, Noll and Vo's hash: IETF draft-eastlake-fnv).
pub fn state_hash(commands: &[JointCommand], angles: &[f64]) -> u64 {
    commands
        .iter()
        .zip(angles)
        .flat_map(|(command, angle)| [command.value(), *angle])
        .flat_map(|value| value.to_bits().to_le_bytes())
        .fold(OFFSET, |hash, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(PRIME)
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_hashes_to_the_offset_basis() {
        assert_eq!(state_hash(&[], &[]), 0xCBF2_9CE4_8422_2325);
    }

    #[test]
    fn zeros_only_multiply() {
        // XOR with a zero byte changes nothing: sixteen multiplications remain.
        let expected = (0..16).fold(OFFSET, |hash, _| hash.wrapping_mul(PRIME));
        assert_eq!(state_hash(&[JointCommand::at(0.0)], &[0.0]), expected);
    }

    #[test]
    fn a_last_bit_a_sign_of_zero_and_the_order_count() {
        let one = [JointCommand::at(1.0)];
        let hash = state_hash(&one, &[2.0]);
        assert_ne!(hash, state_hash(&one, &[2.0_f64.next_up()]));
        assert_ne!(hash, state_hash(&[JointCommand::at(2.0)], &[1.0]));
        assert_ne!(state_hash(&one, &[0.0]), state_hash(&one, &[-0.0]));
    }
}
