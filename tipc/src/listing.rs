//! The classical listing files (T.I.P. 3.1 §10-4).

use crate::program::Program;

/// FORMAL.TMP: one line a step, fields separated by tabs.
pub fn formal(program: &Program) -> String {
    let lines = program.steps().iter().map(|step| step.formal.as_str());
    lines.flat_map(|line| [line, "\n"]).collect()
}

/// LABEL.TMP: `L` or `S` (declared by SUBROUTINE), name and step of each label.
pub fn label(program: &Program) -> String {
    let line = |label: &crate::program::Label| {
        let kind = if label.subroutine { 'S' } else { 'L' };
        format!("{kind}\t{}:\t{}\n", label.name, label.step)
    };
    program.labels().iter().map(line).collect()
}
