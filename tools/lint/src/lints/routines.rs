//! Parts that GOSUB calls and that do not come back, and a RETURN that comes back from nowhere (T.I.P. 3.1 §7-6-5).

use super::LintContext;
use super::unreachable::Unreachable;
use super::walk::{Into, Walk};
use crate::message::Linting;
use std::collections::BTreeSet;
use tipc::analysis::flow::{Call, Flow, NodeId};
use tipc::code::Code;
use tipc::diagnostic::{Diagnostic, Diagnostics};
use tipc::program::{Action, End, Program, StepId};
use tipc::syntax::StatementKind;

/// Warns of GOSUB and RETURN that do not match. Silent about a part that ends the program by EXIT, or repeats without
/// an end; and about a RETURN in a SUBROUTINE, since another warning speaks of running into that.
pub(super) fn warn(context: &LintContext<'_>, unreachable: &Unreachable, found: &mut Diagnostics) {
    let mut inside = Vec::new();
    let mut is_inside = false;
    for statement in context.module.steps() {
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
    let mismatches = mismatches(context.program, context.flow, |step| inside[step as usize]);
    for OneWay { entry, call } in mismatches.one_way {
        if unreachable.is_live(call) {
            found.extend(never_returns(context, entry, call));
        }
    }
    if let Some(lost) = mismatches.lost.and_then(|step| context.statement(step)) {
        let diagnostic = Diagnostic::new(Code::LostReturn, lost.span, Linting::ReturnsNowhere);
        found.push(diagnostic.help(Linting::PutJumpAboveLabel));
    }
}

fn never_returns(context: &LintContext<'_>, entry: StepId, call: StepId) -> Option<Diagnostic> {
    let (part, caller) = (context.statement(entry)?, context.statement(call)?);
    let (name, _) = part.kind.label()?;
    let diagnostic = Diagnostic::new(Code::NoReturn, part.span, Linting::NeverReturns);
    let diagnostic = diagnostic.about(name.node.as_str());
    Some(
        diagnostic
            .label(caller.span, Linting::CalledHere)
            .help(Linting::EndWithReturn),
    )
}

/// Routines whose calls and returns do not match.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
struct Mismatches {
    /// Routines that cannot come back, although they do not end the program by EXIT.
    one_way: Vec<OneWay>,
    /// The first RETURN that a path without a call comes to.
    lost: Option<StepId>,
}

/// A routine that cannot come back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct OneWay {
    /// First step of the routine.
    entry: StepId,
    /// The first step that calls it.
    call: StepId,
}

/// Looks at the calls and returns of a program. What is in a SUBROUTINE may be left out: `is_inside` says which steps are.
fn mismatches(program: &Program, flow: &Flow, is_inside: impl Fn(StepId) -> bool) -> Mismatches {
    let own = own_nodes(flow);
    let is_lost = |id: &NodeId| own[*id] && flow.nodes()[*id].returns;
    let lost = (0..own.len())
        .filter(is_lost)
        .map(|id| flow.nodes()[id].step);
    Mismatches {
        one_way: one_way(program, flow),
        lost: lost.into_iter().find(|step| !is_inside(*step)),
    }
}

/// Returns the nodes that paths from the start come to without being called, as if every call came back.
fn own_nodes(flow: &Flow) -> Vec<bool> {
    let mut own = vec![false; flow.nodes().len()];
    let mut open = vec![0];
    while let Some(id) = open.pop() {
        if let Some(node) = flow.nodes().get(id)
            && !std::mem::replace(&mut own[id], true)
        {
            open.extend(node.next.iter().copied());
            open.extend(node.call.map(|call| call.back));
        }
    }
    own
}

fn one_way(program: &Program, flow: &Flow) -> Vec<OneWay> {
    let mut walk = Walk::new(flow);
    let mut entries = BTreeSet::new();
    let calls = flow
        .nodes()
        .iter()
        .filter_map(|node| Some((node.step, node.call?)));
    calls
        .filter(|(_, call)| entries.insert(call.entry))
        .filter(|(_, call)| is_one_way(program, flow, &mut walk, *call) == Some(true))
        .map(|(step, call)| OneWay {
            entry: flow.nodes()[call.entry].step,
            call: step,
        })
        .collect()
}

/// Returns whether the routine does something, and then runs to the end of the source or into a call of itself, but
/// never returns;
/// `None` if it is too long to say.
fn is_one_way(program: &Program, flow: &Flow, walk: &mut Walk<'_>, call: Call) -> Option<bool> {
    let path = walk.from(&[call.entry], None, Into::Itself)?;
    let nodes = || path.iter().map(|id| &flow.nodes()[*id]);
    let actions = || nodes().map(|node| &program.steps()[node.step as usize].action);
    if nodes().any(|node| node.returns) {
        return Some(false);
    }
    let runs_out = actions().any(|action| matches!(action, Action::Finish(End::End)));
    let calls_itself = nodes().any(|node| node.call.is_some_and(|inner| inner.entry == call.entry));
    Some((runs_out || calls_itself) && actions().any(Action::acts))
}
