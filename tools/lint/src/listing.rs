//! The classical listing files (T.I.P. 3.1 §4-2, §10-4, §11).

pub(crate) mod formal;
mod object;

pub(crate) use formal::Constants;
pub use object::object;

use tipc::code::Level;
use tipc::diagnostic::Diagnostic;
use tipc::program::{LabelKind, Program};
use tipc::render;
use tipc::source::Source;
use tipc::syntax::Module;

/// Renders FORMAL.TMP of the module that a source was parsed to: one line a step, fields separated by tabs.
pub fn formal(source: &Source, module: &Module) -> String {
    let mut text = Vec::new();
    let constants = Constants::of(module);
    for statement in module.steps() {
        formal::write(&mut text, source, statement, &constants, b'\t');
        text.push(b'\n');
    }
    String::from_utf8_lossy(&text).into_owned()
}

/// Renders LABEL.TMP: `L`, `S` (declared by SUBROUTINE) or `T` (by THREAD), name and step of each label.
pub fn label(program: &Program) -> String {
    let line = |label: &tipc::program::Label| {
        let kind = match label.kind {
            LabelKind::Plain => 'L',
            LabelKind::Subroutine => 'S',
            LabelKind::Thread => 'T',
        };
        format!("{kind}\t{}:\t{}\n", label.name, label.step)
    };
    program.labels().iter().map(line).collect()
}

/// Renders WARNING.LOG: the warnings among the diagnostics of a source, one a line.
pub fn warnings(source: &Source, diagnostics: &[Diagnostic]) -> String {
    let warnings = diagnostics.iter().filter(|it| it.level() == Level::Warning);
    warnings
        .map(|warning| render::classical(source, warning) + "\n")
        .collect()
}
