//! Operands, conditions and expressions of steps.

use super::{Arithmetic, Axis, Flag, Function, Reading, Relation};

/// A variable, by its index in [`Program::variables`](super::Program::variables).
pub type VariableId = usize;

/// One scalar: a VAR, or a member of a struct.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Scalar {
    /// The variable.
    pub variable: VariableId,
    /// The member, from 0; 0 for a VAR.
    pub member: usize,
}

/// A number that a step reads.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Operand {
    /// A constant.
    Constant(f64),
    /// A scalar, its sign changed if `negative`.
    Scalar {
        /// The scalar.
        scalar: Scalar,
        /// `-` precedes it.
        negative: bool,
    },
    /// A special variable, or a member of one, its sign changed if `negative`.
    Reading {
        /// The special variable.
        reading: Reading,
        /// The member, from 0; 0 for a number.
        member: usize,
        /// `-` precedes it.
        negative: bool,
    },
}

/// A whole POS or JOINT that a step reads.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StructOperand {
    /// A variable.
    Variable(VariableId),
    /// A special variable.
    Reading(Reading),
}

impl StructOperand {
    /// Returns one of its members as an operand.
    pub const fn member(self, member: usize) -> Operand {
        match self {
            StructOperand::Variable(variable) => Operand::Scalar {
                scalar: Scalar { variable, member },
                negative: false,
            },
            StructOperand::Reading(reading) => Operand::Reading {
                reading,
                member,
                negative: false,
            },
        }
    }
}

/// A condition.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Condition {
    /// Two numbers compared.
    Compare {
        /// The left one.
        left: Operand,
        /// Relation between the sides.
        relation: Relation,
        /// The right one.
        right: Operand,
    },
    /// An event flag.
    Flag {
        /// Which one.
        flag: Flag,
        /// `!` precedes it.
        negated: bool,
    },
}

/// The right side of a scalar equation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ScalarExpression {
    /// `a`
    Operand(Operand),
    /// `a + b` and its like.
    Binary {
        /// The left operand.
        left: Operand,
        /// The operation.
        operation: Arithmetic,
        /// The right operand.
        right: Operand,
    },
    /// A function of one scalar.
    Function {
        /// Which one.
        function: Function,
        /// Its operand.
        operand: Operand,
    },
    /// `ATAN2 a b`
    Atan2 {
        /// The first operand.
        y: Operand,
        /// The second one.
        x: Operand,
    },
    /// `NORM s`
    Norm(StructOperand),
}

/// The right side of a struct equation; all structs in it are of one type.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StructExpression {
    /// `a`
    Copy(StructOperand),
    /// `a + b` and its like, member by member.
    Binary {
        /// The left operand.
        left: StructOperand,
        /// The operation.
        operation: Arithmetic,
        /// The right operand.
        right: StructOperand,
    },
    /// `UNIT_VECT p`
    UnitVect(StructOperand),
    /// `ROT_X p angle` and its like.
    Rotate {
        /// The axis.
        axis: Axis,
        /// Turned variable.
        operand: StructOperand,
        /// By how many degrees.
        angle: Operand,
    },
}
