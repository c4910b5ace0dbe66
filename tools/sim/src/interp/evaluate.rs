//! The values of operands, equations and conditions. Nothing here changes the state.

use super::{Interpreter, Sensed};
use tip_runtime::command::MAX;
use tip_runtime::fault::Fault;
use tip_runtime::ops::{self, Domain};
use tipc::program::{
    Arithmetic, Axis, Condition, Operand, Reading, Relation, Scalar, ScalarExpression,
    StructExpression, StructOperand, Teach, VariableId,
};

impl Interpreter {
    pub(super) fn read(&self, scalar: Scalar) -> Result<f64, Fault> {
        let index = self.program.scalar_index(scalar);
        self.scalars[index].ok_or(Fault::Unassigned(index as u32))
    }

    pub(super) fn operand(&self, operand: Operand, sensed: &dyn Sensed) -> Result<f64, Fault> {
        match operand {
            Operand::Constant(value) => Ok(value),
            Operand::Scalar { scalar, negative } => {
                let value = self.read(scalar)?;
                Ok(if negative { -value } else { value })
            }
            Operand::Reading {
                reading,
                member,
                negative,
            } => {
                let members = sensed.reading(reading)?;
                let value = *members.get(member).ok_or(Fault::Domain)?;
                Ok(if negative { -value } else { value })
            }
        }
    }

    /// Returns the members of a struct that is a variable or special variable.
    fn read_whole(&self, whole: StructOperand, sensed: &dyn Sensed) -> Result<Vec<f64>, Fault> {
        match whole {
            StructOperand::Variable(variable) => self.read_struct(variable),
            StructOperand::Reading(reading) => {
                let mut members = sensed.reading(reading)?.to_vec();
                members.truncate(match reading {
                    Reading::Measured(Teach::Angle | Teach::Torque, _) => {
                        usize::from(self.program.signature().joints)
                    }
                    Reading::Measured(Teach::Position | Teach::Force, _) => 3,
                    Reading::Timer(_) => 1,
                });
                Ok(members)
            }
        }
    }

    /// Returns the members of a struct.
    pub(super) fn read_struct(&self, variable: VariableId) -> Result<Vec<f64>, Fault> {
        (0..self.program.variables()[variable].size())
            .map(|member| self.read(Scalar { variable, member }))
            .collect()
    }

    fn read_vector(&self, whole: StructOperand, sensed: &dyn Sensed) -> Result<[f64; 3], Fault> {
        let mut vector = [0.0; 3];
        for (place, value) in vector.iter_mut().zip(self.read_whole(whole, sensed)?) {
            *place = value;
        }
        Ok(vector)
    }

    pub(super) fn scalar_value(
        &self,
        target: Scalar,
        update: Option<Arithmetic>,
        value: ScalarExpression,
        sensed: &dyn Sensed,
    ) -> Result<f64, Fault> {
        let value = self.scalar_expression(value, sensed)?;
        match update {
            None => Ok(value),
            Some(operation) => Ok(combine(operation, self.read(target)?, value)?),
        }
    }

    /// Evaluates the right side of an equation.
    pub(crate) fn scalar_expression(
        &self,
        value: ScalarExpression,
        sensed: &dyn Sensed,
    ) -> Result<f64, Fault> {
        match value {
            ScalarExpression::Operand(operand) => self.operand(operand, sensed),
            ScalarExpression::Binary {
                left,
                operation,
                right,
            } => {
                let left = self.operand(left, sensed)?;
                let right = self.operand(right, sensed)?;
                Ok(combine(operation, left, right)?)
            }
            ScalarExpression::Function { function, operand } => {
                Ok(function.call(self.operand(operand, sensed)?)?)
            }
            ScalarExpression::Atan2 { y, x } => {
                let y = self.operand(y, sensed)?;
                let x = self.operand(x, sensed)?;
                Ok(ops::atan2(y, x)?)
            }
            ScalarExpression::Norm(whole) => {
                // Members beyond the struct's own count as zeros, which change no sum of squares.
                let mut members = [0.0; MAX];
                for (place, value) in members.iter_mut().zip(self.read_whole(whole, sensed)?) {
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
        sensed: &dyn Sensed,
    ) -> Result<Vec<f64>, Fault> {
        let value = self.struct_expression(value, sensed)?;
        match update {
            None => Ok(value),
            Some(operation) => Ok(combine_each(operation, &self.read_struct(target)?, &value)?),
        }
    }

    fn struct_expression(
        &self,
        value: StructExpression,
        sensed: &dyn Sensed,
    ) -> Result<Vec<f64>, Fault> {
        match value {
            StructExpression::Copy(whole) => self.read_whole(whole, sensed),
            StructExpression::Binary {
                left,
                operation,
                right,
            } => {
                let left = self.read_whole(left, sensed)?;
                let right = self.read_whole(right, sensed)?;
                Ok(combine_each(operation, &left, &right)?)
            }
            StructExpression::UnitVect(whole) => {
                Ok(ops::unit_vect(self.read_vector(whole, sensed)?)?.to_vec())
            }
            StructExpression::Rotate {
                axis,
                operand,
                angle,
            } => {
                let vector = self.read_vector(operand, sensed)?;
                let angle = self.operand(angle, sensed)?;
                let turned = match axis {
                    Axis::X => ops::rot_x(vector, angle),
                    Axis::Y => ops::rot_y(vector, angle),
                    Axis::Z => ops::rot_z(vector, angle),
                };
                Ok(turned?.to_vec())
            }
        }
    }

    pub(crate) fn holds(&self, condition: Condition, sensed: &dyn Sensed) -> Result<bool, Fault> {
        match condition {
            Condition::Compare {
                left,
                relation,
                right,
            } => {
                let left = self.operand(left, sensed)?;
                let right = self.operand(right, sensed)?;
                Ok(match relation {
                    Relation::Eq => left == right,
                    Relation::Ne => left != right,
                    Relation::Lt => left < right,
                    Relation::Gt => left > right,
                    Relation::Le => left <= right,
                    Relation::Ge => left >= right,
                })
            }
            Condition::Flag { flag, negated } => Ok(sensed.flag(flag) != negated),
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
