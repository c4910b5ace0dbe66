//! Expressions in the program's own language, log points, and the values that a debugger shows.

use super::{DebugError, Debugger};
use crate::event::Event;
use crate::interp::{Interpreter, Sensed};
use crate::message::Debugging;
use crate::run::Run;
use std::fmt;
use tip_lint::query::QueryContext;
use tip_runtime::command::{Flag, MAX, Reading};
use tip_runtime::controller::Mode;
use tip_runtime::fault::Fault;
use tipc::program::{Action, Condition, Operand, Program, ScalarExpression, VariableKind};

/// Names that the debugger adds: the next cycle, and its time, ms.
pub(super) const OWN_NAMES: &[&str] = &["CYCLE", "TIME"];

/// A condition of a breakpoint.
#[derive(Clone, Debug, PartialEq)]
pub struct BreakCondition {
    text: String,
    condition: Condition,
}

/// The value of an expression.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// The value of an equation's right side.
    Number(f64),
    /// The value of a condition.
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

/// A number or a condition to evaluate.
#[derive(Clone, Copy, Debug)]
pub(super) enum Expression {
    Number(ScalarExpression),
    Truth(Condition),
}

impl Expression {
    pub(super) fn new(text: &str, asker: &QueryContext) -> Result<Self, DebugError> {
        match asker.number(text) {
            Ok(value) => Ok(Expression::Number(value)),
            Err(error) => match asker.condition(text) {
                Ok(condition) => Ok(Expression::Truth(condition)),
                Err(_) => Err(error.into()),
            },
        }
    }

    pub(super) fn evaluate(self, now: &Now<'_>) -> Result<Value, Fault> {
        Ok(match self {
            Expression::Number(value) => Value::Number(now.number(value)?),
            Expression::Truth(condition) => Value::Truth(now.holds(condition)?),
        })
    }
}

impl BreakCondition {
    pub(super) fn new(text: &str, asker: &QueryContext) -> Result<Self, DebugError> {
        Ok(BreakCondition {
            text: text.to_owned(),
            condition: asker.condition(text)?,
        })
    }

    /// Returns the text as it was written.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Returns true if it holds at a position. It does not hold if it reads an unassigned variable.
    pub(super) fn holds(&self, now: &Now<'_>) -> bool {
        now.holds(self.condition).unwrap_or(false)
    }
}

/// A run at a position.
pub(super) struct Now<'a> {
    pub(super) run: &'a Run,
    pub(super) at: u64,
    pub(super) asker: &'a QueryContext,
}

impl Sensed for Now<'_> {
    fn flag(&self, flag: Flag) -> bool {
        self.run.flag(flag)
    }

    fn reading(&self, reading: Reading) -> Result<[f64; MAX], Fault> {
        self.run.machine.reading(reading)
    }
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
                left: self.resolve_own_names(left),
                relation,
                right: self.resolve_own_names(right),
            },
            flag @ Condition::Flag { .. } => flag,
        };
        self.interpreter()?.holds(condition, self)
    }

    fn number(&self, value: ScalarExpression) -> Result<f64, Fault> {
        use ScalarExpression as E;
        let value = match value {
            E::Operand(operand) => E::Operand(self.resolve_own_names(operand)),
            E::Binary {
                left,
                operation,
                right,
            } => E::Binary {
                left: self.resolve_own_names(left),
                operation,
                right: self.resolve_own_names(right),
            },
            E::Function { function, operand } => E::Function {
                function,
                operand: self.resolve_own_names(operand),
            },
            E::Atan2 { y, x } => E::Atan2 {
                y: self.resolve_own_names(y),
                x: self.resolve_own_names(x),
            },
            norm @ E::Norm(_) => norm,
        };
        self.interpreter()?.scalar_expression(value, self)
    }

    /// Replaces the debugger's own names by their values in an operand.
    fn resolve_own_names(&self, operand: Operand) -> Operand {
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
    /// Evaluates a condition, or the right side of an equation, at this position.
    ///
    /// # Errors
    /// The text is neither, or its value cannot be calculated.
    pub fn evaluate(&self, text: &str) -> Result<Value, DebugError> {
        let expression = Expression::new(text, &self.asker)?;
        Ok(expression.evaluate(&self.here())?)
    }

    /// Reads an assignment that a user has typed, such as `N = 5` or `P.X=-1.5`, with any right side of an equation.
    /// Returns `None` for another text, or if the value cannot be calculated.
    pub fn assignment(&self, text: &str) -> Option<Event> {
        let (name, value) = text.split_once('=')?;
        let name = name.trim().to_ascii_uppercase();
        let value = match value.trim().parse() {
            Ok(value) => value,
            Err(_) => match self.evaluate(value) {
                Ok(Value::Number(value)) => value,
                _ => return None,
            },
        };
        let is_of_name = |char: char| char.is_ascii_alphanumeric() || matches!(char, '_' | '.');
        let is_name = !name.is_empty() && name.chars().all(is_of_name);
        is_name.then_some(Event::Set(name, value))
    }

    /// Returns the value of a variable or of a member such as `P.X`; none while unassigned.
    ///
    /// # Errors
    /// The program has no such variable.
    pub fn value(&self, name: &str) -> Result<Option<f64>, DebugError> {
        let name = name.trim().to_ascii_uppercase();
        let value = self.run().program().get(&name);
        value.map_err(|error| DebugError::NoVariable(name, error))
    }

    pub(super) fn here(&self) -> Now<'_> {
        Now {
            run: self.run(),
            at: self.now(),
            asker: &self.asker,
        }
    }
}

/// A text with expressions in braces: `stride {N} at {P}`.
#[derive(Debug)]
pub(super) struct LogText(Vec<Part>);

#[derive(Debug)]
enum Part {
    Text(String),
    One(Expression),
    /// The members of a POS or JOINT.
    Members(Vec<Expression>),
}

impl LogText {
    /// Braces that hold nothing, or are not closed, are text.
    pub(super) fn new(
        text: &str,
        program: &Program,
        asker: &QueryContext,
    ) -> Result<Self, DebugError> {
        let mut parts = Vec::new();
        let mut rest = text;
        while let Some((before, after)) = rest.split_once('{') {
            let Some((inside, next)) = after.split_once('}') else {
                break;
            };
            parts.push(Part::Text(before.to_owned()));
            parts.push(match inside.trim() {
                "" => Part::Text(format!("{{{inside}}}")),
                asked => Part::asked(asked, program, asker)?,
            });
            rest = next;
        }
        parts.push(Part::Text(rest.to_owned()));
        Ok(LogText(parts))
    }

    /// Returns its text at a position.
    pub(super) fn at(&self, now: &Now<'_>) -> String {
        self.0.iter().map(|part| part.at(now)).collect()
    }
}

impl Part {
    fn asked(text: &str, program: &Program, asker: &QueryContext) -> Result<Self, DebugError> {
        let is_it = |name: &str| name.eq_ignore_ascii_case(text);
        let mut variables = program.variables().iter();
        let structure = variables.find(|it| is_it(&it.name) && it.size() > 1);
        let Some(structure) = structure else {
            return Expression::new(text, asker).map(Part::One);
        };
        let members = structure.scalar_names();
        let members = members.map(|name| Expression::new(&name, asker));
        members.collect::<Result<_, _>>().map(Part::Members)
    }

    fn at(&self, now: &Now<'_>) -> String {
        match self {
            Part::Text(text) => text.clone(),
            Part::One(expression) => said(*expression, now),
            Part::Members(members) => {
                let members = members.iter().map(|expression| said(*expression, now));
                format!("({})", members.collect::<Vec<_>>().join(", "))
            }
        }
    }
}

fn said(expression: Expression, now: &Now<'_>) -> String {
    match expression.evaluate(now) {
        Ok(value) => value.to_string(),
        Err(Fault::Unassigned(_)) => "unassigned".to_owned(),
        Err(fault) => fault.to_string(),
    }
}

/// A variable with its members.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    /// Its name, upper case.
    pub name: String,
    /// Its type.
    pub kind: VariableKind,
    /// The names of its scalars as the language spells them, such as `P.X`, with their values; none while unassigned.
    pub scalars: Vec<(String, Option<f64>)>,
}

/// A routine that runs, or that waits for one that it called.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// The label or SUBROUTINE that was called; none for the program itself.
    pub name: Option<String>,
    /// The step that comes next, or the call that it waits for.
    pub step: u32,
    /// Its line, from 1.
    pub line: u32,
    /// Its column in characters, from 1.
    pub column: u32,
}

/// Returns the name of a control mode of a leg or joint.
pub fn control(mode: Mode) -> Debugging {
    match mode {
        Mode::Rest => Debugging::AtRest,
        Mode::Position => Debugging::Position,
        Mode::Compliance => Debugging::Compliance,
        Mode::Velocity => Debugging::Velocity,
        Mode::Effort => Debugging::Effort,
    }
}

impl Debugger {
    /// Returns the step that the selected thread takes next.
    pub fn step(&self) -> u32 {
        self.run().step_of(self.thread())
    }

    /// Returns the line of that step, from 1.
    pub fn line(&self) -> u32 {
        self.run().program().line(self.step())
    }

    /// Returns all variables, `VAR_KEY` first.
    pub fn variables(&self) -> Vec<Variable> {
        let engine = self.run().program();
        let scalar = |place| {
            engine
                .scalar(place)
                .map(|(name, value)| (name.to_owned(), value))
        };
        let variables = self.program.variables().iter();
        let shown = variables.map(|variable| Variable {
            name: variable.name.clone(),
            kind: variable.kind,
            scalars: (variable.first..variable.first + variable.size())
                .filter_map(scalar)
                .collect(),
        });
        shown.collect()
    }

    /// Returns the open calls of the main program (0) or a thread, the innermost first, the program or the thread itself
    /// last.
    pub fn frames(&self, thread: u8) -> Vec<Frame> {
        let engine = Self::interpreter(self.run());
        let returns = engine.map_or(&[][..], |engine| engine.calls(thread.into()));
        let calls: Vec<u32> = returns.iter().map(|step| step.saturating_sub(1)).collect();
        let names = std::iter::once(None).chain(calls.iter().map(|call| self.called_by(*call)));
        let steps = calls.iter().copied().chain([self.run().step_of(thread)]);
        let mut frames: Vec<Frame> = names
            .zip(steps)
            .map(|(name, step)| self.frame(name, step))
            .collect();
        frames.reverse();
        frames
    }

    fn frame(&self, name: Option<String>, step: u32) -> Frame {
        let place = self.program.steps().get(step as usize);
        let (line, column) = place.map_or((0, 0), |step| (step.line, step.column));
        Frame {
            name,
            step,
            line,
            column,
        }
    }

    /// Returns the name of the label that a step calls.
    fn called_by(&self, step: u32) -> Option<String> {
        let to = match &self.program.steps().get(step as usize)?.action {
            Action::Gosub { to } | Action::IfGosub { to, .. } => *to,
            _ => return None,
        };
        let label = self.program.labels().iter().find(|label| label.step == to);
        label.map(|label| label.name.clone())
    }

    /// Returns the cycle and the text of each message up to this position. Only the last messages are kept.
    pub fn messages(&self) -> &[(u64, String)] {
        let until = self.said.partition_point(|(at, _)| *at < self.now());
        self.said.get(..until).unwrap_or_default()
    }

    /// Takes the messages since the last call, except those of replayed cycles.
    pub fn take_messages(&mut self) -> Vec<(u64, String)> {
        let messages = self.said.get(self.taken..).unwrap_or_default().to_vec();
        self.taken = self.said.len();
        messages
    }
}
