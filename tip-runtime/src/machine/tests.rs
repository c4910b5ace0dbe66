//! The control loop with scripted programs on a robot that follows every command immediately.

mod console;
mod emergencies;
mod keys;
mod native;
mod threads;

use super::*;
use crate::command::{Command, Op, Poll, Target, Value};
use crate::console::Scripted;
use crate::fault::Fault;
use crate::hardware::HardwareFault;
use crate::model::titan8;
use crate::program::{Context, End, Flow, Signature};
use std::vec::Vec;

pub(super) type Scalars = [(&'static str, Option<f64>); 2];
pub(super) type Step = fn(&mut Scalars, &mut dyn Context) -> Result<Flow, Fault>;

/// A program whose steps are functions.
#[derive(Clone)]
pub(super) struct Script {
    steps: &'static [Step],
    at: u32,
    pub(super) scalars: Scalars,
}

pub(super) const fn script(steps: &'static [Step]) -> Script {
    Script {
        steps,
        at: 0,
        scalars: [("VAR_KEY", None), ("A", None)],
    }
}

impl Program for Script {
    fn signature(&self) -> Signature {
        titan8::MODEL.signature()
    }
    fn name(&self) -> &str {
        "script"
    }
    fn title(&self) -> &str {
        "a test"
    }
    fn at(&self) -> u32 {
        self.at
    }
    fn step(&mut self, cx: &mut dyn Context) -> Result<Flow, Fault> {
        let flow = self.steps[self.at as usize](&mut self.scalars, cx)?;
        if flow == Flow::Next {
            self.at += 1;
        }
        Ok(flow)
    }
    fn scalar(&self, i: usize) -> Option<(&str, Option<f64>)> {
        self.scalars.get(i).copied()
    }
    fn set_scalar(&mut self, i: usize, value: f64) {
        self.scalars[i].1 = Some(value);
    }
    fn line(&self, step: u32) -> u32 {
        step + 4
    }
    fn reset(&mut self) {
        self.at = 0;
    }
}

/// Joints that are where they were commanded to be, and a count of what happened.
#[derive(Clone, Debug)]
pub(super) struct Follower {
    pub(super) sensors: Sensors<4, 3>,
    pub(super) outputs: Vec<Outputs<4, 3>>,
    pub(super) stops: Vec<Fault>,
    pub(super) read_fault: Option<HardwareFault>,
    pub(super) write_fault: Option<HardwareFault>,
}

pub(super) fn follower() -> Follower {
    let mut sensors = Sensors::ZERO;
    sensors.angles = titan8::MODEL.legs.map(|leg| leg.initial);
    Follower {
        sensors,
        outputs: Vec::new(),
        stops: Vec::new(),
        read_fault: None,
        write_fault: None,
    }
}

impl Hardware<4, 3> for Follower {
    fn read(&mut self, into: &mut Sensors<4, 3>) -> Result<(), HardwareFault> {
        *into = self.sensors;
        self.read_fault.map_or(Ok(()), Err)
    }
    fn write(&mut self, outputs: &Outputs<4, 3>) -> Result<(), HardwareFault> {
        self.outputs.push(*outputs);
        for (angle, command) in
            (self.sensors.angles.iter_mut().flatten()).zip(outputs.joints.iter().flatten())
        {
            if let JointCommand::Angle { angle: target, .. } = command {
                *angle = *target;
            }
        }
        self.write_fault.map_or(Ok(()), Err)
    }
    fn stop(&mut self, why: &Fault) {
        self.stops.push(*why);
    }
}

pub(super) type Bench<S = ()> = Machine<Script, Follower, Scripted, S, 4, 3>;

pub(super) static MODEL: Model<4, 3> = titan8::MODEL;

pub(super) fn bench(steps: &'static [Step], keys: &[(u64, u8)]) -> Bench {
    bench_with(steps, keys, ())
}

pub(super) fn bench_with<S: Special>(
    steps: &'static [Step],
    keys: &[(u64, u8)],
    special: S,
) -> Bench<S> {
    Machine::new(
        script(steps),
        &MODEL,
        follower(),
        Scripted::new(keys.to_vec()),
        special,
    )
    .expect("made for this robot")
}

pub(super) fn nop(_: &mut Scalars, _: &mut dyn Context) -> Result<Flow, Fault> {
    Ok(Flow::Next)
}

pub(super) fn stay(_: &mut Scalars, _: &mut dyn Context) -> Result<Flow, Fault> {
    Ok(Flow::Wait)
}

pub(super) fn end(_: &mut Scalars, _: &mut dyn Context) -> Result<Flow, Fault> {
    Ok(Flow::Finished(End::End))
}

pub(super) fn run(cx: &mut dyn Context, op: Op, values: &[f64]) -> Result<Flow, Fault> {
    let values: Vec<_> = values.iter().copied().map(Value::Absolute).collect();
    let command = Command {
        op,
        hs: false,
        target: Target::None,
        values: &values,
    };
    Ok(match cx.command(&command)? {
        Poll::Done => Flow::Next,
        Poll::Pending => Flow::Wait,
    })
}

// clauses: 2.1 2.18 2.19
#[test]
fn one_step_runs_in_each_cycle_and_the_servo_loop_outlives_the_program() {
    let mut machine = bench(&[nop, nop, end], &[]);
    assert_eq!(machine.cycle(), Status::Running);
    assert_eq!(machine.program().at(), 1);
    assert_eq!(machine.cycle(), Status::Running);
    assert_eq!(machine.cycle(), Status::Finished(End::End));
    assert_eq!((machine.cycles(), machine.console().inner().ended), (3, 1));
    assert_eq!(machine.cycle(), Status::Finished(End::End));
    assert_eq!((machine.cycles(), machine.console().inner().ended), (3, 1));
    assert_eq!(machine.hardware().outputs.len(), 4);
}

// clauses: 2.19
#[test]
fn the_servo_holds_the_initial_posture_at_program_start() {
    let mut machine = bench(&[nop, end], &[]);
    machine.cycle();
    let sent = machine.hardware().outputs[0].joints;
    let initial = MODEL.legs.map(|leg| leg.initial.map(JointCommand::at));
    assert_eq!(sent, initial);
}

#[test]
fn a_pause_runs_no_step_and_does_not_count() {
    let mut machine = bench(&[nop, nop, end], &[]);
    machine.cycle();
    machine.pause();
    for _ in 0..5 {
        assert_eq!(machine.cycle(), Status::Running);
    }
    assert_eq!((machine.program().at(), machine.cycles()), (1, 1));
    assert!(machine.controller().is_held());
    assert_eq!(machine.hardware().outputs.len(), 6);
    machine.resume();
    assert!(!machine.controller().is_held());
    machine.cycle();
    assert_eq!((machine.program().at(), machine.cycles()), (2, 2));
}

#[test]
fn a_machine_is_cloned_with_all_its_state() {
    let mut machine = bench(&[nop, nop, end], &[]);
    machine.cycle();
    let mut copy = machine.clone();
    copy.cycle();
    assert_eq!((machine.program().at(), copy.program().at()), (1, 2));
}

#[test]
fn a_program_for_another_robot_is_refused_by_name() {
    let other = crate::model::generic::MODEL;
    let refused = Machine::new(script(&[end]), &other, follower(), (), ())
        .err()
        .expect("another robot");
    assert_eq!(
        std::format!("{refused}"),
        "the program was compiled for titan8 (commands of TITAN VIII, 4 legs of 3 joints), \
         the robot is generic (commands of generic robots, 4 legs of 3 joints)"
    );
}
