//! Variables that nothing reads, assigns or uses (T.I.P. 3.1 §4-2 path 3).

use super::names::Names;
use super::uses::Named;
use crate::code::Code;
use crate::diagnostic::{Diagnostic, Findings};
use crate::language::names::LIMIT;
use crate::message::phrase::{Assign, Lacking};
use crate::message::{Commanding, Message, Naming, Parsing, Suggesting};
use crate::source::{Source, Span};
use crate::symbols::{Access, Use};
use crate::syntax::VariableKind;
use std::collections::HashSet;

/// Reports reads that nothing assigned, and variables that serve nothing.
pub(super) fn report(source: &Source, names: &Names, named: &Named, found: &mut Findings) {
    let mut serves = vec![Service::default(); names.variables.len()];
    for used in named.symbols.all_uses() {
        if let Some(service) = serves.get_mut(used.definition.index()) {
            service.add(used);
        }
    }
    // A misspelled name was to use the one that it is near to.
    let meant = found.iter().filter_map(|finding| match &finding.help {
        Some(Message::Suggesting(Suggesting::DidYouMean { near })) => Some(near.to_string()),
        _ => None,
    });
    let meant: HashSet<String> = meant.collect();
    let lacks_name = found.iter().any(lacks_name);
    for (id, variable) in names.variables.iter().enumerate() {
        let is_refused = variable.name.len() > LIMIT;
        if named.excused[id] || is_refused || meant.contains(&variable.name) {
            continue;
        }
        let name = &variable.name;
        let Service { read, assigned } = serves[id];
        // The name that is missing may be this one.
        if lacks_name && !assigned && variable.kind == VariableKind::Var {
            continue;
        }
        let finding = match (read, assigned, names.declared[id]) {
            (Some(read), false, declared) => {
                let place = read.operand(source);
                Some(never_assigned(name, variable.kind, place, declared))
            }
            (None, false, Some(declared)) => {
                let reason = Naming::NothingUses;
                Some(Diagnostic::new(Code::Unused, declared, reason).about(name))
            }
            (None, true, Some(declared)) if !named.dumped && !named.to_be_shown[id] => {
                let reason = Naming::NothingReads;
                Some(Diagnostic::new(Code::NeverRead, declared, reason).about(name))
            }
            _ => None,
        };
        found.extend(finding);
    }
}

/// Whether a statement lacks the variable that it assigns: `FOR 1 TO 4`, `AD_IN VR1`.
fn lacks_name(finding: &Diagnostic) -> bool {
    let missing = |what| Message::from(Commanding::Missing { what });
    finding.reason == Parsing::VariableBelongsHere.into()
        || [Lacking::Volts, Lacking::Measured]
            .into_iter()
            .any(|what| finding.reason == missing(what))
}

/// What a program does with a variable.
#[derive(Clone, Copy, Default)]
struct Service<'a> {
    /// The first read.
    read: Option<&'a Use>,
    assigned: bool,
}

impl<'a> Service<'a> {
    fn add(&mut self, used: &'a Use) {
        match used.access {
            Access::Read => {
                self.read.get_or_insert(used);
            }
            Access::Assign => self.assigned = true,
            Access::Update => {
                self.read.get_or_insert(used);
                self.assigned = true;
            }
            // What NEXT counts its FOR has begun.
            Access::Count | Access::Define | Access::Jump | Access::Call | Access::Unclear => {}
        }
    }
}

fn never_assigned(
    name: &str,
    kind: VariableKind,
    place: Span,
    declared: Option<Span>,
) -> Diagnostic {
    let reason = Naming::AssignedNowhere { name: name.into() };
    let assign = match (kind, declared) {
        (_, None) => Assign::KeyIn,
        (VariableKind::Var, _) => Assign::Var { name: name.into() },
        (VariableKind::Pos, _) => Assign::Pos { name: name.into() },
        (VariableKind::Joint, _) => Assign::Joint { name: name.into() },
    };
    let help = Naming::AssignBefore { assign };
    let fault = Diagnostic::new(Code::NeverAssigned, place, reason).help(help);
    match declared {
        Some(declared) => fault.label(declared, Naming::DeclaredHere),
        None => fault,
    }
}
