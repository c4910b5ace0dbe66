//! What ended a program by emergency stop, and how that is reported.

use crate::fault::Fault;
use crate::printable::Printable;
use crate::program::Program;
use core::fmt;

/// An emergency stop. Shown, it is the classical one-liner `TIP_ERR:<message> (<kind>)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Emergency {
    /// What happened.
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

/// An emergency stop with its place in the program. Shown, it is the text of EMG.log: the classical
/// one-liner, then `program`, `title`, `step`, `line`, `cycle` and, if one is to blame, `variable`,
/// one per line with a tab after the word. What the program says is [`Printable`].
#[derive(Clone, Copy)]
pub struct Report<'a> {
    /// What happened.
    pub emergency: Emergency,
    /// The program as it was left.
    pub program: &'a dyn Program,
}

impl Report<'_> {
    /// The source line, from 1.
    pub fn line(&self) -> u32 {
        self.program.line(self.emergency.step)
    }

    /// The variable that was read before it was assigned.
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
