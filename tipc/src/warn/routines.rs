//! Parts that GOSUB calls and that do not come back, and a RETURN that comes back from nowhere (T.I.P. 3.1 §7-6-5).

use super::Judged;
use super::unreachable::Unreachable;
use crate::analysis::calls::{OneWay, mismatches};
use crate::code::Code;
use crate::diagnostic::{Diagnostic, Findings};
use crate::message::Warning;
use crate::program::StepId;
use crate::syntax::StatementKind;

/// Silent about a part that ends the program by EXIT, or repeats without an end; and about a RETURN in a SUBROUTINE, since
/// another warning speaks of running into that.
pub(super) fn warn(judged: &Judged<'_>, unreachable: &Unreachable, found: &mut Findings) {
    let mut inside = Vec::new();
    let mut is_inside = false;
    for statement in judged.module.steps() {
        match statement.kind {
            StatementKind::Subroutine { .. } => is_inside = true,
            StatementKind::SubEnd => {
                inside.push(true);
                is_inside = false;
                continue;
            }
            _ => {}
        }
        inside.push(is_inside);
    }
    let mismatches = mismatches(judged.program, judged.flow, |step| inside[step as usize]);
    for OneWay { entry, call } in mismatches.one_way {
        if unreachable.is_live(call) {
            found.extend(never_returns(judged, entry, call));
        }
    }
    if let Some(lost) = mismatches.lost.and_then(|step| judged.statement(step)) {
        let finding = Diagnostic::new(Code::LostReturn, lost.span, Warning::ReturnsNowhere);
        found.push(finding.help(Warning::PutJumpAboveLabel));
    }
}

fn never_returns(judged: &Judged<'_>, entry: StepId, call: StepId) -> Option<Diagnostic> {
    let (part, caller) = (judged.statement(entry)?, judged.statement(call)?);
    let (name, _) = part.kind.label()?;
    let finding = Diagnostic::new(Code::NoReturn, part.span, Warning::NeverReturns);
    let finding = finding.about(name.node.as_str());
    Some(
        finding
            .label(caller.span, Warning::CalledHere)
            .help(Warning::EndWithReturn),
    )
}
