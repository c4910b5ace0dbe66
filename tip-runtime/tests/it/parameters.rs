//! Parameter commands, judged by the robot's motion afterwards.

use crate::rig::{Rig, absolute, distance};
use tip_runtime::command::{Command, Op, Poll, Target};
use tip_runtime::fault::Fault;
use tip_runtime::model::titan8;

const ALL: Target = Target::All;
const F1: Target = Target::Foot(1);
const F2: Target = Target::Foot(2);
const J11: Target = Target::Joint(1, 1);
const J12: Target = Target::Joint(1, 2);
const J21: Target = Target::Joint(2, 1);

/// Returns the distance that a foot moves in the first cycle of a long move.
fn first_way(rig: &Rig, leg: u8, hs: bool) -> f64 {
    let (mut controller, before) = (rig.controller.clone(), rig.foot(leg.into()));
    let up = [before[0], before[1], before[2] + 100.0];
    let command = Command {
        op: Op::Ptp,
        hs,
        target: Target::Foot(leg),
        values: &absolute(&up),
    };
    controller.sense(&rig.sensors).expect("sensors read well");
    assert_eq!(controller.command(&command), Ok(Poll::Done));
    controller.advance();
    let moved = Rig {
        controller,
        ..Rig::titan()
    };
    distance(moved.foot(leg.into()), before)
}

/// Returns V_MAX of a foot: its distance in one cycle at high speed.
fn v_max(rig: &Rig, leg: u8) -> f64 {
    first_way(rig, leg, true) / 0.02
}

/// Returns A_MAX of a foot, from the ½ a t² of the first cycle.
fn a_max(rig: &Rig, leg: u8) -> f64 {
    first_way(rig, leg, false) / 0.0002
}

fn first_turn(rig: &Rig, leg: u8, joint: u8, hs: bool) -> f64 {
    let mut controller = rig.controller.clone();
    let (leg_at, joint_at) = (usize::from(leg) - 1, usize::from(joint) - 1);
    let before = rig.commanded()[leg_at][joint_at];
    let command = Command {
        op: Op::RelPtpAngle,
        hs,
        target: Target::Joint(leg, joint),
        values: &absolute(&[50.0]),
    };
    controller.sense(&rig.sensors).expect("sensors read well");
    assert_eq!(controller.command(&command), Ok(Poll::Done));
    controller.advance();
    controller.outputs()[leg_at][joint_at].value() - before
}

fn omega_max(rig: &Rig, leg: u8, joint: u8) -> f64 {
    first_turn(rig, leg, joint, true) / 0.02
}

fn omega_dot_max(rig: &Rig, leg: u8, joint: u8) -> f64 {
    first_turn(rig, leg, joint, false) / 0.0002
}

fn assert_close(a: f64, b: f64) {
    assert!((a - b).abs() <= 1e-6 * b.abs().max(1e-3), "{a} is not {b}");
}

fn started() -> Rig {
    let mut rig = Rig::titan();
    rig.idle(1);
    rig
}

// clauses: 2.19
#[test]
fn parameters_start_at_their_standard_values() {
    let rig = started();
    assert_close(v_max(&rig, 1), 300.0);
    assert_close(a_max(&rig, 4), 600.0);
    assert_close(omega_max(&rig, 1, 1), 90.0);
    assert_close(omega_dot_max(&rig, 4, 1), 360.0);
    assert_eq!(rig.controller.period(), 20.0);
}

// clauses: 7.21
#[test]
fn limits_of_feet_are_set_for_one_or_all() {
    let mut rig = started();
    rig.done(Op::SetVMax, F1, &[400.0]);
    rig.done(Op::SetAMax, F2, &[1000.0]);
    assert_close(v_max(&rig, 1), 400.0);
    assert_close(v_max(&rig, 2), 300.0);
    assert_close(a_max(&rig, 1), 600.0);
    assert_close(a_max(&rig, 2), 1000.0);
    rig.done(Op::SetVMax, ALL, &[500.0]);
    rig.done(Op::SetAMax, ALL, &[0.0]);
    for leg in 1..=4 {
        assert_close(v_max(&rig, leg), 500.0);
        assert_close(a_max(&rig, leg), 0.0);
    }
}

// clauses: 7.22
#[test]
fn limits_of_joints_are_set_for_one_or_all() {
    let mut rig = started();
    rig.done(Op::SetOmegaMax, J11, &[45.0]);
    rig.done(Op::SetOmegaDotMax, J12, &[100.0]);
    assert_close(omega_max(&rig, 1, 1), 45.0);
    assert_close(omega_max(&rig, 1, 2), 90.0);
    assert_close(omega_dot_max(&rig, 1, 1), 360.0);
    assert_close(omega_dot_max(&rig, 1, 2), 100.0);
    rig.done(Op::SetOmegaMax, ALL, &[0.0]);
    rig.done(Op::SetOmegaDotMax, ALL, &[50.0]);
    for leg in 1..=4 {
        for joint in 1..=3 {
            assert_close(omega_max(&rig, leg, joint), 0.0);
        }
    }
    rig.done(Op::SetOmegaMaxNormal, ALL, &[]);
    assert_close(omega_dot_max(&rig, 3, 2), 50.0);
}

// clauses: 7.23
#[test]
fn rates_are_of_the_standard_value() {
    let mut rig = started();
    for (first, rate) in [(1.0, 25.0), (7.0, 100.0), (900.0, 0.5)] {
        rig.done(Op::SetVMax, ALL, &[first]);
        rig.done(Op::SetAMax, ALL, &[first]);
        rig.done(Op::SetOmegaMax, ALL, &[first]);
        rig.done(Op::SetOmegaDotMax, ALL, &[first]);
        rig.done(Op::SetVMaxRate, F1, &[rate]);
        rig.done(Op::SetAMaxRate, F1, &[rate]);
        rig.done(Op::SetOmegaMaxRate, J11, &[rate]);
        rig.done(Op::SetOmegaDotMaxRate, J11, &[rate]);
        assert_close(v_max(&rig, 1), 3.0 * rate);
        assert_close(a_max(&rig, 1), 6.0 * rate);
        assert_close(omega_max(&rig, 1, 1), 0.9 * rate);
        assert_close(omega_dot_max(&rig, 1, 1), 3.6 * rate);
    }
    rig.done(Op::SetVMaxRate, ALL, &[50.0]);
    assert_close(v_max(&rig, 4), 150.0);
}

// clauses: 7.24
#[test]
fn slow_fast_and_normal_are_of_the_standard_value() {
    for (v, a, w, d, share) in [
        (
            Op::SetVMaxSlow,
            Op::SetAMaxSlow,
            Op::SetOmegaMaxSlow,
            Op::SetOmegaDotMaxSlow,
            0.5,
        ),
        (
            Op::SetVMaxFast,
            Op::SetAMaxFast,
            Op::SetOmegaMaxFast,
            Op::SetOmegaDotMaxFast,
            1.5,
        ),
        (
            Op::SetVMaxNormal,
            Op::SetAMaxNormal,
            Op::SetOmegaMaxNormal,
            Op::SetOmegaDotMaxNormal,
            1.0,
        ),
    ] {
        let mut rig = started();
        rig.done(Op::SetVMax, ALL, &[7.0]);
        rig.done(Op::SetAMax, ALL, &[7.0]);
        rig.done(Op::SetOmegaMax, ALL, &[7.0]);
        rig.done(Op::SetOmegaDotMax, ALL, &[7.0]);
        for (op, target) in [(v, F1), (a, F1), (w, J11), (d, J11)] {
            rig.done(op, target, &[]);
        }
        assert_close(v_max(&rig, 1), 300.0 * share);
        assert_close(a_max(&rig, 1), 600.0 * share);
        assert_close(omega_max(&rig, 1, 1), 90.0 * share);
        assert_close(omega_dot_max(&rig, 1, 1), 360.0 * share);
        assert_close(v_max(&rig, 2), 7.0);
        for op in [v, a, w, d] {
            rig.done(op, ALL, &[]);
        }
        assert_close(a_max(&rig, 2), 600.0 * share);
        assert_close(omega_max(&rig, 2, 1), 90.0 * share);
    }
}

// clauses: 7.21
#[test]
fn position_tolerances_decide_inpos_and_near() {
    let mut rig = started();
    rig.done(Op::SetVMax, ALL, &[0.0]);
    for leg in [1.0, -1.0] {
        let target = if leg > 0.0 { F2 } else { F1 };
        rig.done(Op::Ptp, target, &[leg * 391.0, 201.0, -195.0]);
    }
    for (just, near) in [(4.9, 4.9), (5.1, 4.9), (4.9, 5.1), (5.1, 5.1)] {
        rig.done(Op::SetJustPosition, F1, &[just]);
        rig.done(Op::SetNearPosition, F1, &[near]);
        assert_eq!(rig.controller.inpos(F1), just > 5.0);
        assert_eq!(rig.controller.near(F1), near > 5.0);
        assert!(!rig.controller.inpos(F2) && rig.controller.near(F2));
        rig.done(Op::SetJustPosition, ALL, &[just]);
        rig.done(Op::SetNearPosition, ALL, &[near]);
        assert_eq!(rig.controller.inpos(F2), just > 5.0);
        assert_eq!(rig.controller.near(F2), near > 5.0);
        rig.done(Op::SetJustPosition, ALL, &[2.0]);
        rig.done(Op::SetNearPosition, ALL, &[10.0]);
    }
}

// clauses: 7.25
#[test]
fn angle_tolerances_take_a_joint_a_leg_or_all() {
    type Flag = fn(&Rig, Target) -> bool;
    let commands: [(Op, Flag); 2] = [
        (Op::SetJustAngle, |rig, target| rig.controller.inpos(target)),
        (Op::SetNearAngle, |rig, target| rig.controller.near(target)),
    ];
    for (op, flag) in commands {
        let mut rig = started();
        rig.done(Op::SetOmegaMax, ALL, &[0.0]);
        rig.done(Op::PtpAngle, F1, &[2.0, 2.0, 92.0]);
        rig.done(Op::PtpAngle, F2, &[2.0, 2.0, 92.0]);
        let joints = |rig: &Rig, leg| [1, 2, 3].map(|joint| flag(rig, Target::Joint(leg, joint)));
        rig.done(op, ALL, &[0.0]);
        assert_eq!(joints(&rig, 1), [false; 3]);
        rig.done(op, F1, &[1.9, 2.1, 3.0]);
        assert_eq!(joints(&rig, 1), [false, true, true]);
        assert_eq!(joints(&rig, 2), [false; 3]);
        rig.done(op, J11, &[2.1]);
        assert_eq!(joints(&rig, 1), [true; 3]);
        rig.done(op, ALL, &[3.0, 1.0, 3.0]);
        assert_eq!(joints(&rig, 1), [true, false, true]);
        assert_eq!(joints(&rig, 2), [true, false, true]);
        rig.done(op, ALL, &[2.1]);
        assert_eq!(joints(&rig, 2), [true; 3]);
    }
}

// clauses: 7.21 7.22 7.25
#[test]
fn negative_values_are_outside_the_domain_and_zero_is_not() {
    let feet = [
        Op::SetAMax,
        Op::SetVMax,
        Op::SetJustPosition,
        Op::SetNearPosition,
    ];
    let joints = [
        Op::SetOmegaMax,
        Op::SetOmegaDotMax,
        Op::SetJustAngle,
        Op::SetNearAngle,
    ];
    for (ops, target) in [(feet, F1), (joints, J21), (feet, ALL), (joints, ALL)] {
        for op in ops {
            let mut rig = started();
            assert_eq!(rig.fault(op, target, &[-1e-9]), Fault::Domain);
            for bad in [f64::NAN, f64::INFINITY] {
                assert_eq!(rig.fault(op, target, &[bad]), Fault::Domain);
            }
            assert_close(v_max(&rig, 1), 300.0);
            rig.done(op, target, &[0.0]);
        }
    }
    for op in [Op::SetJustAngle, Op::SetNearAngle] {
        let mut rig = started();
        assert_eq!(rig.fault(op, F1, &[1.0, 1.0, -1.0]), Fault::Domain);
        rig.done(op, F1, &[1.0, 1.0, 0.0]);
    }
}

// clauses: 7.23
#[test]
fn rates_lie_above_0_and_up_to_100() {
    for (op, target) in [
        (Op::SetVMaxRate, F1),
        (Op::SetAMaxRate, ALL),
        (Op::SetOmegaMaxRate, J11),
        (Op::SetOmegaDotMaxRate, ALL),
    ] {
        let mut rig = started();
        for bad in [0.0, -1.0, 100.1, 200.0] {
            assert_eq!(rig.fault(op, target, &[bad]), Fault::Domain);
        }
        rig.done(op, target, &[1e-3]);
        rig.done(op, target, &[100.0]);
    }
}

// clauses: 7.31
#[test]
fn sampling_time_lies_within_the_robots_range() {
    let mut rig = started();
    for bad in [0.99, 1000.1, 0.0, -20.0] {
        assert_eq!(
            rig.fault(Op::SetSamplingTime, Target::None, &[bad]),
            Fault::Domain
        );
    }
    for bad in [0.999, 1001.0, 0.0, -50.0] {
        assert_eq!(
            rig.fault(Op::SetSamplingFreq, Target::None, &[bad]),
            Fault::Domain
        );
    }
    assert_eq!(rig.controller.period(), 20.0);
    for good in [1.0, 1000.0, 33.3] {
        rig.done(Op::SetSamplingTime, Target::None, &[good]);
        assert_eq!(rig.controller.period(), good);
    }
    for (frequency, time) in [(1.0, 1000.0), (1000.0, 1.0), (62.5, 16.0)] {
        rig.done(Op::SetSamplingFreq, Target::None, &[frequency]);
        assert_eq!(rig.controller.period(), time);
    }
}

// clauses: 7.31
#[test]
fn the_sampling_time_may_change_on_the_way() {
    let mut rig = started();
    rig.done(Op::SetSamplingTime, Target::None, &[10.0]);
    rig.done(Op::PtpAngle, J11, &[45.0]);
    rig.idle(19);
    rig.done(Op::SetSamplingTime, Target::None, &[5.0]);
    // 0.20 s in cycles of 10 ms; 0.75 s in all, so 110 cycles of 5 ms.
    rig.idle(108);
    assert!(rig.commanded()[0][0] < 45.0 - 1e-6);
    rig.idle(1);
    assert!((rig.commanded()[0][0] - 45.0).abs() < 1e-9);
}

// clauses: 7.1 7.21
#[test]
fn targets_that_have_no_such_parameter_are_refused() {
    let mut rig = started();
    for target in [Target::None, Target::Floor, Target::Foot(5), J11] {
        assert_eq!(rig.fault(Op::SetVMax, target, &[1.0]), Fault::Domain);
    }
    for target in [Target::None, Target::Floor, Target::Joint(1, 4)] {
        assert_eq!(rig.fault(Op::SetOmegaMax, target, &[1.0]), Fault::Domain);
    }
    assert_eq!(rig.fault(Op::SetVMax, F1, &[]), Fault::Domain);
    assert_eq!(rig.fault(Op::SetJustAngle, F1, &[1.0, 1.0]), Fault::Domain);
    assert_eq!(rig.fault(Op::SetJustAngle, J11, &[1.0; 3]), Fault::Domain);
    assert_eq!(titan8::MODEL.standards.v_max, v_max(&rig, 1).round());
}
