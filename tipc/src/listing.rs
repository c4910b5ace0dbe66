//! The classical listing files (T.I.P. 3.1 §4-2, §10-4, §11).

mod object;

pub use object::object;

use crate::code::Level;
use crate::diagnostic::Diagnostic;
use crate::program::Program;
use crate::render;
use crate::source::Source;

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

/// WARNING.LOG: the warnings among the findings about a source, one a line.
pub fn warnings(source: &Source, findings: &[Diagnostic]) -> String {
    let warnings = findings.iter().filter(|it| it.level() == Level::Warning);
    warnings
        .map(|warning| render::short(source, warning) + "\n")
        .collect()
}
