//! Notes every location that names a variable or label, in the order of the text.

use super::labels::Labels;
use super::names::{Names, ResolvedOperand};
use crate::code::Code;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::language::commands::{self, Meaning};
use crate::language::names::LIMIT;
use crate::message::phrase::Assign;
use crate::message::{Message, Naming};
use crate::parse::narrow;
use crate::program::VariableId;
use crate::source::{Source, Span};
use crate::symbols::{Access, Definition, DefinitionId, DefinitionKind, Symbols, Use};
use crate::syntax::{
    Jump, LabelKind, Operand, OperandKind, Shape, StatementKind, VariableKind, Word,
};
use std::collections::HashSet;
use std::iter;

/// The uses of names in the statements that have been read so far.
pub(super) struct Uses<'a> {
    names: &'a Names,
    labels: &'a Labels<'a>,
    /// In the order of the text.
    all: Vec<Use>,
    /// The first use of the statement that is being looked at.
    first: usize,
    /// The next variable and the next label to be defined.
    next: (VariableId, usize),
    suppressed: Vec<bool>,
    to_be_shown: Vec<bool>,
    dumped: bool,
    may_assign: Vec<VariableKind>,
}

/// The uses of all names of a program.
pub(super) struct NameUses {
    pub(super) symbols: Symbols,
    /// Number of labels.
    pub(super) labels: usize,
    /// For each variable, true if a broken statement names it: no warning about it is sure.
    suppressed: Vec<bool>,
    /// For each variable, true if a MESSAGE was meant to show it but does not: then nothing reads it, and that is not
    /// reported again.
    to_be_shown: Vec<bool>,
    /// True if the program has OUTPUT_VARIABLES, which reads every variable.
    dumped: bool,
    /// Types whose variables a wrong statement may assign: it is not reported that one of them is never assigned.
    may_assign: Vec<VariableKind>,
}

impl<'a> Uses<'a> {
    pub(super) fn new(names: &'a Names, labels: &'a Labels<'a>) -> Self {
        Uses {
            names,
            labels,
            all: Vec::new(),
            first: 0,
            next: (names.predeclared(), 0),
            suppressed: vec![false; names.variables.len()],
            to_be_shown: vec![false; names.variables.len()],
            dumped: false,
            may_assign: Vec::new(),
        }
    }

    /// Goes on to the next statement.
    pub(super) fn enter(&mut self) {
        self.first = self.all.len();
    }

    /// Returns all uses.
    pub(super) fn finish(self) -> NameUses {
        NameUses {
            labels: self.labels.all.len(),
            symbols: Symbols::new(definitions(self.names, self.labels), self.all),
            suppressed: self.suppressed,
            to_be_shown: self.to_be_shown,
            dumped: self.dumped,
            may_assign: self.may_assign,
        }
    }

    /// Records the name of a declaration.
    pub(super) fn declare(&mut self, word: &Word) {
        let (next, _) = self.next;
        let is_next = self.names.declared.get(next) == Some(&Some(word.span));
        self.next.0 += usize::from(is_next);
        let variable = match is_next {
            true => Some(next),
            false => self.names.find(&word.node),
        };
        if let Some(variable) = variable {
            self.note(
                word.span,
                DefinitionId::of_variable(variable),
                Access::Define,
            );
        }
    }

    /// Records the name of a DEFINE.
    pub(super) fn define(&mut self, word: &Word) {
        if let Some(constant) = self.names.find_constant(&word.node) {
            self.note(word.span, self.of_constant(constant), Access::Define);
        }
    }

    /// Records a constant that is named at this location.
    pub(super) fn constant(&mut self, location: Span, constant: usize) {
        self.note(location, self.of_constant(constant), Access::Read);
    }

    fn of_constant(&self, constant: usize) -> DefinitionId {
        let before = self.names.variables.len() + self.labels.all.len();
        DefinitionId::of_constant(constant, before)
    }

    /// Records a label or the name of a SUBROUTINE or THREAD, defined by a statement.
    pub(super) fn define_label(&mut self, word: &Word, statement: usize) {
        let (_, next) = self.next;
        let is_next = self
            .labels
            .all
            .get(next)
            .is_some_and(|label| label.statement == statement);
        self.next.1 += usize::from(is_next);
        let label = match is_next {
            true => Some(next),
            false => self.labels.find(&word.node),
        };
        if let Some(label) = label {
            self.note(word.span, self.label(label), Access::Define);
        }
    }

    /// Records the label that a jump leads to, which GOTO may leave out.
    pub(super) fn jump(&mut self, statement: usize, jump: &Jump, access: Access) {
        let left_out = Span::new(jump.keyword.end, jump.keyword.end);
        let location = jump.label.as_ref().map_or(left_out, |label| label.span);
        if let Some(label) = self.labels.target_of(statement, jump) {
            self.note(location, self.label(label), access);
        }
    }

    /// Records an operand with its resolved meaning.
    pub(super) fn operand(&mut self, operand: &Operand, meant: ResolvedOperand, access: Access) {
        let (definition, member) = match meant {
            ResolvedOperand::Reading { .. } => return,
            ResolvedOperand::Constant(_) => match &operand.kind {
                OperandKind::Name(name) => match self.names.find_constant(name) {
                    Some(constant) => (self.of_constant(constant), None),
                    None => return,
                },
                OperandKind::Number(_) | OperandKind::Member(_) => return,
            },
            ResolvedOperand::Struct { variable, .. } => (DefinitionId::of_variable(variable), None),
            ResolvedOperand::Scalar { scalar, member, .. } => {
                let index = u8::try_from(scalar.member).ok();
                let definition = DefinitionId::of_variable(scalar.variable);
                (definition, index.filter(|_| member))
            }
        };
        let Some(name) = operand.name() else { return };
        let start = operand.span.start + usize::from(operand.negative);
        self.all.push(Use {
            span: Span::new(start, start + name.len()),
            definition,
            access,
            member,
            negative: operand.negative,
        });
    }

    /// Records a whole variable without sign: the name at this location, or none if it is empty.
    pub(super) fn variable(&mut self, location: Span, variable: VariableId, access: Access) {
        self.note(location, DefinitionId::of_variable(variable), access);
    }

    /// Records a variable without sign, or a member of it: the name at this location.
    pub(super) fn member(
        &mut self,
        location: Span,
        variable: VariableId,
        member: Option<usize>,
        access: Access,
    ) {
        self.note(location, DefinitionId::of_variable(variable), access);
        if let Some(last) = self.all.last_mut() {
            last.member = member.and_then(|member| u8::try_from(member).ok());
        }
    }

    /// Records that OUTPUT_VARIABLES writes every variable to a file.
    pub(super) fn dump(&mut self) {
        self.dumped = true;
    }

    /// Suppresses warnings about the variables that the text of a wrong statement names: it may read or assign each of
    /// them.
    pub(super) fn suppress_named(&mut self, source: &Source, statement: Span) {
        let text = source.slice(statement);
        let is_outside = |char: char| !(char.is_ascii_alphanumeric() || char == '_');
        let known = self.all[self.first..].iter().map(|it| it.span.start);
        let known: HashSet<usize> = known.collect();
        let mut start = 0;
        for word in text.split_inclusive(is_outside) {
            let name = word.trim_end_matches(is_outside);
            let location = Span::new(
                statement.start + start,
                statement.start + start + name.len(),
            );
            start += word.len();
            let upper = name.to_ascii_uppercase();
            let Some(definition) = self.named(&upper) else {
                // `2B` is no name, but may mean `B`.
                let behind_digits = upper.trim_start_matches(|it: char| it.is_ascii_digit());
                if let Some(meant) = self.named(behind_digits) {
                    self.suppress(meant);
                }
                continue;
            };
            self.suppress(definition);
            let is_member = source.text()[..location.start].ends_with('.');
            if !is_member && !known.contains(&location.start) {
                self.note(location, definition, Access::Unclear);
            }
        }
        self.all[self.first..].sort_by_key(|it| it.span);
        if !text.is_ascii() {
            let narrow = narrow(text).to_ascii_uppercase();
            let names = narrow.split(is_outside);
            let meant: Vec<_> = names.filter_map(|name| self.named(name)).collect();
            meant.into_iter().for_each(|it| self.suppress(it));
        }
    }

    /// Records the types of variable that a wrong statement may assign, unless it names a declared variable.
    pub(super) fn may_assign(&mut self, kind: &StatementKind) {
        let unknown = |operand: Option<&Operand>| {
            let name = operand.and_then(Operand::name);
            name.is_none_or(|name| self.names.find(name).is_none())
        };
        let kinds: &[VariableKind] = match kind {
            StatementKind::Broken(Shape::For) => &[VariableKind::Var],
            StatementKind::For { counting, .. } if unknown(Some(&counting.variable)) => {
                &[VariableKind::Var]
            }
            StatementKind::Equation(equation) if unknown(Some(&equation.target)) => {
                match &equation.target.kind {
                    OperandKind::Member(_) => &[VariableKind::Pos, VariableKind::Joint],
                    _ => &[VariableKind::Var, VariableKind::Pos, VariableKind::Joint],
                }
            }
            StatementKind::Command {
                name, arguments, ..
            } if unknown(arguments.last()) => {
                match commands::find(&name.node).map(|command| command.meaning) {
                    Some(Meaning::AdIn | Meaning::KeyIn) => &[VariableKind::Var],
                    Some(Meaning::Teach(_)) => &[VariableKind::Pos, VariableKind::Joint],
                    _ => &[],
                }
            }
            _ => &[],
        };
        let new = kinds.iter().filter(|kind| !self.may_assign.contains(kind));
        let new: Vec<VariableKind> = new.copied().collect();
        self.may_assign.extend(new);
    }

    /// Records that a MESSAGE was meant to show the variable but does not.
    pub(super) fn was_to_be_shown(&mut self, variable: VariableId) {
        self.to_be_shown[variable] = true;
    }

    fn suppress(&mut self, definition: DefinitionId) {
        if let Some(suppressed) = self.suppressed.get_mut(definition.index()) {
            *suppressed = true;
        }
    }

    /// Returns the variable of that name, else the label.
    fn named(&self, name: &str) -> Option<DefinitionId> {
        let variable = self.names.find(name).map(DefinitionId::of_variable);
        let constant = || self.names.find_constant(name);
        let constant = || constant().map(|constant| self.of_constant(constant));
        variable
            .or_else(|| self.labels.find(name).map(|label| self.label(label)))
            .or_else(constant)
    }

    fn label(&self, label: usize) -> DefinitionId {
        DefinitionId::of_label(label, self.names.variables.len())
    }

    fn note(&mut self, location: Span, definition: DefinitionId, access: Access) {
        self.all.push(Use {
            span: location,
            definition,
            access,
            member: None,
            negative: false,
        });
    }
}

fn definitions(names: &Names, labels: &Labels<'_>) -> Vec<Definition> {
    let variables = names.variables.iter().zip(&names.declared);
    let variables = variables.map(|(variable, location)| Definition {
        name: variable.name.as_str().into(),
        kind: DefinitionKind::Variable(variable.kind),
        span: *location,
    });
    let labels = labels.all.iter().map(|label| Definition {
        name: label.name.node.clone(),
        kind: match label.kind {
            LabelKind::Thread => DefinitionKind::Thread,
            LabelKind::Subroutine => DefinitionKind::Subroutine,
            LabelKind::Plain => DefinitionKind::Label,
        },
        span: Some(label.name.span),
    });
    let constants = names.constants.iter().map(|constant| Definition {
        name: constant.name.clone(),
        kind: DefinitionKind::Constant,
        span: Some(constant.span),
    });
    variables.chain(labels).chain(constants).collect()
}

/// Reports variables that are read and never assigned, assigned and never read, or never used, and unused constants.
pub(super) fn report(source: &Source, names: &Names, named: &NameUses, found: &mut Diagnostics) {
    let mut uses = vec![VariableUse::default(); names.variables.len()];
    for used in named.symbols.all_uses() {
        if let Some(one) = uses.get_mut(used.definition.index()) {
            one.add(used);
        }
    }
    // A misspelled name probably means the one that was suggested for it, which therefore counts as used.
    let is_meant = names.was_suggested();
    let first = uses.len() + named.labels;
    let mut used = vec![false; names.constants.len()];
    for one in named.symbols.all_uses() {
        let constant = one.definition.index().checked_sub(first);
        let constant = constant.filter(|_| one.access != Access::Define);
        if let Some(used) = constant.and_then(|constant| used.get_mut(constant)) {
            *used = true;
        }
    }
    // A constant is not reported as unused if its line has another diagnostic.
    let line = |span: Span| source.line_number(span.start);
    let mut reported: HashSet<u32> = match names.constants.is_empty() {
        true => HashSet::new(),
        false => found.iter().flat_map(reported_at).map(line).collect(),
    };
    for (constant, used) in names.constants.iter().zip(used) {
        if !used && !is_meant(&constant.name) && reported.insert(line(constant.span)) {
            let reason = Naming::NothingUsesConstant;
            let warning = Diagnostic::new(Code::UnusedConstant, constant.span, reason);
            found.push(warning.about(constant.name.as_str()));
        }
    }
    for (id, variable) in names.variables.iter().enumerate() {
        let is_refused = variable.name.len() > LIMIT;
        let is_shared = variable.special.is_some();
        if named.suppressed[id] || is_refused || is_shared || is_meant(&variable.name) {
            continue;
        }
        let name = &variable.name;
        let VariableUse { read, assigned } = uses[id];
        // A wrong statement may assign this variable.
        if !assigned && named.may_assign.contains(&variable.kind) {
            continue;
        }
        let diagnostic = match (read, assigned, names.declared[id]) {
            (Some(read), false, declared) => {
                let location = read.operand(source);
                Some(never_assigned(name, variable.kind, location, declared))
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
        found.extend(diagnostic);
    }
}

/// Returns the places that a diagnostic names as wrong: its own, and those where it occurs again.
fn reported_at(diagnostic: &Diagnostic) -> impl Iterator<Item = Span> {
    let also = Message::from(Naming::AlsoHere);
    let more = diagnostic.labels.iter();
    let more = more.filter(move |label| label.text == also);
    iter::once(diagnostic.span).chain(more.map(|label| label.span))
}

/// Use of a variable by a program.
#[derive(Clone, Copy, Default)]
struct VariableUse<'a> {
    /// The first read.
    read: Option<&'a Use>,
    assigned: bool,
}

impl<'a> VariableUse<'a> {
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
            // NEXT reads and assigns only the variable that its FOR has assigned.
            Access::Count
            | Access::Define
            | Access::Jump
            | Access::Call
            | Access::Start
            | Access::Control
            | Access::Unclear => {}
        }
    }
}

fn never_assigned(
    name: &str,
    kind: VariableKind,
    location: Span,
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
    let fault = Diagnostic::new(Code::NeverAssigned, location, reason).help(help);
    match declared {
        Some(declared) => fault.label(declared, Naming::DeclaredHere),
        None => fault,
    }
}
