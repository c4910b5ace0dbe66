//! The limits of a robot and their faults.

use crate::rig::{Rig, distance};
use tip_runtime::command::{Op, Target};
use tip_runtime::fault::Fault;

const F1: Target = Target::Foot(1);
const F2: Target = Target::Foot(2);
const J11: Target = Target::Joint(1, 1);

fn emg_off() -> Rig {
    let mut rig = Rig::titan();
    rig.done(Op::EmgOff, Target::None, &[]);
    rig
}

/// Runs cycles without a command until a cycle begins with a fault.
fn idle_to_fault(rig: &mut Rig) -> Fault {
    for _ in 0..2000 {
        if let Err(fault) = rig.tick() {
            return fault;
        }
    }
    panic!("nothing goes wrong");
}

// clauses: 2.22 7.2
#[test]
fn an_unreachable_target_fails_its_own_command_and_changes_nothing() {
    for (op, values) in [
        (Op::Ptp, [100.0, -100.0, 0.0]),
        (Op::Ptp, [-391.0, 201.0, -500.0]),
        (Op::Ptp, [-700.0, 201.0, -200.0]),
        (Op::RelPtp, [0.0, 0.0, -300.0]),
    ] {
        let mut rig = Rig::titan();
        assert_eq!(rig.fault(op, F1, &values), Fault::OutOfReach(F1));
        rig.idle(10);
        assert_eq!(rig.commanded(), [[0.0, 0.0, 90.0]; 4]);
        assert!(!rig.controller.near(F1), "no mode has changed");
    }
    // Full stretch of the knee's working range is still reachable.
    let mut rig = Rig::titan();
    rig.done(Op::Ptp, F1, &[-391.0, 201.0, -330.0]);
}

// clauses: 2.22 7.4
#[test]
fn an_angle_beyond_the_limits_fails_its_own_command() {
    for (joint, low, high) in [(1, -60.0, 60.0), (2, -60.0, 75.0), (3, 5.0, 150.0)] {
        let target = Target::Joint(1, joint);
        for (good, bad) in [(low, low - 0.1), (high, high + 0.1)] {
            let mut rig = Rig::titan();
            let fault = rig.fault(Op::PtpAngle, target, &[bad]);
            assert_eq!(fault, Fault::OutOfReach(target));
            assert!(!rig.controller.near(target), "no mode has changed");
            rig.done(Op::PtpAngle, target, &[good]);
            rig.idle(300);
            assert!(rig.controller.inpos(target));
        }
    }
    let mut rig = Rig::titan();
    let fault = rig.fault(Op::PtpAngle, F1, &[0.0, 0.0, 151.0]);
    assert_eq!(fault, Fault::OutOfReach(Target::Joint(1, 3)));
    assert!(!rig.controller.near(F1));
}

// clauses: 2.22
#[test]
fn leaving_the_reachable_space_on_the_way_is_found_at_the_next_cycle() {
    // 250 mm from the hip the leg reaches ±55 deg of yaw; halfway between, 143 mm from the hip,
    // the knee would have to bend beyond 150 deg.
    let mut rig = Rig::titan();
    rig.done(Op::Ptp, F1, &[-244.4, -3.8, 0.0]);
    rig.cycles(Op::WaitInpos, F1, &[]);
    rig.done(Op::Ptp, F1, &[-244.4, 405.8, 0.0]);
    assert_eq!(idle_to_fault(&mut rig), Fault::OutOfReach(F1));
    let [x, y, z] = rig.foot(1);
    assert!((x + 244.4).abs() < 2.1 && z.abs() < 2.1 && y < 201.0);
    // Under EMG_OFF it stops there.
    let mut rig = emg_off();
    rig.done(Op::Ptp, F1, &[-244.4, -3.8, 0.0]);
    rig.idle(200);
    rig.done(Op::Ptp, F1, &[-244.4, 405.8, 0.0]);
    rig.idle(300);
    let still = rig.foot(1);
    rig.idle(10);
    assert!(distance(rig.foot(1), still) < 1e-9 && still[1] > 50.0 && still[1] < 201.0);
}

// clauses: 2.22 7.42
#[test]
fn a_velocity_into_the_limits_is_an_emergency_or_a_stop() {
    let mut rig = Rig::titan();
    rig.done(Op::VelControl, F2, &[100.0, 0.0, 0.0]);
    assert_eq!(idle_to_fault(&mut rig), Fault::JointLimit(2, 3));

    let mut rig = emg_off();
    rig.done(Op::VelControl, F2, &[100.0, 0.0, 0.0]);
    rig.idle(300);
    let still = rig.foot(2);
    rig.idle(50);
    assert_eq!(rig.foot(2), still);
    // 200 mm of shank and 240 mm of thigh with 5 deg between them reach 439.6 mm.
    let reach = libm::hypot(still[0] - 151.0, still[2]);
    assert!(reach > 437.0 && reach <= 439.61, "{reach}");
    // It can come back.
    rig.done(Op::VelControl, F2, &[-50.0, 0.0, 0.0]);
    rig.idle(50);
    assert!(rig.foot(2)[0] < still[0] - 20.0);
}

// clauses: 7.42
#[test]
fn a_rate_into_a_limit_is_an_emergency_or_a_stop_there() {
    for limit in [60.0, -60.0] {
        let mut rig = Rig::titan();
        let rate = limit / 1.5;
        rig.done(Op::OmegaControl, J11, &[rate]);
        assert_eq!(idle_to_fault(&mut rig), Fault::JointLimit(1, 1));

        let mut rig = emg_off();
        rig.done(Op::OmegaControl, J11, &[rate]);
        rig.done(Op::OmegaControl, Target::Joint(1, 2), &[10.0]);
        rig.idle(200);
        assert_eq!(rig.commanded()[0][0], limit);
        let thigh = rig.commanded()[0][1];
        rig.idle(10);
        assert_eq!(rig.commanded()[0][0], limit);
        assert!(rig.commanded()[0][1] > thigh, "other joints go on");
        rig.done(Op::OmegaControl, J11, &[-rate]);
        rig.idle(20);
        assert!(rig.commanded()[0][0].abs() < 55.0);
    }
}

// clauses: 7.42
#[test]
fn a_joint_does_not_creep_beyond_its_limit() {
    // Each cycle of 1 ms asks for less than what rounding alone may put a joint beyond.
    for (rate, limit) in [(0.000_99, 60.0), (-0.000_99, -60.0)] {
        let mut rig = emg_off();
        rig.done(Op::SetSamplingTime, Target::None, &[1.0]);
        rig.done(Op::PtpAngle, J11, &[limit]);
        rig.idle(2000);
        rig.done(Op::OmegaControl, J11, &[rate]);
        rig.idle(2000);
        assert_eq!(rig.commanded()[0][0], limit);
        assert_eq!(rig.sense(), Ok(()));
    }
    // With the emergency on it is one, as soon as the set point is farther out than rounding puts it.
    let mut rig = Rig::titan();
    rig.done(Op::PtpAngle, J11, &[60.0]);
    rig.idle(200);
    rig.done(Op::OmegaControl, J11, &[0.000_99]);
    assert_eq!(idle_to_fault(&mut rig), Fault::JointLimit(1, 1));
    assert_eq!(rig.commanded()[0][0], 60.0);
}

// clauses: 7.42 2.22
#[test]
fn under_emg_off_a_leg_goes_as_far_as_it_can() {
    let mut rig = emg_off();
    rig.done(Op::Ptp, F2, &[391.0, 201.0, -500.0]);
    rig.idle(300);
    let [x, y, z] = rig.foot(2);
    assert!((x - 391.0).abs() < 1e-6 && (y - 201.0).abs() < 1e-6);
    // √(439.6² − 240²) = 368.3 below the hip.
    assert!(z < -362.0 && z > -368.4, "{z}");
    assert!(!rig.controller.inpos(F2));
    rig.done(Op::PtpAngle, J11, &[80.0]);
    rig.idle(300);
    assert_eq!(rig.commanded()[0][0], 60.0);
    assert!(!rig.controller.inpos(J11));
    // EMG_ON is not an emergency for a joint that stands at its limit.
    rig.done(Op::RelPtpAngle, J11, &[0.0]);
    rig.done(Op::RelPtp, F2, &[0.0; 3]);
    rig.done(Op::EmgOn, Target::None, &[]);
    rig.idle(10);
    assert_eq!(
        rig.fault(Op::PtpAngle, J11, &[80.0]),
        Fault::OutOfReach(J11)
    );
}

// clauses: 7.42 2.22
#[test]
fn measured_joints_may_leave_the_working_limits_only_under_emg_off() {
    for (angle, emg_on, emg_off) in [
        (60.0, false, false),
        (60.1, true, false),
        (65.0, true, false),
        (65.1, true, true),
        (-65.1, true, true),
    ] {
        for (op, expected) in [(Op::EmgOn, emg_on), (Op::EmgOff, emg_off)] {
            let mut rig = Rig::titan();
            rig.done(op, Target::None, &[]);
            rig.stuck[0][0] = true;
            rig.sensors.angles[0][0] = angle;
            let found = rig.sense();
            let fault = Err(Fault::JointLimit(1, 1));
            assert_eq!(found, if expected { fault } else { Ok(()) }, "{angle}");
        }
    }
    // The knee has no room below 0.
    let mut rig = emg_off();
    rig.stuck[3][2] = true;
    rig.sensors.angles[3][2] = -0.1;
    assert_eq!(rig.sense(), Err(Fault::JointLimit(4, 3)));
}

// clauses: 2.22
#[test]
fn a_sensor_that_reads_nonsense_is_a_fault_and_leaves_the_last_angle() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let mut rig = Rig::titan();
        rig.idle(1);
        rig.stuck[1][2] = true;
        rig.sensors.angles[1][2] = bad;
        assert_eq!(rig.sense(), Err(Fault::JointSensor(2, 3)));
        rig.controller.emergency();
        assert_eq!(rig.commanded(), [[0.0, 0.0, 90.0]; 4]);
    }
}

// clauses: 2.21 2.22
#[test]
fn operands_whose_sum_is_not_finite_are_outside_the_domain() {
    let mut rig = emg_off();
    rig.done(Op::Ptp, F1, &[1e308, 0.0, 0.0]);
    assert_eq!(rig.fault(Op::RelPtp, F1, &[1e308, 0.0, 0.0]), Fault::Domain);
    rig.idle(10);
    assert!(distance(rig.foot(1), [-391.0, 201.0, -200.0]) < 400.0);
}

/// Returns the distance of the commanded foot F1 from the line between two places, mm.
fn off_line(rig: &Rig, [from, to]: [[f64; 3]; 2]) -> f64 {
    let [along, off] = [to, rig.foot(1)].map(|at| [0, 1, 2].map(|i| at[i] - from[i]));
    let dot = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let share = dot(along, off) / dot(along, along);
    distance(off, along.map(|part| part * share))
}

/// Returns a leg folded over its hip: 16 mm in front of the yaw axis.
fn folded() -> Rig {
    let mut rig = Rig::titan();
    rig.done(Op::PtpAngle, F1, &[0.0, -50.0, 110.0]);
    rig.idle(200);
    rig
}

// clauses: 7.2
#[test]
fn a_foot_passes_under_its_hip_along_a_straight_line() {
    let mut rig = folded();
    let [x, y, z] = rig.foot(1);
    assert!(x < -117.0 && z < -250.0, "in front of the axis: {x} {z}");
    let target = [-101.0 + 15.0, y, z];
    rig.done(Op::Ptp, F1, &target);
    let mut yaws = 0.0_f64;
    for _ in 0..200 {
        rig.idle(1);
        assert!(off_line(&rig, [[x, y, z], target]) < 1e-6);
        yaws = yaws.max(rig.commanded()[0][0].abs());
    }
    assert!(distance(rig.foot(1), target) < 1e-6);
    assert!(
        yaws < 1e-6,
        "the leg swings under its hip and does not turn: {yaws}"
    );
    // From there it goes on, and back.
    rig.done(Op::RelPtp, F1, &[5.0, 3.0, 0.0]);
    rig.idle(200);
    rig.done(Op::Ptp, F1, &target);
    rig.idle(200);
    rig.done(Op::Ptp, F1, &[x, y, z]);
    rig.idle(200);
    assert!(distance(rig.foot(1), [x, y, z]) < 1e-6);
}

// clauses: 2.22 7.2
#[test]
fn a_foot_does_not_leap_past_its_hip() {
    let mut rig = folded();
    let [x, y, z] = rig.foot(1);
    // The line passes the yaw axis at 1 mm: between two cycles the leg would have to turn round by nearly half a turn.
    let target = [-101.0 + 15.0, y + 2.0, z];
    rig.done(Op::Ptp, F1, &target);
    let mut before = rig.commanded()[0];
    for _ in 0..200 {
        let ticked = rig.tick();
        let now = rig.commanded()[0];
        for (before, now) in before.iter().zip(now) {
            assert!((now - before).abs() < 40.0, "{before} {now}");
        }
        assert!(off_line(&rig, [[x, y, z], target]) < 1e-6);
        before = now;
        if let Err(fault) = ticked {
            assert_eq!(fault, Fault::OutOfReach(F1));
            return;
        }
    }
    panic!("it leapt to {:?}", rig.foot(1));
}
