//! The scalars that a step reads and assigns, as indices among all scalars.

use crate::program::{
    Action, Condition, MessagePart, Operand, Program, Scalar, ScalarExpression, StructExpression,
    StructOperand, VariableId,
};
use std::ops::Range;

/// Calls `found` with each scalar that a step reads, in the order of reading. A scalar may come twice.
pub fn reads(program: &Program, action: &Action, found: impl FnMut(usize)) {
    Reads { program, found }.action(action);
}

/// Returns the scalars that a step assigns. They have neighbouring indices.
pub fn assigns(program: &Program, action: &Action) -> Range<usize> {
    match action {
        Action::SetScalar { target: into, .. }
        | Action::For { variable: into, .. }
        | Action::Next { variable: into, .. }
        | Action::TeachScalar { into, .. }
        | Action::AdIn { into, .. }
        | Action::KeyIn { into } => {
            let scalar = program.scalar_index(*into);
            scalar..scalar + 1
        }
        Action::SetStruct { target: into, .. } | Action::TeachStruct { into, .. } => {
            members(program, *into)
        }
        Action::Nothing
        | Action::If { .. }
        | Action::ElseIf { .. }
        | Action::Else { .. }
        | Action::While { .. }
        | Action::Goto { .. }
        | Action::Until { .. }
        | Action::IfGoto { .. }
        | Action::Gosub { .. }
        | Action::IfGosub { .. }
        | Action::Return
        | Action::Finish(_)
        | Action::Command { .. }
        | Action::StartThread { .. }
        | Action::StopThread { .. }
        | Action::WaitThread { .. }
        | Action::ThreadEnd
        | Action::FileMessage { .. }
        | Action::Message { .. } => 0..0,
    }
}

/// Returns the scalars of a variable.
fn members(program: &Program, variable: VariableId) -> Range<usize> {
    let variable = &program.variables()[variable];
    variable.first..variable.first + variable.size()
}

struct Reads<'a, F> {
    program: &'a Program,
    found: F,
}

impl<F: FnMut(usize)> Reads<'_, F> {
    fn action(&mut self, action: &Action) {
        match action {
            Action::SetScalar {
                target,
                update,
                value,
            } => {
                self.scalar_expression(*value);
                if update.is_some() {
                    self.scalar(*target);
                }
            }
            Action::SetStruct {
                target,
                update,
                value,
            } => {
                self.struct_expression(*value);
                if update.is_some() {
                    self.variable(*target);
                }
            }
            Action::If { condition, .. }
            | Action::ElseIf { condition, .. }
            | Action::While { condition, .. }
            | Action::Until { condition, .. }
            | Action::IfGoto { condition, .. }
            | Action::IfGosub { condition, .. } => self.condition(*condition),
            Action::For { from, to, step, .. } => self.operands([*from, *to, *step]),
            Action::Next {
                variable, to, step, ..
            } => {
                self.scalar(*variable);
                self.operands([*step, *to]);
            }
            Action::Command { arguments, .. } => {
                self.operands(arguments.iter().map(|argument| argument.operand));
            }
            Action::Message { parts } | Action::FileMessage { parts } => {
                for part in parts {
                    if let MessagePart::Value { operand, .. } = part {
                        self.operands([*operand]);
                    }
                }
            }
            Action::Nothing
            | Action::Else { .. }
            | Action::Goto { .. }
            | Action::Gosub { .. }
            | Action::Return
            | Action::Finish(_)
            | Action::TeachStruct { .. }
            | Action::TeachScalar { .. }
            | Action::AdIn { .. }
            | Action::StartThread { .. }
            | Action::StopThread { .. }
            | Action::WaitThread { .. }
            | Action::ThreadEnd
            | Action::KeyIn { .. } => {}
        }
    }

    fn scalar(&mut self, scalar: Scalar) {
        (self.found)(self.program.scalar_index(scalar));
    }

    fn variable(&mut self, variable: VariableId) {
        members(self.program, variable).for_each(&mut self.found);
    }

    fn structure(&mut self, whole: StructOperand) {
        if let StructOperand::Variable(variable) = whole {
            self.variable(variable);
        }
    }

    fn operands(&mut self, operands: impl IntoIterator<Item = Operand>) {
        for operand in operands {
            if let Operand::Scalar { scalar, .. } = operand {
                self.scalar(scalar);
            }
        }
    }

    fn condition(&mut self, condition: Condition) {
        if let Condition::Compare { left, right, .. } = condition {
            self.operands([left, right]);
        }
    }

    fn scalar_expression(&mut self, value: ScalarExpression) {
        match value {
            ScalarExpression::Operand(operand) | ScalarExpression::Function { operand, .. } => {
                self.operands([operand]);
            }
            ScalarExpression::Binary { left, right, .. } => self.operands([left, right]),
            ScalarExpression::Atan2 { y, x } => self.operands([y, x]),
            ScalarExpression::Norm(whole) => self.structure(whole),
        }
    }

    fn struct_expression(&mut self, value: StructExpression) {
        match value {
            StructExpression::Copy(whole) | StructExpression::UnitVect(whole) => {
                self.structure(whole);
            }
            StructExpression::Binary { left, right, .. } => {
                self.structure(left);
                self.structure(right);
            }
            StructExpression::Rotate { operand, angle, .. } => {
                self.structure(operand);
                self.operands([angle]);
            }
        }
    }
}
