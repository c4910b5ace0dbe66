//! What a program does with its names and loops.

use super::Card;
use crate::Document;
use crate::message::Editing;
use tip_lint::cycles::{Part, Span as PartSpan};
use tipc::language::Keyword;
use tipc::message::Message;
use tipc::message::list::List;
use tipc::program::{Action, StepId};
use tipc::symbols::{Access, Definition, DefinitionKind, Use};
use tipc::syntax::{Counting, Expression, OperandKind, StatementKind, VariableKind};

/// The most values that are listed.
const VALUES: usize = 8;

impl Document {
    pub(super) fn name_card(&self, named: &Use, card: &mut Card) -> Option<()> {
        let definition = self.definition_of(named);
        card.code(&declaration(definition));
        match definition.place {
            Some(place) => card.item(Editing::DeclaredOn {
                line: self.line_of(place.start),
            }),
            None => card.item(Editing::Predeclared),
        }
        match definition.kind {
            DefinitionKind::Variable(_) => self.variable(named, card),
            DefinitionKind::Label | DefinitionKind::Subroutine => self.label(named, card),
        }
        Some(())
    }

    fn variable(&self, named: &Use, card: &mut Card) {
        let uses = || self.loaded.symbols.uses(named.definition);
        let count = |wanted: &[Access]| uses().filter(|it| wanted.contains(&it.access)).count();
        card.item(Editing::Touched {
            assigned: count(&[Access::Assign, Access::Update, Access::Count]),
            read: count(&[Access::Read, Access::Update, Access::Count]),
        });
        let meant: Vec<&Use> = uses().filter(|it| overlaps(named, it)).collect();
        if let Some(counting) = self.counting(&meant) {
            card.item(counting);
        }
        if let Some(values) = self.constants(&meant).filter(|values| !values.is_empty()) {
            card.item(Editing::Given {
                values: List(values),
            });
        }
    }

    /// The numbers that are assigned, if nothing else is and they can be listed.
    fn constants(&self, uses: &[&Use]) -> Option<Vec<String>> {
        let mut values = Vec::new();
        for it in uses {
            match it.access {
                Access::Assign => {
                    let value = self.constant(it)?.to_string();
                    if !values.contains(&value) {
                        values.push(value);
                    }
                    if values.len() > VALUES {
                        return None;
                    }
                }
                Access::Update | Access::Count | Access::Unclear => return None,
                Access::Define | Access::Read | Access::Jump | Access::Call => {}
            }
        }
        Some(values)
    }

    /// The number that an equation assigns there.
    fn constant(&self, named: &Use) -> Option<f64> {
        let module = &self.loaded.module;
        let statement = &module.statements[module.statement_at(named.place.start)?];
        let StatementKind::Equation(equation) = &statement.kind else {
            return None;
        };
        match &equation.value {
            Expression::Operand(operand) if equation.update.is_none() => match operand.kind {
                OperandKind::Number(value) => Some(value),
                _ => None,
            },
            _ => None,
        }
    }

    /// What the only FOR counts.
    fn counting(&self, uses: &[&Use]) -> Option<Editing> {
        let mut updates = uses.iter().filter(|it| it.access == Access::Update);
        let (update, None) = (updates.next()?, updates.next()) else {
            return None;
        };
        let module = &self.loaded.module;
        let statement = &module.statements[module.statement_at(update.place.start)?];
        let StatementKind::For { counting, .. } = &statement.kind else {
            return None;
        };
        let Counting { from, to, .. } = &**counting;
        match (&from.kind, &to.kind) {
            (OperandKind::Number(from), OperandKind::Number(to)) => Some(Editing::Counted {
                from: *from,
                to: *to,
            }),
            _ => None,
        }
    }

    fn label(&self, named: &Use, card: &mut Card) {
        let uses = || self.loaded.symbols.uses(named.definition);
        let count = |wanted: Access| uses().filter(|it| it.access == wanted).count();
        card.item(Editing::Jumped {
            jumps: count(Access::Jump),
            calls: count(Access::Call),
        });
        let Some(step) = self.step_of(self.definition_of(named)) else {
            return;
        };
        card.item(Editing::Step { step });
        let of_it = |part: &&Part| part.span == PartSpan::Subroutine { entry: step };
        if let Some(part) = self.parts().iter().find(of_it) {
            let length = Box::new(self.length(part.cycles));
            card.item(Editing::Returns { length });
        }
        if let Some(turns) = self.turns_of(step) {
            card.item(turns);
        }
    }

    fn step_of(&self, definition: &Definition) -> Option<StepId> {
        let module = &self.loaded.module;
        let index = module.statement_at(definition.place?.start)?;
        Some(module.statements[index].step)
    }

    /// The turns of the loop that begins with a step.
    pub(crate) fn turns_of(&self, step: StepId) -> Option<Message> {
        let part = self
            .parts()
            .iter()
            .find(|part| self.opener(part) == Some(step))?;
        Some(self.turns(part))
    }

    /// The step that a loop is known by: its FOR, or the one that its jump leads back to.
    pub(crate) fn opener(&self, part: &Part) -> Option<StepId> {
        let PartSpan::Turn { head, .. } = part.span else {
            return None;
        };
        let steps = self.loaded.program.as_ref()?.steps();
        let before = head.checked_sub(1);
        let is_for = |step: &StepId| {
            let step = steps.get(*step as usize);
            step.is_some_and(|step| matches!(step.action, Action::For { .. }))
        };
        Some(before.filter(is_for).unwrap_or(head))
    }

    pub(crate) fn turns(&self, part: &Part) -> Message {
        let length = Box::new(self.length(part.cycles));
        match part.span {
            PartSpan::Turn {
                turns: Some(turns), ..
            } => Editing::Turns {
                turns: turns.to_string(),
                length: Box::new(Editing::OneTurn { length }.into()),
            }
            .into(),
            _ => Editing::OneTurn { length }.into(),
        }
    }
}

/// Whether two places may mean the same number: the same member, or the whole.
fn overlaps(one: &Use, other: &Use) -> bool {
    one.member.is_none() || other.member.is_none() || one.member == other.member
}

/// How a name is declared.
fn declaration(definition: &Definition) -> String {
    let name = &definition.name;
    let keyword = match definition.kind {
        DefinitionKind::Variable(VariableKind::Var) => Keyword::DefVar,
        DefinitionKind::Variable(VariableKind::Pos) => Keyword::DefPos,
        DefinitionKind::Variable(VariableKind::Joint) => Keyword::DefJoint,
        DefinitionKind::Subroutine => return format!("{} {name}:", Keyword::Subroutine),
        DefinitionKind::Label => return format!("{name}:"),
    };
    format!("{keyword} {name}")
}
