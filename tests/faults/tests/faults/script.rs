//! Short programs that use what their robot has: motion, waiting, inputs, torques, the log.

use tip_runtime::command::{Command, Flag, Op, Poll, Port, Target, Value};
use tip_runtime::fault::Fault;
use tip_runtime::model::Model;
use tip_runtime::program::{Context, End, Flow, Program, Signature};

pub(crate) type Step = fn(&mut dyn Context) -> Result<Flow, Fault>;

/// Runs its steps one after the other, and ends after the last or when a halt is requested.
#[derive(Clone, Copy)]
pub(crate) struct Script {
    signature: Signature,
    steps: &'static [Step],
    at: u32,
}

impl Script {
    pub(crate) fn new<const L: usize, const J: usize>(
        model: &Model<L, J>,
        steps: &'static [Step],
    ) -> Self {
        Script {
            signature: model.signature(),
            steps,
            at: 0,
        }
    }
}

impl Program for Script {
    fn step(&mut self, cx: &mut dyn Context) -> Result<Flow, Fault> {
        let step = self.steps.get(self.at as usize);
        let Some(step) = step.filter(|_| !cx.flag(Flag::HaltRequest)) else {
            return Ok(Flow::Finished(End::End));
        };
        let flow = step(cx)?;
        self.at += u32::from(flow == Flow::Next);
        Ok(flow)
    }
    fn at(&self) -> u32 {
        self.at
    }
    fn reset(&mut self) {
        self.at = 0;
    }
    fn signature(&self) -> Signature {
        self.signature
    }
    fn name(&self) -> &str {
        "script"
    }
    fn title(&self) -> &str {
        "faults"
    }
    fn line(&self, step: u32) -> u32 {
        step + 1
    }
    fn scalar(&self, _: usize) -> Option<(&str, Option<f64>)> {
        None
    }
    fn set_scalar(&mut self, _: usize, _: f64) {}
}

fn order<const N: usize>(
    cx: &mut dyn Context,
    op: Op,
    target: Target,
    values: [Value; N],
) -> Result<Flow, Fault> {
    let command = Command {
        op,
        hs: false,
        target,
        values: &values,
    };
    Ok(match cx.command(&command)? {
        Poll::Done => Flow::Next,
        Poll::Pending => Flow::Wait,
    })
}

fn run<const N: usize>(
    cx: &mut dyn Context,
    op: Op,
    target: Target,
    values: [f64; N],
) -> Result<Flow, Fault> {
    order(cx, op, target, values.map(Value::Absolute))
}

fn relative<const N: usize>(
    cx: &mut dyn Context,
    op: Op,
    target: Target,
    values: [f64; N],
) -> Result<Flow, Fault> {
    order(cx, op, target, values.map(Value::Relative))
}

/// Message of the step that reads the inputs; a compiled program says it earlier.
pub(crate) const INPUTS_READ: &str = "inputs read";

/// Reads every input of a robot with `L` legs, of which `SOLES` have a sole.
fn inputs<const L: u8, const SOLES: u8>(cx: &mut dyn Context) -> Result<Flow, Fault> {
    for n in 1..=3 {
        cx.analog(Port::Knob(n))?;
    }
    for n in 1..=L {
        cx.analog(Port::Joint(n, 1))?;
    }
    for n in 1..=SOLES {
        cx.analog(Port::Paw(n))?;
    }
    cx.analog(Port::Antenna)?;
    cx.message(&INPUTS_READ);
    Ok(Flow::Next)
}

/// A hit key goes to the program.
fn keys(cx: &mut dyn Context) -> Result<Flow, Fault> {
    while cx.flag(Flag::KbHit) {
        cx.key();
    }
    Ok(Flow::Next)
}

const LEG_1: Target = Target::Foot(1);

/// Stands up, lifts a foot and feels for the floor with it, turns a joint, sits down.
pub(crate) const TITAN: &[Step] = &[
    |cx| run(cx, Op::LogStart, Target::None, []),
    |cx| run(cx, Op::StandUp, Target::None, [10.0]),
    keys,
    |cx| relative(cx, Op::RelPtp, LEG_1, [0.0, 0.0, 8.0]),
    |cx| run(cx, Op::WaitInpos, LEG_1, []),
    |cx| run(cx, Op::DetectFloor, LEG_1, [1.0]),
    |cx| run(cx, Op::PtpAngle, Target::Joint(2, 1), [3.0]),
    |cx| relative(cx, Op::VelControl, Target::Foot(3), [0.0, 5.0, 0.0]),
    |cx| run(cx, Op::Sleep, Target::None, [100.0]),
    inputs::<4, 4>,
    |cx| run(cx, Op::AllStop, Target::None, []),
    |cx| run(cx, Op::AllStopRelease, Target::None, []),
    |cx| run(cx, Op::OmegaControl, Target::Joint(4, 2), [-4.0]),
    |cx| run(cx, Op::WaitInpos, Target::All, []),
    |cx| run(cx, Op::SitDown, Target::None, [10.0]),
];

/// Moves one leg, presses, pushes and gives way with the others.
pub(crate) const GENERIC: &[Step] = &[
    |cx| run(cx, Op::LogStart, Target::None, []),
    |cx| relative(cx, Op::Ptp, LEG_1, [0.0, 5.0, 20.0]),
    |cx| run(cx, Op::Torque, Target::Joint(2, 1), [1.0]),
    |cx| relative(cx, Op::Force, Target::Foot(3), [1.0, 0.0, 0.0]),
    keys,
    |cx| relative(cx, Op::ComplianceAngle, Target::Joint(4, 3), [5.0]),
    |cx| run(cx, Op::Sleep, Target::None, [200.0]),
    |cx| run(cx, Op::WaitInpos, LEG_1, []),
    |cx| relative(cx, Op::Torque, Target::Joint(2, 1), [0.5]),
    inputs::<4, 4>,
    |cx| run(cx, Op::NoCompliance, Target::Foot(3), []),
    |cx| run(cx, Op::Sleep, Target::None, [100.0]),
];

/// Lowers the floor, and bends each finger by another law.
pub(crate) const HAND: &[Step] = &[
    |cx| run(cx, Op::LogStart, Target::None, []),
    |cx| run(cx, Op::Ptp, Target::Floor, [0.0, -131.0, 0.0]),
    |cx| relative(cx, Op::PtpAngle, Target::Joint(1, 2), [3.0]),
    |cx| run(cx, Op::Torque, Target::Joint(1, 1), [5.0]),
    |cx| relative(cx, Op::Force, Target::Foot(2), [0.1, 0.0, 0.0]),
    keys,
    |cx| relative(cx, Op::CompliancePosition, Target::Foot(3), [2.0, 2.0, 0.0]),
    |cx| run(cx, Op::Sleep, Target::None, [40.0]),
    |cx| run(cx, Op::NoCompliance, Target::Foot(2), []),
    |cx| relative(cx, Op::Torque, Target::Joint(1, 1), [-2.0]),
    |cx| run(cx, Op::Sleep, Target::None, [40.0]),
    inputs::<3, 0>,
    |cx| run(cx, Op::NoCompliance, LEG_1, []),
    |cx| run(cx, Op::WaitInpos, Target::All, []),
];
