//! Variables that nothing reads, assigns or uses (T.I.P. 3.1 §4-2 path 3).

use super::names::Names;
use super::uses::Named;
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::source::{Source, Span};
use crate::symbols::{Access, Use};
use crate::syntax::VariableKind;

/// Reports reads that nothing assigned, and variables that serve nothing.
pub(super) fn report(source: &Source, names: &Names, named: &Named, found: &mut Vec<Diagnostic>) {
    let mut serves = vec![Service::default(); names.variables.len()];
    for used in named.symbols.all_uses() {
        if let Some(service) = serves.get_mut(used.definition.index()) {
            service.add(used);
        }
    }
    for (id, variable) in names.variables.iter().enumerate() {
        if named.excused[id] {
            continue;
        }
        let name = &variable.name;
        let Service { read, assigned } = serves[id];
        let finding = match (read, assigned, names.declared[id]) {
            (Some(read), false, declared) => {
                let place = read.operand(source);
                Some(never_assigned(name, variable.kind, place, declared))
            }
            (None, false, Some(declared)) => {
                let reason = "nothing uses this name";
                Some(Diagnostic::new(Code::Unused, declared, reason).about(name))
            }
            (None, true, Some(declared)) if !named.dumped => {
                let reason = "nothing reads this variable";
                Some(Diagnostic::new(Code::NeverRead, declared, reason).about(name))
            }
            _ => None,
        };
        found.extend(finding);
    }
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
    let reason = format!("`{name}` is read here and assigned nowhere");
    let help = match (kind, declared) {
        (_, None) => "KEY_IN without argument assigns it".to_owned(),
        (VariableKind::Var, _) => format!("assign it before, as `{name} = 0`"),
        (VariableKind::Pos, _) => {
            format!("assign it before, as `{name}.X = 0` or `TEACH_POSITION F1 {name}`")
        }
        (VariableKind::Joint, _) => {
            format!("assign it before, as `{name}.J1 = 0` or `TEACH_ANGLE F1 {name}`")
        }
    };
    let fault = Diagnostic::new(Code::NeverAssigned, place, reason).help(help);
    match declared {
        Some(declared) => fault.label(declared, "declared here"),
        None => fault,
    }
}
