//! Parts that GOSUB calls and that do not come back, and a RETURN that comes back from nowhere (T.I.P. 3.1 §7-6-5).

use super::Judged;
use super::unreachable::Unreachable;
use crate::analysis::calls::{OneWay, mismatches};
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::message::Warning;
use crate::syntax::StatementKind;

/// Silent about a part that ends the program by EXIT, or repeats without an end; and about a RETURN in a SUBROUTINE, since
/// another warning speaks of running into that.
pub(super) fn warn(judged: &Judged<'_>, unreachable: &Unreachable, found: &mut Vec<Diagnostic>) {
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
    let mismatches = mismatches(judged.program, |step| inside[step as usize]);
    for one_way in mismatches.one_way {
        if unreachable.is_live(one_way.call) {
            found.extend(never_returns(judged, one_way));
        }
    }
    if let Some(lost) = mismatches.lost.and_then(|step| judged.statement(step)) {
        let finding = Diagnostic::new(Code::LostReturn, lost.span, Warning::ReturnsNowhere);
        found.push(finding.help(Warning::PutJumpAboveLabel));
    }
}

fn never_returns(judged: &Judged<'_>, one_way: OneWay) -> Option<Diagnostic> {
    let (part, caller) = (
        judged.statement(one_way.entry)?,
        judged.statement(one_way.call)?,
    );
    let (name, _) = part.kind.label()?;
    let (reason, help, place, label) = match one_way.again {
        None => (
            Warning::NeverReturns,
            Warning::EndWithReturn,
            caller,
            Warning::CalledHere,
        ),
        Some(again) => (
            Warning::CallsItselfFirst,
            Warning::CallUnderCondition,
            judged.statement(again)?,
            Warning::CallsItselfHere,
        ),
    };
    let finding = Diagnostic::new(Code::NoReturn, part.span, reason).about(name.node.as_str());
    Some(finding.label(place.span, label).help(help))
}
