//! Moves of feet and joints on ideal servos.

use crate::rig::{Rig, distance};
use tip_runtime::command::{Op, Target};

const F1: Target = Target::Foot(1);
const J11: Target = Target::Joint(1, 1);

/// Returns the number of cycles until the commands of leg 1 stand still at `goal`.
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

// clauses: 2.24 7.2
#[test]
fn a_stretched_leg_that_turns_brakes_by_its_joints_before_its_foot_sets_off() {
    let mut rig = Rig::titan();
    // The knee's working limit: the foot is on the border of its reach, and goes along it.
    rig.done(Op::PtpAngle, F1, &[0.0, 0.0, 5.0]);
    rig.cycles(Op::WaitInpos, F1, &[]);
    rig.done(Op::OmegaControl, Target::Joint(1, 1), &[60.0]);
    rig.idle(20);
    let mut angles = vec![rig.commanded()[0]];
    rig.idle(1);
    angles.push(rig.commanded()[0]);
    rig.done(Op::Ptp, F1, &[-391.0, 301.0, -150.0]);
    for _ in 0..9 {
        angles.push(rig.commanded()[0]);
        rig.idle(1);
    }
    // 60 deg/s take 8.3 cycles of 20 ms at 360 deg/s²; nothing else turns meanwhile.
    for three in angles.windows(3) {
        let bend = three[2][0] - 2.0 * three[1][0] + three[0][0];
        assert!((-0.144 - 1e-9..1e-9).contains(&bend), "{bend}");
        assert_eq!(three[2][1..], three[0][1..]);
    }
    rig.cycles(Op::WaitInpos, F1, &[]);
    assert!(distance(rig.foot(1), [-391.0, 301.0, -150.0]) < 2.1);
}

// clauses: 2.24 7.2
#[test]
fn a_foot_whose_leg_turns_sets_off_at_once_where_it_stays_within_reach() {
    let mut rig = Rig::titan();
    rig.done(Op::OmegaControl, Target::Joint(1, 1), &[30.0]);
    rig.idle(10);
    let before = rig.foot(1);
    rig.idle(1);
    let turning = rig.foot(1);
    rig.done(Op::Ptp, F1, &[-391.0, 201.0, -120.0]);
    // It goes on as fast as it went, and up as well.
    let (after, way) = (rig.foot(1), distance(turning, before));
    assert!((distance(after, turning) - way).abs() < 600.0 * 0.02 * 0.02 + 0.1);
    assert!(after[2] > turning[2] + 0.01, "{after:?}");
}
