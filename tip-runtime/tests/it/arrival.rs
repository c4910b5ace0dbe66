//! INPOS, NEAR and the commands that wait for them.

use crate::rig::Rig;
use tip_runtime::command::{Op, Poll, Target};
use tip_runtime::fault::Fault;

const F1: Target = Target::Foot(1);
const F2: Target = Target::Foot(2);
const J11: Target = Target::Joint(1, 1);
const J12: Target = Target::Joint(1, 2);

/// Returns a robot that takes commands but does not move.
fn still() -> Rig {
    let mut rig = Rig::titan();
    rig.done(Op::SetVMax, Target::All, &[0.0]);
    rig.done(Op::SetOmegaMax, Target::All, &[0.0]);
    rig
}

fn flags(rig: &Rig, target: Target) -> (bool, bool) {
    (rig.controller.inpos(target), rig.controller.near(target))
}

// clauses: 5.1
#[test]
fn with_nothing_controlled_inpos_holds_and_near_does_not() {
    let mut rig = Rig::titan();
    rig.idle(1);
    for target in [Target::All, F1, J11] {
        assert_eq!(flags(&rig, target), (true, false));
    }
    rig.done(Op::OmegaControl, J11, &[1.0]);
    rig.done(Op::VelControl, F2, &[0.0, 0.0, 1.0]);
    for target in [Target::All, F1, J11, F2] {
        assert_eq!(flags(&rig, target), (true, false));
    }
}

// clauses: 5.1 7.21
#[test]
fn a_foot_is_measured_in_mm_by_its_distance() {
    // Distance, JUST (2 mm) and NEAR (10 mm).
    for (off, expected) in [
        ([0.0, 0.0, 1.99], (true, true)),
        ([0.0, 0.0, 2.01], (false, true)),
        ([0.0, 1.5, 1.5], (false, true)),
        ([0.0, 6.0, 7.9], (false, true)),
        ([0.0, 6.0, 8.1], (false, false)),
    ] {
        let mut rig = still();
        let target = [-391.0 + off[0], 201.0 + off[1], -200.0 + off[2]];
        rig.done(Op::Ptp, F1, &target);
        rig.idle(1);
        for target in [F1, Target::All, J11, J12] {
            assert_eq!(flags(&rig, target), expected, "{off:?} {target}");
        }
        assert_eq!(flags(&rig, F2), (true, false));
    }
}

// clauses: 5.1 7.25
#[test]
fn a_joint_is_measured_in_degrees() {
    for (angle, expected) in [
        (0.99, (true, true)),
        (-0.99, (true, true)),
        (1.01, (false, true)),
        (-4.99, (false, true)),
        (5.01, (false, false)),
    ] {
        let mut rig = still();
        rig.done(Op::PtpAngle, J11, &[angle]);
        rig.idle(1);
        // The other joints of the leg are uncontrolled and have no say.
        for target in [J11, F1, Target::All] {
            assert_eq!(flags(&rig, target), expected, "{angle}");
        }
        assert_eq!(flags(&rig, J12), (true, false));
    }
}

// clauses: 5.1
#[test]
fn every_joint_of_a_leg_and_every_leg_has_to_arrive() {
    let mut rig = still();
    rig.done(Op::PtpAngle, J11, &[0.5]);
    rig.done(Op::PtpAngle, J12, &[3.0]);
    rig.done(Op::Ptp, F2, &[391.0, 201.0, -200.0]);
    rig.idle(1);
    assert_eq!(flags(&rig, J11), (true, true));
    assert_eq!(flags(&rig, F1), (false, true));
    assert_eq!(flags(&rig, F2), (true, true));
    assert_eq!(flags(&rig, Target::All), (false, true));
    rig.done(Op::Ptp, F2, &[391.0, 201.0, -150.0]);
    rig.idle(1);
    assert_eq!(flags(&rig, Target::All), (false, false));
}

// clauses: 7.15 7.16 2.17
#[test]
fn waits_end_in_the_cycle_that_finds_the_target_reached() {
    // 50 mm at 600 mm/s²: 0.577 s; 2 mm before its end 0.082 s are left, 10 mm before it 0.183 s.
    for (wait, seconds) in [
        (Op::WaitInpos, 0.577 - 0.082),
        (Op::WaitNear, 0.577 - 0.183),
    ] {
        let mut rig = Rig::titan();
        rig.done(Op::SetSamplingTime, Target::None, &[1.0]);
        rig.done(Op::Ptp, F1, &[-391.0, 201.0, -150.0]);
        let cycles = rig.cycles(wait, F1, &[]) as f64 / 1000.0;
        assert!((cycles - seconds).abs() < 0.002, "{cycles}");
        assert_eq!(rig.cycles(wait, Target::All, &[]), 1);
        assert_eq!(rig.cycles(wait, J12, &[]), 1);
    }
}

// clauses: 7.15 7.16
#[test]
fn waiting_for_what_is_not_controlled() {
    let mut rig = Rig::titan();
    for target in [F1, J11, Target::All] {
        assert_eq!(rig.cycles(Op::WaitInpos, target, &[]), 1);
    }
    assert_eq!(rig.cycles(Op::WaitNear, Target::All, &[]), 1);
    assert_eq!(rig.fault(Op::WaitNear, F1, &[]), Fault::InvalidMode);
    assert_eq!(rig.fault(Op::WaitNear, J11, &[]), Fault::InvalidMode);
    // One controlled joint is enough for its leg, not for its neighbour.
    rig.done(Op::PtpAngle, J11, &[0.0]);
    assert_eq!(rig.run(Op::WaitNear, F1, &[]), Ok(Poll::Done));
    assert_eq!(rig.fault(Op::WaitNear, J12, &[]), Fault::InvalidMode);
}

// clauses: 5.1
#[test]
fn what_is_measured_counts_not_what_is_commanded() {
    let mut rig = Rig::titan();
    rig.stuck[0][0] = true;
    rig.done(Op::PtpAngle, J11, &[20.0]);
    rig.idle(100);
    assert_eq!(rig.commanded()[0][0], 20.0);
    assert_eq!(flags(&rig, J11), (false, false));
    rig.sensors.angles[0][0] = 19.5;
    rig.idle(1);
    assert_eq!(flags(&rig, J11), (true, true));
}
