//! Emergency stops: their cause and their report.

use crate::fault::Fault;
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
}

impl fmt::Display for Emergency {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "TIP_ERR:{} ({})", self.fault, self.fault.kind())
    }
}

/// An emergency stop with its place in the program. `Display` writes the text of EMG.log: the
/// classical one-liner, then `program`, `title`, `step`, `line`, `cycle` and, if one caused it,
/// `variable`, one per line with a tab after the word. Texts of the program are shown as
/// [`Printable`].
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
        let Emergency { step, cycle, .. } = self.emergency;
        writeln!(f, "{}", Printable::line(self.emergency))?;
        writeln!(f, "program\t{}", Printable::line(self.program.name()))?;
        writeln!(f, "title\t{}", Printable::line(self.program.title()))?;
        writeln!(f, "step\t{step}")?;
        writeln!(f, "line\t{}", self.line())?;
        writeln!(f, "cycle\t{cycle}")?;
        match self.variable() {
            Some(name) => writeln!(f, "variable\t{}", Printable::line(name)),
            None => Ok(()),
        }
    }
}
