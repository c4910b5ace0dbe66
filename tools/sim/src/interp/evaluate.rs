//! The values of operands, equations and conditions. Nothing here changes the state.

use super::Interpreter;
use tip_runtime::command::MAX;
use tip_runtime::fault::Fault;
use tip_runtime::ops::{self, Domain};
use tipc::program::{
    Arithmetic, Axis, Condition, Flag, Operand, Relation, Scalar, ScalarExpression,
    StructExpression, StructOperand, VariableId,
};

impl Interpreter {
    pub(super) fn read(&self, scalar: Scalar) -> Result<f64, Fault> {
        let index = self.program.scalar_index(scalar);
        self.scalars[index].ok_or(Fault::Unassigned(index as u32))
    }

    pub(super) fn operand(&self, operand: Operand) -> Result<f64, Fault> {
        match operand {
            Operand::Constant(value) => Ok(value),
            Operand::Scalar { scalar, negative } => {
                let value = self.read(scalar)?;
                Ok(if negative { -value } else { value })
            }
            // Special variables are not interpreted yet.
            Operand::Reading { .. } => Err(Fault::Domain),
        }
    }

    /// Returns the members of a struct that is a variable or special variable.
    fn read_whole(&self, whole: StructOperand) -> Result<Vec<f64>, Fault> {
        match whole {
            StructOperand::Variable(variable) => self.read_struct(variable),
            // Special variables are not interpreted yet.
            StructOperand::Reading(_) => Err(Fault::Domain),
        }
    }

    /// Returns the members of a struct.
    pub(super) fn read_struct(&self, variable: VariableId) -> Result<Vec<f64>, Fault> {
        (0..self.program.variables()[variable].size())
            .map(|member| self.read(Scalar { variable, member }))
            .collect()
    }

    fn read_vector(&self, whole: StructOperand) -> Result<[f64; 3], Fault> {
        let mut vector = [0.0; 3];
        for (place, value) in vector.iter_mut().zip(self.read_whole(whole)?) {
            *place = value;
        }
        Ok(vector)
    }

    pub(super) fn scalar_value(
        &self,
        target: Scalar,
        update: Option<Arithmetic>,
        value: ScalarExpression,
    ) -> Result<f64, Fault> {
        let value = self.scalar_expression(value)?;
        match update {
            None => Ok(value),
            Some(operation) => Ok(combine(operation, self.read(target)?, value)?),
        }
    }

    /// Evaluates the right side of an equation.
    pub(crate) fn scalar_expression(&self, value: ScalarExpression) -> Result<f64, Fault> {
        match value {
            ScalarExpression::Operand(operand) => self.operand(operand),
            ScalarExpression::Binary {
                left,
                operation,
                right,
            } => {
                let left = self.operand(left)?;
                let right = self.operand(right)?;
                Ok(combine(operation, left, right)?)
            }
            ScalarExpression::Function { function, operand } => {
                Ok(function.call(self.operand(operand)?)?)
            }
            ScalarExpression::Atan2 { y, x } => {
                let y = self.operand(y)?;
                let x = self.operand(x)?;
                Ok(ops::atan2(y, x)?)
            }
            ScalarExpression::Norm(whole) => {
                // Members beyond the struct's own count as zeros, which change no sum of squares.
                let mut members = [0.0; MAX];
                for (place, value) in members.iter_mut().zip(self.read_whole(whole)?) {
                    *place = value;
                }
                Ok(ops::norm(members)?)
            }
        }
    }

    pub(super) fn struct_value(
        &self,
        target: VariableId,
        update: Option<Arithmetic>,
        value: StructExpression,
    ) -> Result<Vec<f64>, Fault> {
        let value = self.struct_expression(value)?;
        match update {
            None => Ok(value),
            Some(operation) => Ok(combine_each(operation, &self.read_struct(target)?, &value)?),
        }
    }

    fn struct_expression(&self, value: StructExpression) -> Result<Vec<f64>, Fault> {
        match value {
            StructExpression::Copy(whole) => self.read_whole(whole),
            StructExpression::Binary {
                left,
                operation,
                right,
            } => {
                let left = self.read_whole(left)?;
                let right = self.read_whole(right)?;
                Ok(combine_each(operation, &left, &right)?)
            }
            StructExpression::UnitVect(whole) => {
                Ok(ops::unit_vect(self.read_vector(whole)?)?.to_vec())
            }
            StructExpression::Rotate {
                axis,
                operand,
                angle,
            } => {
                let vector = self.read_vector(operand)?;
                let angle = self.operand(angle)?;
                let turned = match axis {
                    Axis::X => ops::rot_x(vector, angle),
                    Axis::Y => ops::rot_y(vector, angle),
                    Axis::Z => ops::rot_z(vector, angle),
                };
                Ok(turned?.to_vec())
            }
        }
    }

    pub(crate) fn holds(
        &self,
        condition: Condition,
        flag_is_up: &dyn Fn(Flag) -> bool,
    ) -> Result<bool, Fault> {
        match condition {
            Condition::Compare {
                left,
                relation,
                right,
            } => {
                let left = self.operand(left)?;
                let right = self.operand(right)?;
                Ok(match relation {
                    Relation::Eq => left == right,
                    Relation::Ne => left != right,
                    Relation::Lt => left < right,
                    Relation::Gt => left > right,
                    Relation::Le => left <= right,
                    Relation::Ge => left >= right,
                })
            }
            Condition::Flag { flag, negated } => Ok(flag_is_up(flag) != negated),
        }
    }
}

fn combine(operation: Arithmetic, left: f64, right: f64) -> Result<f64, Domain> {
    match operation {
        Arithmetic::Add => ops::add(left, right),
        Arithmetic::Sub => ops::sub(left, right),
        Arithmetic::Mul => ops::mul(left, right),
        Arithmetic::Div => ops::div(left, right),
    }
}

fn combine_each(operation: Arithmetic, left: &[f64], right: &[f64]) -> Result<Vec<f64>, Domain> {
    left.iter()
        .zip(right)
        .map(|(left, right)| combine(operation, *left, *right))
        .collect()
}
