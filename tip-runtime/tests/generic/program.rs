//! A program that is a list of commands, on the simulated robot.

use tip_runtime::command::{Command, Op, Poll, Target, Value};
use tip_runtime::fault::Fault;
use tip_runtime::machine::Machine;
use tip_runtime::model::Model;
use tip_runtime::plant::SimulatedPlant;
use tip_runtime::program::{Context, End, Flow, Program, Signature};

/// One step: a command on a target with its values.
pub(crate) type Step = (Op, Target, Vec<f64>);

/// Runs its steps one after the other, then ends.
pub(crate) struct List {
    steps: Vec<Step>,
    at: u32,
    signature: Signature,
}

impl Program for List {
    fn signature(&self) -> Signature {
        self.signature
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
        let mut values = [Value::absolute(0.0); 9];
        for (value, number) in values.iter_mut().zip(numbers) {
            *value = Value::absolute(*number);
        }
        let command = Command {
            op: *op,
            hs: false,
            target: *target,
            values: &values[..numbers.len()],
        };
        if cx.command(&command)? == Poll::Pending {
            return Ok(Flow::Wait);
        }
        self.at += 1;
        Ok(Flow::Next)
    }
    fn scalar(&self, _: usize) -> Option<(&str, Option<f64>)> {
        None
    }
    fn line(&self, step: u32) -> u32 {
        step
    }
    fn reset(&mut self) {
        self.at = 0;
    }
}

pub(crate) type Bench<'m, const L: usize, const J: usize> =
    Machine<'m, List, SimulatedPlant<L, J>, (), (), L, J>;

pub(crate) fn bench<const L: usize, const J: usize>(
    model: &Model<L, J>,
    steps: Vec<Step>,
) -> Bench<'_, L, J> {
    let list = List {
        steps,
        at: 0,
        signature: model.signature(),
    };
    let plant = SimulatedPlant::new(model);
    Machine::new(list, model, plant, (), ()).expect("made for this robot")
}

/// Runs to the end, or to the emergency that is told.
pub(crate) fn run<const L: usize, const J: usize>(
    model: &Model<L, J>,
    steps: Vec<Step>,
) -> (Bench<'_, L, J>, Option<Fault>) {
    let mut machine = bench(model, steps);
    for _ in 0..3000 {
        if !machine.cycle().is_running() {
            let fault = machine.emergency().map(|emergency| emergency.fault);
            return (machine, fault);
        }
    }
    let at = machine.program().at();
    panic!("{} is still at step {at}", model.name);
}
