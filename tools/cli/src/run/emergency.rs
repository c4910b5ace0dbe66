//! An emergency stop, reported with its place in the program.

use super::super::place::place;
use std::fmt::Write as _;
use tip_runtime::fault::Fault;
use tip_runtime::machine::Emergency;
use tip_runtime::program::Program as _;
use tip_sim::Interpreter;
use tipc::source::Source;

/// The classical line, the statement that ran, and what else is known.
pub(super) fn describe(emergency: &Emergency, source: &Source, program: &Interpreter) -> String {
    let Emergency { fault, step, cycle } = emergency;
    let mut text = format!("TIP_ERR:{fault} ({})\n", fault.kind());
    text += &place(source, program.program(), *step);
    // Writing to a String cannot fail.
    let _ = writeln!(text, "step {step}, cycle {cycle}");
    if let Fault::Unassigned(index) = fault
        && let Some((name, _)) = program.scalar(*index as usize)
    {
        let _ = writeln!(text, "{name} has no value yet");
    }
    text
}
