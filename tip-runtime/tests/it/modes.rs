//! The control mode that each command sets, joint by joint.

use crate::rig::{Rig, distance};
use tip_runtime::command::{Command, Op, Poll, Target, Value};
use tip_runtime::fault::Fault;
use tip_runtime::model::{Model, generic, titan8};

const F1: Target = Target::Foot(1);
const J11: Target = Target::Joint(1, 1);
const J12: Target = Target::Joint(1, 2);
const J13: Target = Target::Joint(1, 3);

/// Returns true if a target is under position or angle control: WAIT_NEAR refuses it otherwise.
fn is_controlled(rig: &Rig, target: Target) -> bool {
    let command = Command {
        op: Op::WaitNear,
        hs: false,
        target,
        values: &[],
    };
    match rig.controller.clone().command(&command) {
        Ok(_) => true,
        Err(fault) => {
            assert_eq!(fault, Fault::InvalidMode);
            false
        }
    }
}

fn controlled(rig: &Rig) -> [bool; 3] {
    [J11, J12, J13].map(|joint| is_controlled(rig, joint))
}

// clauses: 2.19 2.25
#[test]
fn nothing_is_controlled_at_the_start_and_the_servos_hold() {
    let mut rig = Rig::titan();
    rig.idle(10);
    assert_eq!(controlled(&rig), [false; 3]);
    assert_eq!(rig.commanded(), [[0.0, 0.0, 90.0]; 4]);
    assert_eq!(rig.controller.period(), 20.0);
}

// clauses: 2.25 7.2 7.3
#[test]
fn a_foot_command_takes_all_joints_of_its_leg_only() {
    let mut rig = Rig::titan();
    rig.done(Op::PtpAngle, J11, &[5.0]);
    rig.done(Op::Ptp, F1, &[-391.0, 201.0, -190.0]);
    assert_eq!(controlled(&rig), [true; 3]);
    assert!(!is_controlled(&rig, Target::Foot(2)));
    rig.idle(100);
    assert!(distance(rig.foot(1), [-391.0, 201.0, -190.0]) < 1e-9);
}

// clauses: 2.25 7.7
#[test]
fn velocity_control_is_no_position_control() {
    let mut rig = Rig::titan();
    rig.done(Op::Ptp, F1, &[-391.0, 201.0, -190.0]);
    rig.done(Op::VelControl, F1, &[0.0, 0.0, 10.0]);
    assert_eq!(controlled(&rig), [false; 3]);
}

// clauses: 2.25 7.4
#[test]
fn a_joint_command_takes_its_joint_only() {
    let mut rig = Rig::titan();
    rig.done(Op::PtpAngle, J12, &[5.0]);
    assert_eq!(controlled(&rig), [false, true, false]);
    rig.done(Op::OmegaControl, J11, &[5.0]);
    assert_eq!(controlled(&rig), [false, true, false]);
    rig.done(Op::PtpAngle, F1, &[1.0, 2.0, 91.0]);
    assert_eq!(controlled(&rig), [true; 3]);
    rig.done(Op::OmegaControl, J12, &[1.0]);
    assert_eq!(controlled(&rig), [true, false, true]);
}

// clauses: 2.25 7.4 7.8
#[test]
fn a_joint_command_leaves_the_others_of_a_foot_mode_at_their_measured_angles() {
    for foot_mode in [Op::Ptp, Op::VelControl] {
        for joint_mode in [Op::PtpAngle, Op::OmegaControl] {
            let mut rig = Rig::titan();
            match foot_mode {
                Op::Ptp => rig.done(Op::Ptp, F1, &[-391.0, 201.0, -200.0]),
                _ => rig.done(Op::VelControl, F1, &[0.0, 0.0, 0.0]),
            }
            // The knee is measured away from its command.
            rig.stuck[0][2] = true;
            rig.sensors.angles[0][2] = 92.0;
            rig.done(joint_mode, J11, &[5.0]);
            assert_eq!(controlled(&rig), [joint_mode == Op::PtpAngle, true, true]);
            rig.idle(100);
            let [_, thigh, knee] = rig.commanded()[0];
            assert!(thigh.abs() < 1e-9 && (knee - 92.0).abs() < 1e-9);
        }
    }
}

// clauses: 2.24 2.25
#[test]
fn changing_between_foot_and_joints_keeps_the_velocity() {
    let mut rig = Rig::titan();
    rig.done(Op::SetSamplingTime, Target::None, &[1.0]);
    let commands: [(Op, Target, &[f64]); 6] = [
        (Op::Ptp, F1, &[-391.0, 281.0, -160.0]),
        (Op::OmegaControl, J12, &[10.0]),
        (Op::VelControl, F1, &[0.0, 20.0, 10.0]),
        (Op::PtpAngle, J11, &[10.0]),
        (Op::Ptp, F1, &[-391.0, 181.0, -180.0]),
        (Op::PtpAngle, J13, &[80.0]),
    ];
    let (mut previous, mut velocity) = (rig.foot(1), [0.0; 3]);
    for round in 0..8 {
        for (op, target, values) in commands {
            for cycle in 0..60 {
                if cycle == 0 {
                    rig.done(op, target, values);
                } else {
                    rig.idle(1);
                }
                let foot = rig.foot(1);
                let now = [0, 1, 2].map(|i| (foot[i] - previous[i]) / 0.001);
                // In 1 ms a foot gains 0.6 mm/s; three joints at 360 deg/s² give a leg of at
                // most 490 mm no more than 9.3 mm/s.
                let jump = distance(now, velocity);
                assert!(jump < 9.3, "{round}, {}: {jump}", op.name());
                (previous, velocity) = (foot, now);
            }
        }
    }
}

// clauses: 7.1 7.2
#[test]
fn relative_positions_count_from_the_measured_one() {
    let mut rig = Rig::titan();
    rig.done(Op::Ptp, F1, &[-391.0, 201.0, -150.0]);
    let values = [
        Value::Relative(0.0),
        Value::Relative(10.0),
        Value::Absolute(-190.0),
    ];
    assert_eq!(rig.run(Op::Ptp, F1, &values), Ok(Poll::Done));
    rig.idle(200);
    // One cycle after the start the foot stands where it was, except for ½ a t² = 0.12 mm along z.
    assert!(distance(rig.foot(1), [-391.0, 211.0, -190.0]) < 1e-9);
}

// clauses: 7.3
#[test]
fn rel_ptp_counts_from_the_target() {
    let mut rig = Rig::titan();
    rig.done(Op::Ptp, F1, &[-391.0, 201.0, -180.0]);
    rig.done(Op::RelPtp, F1, &[0.0, 10.0, -5.0]);
    rig.done(Op::RelPtp, F1, &[0.0, 10.0, -5.0]);
    rig.idle(200);
    assert!(distance(rig.foot(1), [-391.0, 221.0, -190.0]) < 1e-9);
}

// clauses: 7.3
#[test]
fn rel_ptp_counts_from_the_measured_position_if_there_is_no_target() {
    let mut rig = Rig::titan();
    rig.done(Op::RelPtp, F1, &[0.0, 10.0, 20.0]);
    rig.idle(200);
    assert!(distance(rig.foot(1), [-391.0, 211.0, -180.0]) < 1e-9);
}

// clauses: 7.4
#[test]
fn angles_count_from_where_their_command_says() {
    let mut rig = Rig::titan();
    rig.done(Op::PtpAngle, J11, &[20.0]);
    rig.done(Op::RelPtpAngle, J11, &[5.0]);
    let relative = [Value::Relative(7.0)];
    assert_eq!(rig.run(Op::PtpAngle, J12, &relative), Ok(Poll::Done));
    rig.done(Op::RelPtpAngle, J13, &[-3.0]);
    rig.idle(200);
    let [yaw, thigh, knee] = rig.commanded()[0];
    assert!((yaw - 25.0).abs() < 1e-9 && (thigh - 7.0).abs() < 1e-9);
    assert!((knee - 87.0).abs() < 1e-9);
    // From a foot mode there is no angle target: the measured angle counts.
    let mut rig = Rig::titan();
    rig.done(Op::Ptp, F1, &[-391.0, 201.0, -150.0]);
    rig.done(Op::RelPtpAngle, J13, &[-3.0]);
    rig.idle(200);
    assert!((rig.commanded()[0][2] - 87.0).abs() < 0.5);
}

// clauses: 7.7
#[test]
fn relative_velocities_count_from_the_command_else_from_the_measured_one() {
    let mut rig = Rig::titan();
    rig.done(Op::VelControl, F1, &[0.0, 0.0, 20.0]);
    let more = [0.0, 0.0, 30.0].map(Value::Relative);
    assert_eq!(rig.run(Op::VelControl, F1, &more), Ok(Poll::Done));
    let before = rig.foot(1);
    rig.idle(50);
    // 12 mm/s when it began, 50 mm/s soon after: between 45 and 50 mm in a second.
    let way = rig.foot(1)[2] - before[2];
    assert!(way > 45.0 && way < 50.0, "{way}");

    // A position-controlled foot at 300 mm/s has no velocity command; R 0 keeps what is measured.
    let mut rig = Rig::titan();
    rig.done_hs(Op::Ptp, F1, &[-391.0, 301.0, -200.0]);
    rig.idle(5);
    let keep = [0.0; 3].map(Value::Relative);
    assert_eq!(rig.run(Op::VelControl, F1, &keep), Ok(Poll::Done));
    let before = rig.foot(1);
    rig.idle(5);
    assert!((distance(rig.foot(1), before) - 30.0).abs() < 0.2);
}

// clauses: 7.8
#[test]
fn relative_rates_count_from_the_command_else_from_the_measured_one() {
    let mut rig = Rig::titan();
    rig.done(Op::OmegaControl, J11, &[10.0]);
    let more = [Value::Relative(5.0)];
    assert_eq!(rig.run(Op::OmegaControl, J11, &more), Ok(Poll::Done));
    rig.idle(20);
    let before = rig.commanded()[0][0];
    rig.idle(50);
    assert!((rig.commanded()[0][0] - before - 15.0).abs() < 1e-9);

    let mut rig = Rig::titan();
    rig.done_hs(Op::PtpAngle, J11, &[50.0]);
    rig.idle(5);
    let keep = [Value::Relative(0.0)];
    assert_eq!(rig.run(Op::OmegaControl, J11, &keep), Ok(Poll::Done));
    let before = rig.commanded()[0][0];
    rig.idle(5);
    assert!((rig.commanded()[0][0] - before - 9.0).abs() < 1e-9);
}

/// A joint whose angle is measured in each third cycle has the rate of a joint that is measured in each.
// clauses: 7.8
#[test]
fn the_measured_rate_is_that_of_the_time_between_measurements() {
    for cycles in 6..12 {
        let mut rig = Rig::titan();
        rig.done_hs(Op::PtpAngle, J11, &[50.0]);
        for cycle in 1..=cycles {
            let age = cycle % 3;
            rig.sensors.ages[0][0] = age;
            rig.stuck[0][0] = age > 0;
            rig.idle(1);
        }
        let keep = [Value::Relative(0.0)];
        assert_eq!(rig.run(Op::OmegaControl, J11, &keep), Ok(Poll::Done));
        let before = rig.commanded()[0][0];
        rig.idle(5);
        let turned = rig.commanded()[0][0] - before;
        assert!((turned - 9.0).abs() < 1e-9, "{cycles}: {turned}");
    }
}

// clauses: 7.7 7.8
#[test]
fn velocities_are_reached_under_the_acceleration_limit() {
    let mut rig = Rig::titan();
    rig.done(Op::VelControl, F1, &[0.0, 60.0, 0.0]);
    // ½ · 600 mm/s² · (20 ms)².
    assert!((rig.foot(1)[1] - 201.12).abs() < 1e-9);
    rig.done(Op::OmegaControl, Target::Joint(2, 1), &[36.0]);
    // ½ · 360 deg/s² · (20 ms)².
    assert!((rig.commanded()[1][0] - 0.072).abs() < 1e-9);
}

// clauses: 7.1 7.9 7.11 7.26
#[test]
fn a_robot_without_torques_has_no_commands_of_force() {
    let mut rig = Rig::titan();
    for op in [Op::Torque, Op::ComplianceAngle, Op::SetTorqueMax] {
        assert_eq!(rig.fault(op, J11, &[1.0]), Fault::Domain);
        rig.done(Op::Ptp, F1, &[-391.0, 201.0, -190.0]);
        Rig::generic().done(op, J11, &[1.0]);
    }
}

// clauses: 7.44
#[test]
fn nobody_stands_up_on_legs_that_give_force() {
    const STRONG: Model<4, 3> = Model {
        forces: generic::MODEL.forces,
        ..titan8::MODEL
    };
    let pushes: [(Op, &[f64]); 2] = [(Op::Torque, &[1.0]), (Op::Force, &[1.0, 0.0, 0.0])];
    for (op, values) in pushes {
        let mut rig = Rig::new(&STRONG);
        rig.done(op, J13, values);
        assert_eq!(
            rig.fault(Op::StandUp, Target::None, &[10.0]),
            Fault::InvalidMode
        );
        rig.done(Op::NoCompliance, J13, &[]);
        rig.cycles(Op::StandUp, Target::None, &[10.0]);
    }
}

// clauses: 7.44 7.45 7.46
#[test]
fn a_generic_robot_neither_stands_up_nor_searches() {
    let mut rig = Rig::generic();
    for (op, target) in [
        (Op::StandUp, Target::None),
        (Op::SitDown, Target::None),
        (Op::DetectFloor, F1),
        (Op::DetectObject, Target::None),
    ] {
        assert_eq!(rig.fault(op, target, &[1.0]), Fault::Domain, "{op:?}");
    }
}

// clauses: 7.1
#[test]
fn targets_that_do_not_exist_are_refused() {
    let mut rig = Rig::titan();
    let position = [-391.0, 201.0, -190.0];
    for target in [
        Target::None,
        Target::All,
        Target::Floor,
        Target::Foot(0),
        Target::Foot(5),
        J11,
    ] {
        assert_eq!(rig.fault(Op::Ptp, target, &position), Fault::Domain);
        assert_eq!(rig.fault(Op::VelControl, target, &[0.0; 3]), Fault::Domain);
    }
    for target in [
        Target::All,
        Target::Joint(0, 1),
        Target::Joint(1, 0),
        Target::Joint(1, 4),
        Target::Joint(5, 1),
    ] {
        assert_eq!(rig.fault(Op::PtpAngle, target, &[0.0]), Fault::Domain);
        assert_eq!(rig.fault(Op::OmegaControl, target, &[0.0]), Fault::Domain);
    }
    assert_eq!(rig.fault(Op::Ptp, F1, &[0.0]), Fault::Domain);
    assert_eq!(rig.fault(Op::PtpAngle, F1, &[0.0]), Fault::Domain);
}

// clauses: 7.7 7.8 7.21 7.22
#[test]
fn velocities_are_bound_by_the_acceleration_not_by_the_speed_of_moves() {
    let mut rig = Rig::titan();
    rig.done(Op::SetVMax, Target::All, &[1.0]);
    rig.done(Op::SetOmegaMax, Target::All, &[1.0]);
    rig.done(Op::VelControl, F1, &[0.0, 0.0, 60.0]);
    rig.done(Op::OmegaControl, Target::Joint(2, 1), &[18.0]);
    rig.idle(10);
    let (foot, joint) = (rig.foot(1)[2], rig.commanded()[1][0]);
    rig.idle(1);
    assert!((rig.foot(1)[2] - foot - 1.2).abs() < 1e-9);
    assert!((rig.commanded()[1][0] - joint - 0.36).abs() < 1e-9);
    // Without acceleration there is no motion.
    let mut rig = Rig::titan();
    rig.done(Op::SetAMax, Target::All, &[0.0]);
    rig.done(Op::SetOmegaDotMax, Target::All, &[0.0]);
    rig.done(Op::VelControl, F1, &[0.0, 0.0, 60.0]);
    rig.done(Op::OmegaControl, Target::Joint(2, 1), &[18.0]);
    rig.idle(10);
    assert_eq!(rig.commanded(), [[0.0, 0.0, 90.0]; 4]);
}
