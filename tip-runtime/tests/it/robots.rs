//! Robots of other shapes: controller and kinematics are independent of the numbers of legs and
//! joints.

use crate::rig::absolute;
use tip_runtime::command::{Command, Op, Poll, Target};
use tip_runtime::controller::Controller;
use tip_runtime::fault::Fault;
use tip_runtime::hardware::{JointCommand, Sensors};
use tip_runtime::kinematics::Chain;
use tip_runtime::model::{Joint, Leg, Model, Range, titan8};

/// Returns `legs` on TITAN VIII's body.
fn robot<const L: usize, const J: usize>(legs: [Leg<J>; L]) -> Model<L, J> {
    let titan = titan8::MODEL;
    Model {
        name: "other",
        family: titan.family,
        legs,
        inverse: titan.inverse,
        body: titan.body,
        standards: titan.standards,
        periods: titan.periods,
        contact: titan.contact,
        lamps: titan.lamps,
        forces: titan.forces,
        slider: titan.slider,
        vibration: titan.vibration,
        may_touch: titan.may_touch,
    }
}

/// Returns a finger in the x–y plane: every joint turns about z, every link points along x.
fn planar<const J: usize>(lengths: [f64; J]) -> Leg<J> {
    Leg {
        base: [10.0, 20.0, 30.0],
        joints: lengths.map(|length| Joint {
            axis: [0.0, 0.0, 1.0],
            link: [length, 0.0, 0.0],
            limits: Range::new(-90.0, 90.0),
            outer: Range::new(-95.0, 95.0),
            mass: 0.1,
            inertial: None,
            torque: 1.0,
            radius: None,
        }),
        initial: [0.0; J],
    }
}

/// Runs one cycle on an ideal servo.
fn run<const L: usize, const J: usize>(
    controller: &mut Controller<L, J>,
    op: Op,
    target: Target,
    values: &[f64],
) -> Result<Poll, Fault> {
    let sensors = Sensors {
        angles: controller.outputs().map(|leg| leg.map(JointCommand::value)),
        ..Sensors::ZERO
    };
    controller.sense(&sensors)?;
    let poll = controller.command(&Command {
        op,
        hs: false,
        target,
        values: &absolute(values),
    })?;
    controller.advance();
    Ok(poll)
}

// clauses: 7.17
#[test]
fn a_planar_chain_of_four_joints_follows_its_sums() {
    let lengths = [70.0, 50.0, 40.0, 30.0];
    let angles = [10.0_f64, -20.0, 45.0, 80.0];
    let (mut x, mut y, mut direction) = (10.0, 20.0, 0.0_f64);
    for (length, angle) in lengths.iter().zip(angles) {
        direction += angle.to_radians();
        x += length * libm::cos(direction);
        y += length * libm::sin(direction);
    }
    let foot = Chain::new(&planar(lengths), &angles).foot();
    assert!((foot[0] - x).abs() < 1e-9 && (foot[1] - y).abs() < 1e-9);
    assert!((foot[2] - 30.0).abs() < 1e-12);
}

// clauses: 7.2 7.4 7.8
#[test]
fn six_legs_walk_on_their_own() {
    let [a, b, c, d] = titan8::MODEL.legs;
    let model = robot([a, b, c, d, a, b]);
    let mut controller = Controller::new(&model);
    let goal = [391.0, 221.0, -180.0];
    let done = Ok(Poll::Done);
    assert_eq!(run(&mut controller, Op::Ptp, Target::Foot(6), &goal), done);
    let joint = Target::Joint(5, 3);
    assert_eq!(run(&mut controller, Op::PtpAngle, joint, &[80.0]), done);
    while run(&mut controller, Op::WaitInpos, Target::All, &[]) == Ok(Poll::Pending) {}
    assert!(controller.near(Target::Foot(6)) && controller.near(joint));
    assert!(!controller.near(Target::Foot(1)));
    let gone = run(&mut controller, Op::Ptp, Target::Foot(7), &goal);
    assert_eq!(gone, Err(Fault::Domain));
}

// clauses: 7.4 7.8 2.22
#[test]
fn legs_without_an_inverse_still_take_commands_of_joints() {
    let model = robot([planar([70.0, 50.0]), planar([60.0, 40.0])]);
    let mut controller = Controller::new(&model);
    let leg = Target::Foot(2);
    let turned = run(&mut controller, Op::PtpAngle, leg, &[5.0, -5.0]);
    assert_eq!(turned, Ok(Poll::Done));
    while run(&mut controller, Op::WaitInpos, leg, &[]) == Ok(Poll::Pending) {}
    assert!(controller.near(leg));
    let moved = run(&mut controller, Op::Ptp, leg, &[100.0, 20.0, 30.0]);
    assert_eq!(moved, Err(Fault::OutOfReach(leg)));
}
