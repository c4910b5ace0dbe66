//! A program that is a list of commands.

use tip_runtime::command::{Command, Op, Target, Value};
use tip_runtime::fault::Fault;
use tip_runtime::program::{Context, End, Flow, Program, Signature};

/// One step: a command on a target with its values.
pub(crate) type Step<V> = (Op, Target, V);

/// Runs its steps one after the other, then ends.
pub(crate) struct List<V> {
    steps: Vec<Step<V>>,
    at: u32,
    robot: Signature,
}

impl<V> List<V> {
    pub(crate) fn new(steps: Vec<Step<V>>, robot: Signature) -> Self {
        List {
            steps,
            at: 0,
            robot,
        }
    }
}

impl<V: AsRef<[f64]>> Program for List<V> {
    fn signature(&self) -> Signature {
        self.robot
    }
    fn name(&self) -> &str {
        "list"
    }
    fn title(&self) -> &str {
        ""
    }
    fn at(&self) -> u32 {
        self.at
    }
    fn step(&mut self, cx: &mut dyn Context) -> Result<Flow, Fault> {
        let Some((op, target, numbers)) = self.steps.get(self.at as usize) else {
            return Ok(Flow::Finished(End::End));
        };
        let numbers = numbers.as_ref();
        let mut values = [Value::Absolute(0.0); 9];
        for (value, number) in values.iter_mut().zip(numbers) {
            *value = Value::Absolute(*number);
        }
        let command = Command {
            op: *op,
            hs: false,
            target: *target,
            values: &values[..numbers.len()],
        };
        let next = self.at + 1;
        let flow = cx.ask(&command, &mut self.at, next)?;
        if flow == Flow::Next {
            cx.message(&op.name());
        }
        Ok(flow)
    }
    fn scalar(&self, i: usize) -> Option<(&str, Option<f64>)> {
        (i == 0).then_some(("VAR_KEY", None))
    }
    fn set_scalar(&mut self, _: usize, _: f64) {}
    fn line(&self, step: u32) -> u32 {
        step + 3
    }
    fn reset(&mut self) {
        self.at = 0;
    }
}
