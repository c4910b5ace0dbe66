//! One line for each diagnostic.

use crate::diagnostic::Diagnostic;
use crate::source::Source;

/// `FILE:LINE:COLUMN: error: TIP_ERR:<message> (<kind>)`, or `FILE:LINE:COLUMN: warning: <message>`; no line end.
pub fn short(source: &Source, diagnostic: &Diagnostic) -> String {
    let (line, column) = source.line_column(diagnostic.span.start);
    let level = diagnostic.level().name();
    let title = diagnostic.title();
    format!("{}:{line}:{column}: {level}: {title}", source.name())
}
