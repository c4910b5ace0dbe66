//! The line of the original interpreter for each diagnostic, behind its place.

use crate::diagnostic::Diagnostic;
use crate::source::Source;
use tip_runtime::printable::Printable;

/// `FILE:LINE:COLUMN: error: TIP_ERR:<message> (<kind>)`, or `FILE:LINE:COLUMN: warning: <message>`, in English and without line
/// end (T.I.P. 3.1 §9); WARNING.LOG is made of such lines.
pub fn classical(source: &Source, diagnostic: &Diagnostic) -> String {
    let (line, column) = source.line_column(diagnostic.span.start);
    let level = diagnostic.level().name();
    let title = diagnostic.title();
    let name = source.name();
    Printable::line(format_args!("{name}:{line}:{column}: {level}: {title}")).to_string()
}
