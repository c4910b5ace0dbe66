//! The text of OUTPUT_VARIABLES.

use crate::printable::Printable;
use crate::program::Program;
use core::fmt;

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
