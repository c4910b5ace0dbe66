//! Commands and events that bring the robot to rest.

use crate::rig::{self, Rig, distance};
use tip_runtime::command::{Command, Op, Poll, Target};

const F1: Target = Target::Foot(1);
const F2: Target = Target::Foot(2);
const J11: Target = Target::Joint(1, 1);
const J21: Target = Target::Joint(2, 1);
const GOAL: [f64; 3] = [-391.0, 281.0, -160.0];

/// Returns foot 1 after 11 cycles of motion, J21 after 10.
fn under_way() -> Rig {
    let mut rig = Rig::titan();
    rig.done(Op::Ptp, F1, &GOAL);
    rig.done(Op::PtpAngle, J21, &[50.0]);
    rig.idle(9);
    rig
}

/// Returns the speed of foot 1 in the next cycle.
fn speed(rig: &mut Rig) -> f64 {
    let before = rig.foot(1);
    rig.idle(1);
    distance(rig.foot(1), before) / 0.02
}

fn run_to_rest(rig: &mut Rig) {
    while speed(rig) > 1e-9 {}
    rig.idle(50);
}

// clauses: 7.5 2.24
#[test]
fn all_stop_brakes_and_release_resumes() {
    let mut rig = under_way();
    let from = rig.foot(1);
    rig.done(Op::AllStop, Target::None, &[]);
    assert!(rig.controller.is_held());
    // 11 cycles at 600 mm/s² made 132 mm/s; 132² / 1200 = 14.5 mm.
    run_to_rest(&mut rig);
    assert!((distance(rig.foot(1), from) - 14.52).abs() < 0.01);
    let joint = rig.commanded()[1][0];
    // 10 cycles at 360 deg/s² made 72 deg/s: 7.2 deg, then 7.2 deg of braking.
    assert!((joint - 14.4).abs() < 1e-9);
    // Modes and targets stay, and INPOS and NEAR go on meaning them.
    assert!(!rig.controller.inpos(F1) && !rig.controller.near(F1));
    assert!(!rig.controller.inpos(J21));
    assert!(!rig.controller.inpos(Target::All));
    assert_eq!(rig.run(Op::WaitNear, F1, &[]), Ok(Poll::Pending));
    rig.done(Op::AllStopRelease, Target::None, &[]);
    assert!(!rig.controller.is_held());
    rig.idle(200);
    assert!(distance(rig.foot(1), GOAL) < 1e-9);
    assert!((rig.commanded()[1][0] - 50.0).abs() < 1e-9);
    assert!(rig.controller.inpos(Target::All));
}

// clauses: 7.5
#[test]
fn targets_set_while_held_start_together_at_the_release() {
    let mut rig = Rig::titan();
    rig.done(Op::AllStop, Target::None, &[]);
    rig.done(Op::Ptp, F1, &[-391.0, 251.0, -200.0]);
    rig.idle(7);
    rig.done(Op::Ptp, F2, &[391.0, 251.0, -200.0]);
    rig.done(Op::OmegaControl, Target::Joint(3, 1), &[10.0]);
    rig.idle(5);
    assert_eq!(rig.commanded(), [[0.0, 0.0, 90.0]; 4]);
    rig.done(Op::AllStopRelease, Target::None, &[]);
    for _ in 0..20 {
        rig.idle(1);
        assert!((rig.foot(1)[1] - rig.foot(2)[1]).abs() < 1e-9);
    }
    assert!(rig.foot(1)[1] > 205.0);
    assert!(rig.commanded()[2][0] > 1.0);
}

// clauses: 7.5
#[test]
fn all_stop_holds_velocities_too() {
    let mut rig = Rig::titan();
    rig.done(Op::VelControl, F1, &[0.0, 0.0, 60.0]);
    rig.idle(20);
    rig.done(Op::AllStop, Target::None, &[]);
    run_to_rest(&mut rig);
    let still = rig.foot(1);
    rig.idle(20);
    assert_eq!(rig.foot(1), still);
    rig.done(Op::AllStopRelease, Target::None, &[]);
    rig.idle(20);
    assert!((speed(&mut rig) - 60.0).abs() < 1e-6);
}

// clauses: 7.5
#[test]
fn release_without_stop_means_nothing() {
    let mut rig = under_way();
    rig.done(Op::AllStopRelease, Target::None, &[]);
    rig.idle(200);
    assert!(distance(rig.foot(1), GOAL) < 1e-9);
}

// clauses: 7.3 2.24
#[test]
fn rel_ptp_of_zero_stops_here() {
    let mut rig = under_way();
    let from = rig.foot(1);
    rig.done(Op::RelPtp, F1, &[0.0; 3]);
    assert!(!rig.controller.inpos(F1), "the foot has still to stop");
    run_to_rest(&mut rig);
    assert!((distance(rig.foot(1), from) - 14.52).abs() < 0.01);
    // The target is the point of rest.
    assert!(rig.controller.inpos(F1));
    let rest = rig.foot(1);
    rig.done(Op::RelPtp, F1, &[0.0, 10.0, 0.0]);
    rig.idle(100);
    assert!(distance(rig.foot(1), [rest[0], rest[1] + 10.0, rest[2]]) < 1e-9);
    // One member of another value makes it a move like any other.
    let mut rig = under_way();
    rig.done(Op::RelPtp, F1, &[0.0, 0.0, 1e-3]);
    rig.idle(200);
    assert!(distance(rig.foot(1), [GOAL[0], GOAL[1], GOAL[2] + 1e-3]) < 1e-9);
}

// clauses: 7.4 2.24
#[test]
fn rel_ptp_angle_of_zero_stops_here() {
    let mut rig = under_way();
    rig.done(Op::RelPtpAngle, J21, &[0.0]);
    rig.idle(100);
    assert!((rig.commanded()[1][0] - 14.4).abs() < 1e-9);
    assert!(rig.controller.inpos(J21));
    // For a leg all joints have to be zero.
    let mut rig = under_way();
    rig.done(Op::RelPtpAngle, F2, &[0.0; 3]);
    rig.idle(100);
    assert!((rig.commanded()[1][0] - 14.4).abs() < 1e-9);
    let mut rig = under_way();
    rig.done(Op::RelPtpAngle, F2, &[0.0, 0.0, 1.0]);
    rig.idle(100);
    assert!((rig.commanded()[1][0] - 50.0).abs() < 1e-9);
}

// clauses: 7.11 7.1
#[test]
fn zero_relative_to_the_measured_position_is_no_stop() {
    // PTP R 0 heads for where the foot is now, which it leaves while it brakes.
    let mut rig = under_way();
    let here = rig.foot(1);
    let zero = [0.0; 3].map(tip_runtime::command::Value::Relative);
    assert_eq!(rig.run(Op::Ptp, F1, &zero), Ok(Poll::Done));
    rig.idle(200);
    assert!(distance(rig.foot(1), here) < 1e-9);
}

// clauses: 7.6
#[test]
fn initial_posture_takes_one_cycle_at_rest_and_restores_everything() {
    let mut rig = Rig::titan();
    rig.done(Op::SetVMax, Target::All, &[10.0]);
    rig.done(Op::SetSamplingTime, Target::None, &[50.0]);
    rig.done(Op::EmgOff, Target::None, &[]);
    rig.done(Op::PtpAngle, J11, &[20.0]);
    rig.idle(100);
    rig.done(Op::AllStop, Target::None, &[]);
    assert_eq!(rig.cycles(Op::InitialPosture, Target::None, &[]), 1);
    assert_eq!(rig.controller.period(), 20.0);
    assert!(!rig.controller.is_held());
    assert!(!rig.controller.inpos(F1), "it has only set off");
    rig.idle(200);
    for (leg, commanded) in rig.model.legs.iter().zip(rig.commanded()) {
        for (initial, commanded) in leg.initial.iter().zip(commanded) {
            assert!((initial - commanded).abs() < 1e-9);
        }
    }
    // Feet are under position control: a joint counts in mm.
    assert!(rig.controller.inpos(Target::All) && rig.controller.near(F2));
    // EMG_ON again.
    let fault = rig.fault(Op::Ptp, F1, &[100.0, -100.0, 0.0]);
    assert_eq!(fault, tip_runtime::fault::Fault::OutOfReach(F1));
}

// clauses: 7.6 2.17 2.24
#[test]
fn initial_posture_waits_until_the_robot_is_still() {
    let mut rig = under_way();
    // 132 mm/s under 600 mm/s² and 72 deg/s under 360 deg/s²: 11 cycles of braking.
    assert_eq!(rig.cycles(Op::InitialPosture, Target::None, &[]), 12);
    rig.idle(200);
    assert!(distance(rig.foot(1), [-391.0, 201.0, -200.0]) < 1e-9);
}

// clauses: 2.18 2.24
#[test]
fn finishing_brakes_then_restores_and_controls_nothing() {
    let mut rig = under_way();
    rig.done(Op::SetSamplingTime, Target::None, &[10.0]);
    let from = rig.foot(1);
    rig.controller.finish();
    rig.controller.advance();
    assert_eq!(rig.controller.period(), 10.0, "the limits in force hold on");
    run_to_rest(&mut rig);
    let way = distance(rig.foot(1), from);
    assert!(way > 10.0 && way < 20.0, "{way}");
    assert_eq!(rig.controller.period(), 20.0);
    assert!(rig.controller.inpos(Target::All) && !rig.controller.near(Target::All));
    assert!(!rig.controller.is_held());
    let still = rig.commanded();
    rig.idle(50);
    assert_eq!(rig.commanded(), still);
}

// clauses: 2.18
#[test]
fn finishing_at_rest_restores_at_once() {
    let mut rig = Rig::titan();
    rig.done(Op::AllStop, Target::None, &[]);
    rig.done(Op::SetSamplingTime, Target::None, &[10.0]);
    rig.controller.finish();
    assert_eq!(rig.controller.period(), 20.0);
    assert!(!rig.controller.is_held());
}

// clauses: 2.19
#[test]
fn an_emergency_freezes_every_joint_where_it_is_measured() {
    let mut rig = under_way();
    rig.stuck[3][1] = true;
    rig.sensors.angles[3][1] = 1.5;
    rig.sense().expect("sensors read well");
    rig.controller.emergency();
    assert_eq!(rig.commanded(), rig.sensors.angles);
    let still = rig.commanded();
    rig.idle(50);
    assert_eq!(rig.commanded(), still);
    assert!(!rig.controller.near(Target::All));
}

// clauses: 7.41
#[test]
fn holding_from_outside_is_all_stop() {
    let mut rig = under_way();
    rig.controller.hold();
    assert!(rig.controller.is_held());
    run_to_rest(&mut rig);
    rig.controller.release();
    rig.idle(200);
    assert!(distance(rig.foot(1), GOAL) < 1e-9);
}

// clauses: 7.2 2.24
#[test]
fn a_high_speed_move_is_stopped_at_once() {
    let mut rig = Rig::titan();
    rig.done_hs(Op::Ptp, F1, &GOAL);
    rig.idle(2);
    let from = rig.foot(1);
    let stop = Command {
        op: Op::RelPtp,
        hs: false,
        target: F1,
        values: &rig::absolute(&[0.0; 3]),
    };
    assert_eq!(rig.run_with(&stop), Ok(Poll::Done));
    assert!(distance(rig.foot(1), from) < 1e-9);
}

// clauses: 2.24 7.2 7.3
#[test]
fn a_plain_move_brakes_even_behind_a_high_speed_one() {
    let mut rig = Rig::titan();
    rig.done_hs(Op::Ptp, F1, &[-391.0, 301.0, -200.0]);
    rig.idle(2);
    let from = rig.foot(1)[1];
    // 300 mm/s under 600 mm/s² need 75 mm to stop: it brakes immediately.
    rig.done(Op::Ptp, F1, &[-391.0, from + 20.0, -200.0]);
    assert!((rig.foot(1)[1] - from - (6.0 - 0.12)).abs() < 1e-9);
}
