//! A program as nested blocks, for the peers that are scripts.

use std::collections::BTreeMap;
use tipc::program::{Action, Condition, LabelKind, Operand, Program, Scalar, StepId};

/// The main program, and the subroutines by their first steps.
pub(crate) struct Blocks<'a> {
    pub(crate) main: Vec<Node<'a>>,
    pub(crate) subroutines: BTreeMap<StepId, Vec<Node<'a>>>,
}

/// A statement. Each step that it stands for takes a control cycle.
pub(crate) enum Node<'a> {
    /// A step.
    Step(&'a Action),
    /// A label, what follows it, and the GOTO that leads back.
    Endless(Vec<Node<'a>>),
    /// IF, what it guards, and ENDIF.
    If(Condition, Vec<Node<'a>>),
    /// FOR, its body, and NEXT.
    For(Scalar, Operand, Operand, Vec<Node<'a>>),
    /// CALL.
    Call(StepId),
}

/// Finds the blocks of a program.
///
/// # Panics
/// If jumps cross.
pub(crate) fn blocks(program: &Program) -> Blocks<'_> {
    let subroutines: Vec<StepId> = program
        .labels()
        .iter()
        .filter(|label| label.kind == LabelKind::Subroutine)
        .map(|label| label.step)
        .collect();
    let end = program.steps().len() as StepId - 1;
    let main_end = subroutines.first().copied().unwrap_or(end);
    let ends = subroutines.iter().skip(1).copied().chain([end]);
    let of = |(first, behind): (&StepId, StepId)| (*first, nodes(program, *first, behind));
    Blocks {
        main: nodes(program, 0, main_end),
        subroutines: subroutines.iter().zip(ends).map(of).collect(),
    }
}

fn nodes(program: &Program, first: StepId, behind: StepId) -> Vec<Node<'_>> {
    let steps = program.steps();
    let action = |at: StepId| &steps[at as usize].action;
    let mut nodes = Vec::new();
    let mut at = first;
    while at < behind {
        let (node, next) = match action(at) {
            Action::If {
                condition,
                otherwise,
            } => {
                let inner = self::nodes(program, at + 1, *otherwise);
                (Node::If(*condition, inner), otherwise + 1)
            }
            Action::For {
                variable,
                from,
                to,
                exit,
                ..
            } => {
                let inner = self::nodes(program, at + 1, exit - 1);
                (Node::For(*variable, *from, *to, inner), *exit)
            }
            Action::Gosub { to } => (Node::Call(*to), at + 1),
            Action::Nothing => {
                let leads_back = |step: &StepId| *action(*step) == Action::Goto { to: at };
                match (at + 1..behind).find(leads_back) {
                    Some(goto) => (Node::Endless(self::nodes(program, at + 1, goto)), goto + 1),
                    None => (Node::Step(action(at)), at + 1),
                }
            }
            plain => (Node::Step(plain), at + 1),
        };
        nodes.push(node);
        at = next;
    }
    nodes
}
