//! FORCE and TEACH_FORCE.

use crate::hand::rig::{F1, Hand, J12, J13, all_close, close, moments, transposed};
use tip_runtime::command::{Op, Target, Teach, Value};
use tip_runtime::controller::Controller;
use tip_runtime::fault::Fault;
use tip_runtime::hardware::Sensors;
use tip_runtime::kinematics::{Chain, LegPoint};
use tip_runtime::model::{generic, hand};

// clauses: 7.1 7.10
#[test]
fn a_force_acts_through_the_transposed_jacobian() {
    for n in [1, 2, 3] {
        let mut rig = Hand::new();
        let finger = Target::Foot(n);
        let expected = transposed(&rig.chain(usize::from(n)), [0.2, -0.3, 0.0]);
        rig.done(Op::Force, finger, &[0.2, -0.3, 50.0]);
        let commanded = rig.commanded(usize::from(n)).map(Option::unwrap_or_default);
        all_close(commanded, expected, 1e-9);
        let expected = transposed(&rig.chain(usize::from(n)), [0.3, -0.3, 0.0]);
        rig.relative(Op::Force, finger, &[0.1, 0.0, 0.0]);
        let commanded = rig.commanded(usize::from(n)).map(Option::unwrap_or_default);
        all_close(commanded, expected, 1e-9);
    }
}

// clauses: 2.25 7.10
#[test]
fn a_force_at_the_third_joint_leaves_that_joint_alone() {
    let mut rig = Hand::new();
    let chain = rig.chain(1);
    let third = chain.joint(2).expect("J13");
    let expected = moments(&chain, third, [0.2, 0.1]);
    rig.done(Op::Force, J13, &[0.2, 0.1, 0.0]);
    let [first, second, third] = rig.commanded(1);
    close(first.expect("a torque"), expected[0], 1e-9);
    close(second.expect("a torque"), expected[1], 1e-9);
    assert_eq!(third, None);
    assert_eq!(rig.fault(Op::Force, J12, &[0.0; 3]), Fault::Domain);
}

// clauses: 7.10 7.26 7.29
#[test]
fn a_force_is_bound_by_torque_max_and_by_no_compliance_limit() {
    let mut rig = Hand::new();
    rig.done(Op::SetComplianceForceLimit, F1, &[0.01, 0.01, 0.01]);
    rig.done(Op::SetTorqueMax, Target::All, &[5.0]);
    rig.done(Op::Force, F1, &[1.0, 0.0, 0.0]);
    let free = transposed(&Hand::new().chain(1), [1.0, 0.0, 0.0]);
    for (commanded, free) in rig.commanded(1).iter().zip(free) {
        assert!(free.abs() > 5.0);
        close(commanded.expect("a torque"), 5.0 * free.signum(), 1e-9);
    }
}

// clauses: 7.19
#[test]
fn forces_are_told_from_torques() {
    let mut rig = Hand::new();
    rig.idle(1);
    // Held by angle, the joints balance what pulls: the finger pushes against it.
    rig.pull[0] = [0.4, 0.7, 0.0];
    rig.pull[2] = [-0.4, 0.1, 0.0];
    rig.idle(2);
    all_close(rig.teach(Teach::Force, F1), [-0.4, -0.7, 0.0], 1e-9);
    all_close(
        rig.teach(Teach::Force, Target::Foot(3)),
        [0.4, -0.1, 0.0],
        1e-9,
    );
    assert_eq!(rig.teach(Teach::Force, Target::Foot(2)), [0.0; 3]);
    // What a finger is commanded to push with is what is read.
    let mut rig = Hand::new();
    rig.done(Op::Force, F1, &[0.3, -0.2, 0.0]);
    rig.controller.sense(&rig.sensors).expect("good sensors");
    all_close(rig.teach(Teach::Force, F1), [0.3, -0.2, 0.0], 0.01);
}

// clauses: 7.19
#[test]
fn torques_beyond_a_force_are_left_out() {
    // Least squares: what the rest of the torques would need is across every force's torques.
    let chain = Chain::new(&hand::MODEL.legs[0], &[10.0, 30.0, 40.0]);
    let torques = [0.03, 0.05, -0.02];
    let force = chain
        .force_of_torques(LegPoint::Tip, &torques, [true, true, false])
        .expect("regular");
    let explained = chain.torques_of_force(LegPoint::Tip, force).expect("a tip");
    for direction in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]] {
        let along = chain
            .torques_of_force(LegPoint::Tip, direction)
            .expect("a tip");
        let rest: f64 = (0..3).map(|m| (torques[m] - explained[m]) * along[m]).sum();
        close(rest, 0.0, 1e-12);
    }
}

// clauses: 7.19
#[test]
fn the_second_joint_tells_of_the_end_of_its_link() {
    let mut rig = Hand::new();
    rig.sensors.angles[0] = [-40.0, 30.0, 80.0];
    let chain = rig.chain(1);
    let [first, second, _] = moments(&chain, chain.joint(2).expect("J13"), [0.6, -0.2]);
    rig.sensors.torques[0] = [first, second, 999.0];
    rig.controller.sense(&rig.sensors).expect("good sensors");
    all_close(rig.teach(Teach::Force, J12), [0.6, -0.2, 0.0], 1e-9);
    assert_eq!(rig.controller.teach(Teach::Force, J13), Err(Fault::Domain));
}

// clauses: 7.19
#[test]
fn a_singular_finger_tells_no_force() {
    let mut rig = Hand::new();
    rig.sensors.angles[0] = [20.0, 0.0, 0.0];
    rig.sensors.torques[0] = [10.0; 3];
    rig.controller.sense(&rig.sensors).expect("good sensors");
    assert_eq!(rig.teach(Teach::Force, F1), [0.0, 0.0, -1.0]);
    assert_eq!(rig.teach(Teach::Force, J12), [0.0, 0.0, -1.0]);
    rig.sensors.angles[0] = [20.0, 0.0, 2.0];
    rig.controller.sense(&rig.sensors).expect("good sensors");
    assert_ne!(rig.teach(Teach::Force, F1)[2], -1.0);
    assert_eq!(rig.teach(Teach::Force, J12)[2], -1.0);
}

// clauses: 7.10 7.19
#[test]
fn the_generic_robot_counts_in_newton_metres() {
    let model = &generic::MODEL;
    let mut controller = Controller::new(model);
    let leg = Target::Foot(2);
    let initial = model.legs.map(|leg| leg.initial);
    let mut sensors = Sensors {
        angles: initial,
        ..Sensors::ZERO
    };
    controller.sense(&sensors).expect("good sensors");
    let values = [10.0, -5.0, -40.0].map(Value::Absolute);
    let command = tip_runtime::command::Command {
        op: Op::Force,
        hs: false,
        target: leg,
        values: &values,
    };
    controller.command(&command).expect("done");
    controller.advance();
    // J = (0, 0, 90): the foot is 290 mm out and 200 mm down. The yaw feels the push forwards, the
    // thigh the lift at 240 mm and the push outwards at 200 mm, the knee the latter alone.
    let commanded = controller.outputs()[1].map(|command| command.value());
    all_close(
        commanded,
        [-5.0 * 0.29, -40.0 * 0.24 + 10.0 * 0.2, -10.0 * 0.2],
        1e-9,
    );
    sensors.torques[1] = commanded;
    controller.sense(&sensors).expect("good sensors");
    let force = controller.teach(Teach::Force, leg).expect("measured");
    all_close([force[0], force[1], force[2]], [10.0, -5.0, -40.0], 1e-9);
}
