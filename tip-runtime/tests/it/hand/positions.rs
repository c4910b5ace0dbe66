//! Fingertips, third joints and the slider under position control.

use crate::hand::rig::{F1, Hand, J11, J12, J13, all_close, close};
use nalgebra::Matrix3;
use tip_runtime::command::{Command, Op, Poll, Target, Teach, Value};
use tip_runtime::fault::Fault;
use tip_runtime::kinematics::{Chain, LegPoint, resolve};
use tip_runtime::model::hand;

const ALL: Target = Target::All;
const FLOOR: Target = Target::Floor;
const PLANE: [bool; 3] = [true, true, false];

/// Returns the fingertip of F1 for its angles: links hang down, angles add up.
fn tip_of(angles: [f64; 3]) -> [f64; 3] {
    let (mut x, mut y, mut turned) = (-60.0, 0.0, 0.0_f64);
    for (length, angle) in [70.0, 50.0, 40.0].iter().zip(angles) {
        turned += angle.to_radians();
        x += length * turned.sin();
        y -= length * turned.cos();
    }
    [x, y, 0.0]
}

// clauses: 7.17
#[test]
fn fingers_hang_down_and_close_towards_the_centre() {
    let rig = Hand::new();
    let tip = tip_of([-40.0, 0.0, 80.0]);
    all_close(rig.teach(Teach::Position, F1), tip, 1e-9);
    for n in [2, 3] {
        let mirrored = [-tip[0], tip[1], 0.0];
        all_close(rig.teach(Teach::Position, Target::Foot(n)), mirrored, 1e-9);
        // F2 and F3 stand apart along z, which the language does not see.
        assert!(rig.tip(usize::from(n))[2].abs() > 1.0);
    }
    let straight = Chain::new(&hand::MODEL.legs[0], &[0.0; 3]);
    all_close(straight.foot(), [-60.0, -160.0, 0.0], 1e-9);
    all_close(straight.joint(2).expect("J13"), [-60.0, -120.0, 0.0], 1e-9);
}

// clauses: 7.2
#[test]
fn a_small_step_is_the_least_turn() {
    let finger = &hand::MODEL.legs[0];
    for from in [[-40.0, 10.0, 80.0], [10.0, 30.0, 40.0], [30.0, 60.0, 20.0]] {
        let [x, y, z] = tip_of(from);
        let angles =
            resolve(finger, &from, LegPoint::Tip, [x + 1e-3, y - 2e-3, z], PLANE).expect("near");
        all_close(tip_of(angles), [x + 1e-3, y - 2e-3, 0.0], 1e-8);
        // What keeps the tip in place is across both rows of the Jacobian: no share of it is spent.
        let jacobian = Matrix3::from(Chain::new(finger, &from).foot_jacobian());
        let idle = jacobian.row(0).cross(&jacobian.row(1));
        let turn: Vec<f64> = angles.iter().zip(from).map(|(a, b)| a - b).collect();
        let size = turn.iter().map(|turn| turn * turn).sum::<f64>().sqrt();
        let spent: f64 = idle.iter().zip(&turn).map(|(a, b)| a * b).sum();
        assert!(size > 0.0 && (spent / idle.norm()).abs() < 1e-4 * size);
    }
}

// clauses: 2.22 7.2
#[test]
fn what_is_found_is_within_the_limits_and_what_is_not_is_far() {
    let finger = &hand::MODEL.legs[0];
    for x in (-150..=20).step_by(10) {
        for y in (-150..=-60).step_by(10) {
            let target = [f64::from(x), f64::from(y), 0.0];
            if let Some(angles) = resolve(finger, &finger.initial, LegPoint::Tip, target, PLANE) {
                all_close(tip_of(angles), target, 1e-6);
                for (joint, angle) in finger.joints.iter().zip(angles) {
                    assert!(joint.limits.contains(angle));
                }
            }
        }
    }
    let near = resolve(
        finger,
        &finger.initial,
        LegPoint::Tip,
        [-60.0, -159.9, 0.0],
        PLANE,
    );
    assert!(near.is_some());
    let far = resolve(
        finger,
        &finger.initial,
        LegPoint::Tip,
        [-60.0, -160.1, 0.0],
        PLANE,
    );
    assert!(far.is_none());
    // Stretched out to the very end.
    let end = resolve(
        finger,
        &finger.initial,
        LegPoint::Tip,
        [-60.0, -160.0, 0.0],
        PLANE,
    );
    all_close(end.map_or([9.0; 3], tip_of), [-60.0, -160.0, 0.0], 1e-6);
}

// clauses: 7.1 7.2 7.3
#[test]
fn a_fingertip_goes_straight_and_ignores_z() {
    let mut rig = Hand::new();
    let [x, y, _] = rig.tip(1);
    rig.done(Op::Ptp, F1, &[x + 30.0, y + 10.0, 77.0]);
    let mut cycles = 0;
    while !rig.controller.inpos(F1) {
        rig.idle(1);
        let [at_x, at_y, _] = rig.tip(1);
        close((at_x - x) * 10.0, (at_y - y) * 30.0, 1e-5);
        cycles += 1;
        assert!(cycles < 1000);
    }
    rig.idle(100);
    all_close(
        rig.teach(Teach::Position, F1),
        [x + 30.0, y + 10.0, 0.0],
        1e-6,
    );
    rig.done(Op::RelPtp, F1, &[-5.0, 0.0, 1e6]);
    rig.idle(500);
    all_close(
        rig.teach(Teach::Position, F1),
        [x + 25.0, y + 10.0, 0.0],
        1e-6,
    );
    assert_eq!(
        rig.fault(Op::Ptp, F1, &[-60.0, -161.0, 0.0]),
        Fault::OutOfReach(F1)
    );
}

// clauses: 7.2 7.21
#[test]
fn speed_is_v_max() {
    let mut rig = Hand::new();
    rig.done(Op::SetVMax, F1, &[20.0]);
    let [x, y, _] = rig.tip(2);
    rig.done(Op::Ptp, Target::Foot(2), &[x - 30.0, y, 0.0]);
    let [x, y, _] = rig.tip(1);
    rig.done(Op::Ptp, F1, &[x + 30.0, y, 0.0]);
    // F1 is at its speed after 50 ms, F2 from 250 to 300 ms.
    rig.idle(135);
    let before = (rig.tip(1)[0], rig.tip(2)[0]);
    rig.idle(1);
    close(rig.tip(1)[0] - before.0, 0.04, 1e-6);
    close(before.1 - rig.tip(2)[0], 0.2, 1e-6);
}

// clauses: 2.25 5.1 7.2
#[test]
fn the_third_joint_is_put_by_the_two_before_it() {
    let mut rig = Hand::new();
    let [x, y, _] = rig.teach(Teach::Position, J13);
    rig.done(Op::OmegaControl, J13, &[-5.0]);
    rig.done(Op::Ptp, J13, &[x + 20.0, y + 20.0, 9.0]);
    assert!(!rig.controller.inpos(J13) && !rig.controller.inpos(F1));
    rig.cycles(Op::WaitInpos, J13, &[]).expect("it arrives");
    rig.idle(300);
    all_close(
        rig.teach(Teach::Position, J13),
        [x + 20.0, y + 20.0, 0.0],
        1e-6,
    );
    // The third joint kept its angular velocity.
    let angle = rig.sensors.angles[0][2];
    rig.idle(10);
    close(rig.sensors.angles[0][2], angle - 0.1, 1e-9);
    // A joint that served the fingertip holds its angle.
    let mut rig = Hand::new();
    let [x, y, _] = rig.tip(1);
    rig.done(Op::Ptp, F1, &[x + 5.0, y, 0.0]);
    rig.idle(500);
    let third = rig.sensors.angles[0][2];
    let [x, y, _] = rig.teach(Teach::Position, J13);
    rig.done(Op::Ptp, J13, &[x + 9.0, y, 0.0]);
    rig.idle(500);
    close(rig.sensors.angles[0][2], third, 1e-6);
    // A joint command ends the mode; its other joints stay where they are measured.
    rig.done(Op::PtpAngle, J11, &[-30.0]);
    let second = rig.sensors.angles[0][1];
    rig.idle(500);
    close(rig.sensors.angles[0][0], -30.0, 1e-9);
    close(rig.sensors.angles[0][1], second, 1e-6);
    assert!(rig.controller.near(J12));
    assert_eq!(rig.fault(Op::Ptp, J12, &[0.0, -100.0, 0.0]), Fault::Domain);
    let far = rig.fault(Op::Ptp, J13, &[-60.0, -121.0, 0.0]);
    assert_eq!(far, Fault::OutOfReach(J13));
}

// clauses: 5.1 7.2
#[test]
fn a_third_joint_has_arrived_where_its_position_has_whatever_its_angle() {
    let mut rig = Hand::new();
    let [x, y, _] = rig.teach(Teach::Position, J13);
    rig.done(Op::PtpAngle, J13, &[80.0]);
    assert!(rig.controller.inpos(J13) && rig.controller.near(J13));
    rig.done(Op::Ptp, J13, &[x + 20.0, y + 20.0, 0.0]);
    assert!(!rig.controller.inpos(J13) && !rig.controller.near(J13));
}

// clauses: 7.3
#[test]
fn rel_ptp_of_a_third_joint_counts_from_its_target() {
    let mut rig = Hand::new();
    let [x, y, _] = rig.teach(Teach::Position, J13);
    rig.done(Op::Ptp, J13, &[x + 10.0, y + 10.0, 0.0]);
    rig.done(Op::RelPtp, J13, &[-5.0, -5.0, 0.0]);
    rig.idle(200);
    let place = rig.teach(Teach::Position, J13);
    all_close(place, [x + 5.0, y + 5.0, 0.0], 1e-6);
}

// clauses: 2.25 7.6
#[test]
fn a_robot_is_not_still_while_a_joint_behind_the_controlled_one_turns() {
    let mut rig = Hand::new();
    rig.done(Op::OmegaControl, J13, &[-5.0]);
    rig.idle(10);
    let place = rig.teach(Teach::Position, J13);
    rig.done(Op::Ptp, J13, &place);
    // 5 deg/s under 360 deg/s²: 7 cycles of braking.
    assert_eq!(rig.cycles(Op::InitialPosture, Target::None, &[]), Some(8));
}

/// Runs a PTP at high speed.
fn done_hs(rig: &mut Hand, target: Target, place: [f64; 3]) {
    rig.controller.sense(&rig.sensors).expect("good sensors");
    let command = Command {
        op: Op::Ptp,
        hs: true,
        target,
        values: &place.map(Value::Absolute),
    };
    assert_eq!(rig.controller.command(&command), Ok(Poll::Done));
    rig.advance();
}

// clauses: 7.2
#[test]
fn a_finger_gets_to_a_place_from_the_posture_that_it_has() {
    // Fast enough to be there in the next cycle.
    let mut rig = Hand::new();
    rig.done(Op::SetVMax, F1, &[1e6]);
    let place = [-30.0, -120.0, 0.0];
    done_hs(&mut rig, F1, place);
    all_close(rig.tip(1), place, 1e-6);
    let first = rig.sensors.angles[0];
    rig.done(Op::SetOmegaMax, ALL, &[720.0]);
    rig.done(Op::SetOmegaDotMax, ALL, &[1e4]);
    rig.done(Op::PtpAngle, F1, &[-60.0, 90.0, 10.0]);
    rig.idle(200);
    done_hs(&mut rig, F1, place);
    all_close(rig.tip(1), place, 1e-6);
    let turned = (rig.sensors.angles[0][1] - first[1]).abs();
    assert!(turned > 5.0, "{turned}");
}

/// Returns the slider in motion, at its full speed of 0.2 mm in a cycle.
fn slider_at_high_speed() -> Hand {
    let mut rig = Hand::new();
    done_hs(&mut rig, FLOOR, [0.0, -60.0, 0.0]);
    close(rig.controller.slider()[1], -129.8, 1e-9);
    rig
}

// clauses: 2.24 7.2
#[test]
fn the_slider_obeys_its_acceleration_save_at_high_speed() {
    let mut rig = slider_at_high_speed();
    // 100 mm/s under 400 mm/s² need 12.5 mm to stop: it brakes immediately, by ½ · 400 · 0.002² mm.
    rig.done(Op::Ptp, FLOOR, &[0.0, -125.0, 0.0]);
    close(rig.controller.slider()[1], -129.6 - 0.0008, 1e-9);
}

// clauses: 2.24 7.3
#[test]
fn rel_ptp_of_zero_stops_the_slider() {
    let mut rig = slider_at_high_speed();
    rig.done(Op::RelPtp, FLOOR, &[0.0; 3]);
    rig.idle(10);
    close(rig.controller.slider()[1], -129.8, 1e-9);
    assert!(rig.controller.inpos(ALL) && rig.controller.near(ALL));
    // At 40 mm/s after 0.1 s and 2 mm; as much to stop.
    let mut rig = Hand::new();
    rig.done(Op::Ptp, FLOOR, &[0.0, -60.0, 0.0]);
    rig.idle(49);
    rig.done(Op::RelPtp, FLOOR, &[0.0; 3]);
    rig.idle(100);
    close(rig.controller.slider()[1], -126.0, 1e-9);
}

// clauses: 7.2 7.3 7.6 7.21
#[test]
fn the_slider_carries_the_floor() {
    let mut rig = Hand::new();
    assert_eq!(rig.controller.slider(), [0.0, -130.0, 0.0]);
    rig.done(Op::SetVMax, FLOOR, &[10.0]);
    rig.done(Op::Ptp, FLOOR, &[0.0, -120.0, 0.0]);
    assert!(!rig.controller.inpos(ALL));
    rig.idle(250);
    let before = rig.controller.slider()[1];
    rig.idle(1);
    close(rig.controller.slider()[1] - before, 0.02, 1e-9);
    rig.cycles(Op::WaitInpos, ALL, &[]).expect("it arrives");
    rig.idle(500);
    assert_eq!(rig.controller.slider(), [0.0, -120.0, 0.0]);
    rig.done(Op::RelPtp, FLOOR, &[0.0, -5.0, 0.0]);
    rig.done(Op::RelPtp, FLOOR, &[0.0, -5.0, 0.0]);
    rig.idle(2000);
    assert_eq!(rig.controller.slider(), [0.0, -130.0, 0.0]);
    let out = Fault::OutOfReach(FLOOR);
    assert_eq!(rig.fault(Op::Ptp, FLOOR, &[0.0, -59.0, 0.0]), out);
    assert_eq!(rig.fault(Op::Ptp, FLOOR, &[1.0, -130.0, 0.0]), out);
    rig.done(Op::Ptp, FLOOR, &[0.0, -60.0, 0.0]);
    rig.done(Op::AllStop, Target::None, &[]);
    rig.idle(100);
    let held = rig.controller.slider();
    rig.idle(100);
    assert_eq!(rig.controller.slider(), held);
    rig.cycles(Op::InitialPosture, Target::None, &[]);
    rig.idle(3000);
    assert_eq!(rig.controller.slider(), [0.0, -130.0, 0.0]);
    rig.done(Op::EmgOff, Target::None, &[]);
    rig.done(Op::Ptp, FLOOR, &[0.0, 0.0, 0.0]);
    rig.idle(3000);
    assert_eq!(rig.controller.slider(), [0.0, -60.0, 0.0]);
}
