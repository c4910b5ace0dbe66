//! Programs built by hand, for unit tests.

use crate::language::reserved::VAR_KEY;
use crate::program::{
    Action, Argument, Condition, Label, LabelKind, Mark, Operand, Program, Relation, Scalar, Step,
    StepId, Variable, VariableKind,
};
use tip_runtime::model::titan8;

/// Returns a program for TITAN VIII: `VAR_KEY`, the variables of these names and types, and a step for
/// each action, one a line from line 3 on.
pub(crate) fn program(variables: &[(&str, VariableKind)], actions: Vec<Action>) -> Program {
    let signature = titan8::MODEL.signature();
    let mut declared = Vec::new();
    let mut first = 0;
    for (name, kind) in [(VAR_KEY, VariableKind::Var)].iter().chain(variables) {
        let variable = Variable {
            name: (*name).to_owned(),
            kind: *kind,
            first,
            joints: usize::from(signature.joints),
            special: None,
        };
        first += variable.size();
        declared.push(variable);
    }
    let steps = (3..).zip(actions).map(|(line, action)| Step {
        action,
        line,
        column: 1,
        text: format!("LINE {line}").into(),
    });
    Program {
        source_name: "by_hand.prg".to_owned(),
        source_hash: 0x0123_4567_89ab_cdef,
        edition: crate::language::Edition::default(),
        title: "built by hand".to_owned(),
        signature,
        variables: declared,
        constants: Vec::new(),
        labels: Vec::new(),
        threads: Vec::new(),
        steps: steps.collect(),
    }
}

/// Adds labels to a program.
pub(crate) fn labelled(mut program: Program, labels: &[(&str, StepId)]) -> Program {
    program.labels = labels
        .iter()
        .map(|(name, step)| Label {
            name: (*name).to_owned(),
            step: *step,
            kind: LabelKind::Plain,
        })
        .collect();
    program
}

/// Returns the scalar of a VAR.
pub(crate) fn scalar(variable: usize) -> Scalar {
    member(variable, 0)
}

/// Returns a member of a struct.
pub(crate) fn member(variable: usize, member: usize) -> Scalar {
    Scalar { variable, member }
}

/// Returns a scalar as an operand.
pub(crate) fn read(variable: usize) -> Operand {
    Operand::Scalar {
        scalar: scalar(variable),
        negative: false,
    }
}

/// Returns a constant as an operand.
pub(crate) fn constant(value: f64) -> Operand {
    Operand::Constant(value)
}

/// Returns a constant as an argument.
pub(crate) fn argument(value: f64) -> Argument {
    Argument {
        operand: constant(value),
        mark: Mark::None,
    }
}

/// Returns a comparison.
pub(crate) fn compare(left: Operand, relation: Relation, right: Operand) -> Condition {
    Condition::Compare {
        left,
        relation,
        right,
    }
}
