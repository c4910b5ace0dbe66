//! INITIAL_POSTURE brings back every joint, not only the fingertip.

use crate::hand::rig::{F1, Hand, all_close};
use tip_runtime::command::{Op, Target};
use tip_runtime::model::hand;

const ALL: Target = Target::All;
const NONE: Target = Target::None;

/// One second, in cycles of 2 ms.
const SECOND: usize = 500;

/// Runs INITIAL_POSTURE from a posture of F1; returns the distance of each joint from its initial
/// angle one second after INPOS.
fn left_from(start: [f64; 3]) -> f64 {
    let mut rig = Hand::new();
    rig.sensors.angles[0] = start;
    rig.controller
        .sense(&rig.sensors)
        .expect("within the limits");
    rig.controller.emergency();
    assert_eq!(rig.cycles(Op::InitialPosture, NONE, &[]), Some(1));
    rig.cycles(Op::WaitInpos, ALL, &[]).expect("it arrives");
    rig.idle(SECOND);
    let joints = rig.sensors.angles[0].into_iter();
    let gaps = joints
        .zip(hand::MODEL.legs[0].initial)
        .map(|(angle, initial)| (angle - initial).abs());
    gaps.fold(0.0, f64::max)
}

// clauses: 7.6
#[test]
fn every_joint_returns_to_its_initial_angle() {
    let starts = [
        [0.0, 0.0, 0.0],
        [-40.0, 0.0, 60.0],
        [10.0, 30.0, 40.0],
        [-60.0, 60.0, 20.0],
        [30.0, 80.0, 100.0],
        [-80.0, 100.0, 100.0],
        [-20.0, -10.0, 90.0],
        [-70.0, 5.0, -5.0],
    ];
    for start in starts {
        let left = left_from(start);
        assert!(left <= 1.0, "{start:?} {left}");
    }
}

// clauses: 5.1 7.6
#[test]
fn a_fingertip_that_is_there_already_stays_while_its_joints_return() {
    // The triangle of base, joint 3 and tip with joint 2 bent by 40 deg.
    let mut rig = Hand::new();
    let tip = rig.tip(1);
    let there = tip_runtime::kinematics::resolve(
        &hand::MODEL.legs[0],
        &[-55.0, 40.0, 45.0],
        tip_runtime::kinematics::LegPoint::Tip,
        tip,
        [true, true, false],
    );
    let there = there.expect("it reaches its own place");
    assert!(there[1] > 20.0);
    rig.sensors.angles[0] = there;
    rig.controller
        .sense(&rig.sensors)
        .expect("within the limits");
    rig.controller.emergency();
    rig.cycles(Op::InitialPosture, NONE, &[]);
    assert!(rig.controller.inpos(F1), "the fingertip decides");
    let mut before = rig.sensors.angles[0];
    for _ in 0..SECOND {
        rig.idle(1);
        all_close(rig.tip(1), tip, 1e-5);
        // No joint leaps: 40 deg in 0.8 s are at most 100 deg/s, and joint 1 and 3 follow.
        all_close(rig.sensors.angles[0], before, 0.4);
        before = rig.sensors.angles[0];
    }
    all_close(rig.sensors.angles[0], [-40.0, 0.0, 80.0], 1.0);
}
