//! Emergency stops: their cause and their report.

use crate::fault::{Fault, HardwareFault};
use crate::printable::Printable;
use crate::program::Program;
use core::fmt;

/// An emergency stop. `Display` writes the classical one-liner `TIP_ERR:<message> (<kind>)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Emergency {
    /// The cause.
    pub fault: Fault,
    /// The step that ran, or would have run, in that cycle.
    pub step: u32,
    /// The cycle, from 0.
    pub cycle: u64,
    /// The thread whose step caused it; `None` for the main program's steps and the robot's own faults.
    pub thread: Option<ThreadName>,
    /// The first failure to stop the robot, in this cycle or a later one.
    pub stop_fault: Option<HardwareFault>,
}

/// The name of a thread, as a value.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct ThreadName {
    bytes: [u8; Self::MAX_LABEL_BYTES],
    len: u8,
}

impl ThreadName {
    /// The longest name of a label, bytes.
    const MAX_LABEL_BYTES: usize = 32;

    /// Returns a name, cut to the length that labels have.
    pub(crate) fn new(name: &str) -> Self {
        let mut kept = ThreadName {
            bytes: [0; Self::MAX_LABEL_BYTES],
            len: 0,
        };
        for (place, byte) in kept.bytes.iter_mut().zip(name.bytes()) {
            *place = byte;
            kept.len += 1;
        }
        kept
    }

    /// Returns the name.
    pub fn as_str(&self) -> &str {
        let bytes = self.bytes.get(..usize::from(self.len)).unwrap_or(&[]);
        core::str::from_utf8(bytes).unwrap_or("")
    }
}

impl fmt::Debug for ThreadName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.as_str().fmt(f)
    }
}

impl fmt::Display for Emergency {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "TIP_ERR:{} ({})", self.fault, self.fault.kind())
    }
}

/// An emergency stop with its place in the program. `Display` writes the text of EMG.log: the
/// classical one-liner, then `program`, `title`, `thread` if a thread's step caused it, `step`, `line`,
/// `cycle`, if one caused it `variable`, and `stop` if the robot could not be stopped, one per line with a tab after
/// the word. Texts of the program are shown as [`Printable`].
#[derive(Clone, Copy)]
pub struct Report<'a> {
    /// The emergency stop.
    pub emergency: Emergency,
    /// The program in the state of the emergency.
    pub program: &'a dyn Program,
}

impl Report<'_> {
    /// Returns the source line, from 1.
    pub fn line(&self) -> u32 {
        self.program.line(self.emergency.step)
    }

    /// Returns the variable that was read before it was assigned.
    pub fn variable(&self) -> Option<&str> {
        match self.emergency.fault {
            Fault::Unassigned(index) => self.program.scalar(index as usize).map(|(name, _)| name),
            _ => None,
        }
    }
}

impl fmt::Display for Report<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Emergency {
            step,
            cycle,
            thread,
            stop_fault,
            ..
        } = self.emergency;
        writeln!(f, "{}", Printable::line(self.emergency))?;
        writeln!(f, "program\t{}", Printable::line(self.program.name()))?;
        writeln!(f, "title\t{}", Printable::line(self.program.title()))?;
        if let Some(thread) = thread {
            writeln!(f, "thread\t{}", thread.as_str())?;
        }
        writeln!(f, "step\t{step}")?;
        writeln!(f, "line\t{}", self.line())?;
        writeln!(f, "cycle\t{cycle}")?;
        if let Some(name) = self.variable() {
            writeln!(f, "variable\t{}", Printable::line(name))?;
        }
        match stop_fault {
            Some(fault) => writeln!(f, "stop\t{}", Printable::line(fault)),
            None => Ok(()),
        }
    }
}
