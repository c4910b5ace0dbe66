//! A program on the wrong robot.

use crate::program::{Program, Signature};
use core::fmt;

/// The program was checked for another robot than the one it was put on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mismatch {
    /// The robot the program was checked for.
    pub program: Signature,
    /// The robot at hand.
    pub robot: Signature,
}

impl Mismatch {
    /// Checks a program against a robot. Compiled once, whatever the sizes of robots.
    #[inline(never)]
    pub(super) fn check(program: &dyn Program, robot: Signature) -> Result<(), Self> {
        let program = program.signature();
        if program == robot {
            Ok(())
        } else {
            Err(Mismatch { program, robot })
        }
    }
}

impl fmt::Display for Mismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the program was compiled for ")?;
        describe(f, self.program)?;
        f.write_str(", the robot is ")?;
        describe(f, self.robot)
    }
}

fn describe(f: &mut fmt::Formatter<'_>, robot: Signature) -> fmt::Result {
    let Signature {
        robot,
        family,
        legs,
        joints,
    } = robot;
    write!(
        f,
        "{robot} (commands of {family}, {legs} legs of {joints} joints)"
    )
}

impl core::error::Error for Mismatch {}
