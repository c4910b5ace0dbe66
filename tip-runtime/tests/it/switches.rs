//! Switches of joints in edition 3.2: DIRECT, LOCK, working limits.

use crate::rig::{Rig, absolute, distance};
use tip_runtime::command::{Command, Op, Poll, Target};
use tip_runtime::controller::Controller;
use tip_runtime::fault::Fault;
use tip_runtime::hardware::{JointCommand, Sensors};
use tip_runtime::model::hand;

const ALL: Target = Target::All;
const F1: Target = Target::Foot(1);
const J11: Target = Target::Joint(1, 1);
const J12: Target = Target::Joint(1, 2);
const J13: Target = Target::Joint(1, 3);

fn titan(setup: &[(Op, Target, &[f64])]) -> Rig {
    let mut rig = Rig::titan();
    for (op, target, values) in setup {
        rig.done(*op, *target, values);
    }
    rig
}

/// A hand whose joints stay where they were at first, whatever they are told.
struct Still(Controller<3, 3>, Sensors<3, 3>);

impl Still {
    fn hand() -> Self {
        let angles = hand::MODEL.legs.map(|finger| finger.initial);
        let slider = [0.0, -130.0, 0.0];
        let sensors = Sensors {
            angles,
            slider,
            ..Sensors::ZERO
        };
        Still(Controller::new(&hand::MODEL), sensors)
    }

    fn run(&mut self, op: Op, target: Target, values: &[f64]) -> Result<Poll, Fault> {
        self.0.sense(&self.1)?;
        let values = &absolute(values);
        let poll = self.0.command(&Command {
            op,
            hs: false,
            target,
            values,
        })?;
        self.0.advance();
        Ok(poll)
    }

    fn done(&mut self, op: Op, target: Target, values: &[f64]) {
        assert_eq!(
            self.run(op, target, values),
            Ok(Poll::Done),
            "{op} {target}"
        );
    }

    /// Returns true for each joint of finger 1 that is told a torque.
    fn soft(&self, finger: usize) -> [bool; 3] {
        self.0.outputs()[finger - 1].map(|command| matches!(command, JointCommand::Torque(_)))
    }
}

// clauses: 16.1
#[test]
fn a_direct_joint_is_at_its_target_in_the_cycle_of_its_command() {
    let mut rig = titan(&[(Op::Direct, J11, &[])]);
    rig.done(Op::PtpAngle, J11, &[10.0]);
    assert_eq!(rig.commanded()[0], [10.0, 0.0, 90.0]);
    // The others keep their limits: ½ · 360 · 0.02² deg in the first cycle.
    rig.done(Op::PtpAngle, J12, &[10.0]);
    assert!((rig.commanded()[0][1] - 0.072).abs() < 1e-12);
    // The word decides: F1 is not switched, though its joint is.
    rig.done(Op::PtpAngle, F1, &[20.0, 0.0, 90.0]);
    assert!((rig.commanded()[0][0] - 10.072).abs() < 1e-9);
    rig.done(Op::Trajectory, J11, &[]);
    rig.idle(100);
    rig.done(Op::PtpAngle, J11, &[0.0]);
    assert!((rig.commanded()[0][0] - 19.928).abs() < 1e-9);
}

// clauses: 16.1
#[test]
fn a_direct_foot_and_its_joints_jump_and_stay() {
    for target in [F1, ALL] {
        let mut rig = titan(&[(Op::Direct, target, &[])]);
        let place = [-371.0, 221.0, -180.0];
        rig.done(Op::Ptp, F1, &place);
        assert!(distance(rig.foot(1), place) < 1e-9);
        let there = rig.commanded();
        rig.idle(3);
        assert_eq!(rig.commanded(), there);
        assert!(rig.controller.inpos(F1));
        rig.done(Op::RelPtp, F1, &[0.0, 0.0, 10.0]);
        assert!(distance(rig.foot(1), [-371.0, 221.0, -170.0]) < 1e-9);
        rig.done(Op::PtpAngle, J13, &[80.0]);
        assert_eq!(rig.commanded()[0][2], 80.0);
    }
}

// clauses: 16.1
#[test]
fn motions_under_way_end_as_they_began_and_trajectory_starts_from_rest() {
    let mut rig = titan(&[(Op::PtpAngle, J11, &[30.0])]);
    rig.done(Op::Direct, J11, &[]);
    // 0.072 · 4 after two cycles.
    assert!((rig.commanded()[0][0] - 0.288).abs() < 1e-9);
    rig.done(Op::PtpAngle, J11, &[-20.0]);
    rig.done(Op::Trajectory, J11, &[]);
    assert_eq!(rig.commanded()[0][0], -20.0);
    rig.done(Op::PtpAngle, J11, &[-10.0]);
    assert!((rig.commanded()[0][0] + 19.928).abs() < 1e-9);
}

// clauses: 16.1
#[test]
fn a_direct_stop_stops_at_the_present_set_point() {
    let mut rig = titan(&[(Op::PtpAngle, J11, &[30.0])]);
    rig.idle(3);
    rig.done(Op::Direct, J11, &[]);
    let before = rig.commanded()[0][0];
    rig.done(Op::RelPtpAngle, J11, &[0.0]);
    assert_eq!(rig.commanded()[0][0], before);
}

// clauses: 16.1
#[test]
fn the_release_of_a_stop_keeps_its_limits() {
    let mut rig = titan(&[(Op::Direct, ALL, &[]), (Op::AllStop, Target::None, &[])]);
    rig.done(Op::PtpAngle, J11, &[10.0]);
    assert_eq!(rig.commanded()[0][0], 0.0);
    rig.done(Op::AllStopRelease, Target::None, &[]);
    assert!((rig.commanded()[0][0] - 0.072).abs() < 1e-12);
}

// clauses: 16.1
#[test]
fn a_direct_target_out_of_reach_fails_as_ever() {
    let mut rig = titan(&[(Op::Direct, ALL, &[])]);
    assert_eq!(
        rig.fault(Op::PtpAngle, J11, &[61.0]),
        Fault::OutOfReach(J11)
    );
    let far = [100.0, -100.0, 0.0];
    assert_eq!(rig.fault(Op::Ptp, F1, &far), Fault::OutOfReach(F1));
    assert_eq!(rig.fault(Op::Direct, Target::Floor, &[]), Fault::Domain);
}

// clauses: 16.1
#[test]
fn a_direct_spring_pulls_from_its_target_at_once() {
    let mut hand = Still::hand();
    hand.done(Op::Direct, J13, &[]);
    hand.done(
        Op::ComplianceAngle,
        J13,
        &[hand::MODEL.legs[0].initial[2] + 5.0],
    );
    let JointCommand::Torque(torque) = hand.0.outputs()[0][2] else {
        panic!("a spring commands a torque");
    };
    let stiffness = hand::MODEL.forces.expect("it has forces").angle_stiffness;
    assert!((torque - 5.0 * stiffness).abs() < 1e-9);
}

// clauses: 16.1 16.2 16.3
#[test]
fn the_initial_posture_puts_every_switch_back() {
    let mut rig = titan(&[
        (Op::Direct, ALL, &[]),
        (Op::Lock, F1, &[]),
        (Op::SetLimit, J11, &[-10.0, 10.0]),
        (Op::InitialPosture, Target::None, &[]),
    ]);
    rig.done(Op::PtpAngle, J11, &[30.0]);
    assert!((rig.commanded()[0][0] - 0.072).abs() < 1e-9);
}

// clauses: 16.2
#[test]
fn what_would_change_a_locked_joint_is_refused() {
    let place = [-391.0, 201.0, -200.0];
    for (op, target, values) in [
        (Op::Ptp, F1, &place[..]),
        (Op::RelPtp, F1, &[0.0; 3]),
        (Op::PtpAngle, F1, &[0.0, 0.0, 90.0]),
        (Op::PtpAngle, J12, &[0.0]),
        (Op::VelControl, F1, &[0.0; 3]),
        (Op::OmegaControl, J12, &[0.0]),
        (Op::Direct, F1, &[]),
        (Op::Direct, J12, &[]),
        (Op::Trajectory, J12, &[]),
        (Op::StandUp, Target::None, &[5.0]),
        (Op::SitDown, Target::None, &[5.0]),
        (Op::DetectFloor, F1, &[1.0]),
        (Op::DetectFloor, ALL, &[2.0]),
    ] {
        let mut rig = titan(&[(Op::Lock, J12, &[])]);
        assert_eq!(rig.fault(op, target, values), Fault::InvalidMode, "{op}");
        let mut rig = titan(&[(Op::Lock, ALL, &[]), (Op::Unlock, J12, &[])]);
        rig.done(Op::Unlock, ALL, &[]);
        assert!(rig.run(op, target, &absolute(values)).is_ok(), "{op}");
    }
    // Neighbours, waits, parameters and stops are free.
    let mut rig = titan(&[(Op::Lock, J12, &[])]);
    for (op, target, values) in [
        (Op::PtpAngle, J11, &[1.0][..]),
        (Op::Ptp, Target::Foot(2), &[391.0, 201.0, -190.0]),
        (Op::SetOmegaMax, J12, &[10.0]),
        (Op::SetLimit, J12, &[-10.0, 10.0]),
        (Op::WaitInpos, J12, &[]),
        (Op::Direct, ALL, &[]),
        (Op::AllStop, Target::None, &[]),
        (Op::AllStopRelease, Target::None, &[]),
    ] {
        rig.done(op, target, values);
    }
    // DIRECT ALL passed over the locked joint and its foot.
    rig.done(Op::Unlock, ALL, &[]);
    rig.done(Op::PtpAngle, J12, &[5.0]);
    assert!(rig.commanded()[0][1] < 1.0);
    rig.done(Op::PtpAngle, J13, &[80.0]);
    assert_eq!(rig.commanded()[0][2], 80.0);
    rig.done(Op::PtpAngle, F1, &[20.0, 5.0, 80.0]);
    assert!(rig.commanded()[0][0] < 2.0);
}

// clauses: 16.2
#[test]
fn an_operand_out_of_its_domain_comes_before_a_lock() {
    let mut rig = titan(&[(Op::Lock, ALL, &[])]);
    assert_eq!(rig.fault(Op::DetectFloor, F1, &[4.0]), Fault::Domain);
    let far = [100.0, -100.0, 0.0];
    assert_eq!(rig.fault(Op::Ptp, F1, &far), Fault::InvalidMode);
}

// clauses: 16.2
#[test]
fn a_joint_under_a_foot_mode_needs_the_whole_leg() {
    let mut rig = titan(&[
        (Op::Ptp, F1, &[-391.0, 201.0, -190.0]),
        (Op::Lock, J12, &[]),
    ]);
    assert_eq!(rig.fault(Op::PtpAngle, J11, &[1.0]), Fault::InvalidMode);
    // The motion under way goes on to its target.
    rig.idle(100);
    assert!(distance(rig.foot(1), [-391.0, 201.0, -190.0]) < 1e-9);
}

// clauses: 16.2
/// [16.2]: a lock is checked after domains ([2.21]).
#[test]
fn a_result_that_is_not_finite_comes_before_a_lock() {
    const HUGE: f64 = 1.7e308;
    let mut rig = titan(&[
        (Op::EmgOff, Target::None, &[]),
        (Op::PtpAngle, J11, &[HUGE]),
        (Op::Lock, ALL, &[]),
    ]);
    assert_eq!(rig.fault(Op::RelPtpAngle, J11, &[HUGE]), Fault::Domain);
    assert_eq!(rig.fault(Op::RelPtpAngle, J11, &[1.0]), Fault::InvalidMode);
}

// clauses: 16.2
#[test]
fn compliance_of_all_passes_over_what_is_locked() {
    let mut hand = Still::hand();
    hand.done(Op::Lock, J12, &[]);
    let [angles, ..] = hand::MODEL.legs.map(|finger| finger.initial);
    hand.done(Op::ComplianceAngle, ALL, &angles);
    assert_eq!(hand.soft(1), [true, false, true]);
    assert_eq!(hand.soft(2), [true; 3]);

    let mut hand = Still::hand();
    hand.done(Op::Lock, J12, &[]);
    hand.done(Op::CompliancePosition, ALL, &[0.0, -100.0, 0.0]);
    assert_eq!(hand.soft(1), [false; 3]);
    assert_eq!(hand.soft(2), [true; 3]);
    let fault = hand.run(Op::ComplianceAngle, F1, &angles);
    assert_eq!(fault, Err(Fault::InvalidMode));
    hand.done(Op::NoCompliance, Target::Foot(2), &[]);
    assert_eq!(
        hand.run(Op::NoCompliance, J12, &[]),
        Err(Fault::InvalidMode)
    );

    // A leg under a foot mode cannot give single joints.
    let mut hand = Still::hand();
    hand.done(Op::CompliancePosition, ALL, &[0.0, -100.0, 0.0]);
    hand.done(Op::Lock, J12, &[]);
    hand.done(Op::ComplianceAngle, ALL, &angles);
    hand.done(Op::Unlock, J12, &[]);
    hand.done(Op::NoCompliance, J13, &[]);
    assert_eq!(hand.soft(1), [false; 3], "its foot was still pulled");
    assert_eq!(hand.soft(2), [true; 3]);
}

// clauses: 16.2
#[test]
fn a_point_of_a_finger_needs_the_joints_before_it() {
    let third = |hand: &mut Still| hand.run(Op::Force, J13, &[0.0; 3]);
    for (locked, refused) in [
        (J11, true),
        (J12, true),
        (J13, true),
        (Target::Joint(2, 1), false),
    ] {
        let mut hand = Still::hand();
        hand.done(Op::Lock, locked, &[]);
        assert_eq!(third(&mut hand).is_err(), refused, "{locked}");
    }
    // Joint 3 of a finger whose third point is controlled goes for itself; naming it takes the others.
    let mut hand = Still::hand();
    assert_eq!(third(&mut hand), Ok(Poll::Done));
    hand.done(Op::Lock, J11, &[]);
    assert_eq!(hand.run(Op::Torque, J13, &[0.0]), Err(Fault::InvalidMode));
    let mut hand = Still::hand();
    hand.done(Op::Lock, J11, &[]);
    let detect = hand.run(Op::DetectObject, Target::None, &[1.0]);
    assert_eq!(detect, Err(Fault::InvalidMode));
}

// clauses: 16.3
#[test]
fn working_limits_lie_inside_those_of_the_robot() {
    let mut rig = Rig::titan();
    for (target, values) in [
        (J11, &[-61.0, 0.0][..]),
        (J11, &[0.0, 60.5]),
        (J11, &[5.0, 5.0]),
        (J11, &[6.0, 5.0]),
        (J11, &[5.0]),
        (F1, &[-10.0, -10.0, 4.0, 10.0, 10.0, 100.0]),
        (ALL, &[-10.0, 10.0]),
    ] {
        assert_eq!(
            rig.fault(Op::SetLimit, target, values),
            Fault::Domain,
            "{values:?}"
        );
    }
    // Nothing of a refused one holds.
    rig.done(Op::PtpAngle, J11, &[20.0]);
    rig.done(Op::SetLimit, F1, &[-60.0, -60.0, 5.0, 60.0, 75.0, 150.0]);
    rig.done(Op::SetLimit, J11, &[-30.0, 30.0]);
    assert_eq!(
        rig.fault(Op::PtpAngle, J11, &[31.0]),
        Fault::OutOfReach(J11)
    );
    // Each replaces the last one.
    rig.done(Op::SetLimit, J11, &[-40.0, 40.0]);
    rig.done(Op::PtpAngle, J11, &[31.0]);
    rig.idle(200);
    rig.done(Op::ResetLimit, F1, &[]);
    rig.done(Op::PtpAngle, J11, &[60.0]);
}

// clauses: 16.3
#[test]
fn a_foot_and_a_velocity_end_at_new_limits_as_at_the_robots_own() {
    let mut rig = titan(&[(Op::SetLimit, J13, &[5.0, 95.0])]);
    // Folding the knee further than 95 deg is what this place takes.
    assert_eq!(
        rig.fault(Op::Ptp, F1, &[-341.0, 201.0, -200.0]),
        Fault::OutOfReach(F1)
    );
    let mut rig = titan(&[
        (Op::SetLimit, J11, &[-60.0, 10.0]),
        (Op::OmegaControl, J11, &[30.0]),
    ]);
    let fault = (0..200).find_map(|_| rig.tick().err());
    assert_eq!(fault, Some(Fault::JointLimit(1, 1)));
    assert_eq!(rig.commanded()[0][0], 10.0);
    let mut rig = titan(&[
        (Op::EmgOff, Target::None, &[]),
        (Op::SetLimit, J11, &[-60.0, 10.0]),
        (Op::OmegaControl, J11, &[30.0]),
    ]);
    rig.idle(200);
    assert_eq!(rig.commanded()[0][0], 10.0);
}

// clauses: 16.3
#[test]
fn a_joint_outside_new_limits_may_hold_or_come_back_once() {
    // At 20 deg, with limits of 0 to 10 deg: no emergency.
    let outside = || {
        let mut rig = titan(&[(Op::PtpAngle, J11, &[20.0])]);
        rig.idle(100);
        rig.done(Op::SetLimit, J11, &[0.0, 10.0]);
        rig.idle(5);
        rig
    };
    let mut rig = outside();
    assert_eq!(
        rig.fault(Op::PtpAngle, J11, &[20.0]),
        Fault::OutOfReach(J11)
    );
    // Farther out is a limit.
    let mut rig = outside();
    rig.done(Op::OmegaControl, J11, &[5.0]);
    let fault = (0..10).find_map(|_| rig.tick().err());
    assert_eq!(fault, Some(Fault::JointLimit(1, 1)));
    assert_eq!(rig.commanded()[0][0], 20.0);
    // A foot holds with it, and moves along postures that bring it in.
    let mut rig = outside();
    let place = rig.foot(1);
    rig.done(Op::VelControl, F1, &[0.0; 3]);
    rig.idle(5);
    assert!(distance(rig.foot(1), place) < 1e-9);
    // Once inside, it is as any other.
    let mut rig = outside();
    rig.done(Op::PtpAngle, J11, &[9.0]);
    rig.idle(100);
    rig.done(Op::OmegaControl, J11, &[5.0]);
    let fault = (0..100).find_map(|_| rig.tick().err());
    assert_eq!(fault, Some(Fault::JointLimit(1, 1)));
    assert_eq!(rig.commanded()[0][0], 10.0);
}

// clauses: 16.4
#[test]
fn stiffness_takes_a_finger_and_every_joint_of_it() {
    let mut hand = Still::hand();
    hand.done(Op::SetAngleStiffness, F1, &[1.0, 2.0, 3.0]);
    hand.done(Op::SetAngleStiffness, ALL, &[4.0]);
    hand.done(Op::SetPositionStiffness, ALL, &[0.1, 0.2, -5.0]);
    for (op, values) in [
        (Op::SetAngleStiffness, [1.0, -2.0, 3.0]),
        (Op::SetPositionStiffness, [0.1, -0.2, 0.0]),
    ] {
        assert_eq!(hand.run(op, F1, &values), Err(Fault::Domain));
    }
}
