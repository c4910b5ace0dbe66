//! Vibration of joints about their commands.

use crate::hand::rig::{F1, Hand, J11, J12, J13, close};
use core::f64::consts::TAU;
use tip_runtime::command::{Op, Target};
use tip_runtime::controller::Controller;
use tip_runtime::fault::Fault;
use tip_runtime::hardware::JointCommand;
use tip_runtime::model::titan8;
use tip_runtime::vibration::{Vibration, Waveform};

/// Number of cycles of 2 ms in a wave of 25 Hz.
const WAVE: usize = 20;

fn vibration(waveform: Waveform, amplitude: f64) -> Vibration {
    Vibration {
        waveform,
        amplitude,
        frequency: 25.0,
    }
}

impl Hand {
    fn vibrate(&mut self, joint: Target, vibration: Vibration) {
        let commanded = self.controller.vibrate(joint, Some(vibration));
        commanded.expect("the joint vibrates");
    }

    /// Returns the commands of joint `m` of finger 1 in the next cycles.
    fn commanded_next(&mut self, m: usize, cycles: usize) -> Vec<f64> {
        let mut commanded = || {
            self.idle(1);
            self.controller.outputs()[0][m - 1].value()
        };
        (0..cycles).map(|_| commanded()).collect()
    }
}

// clauses: 7.48
#[test]
fn a_joint_vibrates_about_its_angle_and_is_measured_to() {
    let mut rig = Hand::new();
    rig.vibrate(J13, vibration(Waveform::Sine, 2.0));
    // Half a degree for each volt.
    for k in 1..=3 * WAVE {
        rig.idle(1);
        let expected = 80.0 + (TAU * k as f64 / WAVE as f64).sin();
        close(rig.controller.outputs()[0][2].value(), expected, 1e-9);
        close(rig.sensors.angles[0][2], expected, 1e-9);
    }
    assert_eq!(rig.sensors.angles[0][..2], [-40.0, 0.0]);
    rig.controller.vibrate(J13, None).expect("it stops");
    assert_eq!(rig.commanded_next(3, 1), [80.0]);
}

// clauses: 7.48
#[test]
fn another_frequency_goes_on_from_the_same_place_of_the_wave() {
    let mut rig = Hand::new();
    let slow = vibration(Waveform::Sine, 2.0);
    rig.vibrate(J13, slow);
    // A quarter of a wave, then waves that are twice as fast: a tenth in each cycle.
    rig.commanded_next(3, WAVE / 4);
    let frequency = 50.0;
    rig.vibrate(J13, Vibration { frequency, ..slow });
    for (k, commanded) in (1..).zip(rig.commanded_next(3, 20)) {
        close(
            commanded,
            80.0 + (TAU * (0.25 + 0.1 * f64::from(k))).sin(),
            1e-9,
        );
    }
}

// clauses: 7.48
#[test]
fn the_waves_have_their_shapes() {
    let mut rig = Hand::new();
    rig.vibrate(J11, vibration(Waveform::OneSided, -2.0));
    rig.vibrate(J12, vibration(Waveform::Sawtooth, 2.0));
    rig.vibrate(J13, vibration(Waveform::Sawtooth, -2.0));
    let mut commanded: [Vec<f64>; 3] = Default::default();
    for _ in 0..WAVE {
        rig.idle(1);
        for (commanded, command) in commanded.iter_mut().zip(rig.controller.outputs()[0]) {
            commanded.push(command.value());
        }
    }
    let [one_sided, sawtooth, reversed] = commanded;
    for (k, angle) in (1..).zip(one_sided) {
        let phase = TAU * f64::from(k) / WAVE as f64;
        close(angle, -40.0 - (1.0 - phase.cos()) / 2.0, 1e-9);
    }
    // Eight cycles up to +1, four down to -1, eight up to 0.
    for (k, (up, down)) in (1..).zip(sawtooth.iter().zip(reversed)) {
        let expected = match k {
            1..=8 => f64::from(k) / 8.0,
            9..=12 => 1.0 - f64::from(k - 8) / 2.0,
            _ => -1.0 + f64::from(k - 12) / 8.0,
        };
        close(*up, expected, 1e-9);
        close(down, 80.0 - expected, 1e-9);
    }
}

// clauses: 7.9 7.48
#[test]
fn a_torque_vibrates_within_torque_max() {
    let mut rig = Hand::new();
    rig.done(Op::Torque, F1, &[0.0; 3]);
    rig.done(Op::Torque, J12, &[60.0]);
    rig.vibrate(J12, vibration(Waveform::Sine, 2.0));
    // Ten mN·m for each volt: the finger still closes with 40 at the least.
    let commanded = rig.commanded_next(2, WAVE);
    close(commanded[4], 80.0, 1e-9);
    close(commanded[14], 40.0, 1e-9);
    rig.done(Op::SetTorqueMax, J12, &[70.0]);
    let commanded = rig.commanded_next(2, WAVE);
    close(
        commanded.iter().fold(0.0, |most, t| t.max(most)),
        70.0,
        1e-9,
    );
    // Nor does the motor give more than it can, whatever the amplitude.
    rig.done(Op::SetTorqueMax, J12, &[5000.0]);
    rig.vibrate(J12, vibration(Waveform::Sine, f64::MAX));
    assert!(rig.commanded_next(2, 1)[0].abs() <= 1500.0);
}

// clauses: 2.22 7.48
#[test]
fn no_vibration_leads_beyond_a_working_limit() {
    for amplitude in [2.0, 1000.0, f64::MAX] {
        let mut rig = Hand::new();
        rig.done(Op::PtpAngle, J13, &[109.8]);
        rig.idle(1000);
        rig.vibrate(J13, vibration(Waveform::Sine, amplitude));
        let commanded = rig.commanded_next(3, 3 * WAVE);
        assert!(
            commanded
                .iter()
                .all(|angle| (-10.0..=110.0).contains(angle))
        );
        assert!(commanded.contains(&110.0));
    }
    // A joint that a torque holds at its limit is not shaken on.
    let mut rig = Hand::new();
    rig.done(Op::EmgOff, Target::None, &[]);
    rig.done(Op::Torque, J13, &[60.0]);
    rig.idle(1000);
    rig.done(Op::Torque, J13, &[-1.0]);
    rig.sensors.angles[0][2] = 110.0;
    rig.vibrate(J13, vibration(Waveform::Sine, 2.0));
    assert_eq!(rig.commanded_next(3, 1), [0.0]);
}

// clauses: 5.1 7.15 7.48
#[test]
fn set_points_know_nothing_of_vibration() {
    let mut rig = Hand::new();
    rig.done(Op::SetJustAngle, Target::All, &[0.1]);
    rig.done(Op::PtpAngle, J13, &[90.0]);
    rig.idle(1000);
    assert!(rig.controller.inpos(J13));
    rig.vibrate(J13, vibration(Waveform::Sine, 2.0));
    rig.commanded_next(3, 7);
    rig.done(Op::RelPtpAngle, J13, &[1.0]);
    rig.controller.vibrate(J13, None).expect("it stops");
    rig.idle(1000);
    assert!(rig.controller.inpos(J13));
    close(rig.sensors.angles[0][2], 91.0, 1e-9);
}

// clauses: 2.18 7.5 7.48
#[test]
fn vibration_rests_under_all_stop_and_ends_with_the_program() {
    let shaking = |rig: &mut Hand| rig.commanded_next(3, 3).iter().any(|angle| *angle != 80.0);
    let shaken = || {
        let mut rig = Hand::new();
        rig.vibrate(J13, vibration(Waveform::Sine, 2.0));
        assert!(shaking(&mut rig));
        rig
    };
    let mut rig = shaken();
    rig.controller.hold();
    assert!(!shaking(&mut rig));
    rig.controller.release();
    assert!(shaking(&mut rig));

    let mut rig = shaken();
    rig.controller.finish();
    assert!(!shaking(&mut rig));

    let mut rig = shaken();
    rig.controller.emergency();
    let held = rig.commanded_next(3, 3);
    assert!(held.iter().all(|angle| *angle == held[0]));
}

// clauses: 7.48
#[test]
fn only_joints_that_can_vibrate_do() {
    let sound = vibration(Waveform::Sine, 2.0);
    let refused = |target: Target, vibration: Vibration| {
        let commanded = Hand::new().controller.vibrate(target, Some(vibration));
        assert_eq!(commanded, Err(Fault::Domain));
    };
    for target in [F1, Target::All, Target::Joint(4, 1), Target::Joint(1, 4)] {
        refused(target, sound);
    }
    for frequency in [-1.0, f64::INFINITY, f64::NAN] {
        refused(J11, Vibration { frequency, ..sound });
    }
    for amplitude in [f64::INFINITY, f64::NAN] {
        refused(J11, Vibration { amplitude, ..sound });
    }
    let mut walker = Controller::new(&titan8::MODEL);
    let before = walker.outputs();
    assert_eq!(walker.vibrate(J11, Some(sound)), Err(Fault::Domain));
    walker.advance();
    assert_eq!(walker.outputs(), before);
    assert!(matches!(before[0][0], JointCommand::Angle { .. }));
}
