//! SUBROUTINEs that a program runs into (T.I.P. 3.1 §7-6-5).

use crate::code::Code;
use crate::diagnostic::{Diagnostic, Findings};
use crate::message::Structuring;
use crate::source::Span;
use crate::syntax::{Module, StatementKind};

/// Warns of each SUBROUTINE that the step above it runs into.
pub(crate) fn warn_of_entries(module: &Module, found: &mut Findings) {
    let mut open_above = true;
    for statement in &module.statements {
        if !statement.is_step() {
            continue;
        }
        let is_reported = |place: Span| found.iter().any(|it| it.span == place);
        if let StatementKind::Subroutine { keyword, name } = &statement.kind
            && open_above
            && !is_reported(*keyword)
        {
            let reason = Structuring::RunsInto;
            let help = Structuring::PutJumpAbove;
            let warning = Diagnostic::new(Code::RunsInto, *keyword, reason);
            found.push(warning.about(name.node.as_str()).help(help));
        }
        open_above = statement.kind.goes_on();
    }
}
