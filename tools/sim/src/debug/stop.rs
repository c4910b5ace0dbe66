//! Why a debugger stands where it does.

use crate::motion::Fall;
use tip_runtime::machine::Emergency;
use tip_runtime::program::End;

/// A position, and why the debugger stopped there.
#[derive(Clone, Debug, PartialEq)]
pub struct Stop {
    /// Why.
    pub reason: Reason,
    /// The cycle that comes next.
    pub at: u64,
}

/// Why a debugger stopped.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Reason {
    /// At the beginning of the run.
    Start,
    /// It did the steps that it was asked for.
    Step,
    /// It came to the line or cycle that it was sent to.
    There,
    /// At the breakpoint of this number.
    Breakpoint(u32),
    /// A variable is assigned. Forwards, it has just been; backwards, it is about to be.
    Watch {
        /// The watch of this number.
        id: u32,
        /// Who assigns it.
        by: By,
    },
    /// The robot fell. Forwards, in the cycle before; backwards, in the cycle that comes next.
    Fall(Fall),
    /// Emergency stop.
    Fault(Emergency),
    /// The program is over.
    Ended(End),
    /// It was interrupted.
    Interrupted,
    /// Something was made to happen.
    Change,
}

/// Who assigns a variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By {
    /// A step of the program.
    Step(u32),
    /// An event.
    Event,
}
