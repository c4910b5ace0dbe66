//! A trace of bits: it is compared, not read, and needs no floats as text.

use core::fmt::{self, Write};
use tip_runtime::record::{Cycle, Sink, state_hash};

/// Writes a line for each step of a control cycle: the cycle's number and that of a later step in it, the step, the hash of joint commands and angles
/// that a trace file has as `state`, and the bits of each variable (`-` without a value).
#[derive(Debug)]
pub(crate) struct Trace<'a, W> {
    out: &'a mut W,
    result: fmt::Result,
}

impl<'a, W: Write> Trace<'a, W> {
    /// A trace without a line.
    pub(crate) fn new(out: &'a mut W) -> Self {
        let result = Ok(());
        Trace { out, result }
    }

    /// Every line was written.
    pub(crate) fn is_complete(&self) -> bool {
        self.result.is_ok()
    }

    fn line(&mut self, cycle: &Cycle<'_>) -> fmt::Result {
        let state = state_hash(cycle.sample.commands, cycle.sample.angles);
        write!(self.out, "{}", cycle.sample.cycle)?;
        if cycle.sub > 0 {
            write!(self.out, ".{}", cycle.sub)?;
        }
        write!(self.out, " {} {state:016x}", cycle.step)?;
        for (_, value) in (0..).map_while(|index| cycle.program.scalar(index)) {
            match value {
                Some(value) => write!(self.out, " {:016x}", value.to_bits())?,
                None => self.out.write_str(" -")?,
            }
        }
        self.out.write_str("\n")
    }
}

impl<W: Write> Sink for Trace<'_, W> {
    fn cycle(&mut self, cycle: &Cycle<'_>) {
        self.result = self.result.and_then(|()| self.line(cycle));
    }
}
