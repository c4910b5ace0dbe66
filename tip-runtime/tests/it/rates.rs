//! The rate that comes with each angle.

use crate::rig::Rig;
use tip_runtime::command::{Op, Target, Value};
use tip_runtime::hardware::JointCommand;

const F1: Target = Target::Foot(1);
const J11: Target = Target::Joint(1, 1);

/// The sampling time: s.
const DT: f64 = 0.02;

/// Returns the commanded rates, deg/s.
fn rates(rig: &Rig) -> [[f64; 3]; 4] {
    rig.controller.outputs().map(|leg| {
        leg.map(|command| match command {
            JointCommand::Angle { rate, .. } => rate,
            JointCommand::Torque(_) => panic!("a torque"),
        })
    })
}

/// Returns the angle of a joint after `t` s of a 45 deg move at 90 deg/s and 360 deg/s²: 0.25 s up,
/// 22.5 deg in 0.25 s, 0.25 s down.
fn trapezium(t: f64) -> f64 {
    match t {
        t if t <= 0.25 => 180.0 * t * t,
        t if t <= 0.5 => 11.25 + 90.0 * (t - 0.25),
        t if t <= 0.75 => 45.0 - 180.0 * (0.75 - t) * (0.75 - t),
        _ => 45.0,
    }
}

#[test]
fn a_joint_turns_at_the_rates_of_its_trapezium() {
    let mut rig = Rig::titan();
    let start = rig.commanded()[0][0];
    rig.done(Op::PtpAngle, J11, &[start + 45.0]);
    for cycle in 1..=45 {
        let t = f64::from(cycle) * DT;
        let expected = (trapezium(t) - trapezium(t - DT)) / DT;
        let rate = rates(&rig)[0][0];
        assert!((rate - expected).abs() < 1e-9, "{cycle}: {rate}");
        rig.idle(1);
    }
    // It cruised at OMEGA_MAX, and has come to rest by now.
    assert_eq!(rates(&rig), [[0.0; 3]; 4]);
}

#[test]
fn joints_of_a_moving_foot_turn_from_angle_to_angle() {
    let mut rig = Rig::titan();
    let [x, y, z] = rig.foot(1);
    let before = rig.commanded()[0];
    rig.done(Op::Ptp, F1, &[x + 20.0, y - 40.0, z + 30.0]);
    let mut angles = before;
    let mut fastest = 0.0_f64;
    for _ in 0..100 {
        let (now, rates) = (rig.commanded()[0], rates(&rig)[0]);
        for ((angle, now), rate) in angles.iter_mut().zip(now).zip(rates) {
            *angle += rate * DT;
            assert!((*angle - now).abs() < 1e-9);
            fastest = fastest.max(rate.abs());
        }
        rig.idle(1);
    }
    assert!(fastest > 10.0, "{fastest}");
    assert_eq!(rates(&rig)[0], [0.0; 3]);
}

#[test]
fn a_velocity_is_kept_until_the_joint_is_stopped_at_its_limit() {
    let mut rig = Rig::titan();
    rig.done(Op::EmgOff, Target::None, &[]);
    assert!(
        rig.run(Op::OmegaControl, J11, &[Value::Absolute(30.0)])
            .is_ok()
    );
    // 30 deg/s are reached after 1/12 s, five cycles.
    rig.idle(10);
    assert!((rates(&rig)[0][0] - 30.0).abs() < 1e-9);
    rig.idle(1000);
    assert_eq!(rates(&rig)[0][0], 0.0);
}
