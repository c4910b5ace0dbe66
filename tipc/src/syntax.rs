//! Statements as data: what the parser reads, before anything is looked up or judged.
//!
//! Words are upper-cased. Every piece keeps its span.

mod module;
mod statement;

pub use module::{Module, Statement};
pub use statement::{Jump, JumpKind, LabelKind, Shape, StatementKind, Then};

use crate::source::Span;
use smol_str::{SmolStr, StrExt};

/// A node of the syntax with its location.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Spanned<T> {
    /// The thing.
    pub node: T,
    /// Location in the source.
    pub span: Span,
}

/// The number of a step, from 0.
pub type StepId = u32;

/// A word, upper-cased.
pub type Word = Spanned<SmolStr>;

/// Returns a piece of the source in capital letters, as it is usually written.
pub fn upper_case(text: &str) -> SmolStr {
    match text.bytes().any(|byte| byte.is_ascii_lowercase()) {
        true => text.to_ascii_uppercase_smolstr(),
        false => text.into(),
    }
}

/// The types of variables.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum VariableKind {
    /// A scalar.
    Var,
    /// X, Y, Z in mm.
    Pos,
    /// J1…Jn.
    Joint,
}

/// An operand or argument as written: `-12.5`, `A`, `-P.X`, `F1`, `ALL`, `HS`, `J11`.
#[derive(Clone, Debug, PartialEq)]
pub struct Operand {
    /// Kind of the operand.
    pub kind: OperandKind,
    /// A minus precedes a name (a constant holds its own sign).
    pub negative: bool,
    /// The operand with its sign.
    pub span: Span,
}

/// Kind of an operand.
#[derive(Clone, Debug, PartialEq)]
pub enum OperandKind {
    /// A constant with its sign.
    Number(f64),
    /// A word.
    Name(SmolStr),
    /// The words before and after a point; boxed, since few operands are members.
    Member(Box<(SmolStr, SmolStr)>),
}

/// `a REL b`, or an event flag.
#[derive(Clone, Debug, PartialEq)]
pub enum Condition {
    /// Two scalars compared.
    Compare {
        /// The left operand.
        left: Operand,
        /// The relation.
        relation: Relation,
        /// The right operand.
        right: Operand,
    },
    /// `FLAG` or `!FLAG`.
    Flag {
        /// The flag's name without `!`.
        name: Word,
        /// `!` precedes it.
        negated: bool,
    },
}

/// A relational operator.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Relation {
    /// `==`
    Eq,
    /// `<>`
    Ne,
    /// `<`
    Lt,
    /// `>`
    Gt,
    /// `<=`
    Le,
    /// `>=`
    Ge,
}

/// The four operations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Arithmetic {
    /// `+`
    Add,
    /// `-`
    Sub,
    /// `*`
    Mul,
    /// `/`
    Div,
}

/// The operands of FOR.
#[derive(Clone, Debug, PartialEq)]
pub struct Counting {
    /// The loop variable.
    pub variable: Operand,
    /// The initial value.
    pub from: Operand,
    /// The last value.
    pub to: Operand,
    /// The increment, 1 if omitted.
    pub step: Option<Operand>,
}

/// An equation as written.
#[derive(Clone, Debug, PartialEq)]
pub struct Equation {
    /// The left side.
    pub target: Operand,
    /// `None` for `=`, else the operation of `+= -= *= /=`.
    pub update: Option<Arithmetic>,
    /// The operator's location.
    pub operator: Span,
    /// The right side.
    pub value: Expression,
}

/// The right side of an equation as written; types are for the checker.
#[derive(Clone, Debug, PartialEq)]
pub enum Expression {
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
    /// A function word and its operands, however many there are.
    Function {
        /// The function's name.
        name: Word,
        /// Its operands.
        operands: Vec<Operand>,
    },
}
