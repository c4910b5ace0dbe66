//! Moves of feet and joints on ideal servos.
#![cfg(feature = "control")]

mod rig;

use rig::{Rig, distance};
use tip_runtime::command::{Op, Target};

const F1: Target = Target::Foot(1);
const J11: Target = Target::Joint(1, 1);

/// Cycles until the commands of leg 1 stand still at `goal`.
fn cycles_to(rig: &mut Rig, goal: [f64; 3]) -> usize {
    for cycle in 1..2000 {
        if distance(rig.foot(1), goal) < 1e-9 {
            return cycle;
        }
        rig.idle(1);
    }
    panic!("never arrives");
}

// clauses: 7.2 7.21
#[test]
fn foot_moves_take_the_time_of_the_trapezium() {
    // Distance, seconds at 500 mm/s and 1000 mm/s²: none of these reaches 500 mm/s.
    for (way, seconds) in [(200.0_f64, 0.894), (50.0, 0.447)] {
        let mut rig = Rig::titan();
        rig.done(Op::SetVMax, F1, &[500.0]);
        rig.done(Op::SetAMax, F1, &[1000.0]);
        rig.done(Op::SetSamplingTime, Target::None, &[1.0]);
        let [x, y, z] = rig.foot(1);
        let goal = [x, y - way / 2.0, z];
        rig.done(Op::Ptp, F1, &goal);
        cycles_to(&mut rig, goal);
        let goal = [x, y + way / 2.0, z];
        rig.done(Op::Ptp, F1, &goal);
        let cycles = cycles_to(&mut rig, goal) as f64;
        assert!((cycles / 1000.0 - seconds).abs() <= 0.0015, "{cycles}");
    }
}

// clauses: 7.2
#[test]
fn a_long_move_cruises_at_v_max() {
    // 180 mm at 300 mm/s, 600 mm/s²: 0.5 s up, 30 mm in 0.1 s, 0.5 s down = 1.1 s = 55 cycles.
    let mut rig = Rig::titan();
    let [x, y, z] = rig.foot(1);
    rig.done(Op::Ptp, F1, &[x, y, z + 90.0]);
    let start = [x, y, z + 90.0];
    cycles_to(&mut rig, start);
    rig.done(Op::Ptp, F1, &[x, y, z - 90.0]);
    assert_eq!(cycles_to(&mut rig, [x, y, z - 90.0]), 55);
}

// clauses: 7.4
#[test]
fn joint_moves_take_the_time_of_the_trapezium() {
    // 45 deg at 90 deg/s, 360 deg/s²: 0.25 s up, 22.5 deg in 0.25 s, 0.25 s down = 0.75 s.
    let mut rig = Rig::titan();
    rig.done(Op::SetSamplingTime, Target::None, &[10.0]);
    rig.done(Op::PtpAngle, J11, &[45.0]);
    let mut cycles = 1;
    while rig.commanded()[0][0] < 45.0 - 1e-9 {
        rig.idle(1);
        cycles += 1;
    }
    assert_eq!(cycles, 75);
}

// clauses: 7.44
#[test]
fn stand_up_and_sit_down_come_back() {
    let mut rig = Rig::titan();
    let before = rig.foot(3);
    rig.cycles(Op::StandUp, Target::None, &[60.0]);
    rig.idle(50);
    assert!((rig.foot(3)[2] - (before[2] - 60.0)).abs() < 1e-6);
    rig.cycles(Op::SitDown, Target::None, &[60.0]);
    rig.idle(50);
    assert!(distance(rig.foot(3), before) < 1e-6);
}
