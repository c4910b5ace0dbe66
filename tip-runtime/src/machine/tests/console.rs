//! Lamps, messages, logs and the dump of variables.

use super::*;

fn lamp_on(_: &mut Scalars, cx: &mut dyn Context) -> Result<Flow, Fault> {
    run(cx, Op::LampOn, &[7.9])
}

fn lamp_off(_: &mut Scalars, cx: &mut dyn Context) -> Result<Flow, Fault> {
    run(cx, Op::LampOff, &[7.0])
}

fn lamp_8(_: &mut Scalars, cx: &mut dyn Context) -> Result<Flow, Fault> {
    run(cx, Op::LampOn, &[8.0])
}

fn lamp_minus_1(_: &mut Scalars, cx: &mut dyn Context) -> Result<Flow, Fault> {
    run(cx, Op::LampOff, &[-1.0])
}

// clauses: 7.36
#[test]
fn lamps_are_fitted_devices_with_truncated_numbers() {
    let mut machine = bench(&[lamp_on, nop, lamp_off, end], &[]);
    for _ in 0..4 {
        machine.cycle();
    }
    let lit: Vec<_> = (machine.hardware().outputs.iter())
        .map(|outputs| outputs.lamps[0])
        .collect();
    assert_eq!(lit, [1 << 7, 1 << 7, 0, 0]);

    for steps in [&[lamp_8 as Step] as &'static [Step], &[lamp_minus_1]] {
        let mut machine = bench(steps, &[]);
        assert_eq!(machine.cycle(), Status::Emergency);
        assert_eq!(machine.emergency().map(|e| e.fault), Some(Fault::Domain));
    }
}

fn hello(_: &mut Scalars, cx: &mut dyn Context) -> Result<Flow, Fault> {
    cx.message(&"hello");
    Ok(Flow::Next)
}

fn silent_on(_: &mut Scalars, cx: &mut dyn Context) -> Result<Flow, Fault> {
    run(cx, Op::SilentOn, &[])
}

fn silent_off(_: &mut Scalars, cx: &mut dyn Context) -> Result<Flow, Fault> {
    run(cx, Op::SilentOff, &[])
}

// clauses: 7.35 7.37
#[test]
fn messages_and_silence_reach_the_console() {
    let mut machine = bench(&[hello, silent_on, silent_off, end], &[]);
    for _ in 0..4 {
        machine.cycle();
    }
    let told = machine.console().inner();
    assert_eq!(told.messages, ["hello"]);
    assert_eq!(told.silent, [true, false]);
}

fn start(_: &mut Scalars, cx: &mut dyn Context) -> Result<Flow, Fault> {
    run(cx, Op::LogStart, &[])
}

fn stop(_: &mut Scalars, cx: &mut dyn Context) -> Result<Flow, Fault> {
    run(cx, Op::LogStop, &[])
}

fn one_shot(_: &mut Scalars, cx: &mut dyn Context) -> Result<Flow, Fault> {
    run(cx, Op::LogOneShot, &[])
}

// clauses: 7.40
#[test]
fn sampling_goes_on_between_start_and_stop_and_once_for_a_shot() {
    let mut machine = bench(
        &[
            nop, start, nop, stop, nop, one_shot, nop, start, one_shot, end,
        ],
        &[],
    );
    while machine.cycle().is_running() {}
    let text = std::format!("{}", machine.console().inner().log);
    let cycles: Vec<_> = (text.lines().skip(1))
        .map(|row| row.split('\t').next().expect("a column"))
        .collect();
    assert_eq!(cycles, ["1", "2", "5", "7", "8", "9"]);
    let times: Vec<_> = (text.lines().skip(1))
        .map(|row| row.split('\t').nth(1).expect("a column"))
        .collect();
    assert_eq!(times[..2], ["20.0", "40.0"]);
    // TITAN VIII senses no torque.
    assert!(!text.contains("\tT11"));
}

fn dump(_: &mut Scalars, cx: &mut dyn Context) -> Result<Flow, Fault> {
    run(cx, Op::OutputVariables, &[])
}

fn all_stop(_: &mut Scalars, cx: &mut dyn Context) -> Result<Flow, Fault> {
    run(cx, Op::AllStop, &[])
}

fn assign(scalars: &mut Scalars, _: &mut dyn Context) -> Result<Flow, Fault> {
    scalars[1].1 = Some(-0.5);
    Ok(Flow::Next)
}

// clauses: 7.41 9.5
#[test]
fn every_variable_is_written_and_the_robot_held_for_that_cycle() {
    let mut machine = bench(&[assign, dump, nop, end], &[]);
    machine.cycle();
    machine.cycle();
    assert_eq!(
        machine.console().inner().variables,
        ["# cycle 1, step 1, line 5\nVAR_KEY\tunassigned\nA\t-0.5\n"]
    );
    assert!(!machine.controller().is_held());
}

// clauses: 7.41
#[test]
fn a_robot_that_was_held_stays_held_behind_a_dump() {
    let mut machine = bench(&[all_stop, dump, nop, end], &[]);
    machine.cycle();
    machine.cycle();
    assert!(machine.controller().is_held());
}
