//! TORQUE, its limits, and the commands that end it.

use crate::hand::rig::{F1, Hand, J11, J12, J13, close};
use tip_runtime::command::{Op, Target, Teach};
use tip_runtime::fault::Fault;

const ALL: Target = Target::All;

// clauses: 7.9
#[test]
fn joints_are_told_torques() {
    let mut rig = Hand::new();
    rig.done(Op::Torque, F1, &[10.0, 20.0, -30.0]);
    assert_eq!(rig.commanded(1), [Some(10.0), Some(20.0), Some(-30.0)]);
    assert_eq!(rig.commanded(2), [None; 3]);
    rig.relative(Op::Torque, J12, &[-5.0]);
    assert_eq!(rig.commanded(1), [Some(10.0), Some(15.0), Some(-30.0)]);
    rig.done(Op::PtpAngle, J13, &[80.0]);
    assert_eq!(rig.commanded(1), [Some(10.0), Some(15.0), None]);
    // Where no torque was commanded, R counts from the one that is sensed.
    rig.sensors.torques[1][0] = 7.0;
    rig.relative(Op::Torque, Target::Joint(2, 1), &[1.0]);
    assert_eq!(rig.commanded(2)[0], Some(8.0));
    assert_eq!(rig.fault(Op::Torque, ALL, &[1.0; 3]), Fault::Domain);
}

// clauses: 7.9 7.18
#[test]
fn a_torque_drives_a_joint_and_is_sensed() {
    let mut rig = Hand::new();
    let before = rig.sensors.angles[0][0];
    rig.done(Op::Torque, J11, &[20.0]);
    rig.idle(50);
    assert!(rig.sensors.angles[0][0] > before + 1.0);
    assert_eq!(rig.teach(Teach::Torque, F1)[0], 20.0);
    assert_eq!(rig.teach(Teach::Torque, J11)[0], 20.0);
    // Other joints stay.
    assert_eq!(rig.sensors.angles[0][1], 0.0);
}

// clauses: 7.23 7.24 7.26
#[test]
fn no_joint_is_told_more_than_its_torque_max() {
    let mut rig = Hand::new();
    // At once, so that no joint gets to its limit.
    rig.done(Op::SetSamplingTime, Target::None, &[1.0]);
    let commanded = |rig: &mut Hand, torque: f64| {
        rig.done(Op::Torque, J11, &[torque]);
        rig.commanded(1)[0]
    };
    rig.done(Op::SetTorqueMax, J11, &[40.0]);
    assert_eq!(commanded(&mut rig, 50.0), Some(40.0));
    assert_eq!(commanded(&mut rig, -50.0), Some(-40.0));
    rig.done(Op::SetTorqueMaxSoft, ALL, &[]);
    assert_eq!(commanded(&mut rig, -700.0), Some(-500.0));
    rig.done(Op::SetTorqueMaxFirmly, J11, &[]);
    assert_eq!(commanded(&mut rig, 9000.0), Some(1500.0));
    rig.done(Op::SetTorqueMaxNormal, ALL, &[]);
    assert_eq!(commanded(&mut rig, -9000.0), Some(-1000.0));
    rig.done(Op::SetTorqueMaxRate, J11, &[3.0]);
    assert_eq!(commanded(&mut rig, 31.0), Some(30.0));
    assert_eq!(rig.fault(Op::SetTorqueMax, J11, &[-1.0]), Fault::Domain);
    assert_eq!(
        rig.fault(Op::SetTorqueMaxRate, J11, &[100.1]),
        Fault::Domain
    );
}

// clauses: 7.5 2.24
#[test]
fn all_stop_holds_by_angle_and_the_torque_comes_back() {
    let mut rig = Hand::new();
    rig.done(Op::Torque, J11, &[20.0]);
    rig.idle(20);
    rig.done(Op::AllStop, Target::None, &[]);
    assert_eq!(rig.commanded(1), [None; 3]);
    let held = rig.sensors.angles[0][0];
    rig.idle(50);
    close(rig.sensors.angles[0][0], held, 1e-12);
    rig.done(Op::AllStopRelease, Target::None, &[]);
    assert_eq!(rig.commanded(1)[0], Some(20.0));
    rig.controller.finish();
    rig.idle(2);
    assert_eq!(rig.commanded(1), [None; 3]);
}

// clauses: 5.1 7.13 7.16
#[test]
fn a_torque_is_no_angle_control_until_it_ends() {
    let mut rig = Hand::new();
    rig.done(Op::Torque, J11, &[20.0]);
    assert!(rig.controller.inpos(J11) && !rig.controller.near(J11));
    assert_eq!(rig.fault(Op::WaitNear, J11, &[]), Fault::InvalidMode);
    rig.idle(20);
    rig.done(Op::NoCompliance, J11, &[]);
    assert!(rig.controller.near(J11) && rig.controller.inpos(J11));
    assert_eq!(rig.commanded(1), [None; 3]);
    let held = rig.sensors.angles[0][0];
    rig.idle(50);
    close(rig.sensors.angles[0][0], held, 1e-12);
}

// clauses: 2.22 7.42
#[test]
fn a_joint_that_is_driven_to_its_limit_stops() {
    let mut rig = Hand::new();
    rig.done(Op::Torque, J13, &[60.0]);
    let fault = (0..1000).find_map(|_| rig.tick().err());
    assert_eq!(fault, Some(Fault::JointLimit(1, 3)));

    let mut rig = Hand::new();
    rig.done(Op::EmgOff, Target::None, &[]);
    rig.done(Op::Torque, J13, &[60.0]);
    rig.idle(1000);
    close(rig.sensors.angles[0][2], 110.0, 1e-9);
    // It comes back when the torque does.
    rig.done(Op::Torque, J13, &[-20.0]);
    rig.idle(50);
    assert!(rig.sensors.angles[0][2] < 109.0);
}

/// Returns a finger whose third joint, with a limit of 110 deg, overshot to 112 deg under torque.
fn overshot() -> Hand {
    let mut rig = Hand::new();
    rig.done(Op::EmgOff, Target::None, &[]);
    rig.done(Op::Torque, J13, &[60.0]);
    rig.sensors.angles[0][2] = 112.0;
    rig
}

// clauses: 7.5 7.9 7.13 7.42
#[test]
fn a_joint_that_overshot_is_commanded_no_angle_beyond_its_limit() {
    let ends: [(Op, Target, &[f64]); 5] = [
        (Op::AllStop, Target::None, &[]),
        (Op::NoCompliance, J13, &[]),
        (Op::PtpAngle, J13, &[110.0]),
        (Op::OmegaControl, J13, &[-1.0]),
        (Op::Ptp, F1, &[-60.0, -100.0, 0.0]),
    ];
    for (op, target, values) in ends {
        let mut rig = overshot();
        rig.done(op, target, values);
        for _ in 0..100 {
            // An angle is where the joint of this rig is immediately.
            assert!(rig.sensors.angles[0][2] <= 110.0, "{}", op.name());
            assert_eq!(rig.commanded(1), [None; 3]);
            rig.idle(1);
        }
    }
    // What holds it there has arrived, and is no reason for an emergency.
    let mut rig = overshot();
    rig.done(Op::NoCompliance, J13, &[]);
    rig.done(Op::EmgOn, Target::None, &[]);
    rig.idle(10);
    assert!(rig.controller.inpos(J13));
    assert_eq!(rig.sensors.angles[0][2], 110.0);
}

// clauses: 7.9 7.26
#[test]
fn no_joint_is_told_more_than_its_motor_gives() {
    // 1.5 N·m.
    let mut rig = Hand::new();
    rig.done(Op::SetTorqueMax, ALL, &[5000.0]);
    rig.done(Op::Torque, F1, &[9000.0, -9000.0, 1499.0]);
    assert_eq!(
        rig.commanded(1),
        [Some(1500.0), Some(-1500.0), Some(1499.0)]
    );
    // Springs and forces are bounded alike.
    let mut rig = Hand::new();
    rig.done(Op::SetTorqueMax, ALL, &[5000.0]);
    rig.done(Op::Force, F1, &[-1e6, 0.0, 0.0]);
    let commanded = rig.commanded(1);
    assert!(
        commanded
            .iter()
            .flatten()
            .all(|torque| torque.abs() == 1500.0)
    );
}

// clauses: 2.22
#[test]
fn a_torque_sensor_that_reads_nonsense_is_a_fault() {
    let mut rig = Hand::new();
    rig.idle(1);
    rig.sensors.torques[1][2] = f64::NAN;
    assert_eq!(rig.tick(), Err(Fault::JointSensor(2, 3)));
}
