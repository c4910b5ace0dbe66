//! Execution of one cycle of each step: first its result, then, if nothing failed, its effect.

use super::{Interpreter, Sensed};
use std::fmt;
use tip_runtime::command::{Command, MAX, Poll, Value};
use tip_runtime::fault::Fault;
use tip_runtime::ops::{self, FormattedNumber};
use tip_runtime::program::{CallStack, Context, Flow, Program};
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
    /// Another step, reached "taken".
    To(StepId),
    /// Another step, reached "not taken".
    Otherwise(StepId),
    /// The same step: it waits.
    Wait,
    /// None: the thread is over.
    EndThread,
    /// None: the program is over.
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
    /// Calculates the result of the step, without an effect on the program's state. Everything that can fail is here.
    pub(super) fn outcome(&self, cx: &mut dyn Context) -> Result<Outcome, Fault> {
        let step = self.program.steps().get(self.at() as usize);
        let next = self.at() + 1;
        let on = Then::To(next);
        Ok(match &step.ok_or(Fault::WrongStep)?.action {
            Action::Nothing => on.with(),
            Action::SetScalar {
                target,
                update,
                value,
            } => {
                let value = self.scalar_value(*target, *update, *value, &&*cx)?;
                self.assign(*target, value, on)
            }
            Action::SetStruct {
                target,
                update,
                value,
            } => {
                let values = self.struct_value(*target, *update, *value, &&*cx)?;
                self.assign_struct(*target, values)
            }
            Action::If {
                condition,
                otherwise,
            } => match self.holds(*condition, &&*cx)? {
                true => on.with(),
                false => Then::Otherwise(*otherwise).with(),
            },
            Action::ElseIf {
                condition,
                otherwise,
            } => {
                if self.position().not_taken {
                    match self.holds(*condition, &&*cx)? {
                        true => on.with(),
                        false => Then::Otherwise(*otherwise).with(),
                    }
                } else {
                    Then::To(*otherwise).with()
                }
            }
            Action::Else { end } => Then::To(if self.position().not_taken {
                next
            } else {
                *end
            })
            .with(),
            Action::While { condition, exit } => {
                let goes_on = self.holds(*condition, &&*cx)?;
                Then::To(if goes_on { next } else { *exit }).with()
            }
            Action::Goto { to } => Then::To(*to).with(),
            Action::Until { condition, back } => {
                let done = self.holds(*condition, &&*cx)?;
                Then::To(if done { next } else { *back }).with()
            }
            Action::For {
                variable,
                from,
                to,
                step,
                exit,
            } => {
                let from = self.operand(*from, &&*cx)?;
                let to = self.operand(*to, &&*cx)?;
                let step = self.operand(*step, &&*cx)?;
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
                let step = self.operand(*step, &&*cx)?;
                let to = self.operand(*to, &&*cx)?;
                let value = ops::add(value, step)?;
                let repeats = ops::for_test(value, to, step)?;
                self.assign(
                    *variable,
                    value,
                    Then::To(if repeats { *body } else { next }),
                )
            }
            Action::IfGoto { condition, to } => {
                let jumps = self.holds(*condition, &&*cx)?;
                Then::To(if jumps { *to } else { next }).with()
            }
            Action::Gosub { to } => self.call(*to)?,
            Action::IfGosub { condition, to } => match self.holds(*condition, &&*cx)? {
                true => self.call(*to)?,
                false => on.with(),
            },
            Action::Return => {
                let mut calls = self.position().calls;
                match calls.pop() {
                    Ok(back) => Outcome {
                        calls: Some(calls),
                        ..Then::To(back).with()
                    },
                    Err(_) => self.thread_end()?.with(),
                }
            }
            Action::Finish(end) => Then::Finish(*end).with(),
            Action::Command {
                op,
                hs,
                target,
                arguments,
            } => {
                let (values, count) = self.values(arguments, &&*cx)?;
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
            Action::StartThread { thread } => {
                cx.start_thread(number(*thread))?;
                on.with()
            }
            Action::StopThread { thread } => {
                cx.stop_thread(number(*thread));
                on.with()
            }
            Action::WaitThread { thread } => match cx.wait_thread(number(*thread))? {
                Poll::Done => on.with(),
                Poll::Pending => Then::Wait.with(),
            },
            Action::ThreadEnd => self.thread_end()?.with(),
            Action::FileMessage { parts } => {
                let text = self.text(parts, &&*cx)?;
                cx.append(&text);
                on.with()
            }
            Action::Message { parts } => {
                let text = self.text(parts, &&*cx)?;
                cx.message(&text);
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
        let position = &mut self.positions[self.selected];
        if let Some(calls) = outcome.calls {
            position.calls = calls;
        }
        let (at, not_taken) = match outcome.then {
            Then::To(step) => (step, false),
            Then::Otherwise(step) => (step, true),
            Then::Wait => return Flow::Wait,
            Then::EndThread => return Flow::ThreadEnd,
            Then::Finish(end) => return Flow::Finished(end),
        };
        position.at = at;
        position.not_taken = not_taken;
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
            ..Then::To(self.at() + 1).with()
        }
    }

    /// Returns the end of a thread. The main program fails, since it has nothing to return from.
    fn thread_end(&self) -> Result<Then, Fault> {
        match self.selected {
            0 => Err(Fault::InvalidReturn),
            _ => Ok(Then::EndThread),
        }
    }

    fn call(&self, to: StepId) -> Result<Outcome, Fault> {
        let mut calls = self.position().calls;
        calls.push(self.at() + 1)?;
        Ok(Outcome {
            calls: Some(calls),
            ..Then::To(to).with()
        })
    }

    fn values(
        &self,
        arguments: &[Argument],
        sensed: &dyn Sensed,
    ) -> Result<([Value; MAX], usize), Fault> {
        let mut values = [Value::Absolute(0.0); MAX];
        for (place, argument) in values.iter_mut().zip(arguments) {
            let number = self.operand(argument.operand, sensed)?;
            *place = match argument.mark {
                Mark::None => Value::Absolute(number),
                Mark::Relative => Value::Relative(number),
                Mark::Absolute => Value::Fixed(number),
            };
        }
        Ok((values, arguments.len().min(MAX)))
    }

    fn text<'a>(&self, parts: &'a [MessagePart], sensed: &dyn Sensed) -> Result<Text<'a>, Fault> {
        let pieces = parts.iter().map(|part| {
            Ok(match part {
                MessagePart::Text(text) => Piece::Text(text),
                MessagePart::Value { operand, decimals } => Piece::Value(FormattedNumber {
                    value: self.operand(*operand, sensed)?,
                    decimals: *decimals,
                }),
            })
        });
        Ok(Text(pieces.collect::<Result<_, Fault>>()?))
    }
}

/// Returns the number of a thread from 1, by its index.
fn number(thread: usize) -> u8 {
    u8::try_from(thread + 1).unwrap_or(u8::MAX)
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
