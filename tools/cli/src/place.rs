//! The place of a step in its source, as snippets show it.

use tip_runtime::printable::Printable;
use tipc::program::{Program, StepId};
use tipc::source::Source;

/// The line of a step under the name of its file; nothing for a step that there is none of.
pub(super) fn place(source: &Source, program: &Program, step: StepId) -> String {
    let Some(step) = program.steps().get(step as usize) else {
        return String::new();
    };
    let (line, column) = (step.line, step.column);
    let gutter = " ".repeat(line.to_string().len());
    let statement = Printable::line(source.line_text(line));
    let name = Printable::line(source.name());
    format!("{gutter}--> {name}:{line}:{column}\n{gutter} |\n{line} | {statement}\n{gutter} |\n")
}
