//! Compliance: springs at joints and at points, their stiffness and limits.

use crate::hand::rig::{F1, Hand, J11, J12, J13, all_close, close, moments, transposed};
use tip_runtime::command::{Command, Op, Poll, Target, Teach, Value};
use tip_runtime::fault::Fault;
use tip_runtime::hardware::JointCommand;

const ALL: Target = Target::All;

// clauses: 7.11 7.26
#[test]
fn a_compliant_joint_is_a_spring() {
    let mut rig = Hand::new();
    rig.done(Op::ComplianceAngle, F1, &[-40.0, 20.0, 60.0]);
    rig.idle(2000);
    all_close(rig.sensors.angles[0], [-40.0, 20.0, 60.0], 1e-6);
    for (stiffness, tolerance) in [(20.0, 1e-6), (50.0, 1e-6)] {
        rig.done(Op::SetAngleStiffness, ALL, &[stiffness]);
        rig.pull[0] = [0.4, 0.6, 0.0];
        rig.idle(3000);
        // τ = k Δθ balances Jᵀ F in the posture that it leads to.
        let load = transposed(&rig.chain(1), rig.pull[0]);
        let rest = [-40.0, 20.0, 60.0];
        let bent = core::array::from_fn(|m| rest[m] + load[m] / stiffness);
        all_close(rig.sensors.angles[0], bent, tolerance);
        assert!(load[0].abs() > 1.0);
    }
    rig.pull[0] = [0.0; 3];
    rig.idle(3000);
    all_close(rig.sensors.angles[0], [-40.0, 20.0, 60.0], 1e-6);
}

// clauses: 7.11 7.28 7.30
#[test]
fn a_joint_spring_gives_way_at_its_limit_until_that_is_reset() {
    let mut rig = Hand::new();
    rig.done(Op::SetAngleStiffness, J11, &[1e6]);
    rig.done(Op::SetComplianceTorqueLimit, J11, &[15.0]);
    rig.done(Op::ComplianceAngle, J11, &[-20.0]);
    assert_eq!(rig.commanded(1)[0], Some(15.0));
    let strength = |rig: &Hand| rig.commanded(1)[0].map(f64::abs);
    rig.done(Op::ResetComplianceTorqueLimit, J11, &[]);
    assert_eq!(strength(&rig), Some(1000.0));
    rig.done(Op::SetComplianceTorqueLimit, F1, &[5.0, 6.0, 7.0]);
    assert_eq!(strength(&rig), Some(5.0));
    rig.done(Op::SetComplianceTorqueLimit, ALL, &[4.0]);
    assert_eq!(strength(&rig), Some(4.0));
    for wrong in [0.0, -1.0] {
        let fault = rig.fault(Op::SetComplianceTorqueLimit, ALL, &[wrong]);
        assert_eq!(fault, Fault::Domain);
    }
    for operands in [&[1.0][..], &[1.0; 2], &[1.0; 4]] {
        let fault = rig.fault(Op::SetComplianceTorqueLimit, F1, operands);
        assert_eq!(fault, Fault::Domain);
    }
    assert_eq!(strength(&rig), Some(4.0));
}

// clauses: 7.28
#[test]
fn a_limit_for_each_joint_of_all_fingers() {
    let mut rig = Hand::new();
    rig.done(Op::SetAngleStiffness, ALL, &[1e6]);
    rig.done(Op::SetComplianceTorqueLimit, ALL, &[5.0, 6.0, 7.0]);
    rig.done(Op::RelComplianceAngle, ALL, &[5.0; 3]);
    for finger in 1..=3 {
        assert_eq!(
            rig.commanded(finger),
            [5.0, 6.0, 7.0].map(Some),
            "F{finger}"
        );
    }
    for operands in [&[1.0; 2][..], &[1.0; 4], &[1.0, 0.0, 1.0]] {
        let fault = rig.fault(Op::SetComplianceTorqueLimit, ALL, operands);
        assert_eq!(fault, Fault::Domain);
    }
}

/// Returns the commands of F1 in the cycle in which a spring is set, with HS and without.
fn first_pulls(op: Op, target: Target, goal: &[f64]) -> [[Option<f64>; 3]; 2] {
    [true, false].map(|hs| {
        let mut rig = Hand::new();
        rig.idle(1);
        let values: Vec<Value> = goal.iter().copied().map(Value::Absolute).collect();
        let values = &values;
        let command = Command {
            op,
            hs,
            target,
            values,
        };
        assert_eq!(rig.controller.command(&command), Ok(Poll::Done));
        rig.controller.advance();
        rig.commanded(1)
    })
}

// clauses: 7.11 7.12
#[test]
fn under_hs_a_set_point_is_at_full_speed_at_once() {
    // In the 2 ms of a cycle it goes 90 deg/s · t, else 360 deg/s² · t² / 2, and strains 20 mN·m/deg.
    let turns = [(Op::ComplianceAngle, -10.0), (Op::RelComplianceAngle, 30.0)];
    for (op, goal) in turns {
        let [fast, slow] = first_pulls(op, J11, &[goal]);
        close(fast[0].expect("a torque"), 20.0 * 0.18, 1e-9);
        close(slow[0].expect("a torque"), 20.0 * 0.00072, 1e-9);
    }
    // It goes 100 mm/s · t, else 400 mm/s² · t² / 2, and strains 0.1 N/mm.
    let hand = Hand::new();
    let [x, y, _] = hand.tip(1);
    let moves = [
        (Op::CompliancePosition, [x + 30.0, y, 0.0]),
        (Op::RelCompliancePosition, [30.0, 0.0, 0.0]),
    ];
    for (op, goal) in moves {
        let pulls = first_pulls(op, F1, &goal);
        for (commanded, way) in pulls.iter().zip([0.2, 0.0008]) {
            let expected = transposed(&hand.chain(1), [0.1 * way, 0.0, 0.0]);
            all_close(
                commanded.map(|torque| torque.expect("a torque")),
                expected,
                1e-9,
            );
        }
    }
}

// clauses: 7.12 7.27
#[test]
fn a_compliant_fingertip_is_a_spring() {
    let mut rig = Hand::new();
    let [x, y, _] = rig.tip(1);
    let (x, y) = (x + 20.0, y + 10.0);
    rig.done(Op::CompliancePosition, F1, &[x, y, 55.0]);
    rig.idle(5000);
    all_close(rig.teach(Teach::Position, F1), [x, y, 0.0], 1e-4);
    // 0.1 N/mm: 0.5 N deflect it by 5 mm.
    rig.pull[0] = [0.5, -0.2, 0.0];
    rig.idle(5000);
    all_close(
        rig.teach(Teach::Position, F1),
        [x + 5.0, y - 2.0, 0.0],
        1e-4,
    );
    rig.done(Op::SetPositionStiffness, F1, &[0.2, 0.05, -1.0]);
    rig.idle(5000);
    all_close(
        rig.teach(Teach::Position, F1),
        [x + 2.5, y - 4.0, 0.0],
        1e-4,
    );
    assert_eq!(
        rig.fault(Op::SetPositionStiffness, F1, &[0.1, -0.1, 0.0]),
        Fault::Domain
    );
}

// clauses: 7.12 7.29 7.30
#[test]
fn a_fingertip_spring_gives_way_at_its_limit_until_that_is_reset() {
    let mut rig = Hand::new();
    let [x, y, _] = rig.tip(1);
    rig.done(Op::CompliancePosition, F1, &[x, y, 0.0]);
    rig.done(Op::SetComplianceForceLimit, F1, &[0.2, 0.3, 0.0]);
    rig.pull[0] = [-0.25, 0.0, 0.0];
    rig.idle(200);
    // More than the limit: it is drawn away without end.
    let away = rig.tip(1)[0];
    assert!(away < x - 2.5);
    rig.idle(20);
    assert!(rig.tip(1)[0] < away);
    rig.done(Op::ResetComplianceForceLimit, F1, &[]);
    rig.idle(5000);
    all_close(rig.teach(Teach::Position, F1), [x - 2.5, y, 0.0], 1e-4);
    // A limit of the third joint is another one.
    rig.done(Op::SetComplianceForceLimit, J13, &[0.01, 0.01, 0.01]);
    rig.idle(1000);
    all_close(rig.teach(Teach::Position, F1), [x - 2.5, y, 0.0], 1e-4);
    for wrong in [[0.0, 1.0, 1.0], [1.0, -1.0, 1.0]] {
        let fault = rig.fault(Op::SetComplianceForceLimit, F1, &wrong);
        assert_eq!(fault, Fault::Domain);
    }
    let fault = rig.fault(Op::SetComplianceForceLimit, J12, &[1.0; 3]);
    assert_eq!(fault, Fault::Domain);
}

/// Returns the commands of F1's first two joints as soon as a spring draws a point 20 mm along x,
/// 30 along y.
fn pulled(rig: &Hand, target: Target, [x, y, _]: [f64; 3]) -> [f64; 2] {
    let mut controller = rig.controller.clone();
    controller.sense(&rig.sensors).expect("good sensors");
    let command = Command {
        op: Op::CompliancePosition,
        hs: true,
        target,
        values: &[x + 20.0, y + 30.0, 0.0].map(Value::Absolute),
    };
    assert_eq!(controller.command(&command), Ok(Poll::Done));
    controller.advance();
    let [first, second, _] = controller.outputs()[0].map(JointCommand::value);
    [first, second]
}

// clauses: 7.12 7.29 7.30
#[test]
fn a_force_limit_is_that_of_a_fingertip_of_a_third_joint_or_of_all() {
    // 0.1 N/mm, and the limit.
    let (free, bound) = ([2.0, 3.0], [0.2, 0.3]);
    for (limited, at_tip, at_third) in [(F1, bound, free), (J13, free, bound), (ALL, bound, bound)]
    {
        let mut rig = Hand::new();
        rig.done(Op::SetVMax, F1, &[1e6]);
        let chain = rig.chain(1);
        let (tip, third) = (chain.foot(), chain.joint(2).expect("J13"));
        let check = |rig: &Hand, at_tip: [f64; 2], at_third: [f64; 2]| {
            for (target, place, force) in [(F1, tip, at_tip), (J13, third, at_third)] {
                let commanded = pulled(rig, target, place);
                for (commanded, expected) in commanded.iter().zip(moments(&chain, place, force)) {
                    close(*commanded, expected, 1e-9);
                }
            }
        };
        rig.done(Op::SetComplianceForceLimit, limited, &[0.2, 0.3, 0.0]);
        check(&rig, at_tip, at_third);
        rig.done(Op::ResetComplianceForceLimit, limited, &[]);
        check(&rig, free, free);
    }
}

// clauses: 2.25 7.12
#[test]
fn the_third_joint_can_hang_on_a_spring_too() {
    let mut rig = Hand::new();
    rig.done(Op::PtpAngle, J12, &[40.0]);
    rig.idle(1000);
    let [x, y, _] = rig.teach(Teach::Position, J13);
    rig.done(Op::CompliancePosition, J13, &[x + 10.0, y + 15.0, 0.0]);
    assert_eq!(rig.commanded(1)[2], None);
    rig.idle(5000);
    all_close(
        rig.teach(Teach::Position, J13),
        [x + 10.0, y + 15.0, 0.0],
        1e-3,
    );
    close(rig.sensors.angles[0][2], 80.0, 1e-9);
}

// clauses: 7.1 7.11 7.12
#[test]
fn relative_operands_count_from_the_measured_and_rel_forms_from_the_target() {
    let mut rig = Hand::new();
    rig.done(Op::ComplianceAngle, J12, &[20.0]);
    rig.idle(2000);
    rig.pull[0] = [0.3, 0.3, 0.0];
    rig.idle(2000);
    let bent = rig.sensors.angles[0][1];
    assert!((bent - 20.0).abs() > 0.5);
    let mut other = Hand::new();
    other.done(Op::ComplianceAngle, ALL, &[-40.0, 10.0, 80.0]);
    other.done(Op::RelComplianceAngle, ALL, &[0.0, 5.0, 0.0]);
    other.idle(2000);
    close(other.sensors.angles[2][1], 15.0, 1e-6);
    rig.relative(Op::ComplianceAngle, J12, &[0.0]);
    rig.pull[0] = [0.0; 3];
    rig.idle(2000);
    close(rig.sensors.angles[0][1], bent, 1e-6);
    let mut rig = Hand::new();
    let tips = [1, 2, 3].map(|n| rig.tip(n));
    rig.relative(Op::CompliancePosition, ALL, &[4.0, 0.0, 0.0]);
    rig.done(Op::RelCompliancePosition, ALL, &[0.0, 3.0, 0.0]);
    rig.idle(5000);
    for (n, [x, y, _]) in (1..).zip(tips) {
        let tip = rig.teach(Teach::Position, Target::Foot(n));
        all_close(tip, [x + 4.0, y + 3.0, 0.0], 1e-3);
    }
}

// clauses: 7.12
#[test]
fn marks_of_a_rel_form_say_what_counts_from_the_target() {
    let mut rig = Hand::new();
    let [x, y, _] = rig.tip(1);
    rig.done(Op::CompliancePosition, F1, &[x + 2.0, y + 2.0, 0.0]);
    // From the target, which the fingertip has not reached.
    let marks = [
        Value::Relative(3.0),
        Value::Fixed(y - 4.0),
        Value::Absolute(0.0),
    ];
    let commanded = rig.command(Op::RelCompliancePosition, F1, &marks);
    assert_eq!(commanded, Ok(Poll::Done));
    rig.idle(5000);
    let tip = rig.teach(Teach::Position, F1);
    all_close(tip, [x + 5.0, y - 4.0, 0.0], 1e-3);
}

// clauses: 5.1 7.13 7.15
#[test]
fn compliance_counts_as_position_and_angle_control() {
    let mut rig = Hand::new();
    rig.done(Op::ComplianceAngle, J11, &[-20.0]);
    assert!(!rig.controller.inpos(J11) && !rig.controller.near(J11));
    rig.cycles(Op::WaitInpos, F1, &[]).expect("it arrives");
    assert!(rig.controller.near(F1));
    let [x, y, _] = rig.tip(2);
    let second = Target::Foot(2);
    rig.done(Op::CompliancePosition, second, &[x - 20.0, y, 0.0]);
    assert!(!rig.controller.near(second));
    rig.cycles(Op::WaitNear, second, &[]).expect("it arrives");
    rig.done(Op::NoCompliance, second, &[]);
    assert_eq!(rig.commanded(2), [None; 3]);
    assert!(rig.controller.inpos(second) && rig.controller.near(second));
    let held = rig.sensors.angles[1];
    rig.idle(100);
    all_close(rig.sensors.angles[1], held, 1e-12);
    assert_eq!(rig.fault(Op::NoCompliance, ALL, &[]), Fault::Domain);
}

// clauses: 2.24 7.2 7.13
#[test]
fn a_strained_spring_does_not_jump_when_it_becomes_stiff() {
    let mut rig = Hand::new();
    let [x, y, _] = rig.tip(1);
    rig.done(Op::CompliancePosition, F1, &[x, y, 0.0]);
    rig.pull[0] = [0.5, 0.0, 0.0];
    rig.idle(3000);
    let bent = rig.tip(1);
    rig.done(Op::Ptp, F1, &[x, y, 0.0]);
    assert!((rig.tip(1)[0] - bent[0]).abs() < 0.01);
    rig.idle(2000);
    all_close(rig.teach(Teach::Position, F1), [x, y, 0.0], 1e-6);
}

// clauses: 7.12
#[test]
fn a_strained_spring_stays_strained_under_another_target() {
    let mut rig = Hand::new();
    let start = rig.sensors;
    let [x, y, _] = rig.tip(1);
    let there = [x + 10.0, y, 0.0];
    rig.done(Op::CompliancePosition, F1, &there);
    // Held back, the finger stays while the set point goes all the way.
    for _ in 0..300 {
        rig.sensors = start;
        rig.idle(1);
    }
    for (op, goal) in [
        (Op::CompliancePosition, there),
        (Op::RelCompliancePosition, [0.0; 3]),
    ] {
        rig.sensors = start;
        rig.done(op, F1, &goal);
        // 0.1 N/mm.
        let pull = transposed(&Hand::new().chain(1), [1.0, 0.0, 0.0]);
        all_close(rig.commanded(1).map(Option::unwrap_or_default), pull, 1e-9);
    }
}

// clauses: 7.13
#[test]
fn no_compliance_leaves_positions_alone() {
    let mut rig = Hand::new();
    let [x, y, _] = rig.tip(1);
    rig.done(Op::Ptp, F1, &[x + 10.0, y, 0.0]);
    rig.done(Op::NoCompliance, F1, &[]);
    rig.idle(300);
    all_close(rig.teach(Teach::Position, F1), [x + 10.0, y, 0.0], 1e-6);
    for target in [Target::Joint(1, 4), Target::Joint(1, 0), ALL] {
        assert_eq!(rig.fault(Op::NoCompliance, target, &[]), Fault::Domain);
    }
    // The third joint's position, with a torque in that joint.
    let mut rig = Hand::new();
    let [x, y, _] = rig.teach(Teach::Position, J13);
    rig.done(Op::Torque, J13, &[5.0]);
    rig.done(Op::Ptp, J13, &[x + 10.0, y + 10.0, 0.0]);
    assert_eq!(rig.commanded(1), [None, None, Some(5.0)]);
    rig.done(Op::NoCompliance, J13, &[]);
    assert_eq!(rig.commanded(1), [None; 3]);
    rig.idle(300);
    let place = rig.teach(Teach::Position, J13);
    all_close(place, [x + 10.0, y + 10.0, 0.0], 1e-6);
}

// clauses: 7.13
#[test]
fn no_compliance_holds_what_a_spring_at_the_third_joint_pulled() {
    let mut rig = Hand::new();
    let [x, y, _] = rig.teach(Teach::Position, J13);
    rig.done(Op::CompliancePosition, J13, &[x + 10.0, y + 10.0, 0.0]);
    rig.idle(100);
    let held = rig.sensors.angles[0];
    rig.done(Op::NoCompliance, F1, &[]);
    assert_eq!(rig.commanded(1), [None; 3]);
    rig.idle(100);
    all_close(rig.sensors.angles[0], held, 1e-12);
}
