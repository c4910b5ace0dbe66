//! Commands that move the body.

use crate::cycle::program::{Bench, Step, bench, run};
use tip_runtime::command::{Op, Target};

const ALL: Target = Target::All;

const fn leg(leg: u8) -> Target {
    Target::Foot(leg)
}

const RISE: [Step; 2] = [
    (Op::StandUp, Target::None, &[50.0]),
    (Op::WaitInpos, ALL, &[]),
];

// clauses: 7.15 7.44
#[test]
fn stand_up_lifts_the_body_and_sit_down_lays_it_on_its_belly() {
    let up = run(&RISE);
    let body = up.hardware().body();
    assert!((body.position[2] - 250.0).abs() < 3.0, "{body:?}");
    assert_eq!(up.hardware().belly_load(), 0.0);
    const UP_AND_DOWN: [Step; 3] = [
        RISE[0],
        (Op::SitDown, Target::None, &[50.0]),
        (Op::Sleep, Target::None, &[400.0]),
    ];
    let down = run(&UP_AND_DOWN);
    let body = down.hardware().body();
    assert!((body.position[2] - 200.0).abs() < 3.0, "{body:?}");
    assert!(down.hardware().belly_load() > 0.0);
}

// clauses: 7.3 7.5 7.15
#[test]
fn four_feet_swept_together_take_the_body_along() {
    // Held while the targets are set, all feet start together.
    const SWEEP: [Step; 9] = [
        RISE[0],
        (Op::AllStop, Target::None, &[]),
        (Op::RelPtp, leg(1), &[0.0, -80.0, 0.0]),
        (Op::RelPtp, leg(2), &[0.0, -80.0, 0.0]),
        (Op::RelPtp, leg(3), &[0.0, -80.0, 0.0]),
        (Op::RelPtp, leg(4), &[0.0, -80.0, 0.0]),
        (Op::AllStopRelease, Target::None, &[]),
        (Op::WaitInpos, ALL, &[]),
        (Op::Sleep, Target::None, &[400.0]),
    ];
    let machine = run(&SWEEP);
    let body = machine.hardware().body();
    assert!((body.position[1] - 80.0).abs() < 1.0, "{body:?}");
    assert_eq!(machine.hardware().falls(), 0);
    let slip = machine.hardware().worst_slip();
    assert!(slip <= 1.0, "{slip}");
}

// clauses: 7.45
#[test]
fn detect_floor_finds_the_floor_by_the_soles() {
    const LIFT_AND_FEEL: [Step; 4] = [
        RISE[0],
        (Op::RelPtp, leg(2), &[0.0, 0.0, 4.0]),
        (Op::WaitInpos, leg(2), &[]),
        (Op::DetectFloor, leg(2), &[1.0]),
    ];
    let machine = run(&LIFT_AND_FEEL);
    assert!(machine.hardware().feet()[1].touches());
}

/// Returns the last commanded height of foot 1, by the thigh angle.
fn thigh(machine: &Bench) -> f64 {
    machine.outputs().joints[0][1].value()
}

const SLOWLY_DOWN: Step = (Op::Ptp, leg(1), &[-391.0, 201.0, -250.0]);

// clauses: 2.18 2.24
#[test]
fn the_end_of_a_program_brings_a_moving_robot_to_rest() {
    const ENDS_IN_MOTION: [Step; 2] = [SLOWLY_DOWN, (Op::Sleep, Target::None, &[100.0])];
    let mut machine = run(&ENDS_IN_MOTION);
    let at_the_end = thigh(&machine);
    let mut last = at_the_end;
    for _ in 0..200 {
        machine.cycle();
        last = thigh(&machine);
    }
    machine.cycle();
    assert_eq!(thigh(&machine), last);
    assert!(last < at_the_end, "it needs a way to slow down");
    const ARRIVES: [Step; 2] = [SLOWLY_DOWN, (Op::WaitInpos, ALL, &[])];
    let arrived = run(&ARRIVES);
    assert!(
        last > thigh(&arrived) + 5.0,
        "it does not go on to its target"
    );
}

// clauses: 7.41
#[test]
fn a_dump_of_variables_holds_a_moving_robot_for_its_cycle() {
    const DUMPS: [Step; 4] = [
        SLOWLY_DOWN,
        (Op::Sleep, Target::None, &[200.0]),
        (Op::OutputVariables, Target::None, &[]),
        (Op::WaitInpos, ALL, &[]),
    ];
    const GOES_ON: [Step; 4] = [
        SLOWLY_DOWN,
        (Op::Sleep, Target::None, &[200.0]),
        (Op::FlushBuf, Target::None, &[]),
        (Op::WaitInpos, ALL, &[]),
    ];
    let (mut held, mut free) = (bench(&DUMPS), bench(&GOES_ON));
    while free.cycles() < 12 {
        assert_eq!(thigh(&held), thigh(&free));
        held.cycle();
        free.cycle();
    }
    assert!(thigh(&held) > thigh(&free));
    for _ in 0..200 {
        held.cycle();
    }
    assert!(!held.status().is_running());
}

// clauses: 2.19
#[test]
fn an_emergency_freezes_the_controller_where_the_robot_is() {
    const FAILS_IN_MOTION: [Step; 3] = [
        SLOWLY_DOWN,
        (Op::Sleep, Target::None, &[200.0]),
        (Op::LampOn, Target::None, &[200.0]),
    ];
    let mut machine = bench(&FAILS_IN_MOTION);
    while machine.cycle().is_running() {}
    let measured = machine.hardware().angles();
    for _ in 0..10 {
        machine.cycle();
    }
    assert_eq!(machine.hardware().angles(), measured);
    let commanded = machine.controller().outputs();
    for (commanded, measured) in commanded.iter().flatten().zip(measured.iter().flatten()) {
        assert_eq!(commanded.value(), *measured);
    }
}
