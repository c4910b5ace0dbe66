//! Fingers without obstacles.

use crate::hand_plant::rig::{F1, J11, J13, Rig, close, cycles, held, limp, outputs, plant, write};
use tip_runtime::command::{Op, Target, Teach};
use tip_runtime::fault::Fault;
use tip_runtime::hardware::{Hardware, JointCommand};
use tip_runtime::model::hand;

/// Inertia of each motor, kg·m².
const ROTOR: f64 = 1e-4;
/// Viscous friction of a joint: N·m·s/rad.
const FRICTION: f64 = 0.01;

#[test]
fn a_hand_at_rest_stays_where_it_is_to_the_bit() {
    let mut plant = plant();
    write(&mut plant, &outputs(held()), 200);
    assert_eq!(plant.angles(), hand::MODEL.legs.map(|leg| leg.initial));
    write(&mut plant, &outputs(limp()), 200);
    assert_eq!(plant.angles(), hand::MODEL.legs.map(|leg| leg.initial));
    assert_eq!(plant.torques(), [[0.0; 3]; 3]);
}

// clauses: 7.2 7.4 7.18
#[test]
fn fingers_and_slider_arrive_where_they_are_sent() {
    let mut rig = Rig::new();
    rig.run(Op::PtpAngle, F1, &[-20.0, 30.0, 40.0]);
    rig.run(Op::Ptp, Target::Foot(2), &[90.0, -120.0, 0.0]);
    rig.run(Op::Ptp, Target::Joint(3, 3), &[100.0, -90.0, 0.0]);
    rig.run(Op::Ptp, Target::Floor, &[0.0, -150.0, 0.0]);
    rig.run(Op::WaitInpos, Target::All, &[]);
    rig.idle(0.1);
    let angles = rig.teach(Teach::Angle, F1);
    for (angle, sent) in angles.iter().zip([-20.0, 30.0, 40.0]) {
        close(*angle, sent, 1e-6);
    }
    let [x, y, _] = rig.teach(Teach::Position, Target::Foot(2));
    close(x, 90.0, 1e-3);
    close(y, -120.0, 1e-3);
    let [x, y, _] = rig.teach(Teach::Position, Target::Joint(3, 3));
    close(x, 100.0, 1e-3);
    close(y, -90.0, 1e-3);
    close(rig.sensors().slider[1], -150.0, 1e-9);
}

/// Returns the angle of a joint after `time` s from rest: `I θ̈ = τ − b θ̇`.
fn turned(torque: f64, inertia: f64, time: f64) -> f64 {
    let lag = inertia / FRICTION;
    torque / FRICTION * (time - lag * (1.0 - (-time / lag).exp()))
}

/// Returns the accelerations of each three samples in a row.
fn accelerations(angles: &[f64]) -> Vec<f64> {
    let second = |three: &[f64]| (three[2] - 2.0 * three[1] + three[0]) / (0.002 * 0.002);
    angles.windows(3).map(second).collect()
}

/// Compares a joint of finger 1 that is commanded a torque with the closed form, cycle by cycle.
fn accelerates(mut rig: Rig, joint: Target, m: usize, torque: f64, inertia: f64) {
    let start = rig.plant.angles()[0];
    rig.run(Op::Torque, joint, &[torque]);
    let mut measured = vec![0.0];
    let mut exact = vec![0.0];
    for cycle in 1..=10 {
        measured.push((rig.plant.angles()[0][m] - start[m]).to_radians());
        exact.push(turned(torque / 1000.0, inertia, 0.002 * f64::from(cycle)));
        rig.idle(0.002);
    }
    let exact = accelerations(&exact);
    for (measured, exact) in accelerations(&measured).iter().zip(&exact) {
        close(measured / exact, 1.0, 0.01);
    }
    // From rest it is the torque over the inertia, except for the friction of the first 4 ms.
    close(exact[0] / (torque / 1000.0 / inertia), 1.0, 0.2);
    for (n, (now, start)) in rig.plant.angles()[0].iter().zip(start).enumerate() {
        assert!(n == m || (now - start).abs() < 1e-3);
    }
}

// clauses: 7.9
#[test]
fn a_torque_accelerates_a_free_joint_as_its_inertia_says() {
    // The joints before J13 hold their angles as servos. Its link is a rod that turns about its
    // end: 25 g of 40 mm, and the motor.
    let inertia = 0.025 * 0.04 * 0.04 / 3.0 + ROTOR;
    accelerates(Rig::new(), J13, 2, -20.0, inertia);
}

#[test]
fn a_stretched_finger_swings_about_its_first_joint_as_one_rod() {
    // Joints 2 and 3 hold 0 deg: three rods in line, whose inertia about the first joint is the sum
    // of m (l²/12 + d²), d from the joint to each middle.
    let rods = [
        (0.060, 0.070, 0.035),
        (0.040, 0.050, 0.095),
        (0.025, 0.040, 0.140),
    ];
    let inertia: f64 = rods
        .iter()
        .map(|(m, l, d)| m * (l * l / 12.0 + d * d))
        .sum::<f64>()
        + ROTOR;
    let mut rig = Rig::new();
    rig.run(Op::PtpAngle, F1, &[-40.0, 0.0, 0.0]);
    rig.run(Op::WaitInpos, F1, &[]);
    rig.idle(0.5);
    accelerates(rig, J11, 0, 40.0, inertia);
}

#[test]
fn a_motor_gives_no_more_than_it_can_and_a_servo_yields_to_more() {
    let mut plant = plant();
    let mut commands = held();
    commands[0][2] = JointCommand::Torque(1e6);
    write(&mut plant, &outputs(commands), 1);
    assert_eq!(plant.torques()[0][2], 1500.0);
    // 20 N straight down on a tip 51 mm beside its first joint: 1028 mN·m, less than the motor's.
    let mut plant = self::plant();
    plant.pull(1, [0.0, -20.0]);
    write(&mut plant, &outputs(held()), cycles(0.2));
    let initial = hand::MODEL.legs[0].initial;
    for (angle, initial) in plant.angles()[0].iter().zip(initial) {
        close(*angle, initial, 1e-3);
    }
    // Twice that is more.
    plant.pull(1, [0.0, -40.0]);
    write(&mut plant, &outputs(held()), cycles(0.2));
    assert!((plant.angles()[0][0] - initial[0]).abs() > 5.0);
    plant.pull(1, [0.0, 0.0]);
    write(&mut plant, &outputs(held()), cycles(0.5));
    close(plant.angles()[0][0], initial[0], 1e-3);
}

#[test]
fn stops_hold_what_servos_do_not() {
    let mut plant = plant();
    let mut commands = limp();
    commands[0] = [JointCommand::Torque(1500.0); 3];
    write(&mut plant, &outputs(commands), cycles(2.0));
    for (angle, joint) in plant.angles()[0].iter().zip(hand::MODEL.legs[0].joints) {
        assert!(*angle > joint.outer.max && *angle < joint.outer.max + 3.0);
    }
}

#[test]
fn in_an_emergency_the_motors_hold_where_they_are() {
    let mut plant = plant();
    let mut commands = held();
    commands[0][0] = JointCommand::Torque(40.0);
    write(&mut plant, &outputs(commands), 20);
    let caught = plant.angles()[0][0];
    for _ in 0..cycles(0.5) {
        assert_eq!(plant.stop(&Fault::EmergencyKey), Ok(()));
    }
    let held = plant.angles()[0][0];
    close(held, caught, 0.5);
    for _ in 0..cycles(0.5) {
        assert_eq!(plant.stop(&Fault::EmergencyKey), Ok(()));
    }
    close(plant.angles()[0][0], held, 1e-9);
}

#[test]
fn what_vibrates_in_the_commands_vibrates_in_the_joints() {
    let mut plant = plant();
    let mut swing = (f64::MAX, f64::MIN);
    for cycle in 0..500 {
        let mut commands = held();
        let phase = core::f64::consts::TAU * 60.0 * 0.002 * f64::from(cycle);
        commands[0][2] = JointCommand::at(80.0 + 2.0 * phase.sin());
        write(&mut plant, &outputs(commands), 1);
        let angle = plant.angles()[0][2];
        swing = (swing.0.min(angle), swing.1.max(angle));
    }
    close(swing.1 - swing.0, 4.0, 0.4);
}

#[test]
fn joints_that_are_limp_slow_down_and_stay() {
    let mut plant = plant();
    let mut commands = limp();
    commands[0] = [JointCommand::Torque(30.0); 3];
    write(&mut plant, &outputs(commands), 10);
    write(&mut plant, &outputs(limp()), cycles(3.0));
    let before = plant.angles();
    write(&mut plant, &outputs(limp()), cycles(0.5));
    for (now, before) in plant.angles()[0].iter().zip(before[0]) {
        close(*now, before, 1e-6);
    }
}
