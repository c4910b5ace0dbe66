//! Execution of one cycle of each step: first its result, then, if nothing failed, its effect.

use super::Interpreter;
use std::fmt;
use tip_runtime::command::{Command, MAX, Poll, Value};
use tip_runtime::fault::Fault;
use tip_runtime::ops::{self, FormattedNumber};
use tip_runtime::program::{CallStack, Context, Flow};
use tipc::program::{Action, Argument, End, Mark, MessagePart, Scalar, StepId, VariableId};

/// Result of a step.
pub(super) struct Outcome {
    /// The scalars that it assigns, the first one at `first`.
    first: usize,
    values: Vec<f64>,
    /// The calls that are open after it, if it changes them.
    calls: Option<CallStack>,
    then: Then,
}

/// The step that comes next.
enum Then {
    /// Goes to another step, "taken".
    To(StepId),
    /// Goes to another step, "not taken".
    Otherwise(StepId),
    /// Nowhere: it runs again.
    Wait,
    /// The program is over.
    Finish(End),
}

impl Then {
    fn with(self) -> Outcome {
        Outcome {
            first: 0,
            values: Vec::new(),
            calls: None,
            then: self,
        }
    }
}

impl Interpreter {
    /// Does everything that can fail, with no effect on the program's state.
    pub(super) fn outcome(&self, cx: &mut dyn Context) -> Result<Outcome, Fault> {
        let step = self.program.steps().get(self.at as usize);
        let next = self.at + 1;
        let on = Then::To(next);
        Ok(match &step.ok_or(Fault::WrongStep)?.action {
            Action::Nothing => on.with(),
            Action::SetScalar {
                target,
                update,
                value,
            } => {
                let value = self.scalar_value(*target, *update, *value)?;
                self.assign(*target, value, on)
            }
            Action::SetStruct {
                target,
                update,
                value,
            } => {
                let values = self.struct_value(*target, *update, *value)?;
                self.assign_struct(*target, values)
            }
            Action::If {
                condition,
                otherwise,
            } => match self.holds(*condition, &|flag| cx.flag(flag))? {
                true => on.with(),
                false => Then::Otherwise(*otherwise).with(),
            },
            Action::ElseIf {
                condition,
                otherwise,
            } => {
                if self.not_taken {
                    match self.holds(*condition, &|flag| cx.flag(flag))? {
                        true => on.with(),
                        false => Then::Otherwise(*otherwise).with(),
                    }
                } else {
                    Then::To(*otherwise).with()
                }
            }
            Action::Else { end } => Then::To(if self.not_taken { next } else { *end }).with(),
            Action::While { condition, exit } => {
                let goes_on = self.holds(*condition, &|flag| cx.flag(flag))?;
                Then::To(if goes_on { next } else { *exit }).with()
            }
            Action::Goto { to } => Then::To(*to).with(),
            Action::Until { condition, back } => {
                let done = self.holds(*condition, &|flag| cx.flag(flag))?;
                Then::To(if done { next } else { *back }).with()
            }
            Action::For {
                variable,
                from,
                to,
                step,
                exit,
            } => {
                let from = self.operand(*from)?;
                let to = self.operand(*to)?;
                let step = self.operand(*step)?;
                let enters = ops::for_test(from, to, step)?;
                self.assign(*variable, from, Then::To(if enters { next } else { *exit }))
            }
            Action::Next {
                variable,
                to,
                step,
                body,
            } => {
                let value = self.read(*variable)?;
                let step = self.operand(*step)?;
                let to = self.operand(*to)?;
                let value = ops::add(value, step)?;
                let repeats = ops::for_test(value, to, step)?;
                self.assign(
                    *variable,
                    value,
                    Then::To(if repeats { *body } else { next }),
                )
            }
            Action::IfGoto { condition, to } => {
                let jumps = self.holds(*condition, &|flag| cx.flag(flag))?;
                Then::To(if jumps { *to } else { next }).with()
            }
            Action::Gosub { to } => self.call(*to)?,
            Action::IfGosub { condition, to } => {
                match self.holds(*condition, &|flag| cx.flag(flag))? {
                    true => self.call(*to)?,
                    false => on.with(),
                }
            }
            Action::Return => {
                let mut calls = self.calls;
                let back = calls.pop()?;
                Outcome {
                    calls: Some(calls),
                    ..Then::To(back).with()
                }
            }
            Action::Finish(end) => Then::Finish(*end).with(),
            Action::Command {
                op,
                hs,
                target,
                arguments,
            } => {
                let (values, count) = self.values(arguments)?;
                let poll = cx.command(&Command {
                    op: *op,
                    hs: *hs,
                    target: *target,
                    values: &values[..count],
                })?;
                match poll {
                    Poll::Done => on.with(),
                    Poll::Pending => Then::Wait.with(),
                }
            }
            Action::TeachStruct { what, target, into } => {
                let mut measured = cx.teach(*what, *target)?.to_vec();
                measured.truncate(self.program.variables()[*into].size());
                self.assign_struct(*into, measured)
            }
            Action::TeachScalar { what, target, into } => {
                let [measured, ..] = cx.teach(*what, *target)?;
                self.assign(*into, measured, on)
            }
            Action::AdIn { port, into } => self.assign(*into, cx.analog(*port)?, on),
            Action::KeyIn { into } => match cx.key() {
                Some(key) => self.assign(*into, f64::from(key), on),
                None => Then::Wait.with(),
            },
            // Threads and files of messages are not interpreted yet.
            Action::StartThread { .. }
            | Action::StopThread { .. }
            | Action::WaitThread { .. }
            | Action::ThreadEnd
            | Action::FileMessage { .. } => return Err(Fault::Domain),
            Action::Message { parts } => {
                cx.message(&self.text(parts)?);
                on.with()
            }
        })
    }

    /// Applies the effect of a step that did not fail.
    pub(super) fn apply(&mut self, outcome: Outcome) -> Flow {
        let places = self.scalars.iter_mut().skip(outcome.first);
        for (place, value) in places.zip(outcome.values) {
            *place = Some(value);
        }
        if let Some(calls) = outcome.calls {
            self.calls = calls;
        }
        let (at, not_taken) = match outcome.then {
            Then::To(step) => (step, false),
            Then::Otherwise(step) => (step, true),
            Then::Wait => return Flow::Wait,
            Then::Finish(end) => return Flow::Finished(end),
        };
        self.at = at;
        self.not_taken = not_taken;
        Flow::Next
    }

    fn assign(&self, target: Scalar, value: f64, then: Then) -> Outcome {
        Outcome {
            first: self.program.scalar_index(target),
            values: vec![value],
            ..then.with()
        }
    }

    fn assign_struct(&self, target: VariableId, values: Vec<f64>) -> Outcome {
        Outcome {
            first: self.program.variables()[target].first,
            values,
            ..Then::To(self.at + 1).with()
        }
    }

    fn call(&self, to: StepId) -> Result<Outcome, Fault> {
        let mut calls = self.calls;
        calls.push(self.at + 1)?;
        Ok(Outcome {
            calls: Some(calls),
            ..Then::To(to).with()
        })
    }

    fn values(&self, arguments: &[Argument]) -> Result<([Value; MAX], usize), Fault> {
        let mut values = [Value::Absolute(0.0); MAX];
        for (place, argument) in values.iter_mut().zip(arguments) {
            let number = self.operand(argument.operand)?;
            *place = match argument.mark {
                Mark::None => Value::Absolute(number),
                Mark::Relative => Value::Relative(number),
                Mark::Absolute => Value::Fixed(number),
            };
        }
        Ok((values, arguments.len().min(MAX)))
    }

    fn text<'a>(&self, parts: &'a [MessagePart]) -> Result<Text<'a>, Fault> {
        let pieces = parts.iter().map(|part| {
            Ok(match part {
                MessagePart::Text(text) => Piece::Text(text),
                MessagePart::Value { operand, decimals } => Piece::Value(FormattedNumber {
                    value: self.operand(*operand)?,
                    decimals: *decimals,
                }),
            })
        });
        Ok(Text(pieces.collect::<Result<_, Fault>>()?))
    }
}

/// A MESSAGE with its placeholders replaced.
struct Text<'a>(Vec<Piece<'a>>);

enum Piece<'a> {
    Text(&'a str),
    Value(FormattedNumber),
}

impl fmt::Display for Text<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|piece| match piece {
            Piece::Text(text) => f.write_str(text),
            Piece::Value(value) => value.fmt(f),
        })
    }
}
