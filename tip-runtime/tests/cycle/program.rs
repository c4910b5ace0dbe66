//! A program that is a list of commands.

use tip_runtime::command::{Command, Op, Poll, Target, Value};
use tip_runtime::fault::Fault;
use tip_runtime::machine::Machine;
use tip_runtime::model::{Model, hand, titan8};
use tip_runtime::plant::{Scene, SimulatedHand, SimulatedPlant};
use tip_runtime::program::{Context, End, Flow, Program, Signature};
use tip_runtime::special::hand::HandSpecials;

pub(crate) static MODEL: Model<4, 3> = titan8::MODEL;

/// One step: a command on a target with its values.
pub(crate) type Step = (Op, Target, &'static [f64]);

/// Runs its steps one after the other, then ends.
pub(crate) struct List {
    steps: &'static [Step],
    at: u32,
    robot: Signature,
}

impl List {
    fn new(steps: &'static [Step], robot: Signature) -> Self {
        List {
            steps,
            at: 0,
            robot,
        }
    }
}

impl Program for List {
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
        let mut values = [Value::absolute(0.0); 3];
        for (value, number) in values.iter_mut().zip(*numbers) {
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
        cx.message(&op.name());
        self.at += 1;
        Ok(Flow::Next)
    }
    fn scalar(&self, i: usize) -> Option<(&str, Option<f64>)> {
        (i == 0).then_some(("VAR_KEY", None))
    }
    fn line(&self, step: u32) -> u32 {
        step + 3
    }
    fn reset(&mut self) {
        self.at = 0;
    }
}

pub(crate) type Bench = Machine<'static, List, SimulatedPlant<4, 3>, (), (), 4, 3>;

pub(crate) fn bench(steps: &'static [Step]) -> Bench {
    let plant = SimulatedPlant::new(&MODEL);
    let program = List::new(steps, MODEL.signature());
    Machine::new(program, &MODEL, plant, (), ()).expect("made for this robot")
}

pub(crate) type HandBench = Machine<'static, List, SimulatedHand<3, 3>, (), HandSpecials, 3, 3>;

/// The hand, its native commands and something to grasp.
pub(crate) fn hand_bench(steps: &'static [Step]) -> HandBench {
    let plant = SimulatedHand::new(&hand::MODEL).with_scene(&Scene::CYLINDER);
    let program = List::new(steps, hand::MODEL.signature());
    Machine::new(program, &hand::MODEL, plant, (), HandSpecials::new()).expect("made for the hand")
}

/// Runs to the end, which must come in time and without an emergency.
pub(crate) fn run(steps: &'static [Step]) -> Bench {
    let mut machine = bench(steps);
    for _ in 0..5000 {
        if !machine.cycle().is_running() {
            assert_eq!(machine.emergency(), None);
            return machine;
        }
    }
    panic!("still at step {}", machine.program().at());
}
