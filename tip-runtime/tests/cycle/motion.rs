//! Commands that move the body.

use crate::program::{Step, run};
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
    assert!((body.z - 250.0).abs() < 3.0, "{body:?}");
    assert_eq!(up.hardware().belly_load(), 0.0);
    const UP_AND_DOWN: [Step; 3] = [
        RISE[0],
        (Op::SitDown, Target::None, &[50.0]),
        (Op::Sleep, Target::None, &[400.0]),
    ];
    let down = run(&UP_AND_DOWN);
    let body = down.hardware().body();
    assert!((body.z - 200.0).abs() < 3.0, "{body:?}");
    assert!(down.hardware().belly_load() > 0.0);
}

// clauses: 7.3 7.15
#[test]
fn four_feet_swept_together_take_the_body_along() {
    const SWEEP: [Step; 7] = [
        RISE[0],
        (Op::RelPtp, leg(1), &[0.0, -80.0, 0.0]),
        (Op::RelPtp, leg(2), &[0.0, -80.0, 0.0]),
        (Op::RelPtp, leg(3), &[0.0, -80.0, 0.0]),
        (Op::RelPtp, leg(4), &[0.0, -80.0, 0.0]),
        (Op::WaitInpos, ALL, &[]),
        (Op::Sleep, Target::None, &[400.0]),
    ];
    let machine = run(&SWEEP);
    let body = machine.hardware().body();
    assert!((body.y - 80.0).abs() < 1.0, "{body:?}");
    assert_eq!(machine.hardware().falls(), 0);
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
