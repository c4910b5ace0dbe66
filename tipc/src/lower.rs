//! The only maker of [`Program`]: decides what a statement means.

use crate::check::{Checked, Resolved};
use crate::program::{Action, End, Label, Program, Step, StepId};
use crate::robot::Robot;
use crate::source::Source;
use crate::syntax::{Module, StatementKind, Then};

/// Lowers a module in which nothing was found wrong.
pub(crate) fn lower(
    source: &Source,
    module: &Module,
    mut checked: Checked<'_>,
    robot: Robot,
) -> Program {
    let mut resolved = std::mem::take(&mut checked.resolved);
    let lowering = Lowering {
        module,
        checked: &checked,
    };
    let steps = module
        .statements
        .iter()
        .enumerate()
        .filter(|(_, statement)| statement.is_step())
        .map(|(index, statement)| {
            let column = source.column(statement.span.start);
            Step {
                action: lowering.action(index, &mut resolved),
                line: statement.line,
                column,
                text: source.slice(statement.span).into(),
            }
        })
        .collect();
    let labels = checked
        .labels
        .all
        .iter()
        .map(|label| Label {
            name: label.name.node.to_string(),
            step: module.statements[label.statement].step,
            subroutine: label.subroutine,
        })
        .collect();
    Program {
        source_name: base_name(source.name()).to_owned(),
        source_hash: source.hash(),
        edition: module.edition,
        title: module.title.clone(),
        signature: robot.signature(),
        variables: checked.variables,
        labels,
        steps,
    }
}

fn base_name(path: &str) -> &str {
    path.rsplit(['/', '\\']).next().unwrap_or(path)
}

struct Lowering<'a> {
    module: &'a Module,
    checked: &'a Checked<'a>,
}

impl Lowering<'_> {
    /// What a statement does; a finished action is taken out of `resolved`.
    fn action(&self, index: usize, resolved: &mut [Resolved]) -> Action {
        match &mut resolved[index] {
            Resolved::Action(action) => std::mem::replace(action, Action::Nothing),
            Resolved::Condition(condition) => self.conditional(index, *condition),
            Resolved::For {
                variable,
                from,
                to,
                step,
            } => Action::For {
                variable: *variable,
                from: *from,
                to: *to,
                step: *step,
                exit: self.partner(index) + 1,
            },
            Resolved::Plain | Resolved::Failed => self.plain(index, resolved),
        }
    }

    fn conditional(&self, index: usize, condition: crate::program::Condition) -> Action {
        match &self.module.statements[index].kind {
            StatementKind::If {
                then: Then::Goto(_),
                ..
            } => Action::IfGoto {
                condition,
                to: self.jump(index),
            },
            StatementKind::If {
                then: Then::Gosub(_),
                ..
            } => Action::IfGosub {
                condition,
                to: self.jump(index),
            },
            StatementKind::ElseIf { .. } => Action::ElseIf {
                condition,
                otherwise: self.partner(index),
            },
            StatementKind::While { .. } => Action::While {
                condition,
                exit: self.partner(index) + 1,
            },
            StatementKind::Until { .. } => Action::Until {
                condition,
                back: self.partner(index),
            },
            _ => Action::If {
                condition,
                otherwise: self.partner(index),
            },
        }
    }

    fn plain(&self, index: usize, resolved: &[Resolved]) -> Action {
        match &self.module.statements[index].kind {
            StatementKind::Else => Action::Else {
                end: self.partner(index),
            },
            StatementKind::Wend => Action::Goto {
                to: self.partner(index),
            },
            StatementKind::Goto(_) => Action::Goto {
                to: self.jump(index),
            },
            StatementKind::Gosub(_) | StatementKind::Call(_) => Action::Gosub {
                to: self.jump(index),
            },
            StatementKind::Next { .. } => self.next(index, resolved),
            StatementKind::Return | StatementKind::SubEnd => Action::Return,
            StatementKind::End => Action::Finish(End::End),
            StatementKind::Exit => Action::Finish(End::Exit),
            _ => Action::Nothing,
        }
    }

    fn next(&self, index: usize, resolved: &[Resolved]) -> Action {
        let opener = self.checked.blocks.links[index].partner.unwrap_or(index);
        match &resolved[opener] {
            Resolved::For {
                variable, to, step, ..
            } => Action::Next {
                variable: *variable,
                to: *to,
                step: *step,
                body: self.step(opener) + 1,
            },
            _ => Action::Nothing,
        }
    }

    /// The step that a control word is tied to; checked programs have one.
    fn partner(&self, index: usize) -> StepId {
        let partner = self.checked.blocks.links[index].partner;
        self.step(partner.unwrap_or(index))
    }

    /// The step that a jump leads to; checked programs have one.
    fn jump(&self, index: usize) -> StepId {
        self.step(self.checked.jumps[index].unwrap_or(index))
    }

    fn step(&self, index: usize) -> StepId {
        self.module.statements[index].step
    }
}
