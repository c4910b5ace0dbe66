//! SPECIAL, its flags, and the analogue inputs.

use super::*;
use crate::command::{Flag, Port};
use crate::program::Robot;
use crate::special::Call;

fn special_14(_: &mut Scalars, cx: &mut dyn Context) -> Result<Flow, Fault> {
    run(cx, Op::Special, &[14.0, 30.0])
}

fn special_15(_: &mut Scalars, cx: &mut dyn Context) -> Result<Flow, Fault> {
    run(cx, Op::Special, &[15.9])
}

fn special_256(_: &mut Scalars, cx: &mut dyn Context) -> Result<Flow, Fault> {
    run(cx, Op::Special, &[256.0])
}

fn flag_3(scalars: &mut Scalars, cx: &mut dyn Context) -> Result<Flow, Fault> {
    scalars[1].1 = Some(f64::from(u8::from(cx.flag(Flag::Special(3)))));
    Ok(Flow::Next)
}

// clauses: 2.17 7.43
#[test]
fn a_native_command_decides_when_its_step_is_done() {
    let mut seen = Vec::new();
    let mut machine = bench_with(
        &[special_14, special_14, special_15, end],
        &[],
        |call: Call, _: &mut dyn Robot| {
            seen.push((call.number, call.arguments, call.first));
            Ok(if call.number == 14 && call.first {
                Poll::Pending
            } else {
                Poll::Done
            })
        },
    );
    let at: Vec<_> = (0..5)
        .map(|_| {
            machine.cycle();
            machine.program().at()
        })
        .collect();
    assert_eq!(at, [0, 1, 1, 2, 3]);
    drop(machine);
    let with = [Some(30.0), None];
    assert_eq!(
        seen,
        [
            (14, with, true),
            (14, with, false),
            (14, with, true),
            (14, with, false),
            (15, [None, None], true),
        ]
    );
}

// clauses: 7.43
#[test]
fn an_unknown_native_command_is_a_domain_error() {
    let mut machine = bench(&[special_14], &[]);
    assert_eq!(machine.cycle(), Status::Emergency);
    assert_eq!(machine.emergency().map(|e| e.fault), Some(Fault::Domain));

    let accepting = |_: Call, _: &mut dyn Robot| Ok(Poll::Done);
    let mut machine = bench_with(&[special_256], &[], accepting);
    assert_eq!(machine.cycle(), Status::Emergency);
}

// clauses: 2.19 5.1 7.43
#[test]
fn native_code_sets_flags_and_commands_the_robot() {
    let mut machine = bench_with(
        &[flag_3, special_14, flag_3, end],
        &[],
        |_: Call, robot: &mut dyn Robot| {
            robot.set_special_flag(3, true);
            robot.set_special_flag(10, true);
            robot.command(&Command {
                op: Op::LampOn,
                hs: false,
                target: Target::None,
                values: &[Value::Absolute(2.0)],
            })
        },
    );
    machine.cycle();
    assert_eq!(machine.program().scalars[1].1, Some(0.0));
    machine.cycle();
    machine.cycle();
    assert_eq!(machine.program().scalars[1].1, Some(1.0));
    assert_eq!(machine.hardware().outputs[1].lamps[0], 0b100);
}

/// Counts the cycles that it sees, lights a lamp in the second one, and fails in cycle `fails`.
struct Activity {
    cycles: u32,
    fails: u32,
}

impl Special for Activity {
    fn poll(&mut self, _: Call, _: &mut dyn Robot) -> Result<Poll, Fault> {
        Err(Fault::Domain)
    }

    fn cycle(&mut self, robot: &mut dyn Robot) -> Result<(), Fault> {
        self.cycles += 1;
        if self.cycles == self.fails {
            return Err(Fault::InvalidMode);
        }
        if self.cycles == 2 {
            robot.command(&Command {
                op: Op::LampOn,
                hs: false,
                target: Target::None,
                values: &[Value::Absolute(2.0)],
            })?;
        }
        Ok(())
    }
}

fn active(steps: &'static [Step], fails: u32) -> Bench<Activity> {
    bench_with(steps, &[], Activity { cycles: 0, fails })
}

// clauses: 2.17 7.43
#[test]
fn native_code_goes_on_behind_every_step_of_a_running_program() {
    let mut machine = active(&[nop, nop, stay], 0);
    machine.cycle();
    machine.cycle();
    let lamps: Vec<_> = (machine.hardware().outputs.iter())
        .map(|outputs| outputs.lamps[0])
        .collect();
    assert_eq!(lamps, [0, 0b100]);
    machine.pause();
    machine.cycle();
    machine.resume();
    machine.cycle();
    assert_eq!(machine.special.cycles, 3);

    let mut ended = active(&[nop, end], 0);
    for _ in 0..5 {
        ended.cycle();
    }
    assert_eq!(ended.special.cycles, 1);
}

// clauses: 2.22
#[test]
fn a_fault_of_native_code_behind_a_step_is_found_in_the_next_cycle() {
    let mut machine = active(&[nop, nop, nop, end], 2);
    machine.cycle();
    assert_eq!(machine.cycle(), Status::Running);
    assert_eq!(machine.cycle(), Status::Emergency);
    let emergency = machine.emergency().map(|e| (e.fault, e.step, e.cycle));
    assert_eq!(emergency, Some((Fault::InvalidMode, 2, 2)));
}

const PORTS: [Port; 8] = [
    Port::Channel(13),
    Port::Knob(1),
    Port::Channel(0),
    Port::Joint(1, 1),
    Port::Channel(12),
    Port::Paw(4),
    Port::Antenna,
    Port::Channel(15),
];

fn read_ports(_: &mut Scalars, cx: &mut dyn Context) -> Result<Flow, Fault> {
    let volts = PORTS.map(|port| cx.analog(port));
    let expected = [1.25, 1.25, 2.5, 2.5, 0.0, 4.0, 0.75, -3.0];
    assert_eq!(volts, expected.map(Ok));
    assert_eq!(cx.analog(Port::Channel(16)), Err(Fault::Domain));
    assert_eq!(cx.analog(Port::Knob(4)), Err(Fault::Domain));
    assert_eq!(cx.analog(Port::Knob(0)), Err(Fault::Domain));
    assert_eq!(cx.analog(Port::Joint(5, 1)), Err(Fault::Domain));
    assert_eq!(cx.analog(Port::Paw(5)), Err(Fault::Domain));
    assert_eq!(cx.analog(Port::Knob(2)), Err(Fault::Sensor(Port::Knob(2))));
    assert!(cx.flag(Flag::Antenna));
    Ok(Flow::Next)
}

// clauses: 7.32
#[test]
fn every_input_reads_in_volts_by_channel_and_by_name() {
    let mut machine = bench(&[read_ports, end], &[]);
    let sensors = &mut machine.hardware_mut().sensors;
    for (knob, volts) in (1..).zip([1.25, f64::NAN, -3.0]) {
        sensors.inputs.set(Port::Knob(knob), volts);
    }
    // J11 ranges over ±65 degrees up to its outer limits: half way is 2.5 V.
    sensors.angles[0][0] = 32.5;
    sensors.inputs.set(Port::Paw(4), 4.0);
    sensors.inputs.set(Port::Antenna, 0.75);
    assert_eq!(machine.cycle(), Status::Running);
}
