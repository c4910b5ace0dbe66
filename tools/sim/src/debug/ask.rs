//! What is asked of a run, in the program's own language.

use super::{Debugger, Refused};
use crate::interp::Interpreter;
use crate::run::Run;
use std::fmt;
use tip_lint::ask::Asker;
use tip_runtime::fault::Fault;
use tipc::program::{Condition, Operand, ScalarExpression};

/// The names that only a debugger knows: the cycle that comes next, and when it begins, in ms.
pub(super) const OWN: &[&str] = &["CYCLE", "TIME"];

/// A condition of a breakpoint.
#[derive(Clone, Debug, PartialEq)]
pub struct Asked {
    text: String,
    condition: Condition,
}

/// What an expression comes to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// Of an equation's right side.
    Number(f64),
    /// Of a condition.
    Truth(bool),
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Value::Number(number) => number.fmt(f),
            Value::Truth(truth) => truth.fmt(f),
        }
    }
}

/// A number or a condition that is asked for.
#[derive(Clone, Copy, Debug)]
pub(super) enum Question {
    Number(ScalarExpression),
    Truth(Condition),
}

impl Question {
    pub(super) fn new(text: &str, asker: &Asker) -> Result<Self, Refused> {
        match (asker.number(text), asker.condition(text)) {
            (Ok(value), _) => Ok(Question::Number(value)),
            (Err(_), Ok(condition)) => Ok(Question::Truth(condition)),
            (Err(error), Err(_)) => Err(error.into()),
        }
    }

    pub(super) fn answer(self, now: &Now<'_>) -> Result<Value, Fault> {
        Ok(match self {
            Question::Number(value) => Value::Number(now.number(value)?),
            Question::Truth(condition) => Value::Truth(now.holds(condition)?),
        })
    }
}

impl Asked {
    pub(super) fn new(text: &str, asker: &Asker) -> Result<Self, Refused> {
        Ok(Asked {
            text: text.to_owned(),
            condition: asker.condition(text)?,
        })
    }

    /// As it was written.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Whether it holds at a position; it does not where it reads what is not assigned.
    pub(super) fn holds(&self, now: &Now<'_>) -> bool {
        now.holds(self.condition).unwrap_or(false)
    }
}

/// A run at a position.
pub(super) struct Now<'a> {
    pub(super) run: &'a Run,
    pub(super) at: u64,
    pub(super) asker: &'a Asker,
}

impl Now<'_> {
    fn interpreter(&self) -> Result<&Interpreter, Fault> {
        self.run.engine().ok_or(Fault::WrongStep)
    }

    fn holds(&self, condition: Condition) -> Result<bool, Fault> {
        let condition = match condition {
            Condition::Compare {
                left,
                relation,
                right,
            } => Condition::Compare {
                left: self.known(left),
                relation,
                right: self.known(right),
            },
            flag @ Condition::Flag { .. } => flag,
        };
        let flag_is_up = |flag| self.run.flag(flag);
        self.interpreter()?.holds(condition, &flag_is_up)
    }

    fn number(&self, value: ScalarExpression) -> Result<f64, Fault> {
        use ScalarExpression as E;
        let value = match value {
            E::Operand(operand) => E::Operand(self.known(operand)),
            E::Binary {
                left,
                operation,
                right,
            } => E::Binary {
                left: self.known(left),
                operation,
                right: self.known(right),
            },
            E::Function { function, operand } => E::Function {
                function,
                operand: self.known(operand),
            },
            E::Atan2 { y, x } => E::Atan2 {
                y: self.known(y),
                x: self.known(x),
            },
            norm @ E::Norm(_) => norm,
        };
        self.interpreter()?.scalar_expression(value)
    }

    /// An operand without the debugger's own names.
    fn known(&self, operand: Operand) -> Operand {
        let Operand::Scalar { scalar, negative } = operand else {
            return operand;
        };
        let Some(own) = scalar.variable.checked_sub(self.asker.own()) else {
            return operand;
        };
        let value = match self.asker.more().get(own).map(String::as_str) {
            Some("CYCLE") => self.at as f64,
            _ => self.run.time(),
        };
        Operand::Constant(if negative { -value } else { value })
    }
}

impl Debugger {
    /// What a condition, or the right side of an equation, comes to where the debugger stands.
    ///
    /// # Errors
    /// It is neither, or it cannot be calculated.
    pub fn evaluate(&self, text: &str) -> Result<Value, Refused> {
        let question = Question::new(text, &self.asker)?;
        Ok(question.answer(&self.here())?)
    }

    /// The value of a variable or of a member such as `P.X`; none while unassigned.
    ///
    /// # Errors
    /// The program has no such variable.
    pub fn value(&self, name: &str) -> Result<Option<f64>, Refused> {
        let name = name.trim().to_ascii_uppercase();
        let value = self.run.program().get(&name);
        value.map_err(|error| Refused::NoVariable(name, error))
    }

    pub(super) fn here(&self) -> Now<'_> {
        Now {
            run: &self.run,
            at: self.now,
            asker: &self.asker,
        }
    }
}
