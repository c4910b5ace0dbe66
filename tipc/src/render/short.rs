//! One line for each diagnostic.

use crate::diagnostic::Diagnostic;
use crate::source::Source;
use tip_runtime::printable::Printable;

/// `FILE:LINE:COLUMN: error: TIP_ERR:<message> (<kind>)`, or `FILE:LINE:COLUMN: warning: <message>`; no line end, whatever the
/// file is called: what could act on a terminal is an escape.
pub fn short(source: &Source, diagnostic: &Diagnostic) -> String {
    let (line, column) = source.line_column(diagnostic.span.start);
    let level = diagnostic.level().name();
    let title = diagnostic.title();
    let name = source.name();
    Printable::line(format_args!("{name}:{line}:{column}: {level}: {title}")).to_string()
}
