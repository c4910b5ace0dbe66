//! Which variables are read and assigned (T.I.P. 3.1 §4-2 path 3).

use super::names::Names;
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::program::VariableId;
use crate::syntax::{Span, VariableKind};

/// Where a statement reads a variable.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ReadPlace {
    /// The statement.
    pub(crate) statement: usize,
    /// The variable.
    pub(crate) variable: VariableId,
    /// The operand that names it.
    pub(crate) place: Span,
}

/// What a program does with its variables.
#[derive(Debug)]
pub(crate) struct Usage {
    /// The statement that is being looked at.
    statement: usize,
    /// In the order of the source.
    reads: Vec<ReadPlace>,
    first_read: Vec<Option<Span>>,
    assigned: Vec<bool>,
    /// A broken statement names the variable: nothing can be said of it.
    excused: Vec<bool>,
    /// OUTPUT_VARIABLES reads them all.
    dumped: bool,
}

impl Usage {
    pub(crate) fn new(variables: usize) -> Self {
        Usage {
            statement: 0,
            reads: Vec::new(),
            first_read: vec![None; variables],
            assigned: vec![false; variables],
            excused: vec![false; variables],
            dumped: false,
        }
    }

    /// What follows is about this statement.
    pub(crate) fn enter(&mut self, statement: usize) {
        self.statement = statement;
    }

    /// Something reads the variable here.
    pub(crate) fn read(&mut self, variable: VariableId, place: Span) {
        self.reads.push(ReadPlace {
            statement: self.statement,
            variable,
            place,
        });
        self.first_read[variable].get_or_insert(place);
    }

    /// Something assigns the variable.
    pub(crate) fn assign(&mut self, variable: VariableId) {
        self.assigned[variable] = true;
    }

    /// A broken statement may do anything with the variable.
    pub(crate) fn excuse(&mut self, variable: VariableId) {
        self.excused[variable] = true;
    }

    /// OUTPUT_VARIABLES writes every variable to a file.
    pub(crate) fn dump(&mut self) {
        self.dumped = true;
    }

    /// Every read, in the order of the source.
    pub(crate) fn into_reads(self) -> Vec<ReadPlace> {
        self.reads
    }

    /// Reports reads that nothing assigned, and variables that serve nothing.
    pub(crate) fn report(&self, names: &Names, found: &mut Vec<Diagnostic>) {
        for (id, variable) in names.variables.iter().enumerate() {
            if self.excused[id] {
                continue;
            }
            let name = &variable.name;
            let finding = match (self.first_read[id], self.assigned[id], names.declared[id]) {
                (Some(place), false, declared) => {
                    Some(never_assigned(name, variable.kind, place, declared))
                }
                (None, false, Some(declared)) => {
                    let reason = "nothing uses this name";
                    Some(Diagnostic::new(Code::Unused, declared, reason).about(name))
                }
                (None, true, Some(declared)) if !self.dumped => {
                    let reason = "nothing reads this variable";
                    Some(Diagnostic::new(Code::NeverRead, declared, reason).about(name))
                }
                _ => None,
            };
            found.extend(finding);
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
