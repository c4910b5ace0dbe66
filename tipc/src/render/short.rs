//! One line for each diagnostic.

use crate::code::Level;
use crate::diagnostic::Diagnostic;
use crate::message::Lang;
use crate::source::Source;
use tip_runtime::printable::Printable;

/// `FILE:LINE:COLUMN: error[CODE]: REASON (TIP_ERR:<message>)`, or `FILE:LINE:COLUMN: warning[CODE]: <message>`; no line end,
/// whatever the file is called: what could act on a terminal is an escape.
pub fn short(source: &Source, diagnostic: &Diagnostic, lang: Lang) -> String {
    let (line, column) = source.line_column(diagnostic.span.start);
    let (level, code) = (diagnostic.level(), diagnostic.id());
    let headline = diagnostic.headline(lang);
    let classical = match level {
        Level::Error => format!(" (TIP_ERR:{})", diagnostic.message()),
        Level::Warning => String::new(),
    };
    let (name, level) = (source.name(), level.name());
    let text = format_args!("{name}:{line}:{column}: {level}[{code}]: {headline}{classical}");
    Printable::line(text).to_string()
}

/// `FILE:LINE:COLUMN: error: TIP_ERR:<message> (<kind>)`, or `FILE:LINE:COLUMN: warning: <message>`, in English and without line
/// end (T.I.P. 3.1 §9); WARNING.LOG is made of such lines.
pub fn classical(source: &Source, diagnostic: &Diagnostic) -> String {
    let (line, column) = source.line_column(diagnostic.span.start);
    let level = diagnostic.level().name();
    let title = diagnostic.title();
    let name = source.name();
    Printable::line(format_args!("{name}:{line}:{column}: {level}: {title}")).to_string()
}
