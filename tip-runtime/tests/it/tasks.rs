//! Commands that take several cycles, and teaching.

use crate::rig::{self, Rig, distance};
use tip_runtime::command::{Command, Op, Poll, Port, Target, Teach};
use tip_runtime::fault::Fault;
use tip_runtime::model::titan8;

const F1: Target = Target::Foot(1);
const NONE: Target = Target::None;

// clauses: 2.19 7.14
#[test]
fn sleep_costs_whole_cycles() {
    // Sampling time, SLEEP, cycles.
    for (period, time, cycles) in [
        (20.0, 0.0, 1),
        (20.0, 1.0, 1),
        (20.0, 20.0, 1),
        (20.0, 20.1, 2),
        (20.0, 100.0, 5),
        (20.0, 1000.0, 50),
        (3.0, 10.0, 4),
        (1.1, 3.3, 3),
    ] {
        let mut rig = Rig::titan();
        rig.done(Op::SetSamplingTime, NONE, &[period]);
        assert_eq!(rig.cycles(Op::Sleep, NONE, &[time]), cycles, "{time}");
        assert_eq!(rig.cycles(Op::Sleep, NONE, &[time]), cycles, "again");
    }
    let mut rig = Rig::titan();
    assert_eq!(rig.fault(Op::Sleep, NONE, &[-1e-9]), Fault::Domain);
    assert_eq!(
        rig.run(Op::Sleep, NONE, &rig::absolute(&[1e300])),
        Ok(Poll::Pending)
    );
}

fn v_max(rig: &Rig) -> f64 {
    let mut probe = Rig {
        controller: rig.controller.clone(),
        ..Rig::titan()
    };
    let before = probe.foot(1);
    probe.done_hs(Op::RelPtp, F1, &[0.0, 20.0, 0.0]);
    distance(probe.foot(1), before) / 0.02
}

// clauses: 7.44
#[test]
fn standing_up_pushes_every_foot_down_at_slow_speed() {
    for (op, height) in [
        (Op::StandUp, 60.0),
        (Op::SitDown, -60.0),
        (Op::SitDown, 40.0),
    ] {
        let sign = if op == Op::StandUp { -1.0 } else { 1.0 };
        let mut rig = Rig::titan();
        rig.done(Op::SetVMax, Target::All, &[20.0]);
        let before = [1, 2, 3, 4].map(|leg| rig.foot(leg));
        let command = Command {
            op,
            hs: false,
            target: NONE,
            values: &rig::absolute(&[height]),
        };
        let (mut cycles, mut fastest, mut last) = (0, 0.0_f64, rig.foot(1));
        while rig.run_with(&command) == Ok(Poll::Pending) {
            cycles += 1;
            fastest = fastest.max(distance(rig.foot(1), last) / 0.02);
            last = rig.foot(1);
        }
        // SLOW: 60 mm at 150 mm/s, 600 mm/s² take 0.65 s, 40 mm 0.52 s; not the 2 s of 20 mm/s.
        assert!((20..40).contains(&cycles), "{cycles}");
        assert!(fastest < 150.0 + 1e-6, "{fastest}");
        rig.idle(50);
        assert!((v_max(&rig) - 300.0).abs() < 1e-6, "NORMAL again");
        for (leg, [x, y, z]) in (1..).zip(before) {
            let goal = [x, y, z + sign * height];
            assert!(distance(rig.foot(leg), goal) < 1e-9);
        }
        assert!(rig.controller.near(Target::All), "position control");
    }
}

// clauses: 7.44 2.24
#[test]
fn standing_up_in_motion_settles_first() {
    let mut rig = Rig::titan();
    rig.done(Op::VelControl, F1, &[0.0, 60.0, 0.0]);
    rig.idle(20);
    let from = rig.foot(1);
    rig.cycles(Op::StandUp, NONE, &[50.0]);
    rig.idle(50);
    // 60² / 1200 = 3 mm of braking.
    assert!(distance(rig.foot(1), [from[0], from[1] + 3.0, -250.0]) < 0.01);
}

// clauses: 7.44 2.22
#[test]
fn standing_up_too_high_fails_before_anything_moves() {
    let mut rig = Rig::titan();
    assert_eq!(
        rig.fault(Op::StandUp, NONE, &[300.0]),
        Fault::OutOfReach(F1)
    );
    assert!(!rig.controller.near(F1));
    assert!((v_max(&rig) - 300.0).abs() < 1e-6);
    rig.cycles(Op::StandUp, NONE, &[140.0]);
}

// clauses: 7.44 2.22
#[test]
fn standing_up_while_the_feet_may_hardly_brake_fails_for_want_of_reach() {
    for op in [Op::StandUp, Op::SitDown] {
        let mut rig = Rig::titan();
        rig.done(Op::RelPtp, F1, &[0.0, 60.0, 0.0]);
        rig.idle(5);
        rig.done(Op::SetAMax, Target::All, &[1e-308]);
        assert_eq!(rig.fault(op, NONE, &[10.0]), Fault::OutOfReach(F1));
    }
}

/// Sets the soles to feel the floor below `floor`.
fn feel(rig: &mut Rig, floor: f64) {
    for leg in 1..=4 {
        let feels = rig.foot(leg)[2] <= floor;
        rig.sole(leg, if feels { 1.0 } else { 0.0 });
    }
}

/// Returns the number of cycles until the search is done; `None` if it is not in 20 s.
fn search(rig: &mut Rig, target: Target, way: f64, floor: f64) -> Option<usize> {
    for cycle in 1..1000 {
        feel(rig, floor);
        match rig.run(Op::DetectFloor, target, &rig::absolute(&[way])) {
            Ok(Poll::Done) => return Some(cycle),
            Ok(Poll::Pending) => {}
            Err(_) => return None,
        }
    }
    None
}

// clauses: 7.45
#[test]
fn the_floor_is_found_by_all_legs_at_once_or_in_turn() {
    let mut together = Rig::titan();
    let at_once = search(&mut together, Target::All, 2.0, -260.0).expect("found");
    let mut in_turn = Rig::titan();
    let one_by_one = search(&mut in_turn, Target::All, 1.0, -260.0).expect("found");
    assert!(one_by_one > 3 * at_once);
    for rig in [&mut together, &mut in_turn] {
        rig.idle(20);
        for leg in 1..=4 {
            // At 150 mm/s a foot goes 3 mm in a cycle, and is found in the next.
            let z = rig.foot(leg)[2];
            assert!(z <= -260.0 && z > -267.0, "{z}");
        }
        assert!(rig.controller.near(Target::All), "position control");
    }
}

// clauses: 7.45 7.24
#[test]
fn a_searching_foot_goes_at_slow_speed() {
    for (kind, way) in [(1.0, -3.0), (2.0, -3.0), (3.0, 3.0)] {
        let mut rig = Rig::titan();
        // Soles that search upwards have to feel the floor.
        for leg in 1..=4 {
            rig.sole(leg, if way > 0.0 { 1.0 } else { 0.0 });
        }
        let mut heights = [0.0; 2];
        for _ in 0..20 {
            let poll = rig.run(Op::DetectFloor, F1, &rig::absolute(&[kind]));
            assert_eq!(poll, Ok(Poll::Pending));
            heights = [heights[1], rig.foot(1)[2]];
        }
        // 150 mm/s, after 0.25 s of 600 mm/s².
        assert!((heights[1] - heights[0] - way).abs() < 1e-9, "{heights:?}");
    }
}

// clauses: 7.45
#[test]
fn a_foot_that_has_felt_the_floor_stays_there_whatever_its_sole_reads_later() {
    let mut rig = Rig::titan();
    let mut felt = [0.0; 3];
    for cycle in 1..=30 {
        rig.sole(1, if cycle == 6 { 1.0 } else { 0.0 });
        if cycle == 6 {
            felt = rig.foot(1);
        }
        let poll = rig.run(Op::DetectFloor, Target::All, &rig::absolute(&[2.0]));
        assert_eq!(poll, Ok(Poll::Pending));
    }
    assert!(felt[2] < -202.9 && distance(rig.foot(1), felt) < 1e-9);
    assert!(rig.foot(2)[2] < -250.0, "the others go on");
}

// clauses: 7.45
#[test]
fn legs_in_turn_wait_for_each_other() {
    let mut rig = Rig::titan();
    for _ in 0..10 {
        feel(&mut rig, -260.0);
        let poll = rig.run(Op::DetectFloor, Target::All, &rig::absolute(&[1.0]));
        assert_eq!(poll, Ok(Poll::Pending));
    }
    assert!(rig.foot(1)[2] < -210.0);
    assert_eq!(rig.commanded()[1..], [[0.0, 0.0, 90.0]; 3]);
}

// clauses: 7.45
#[test]
fn one_leg_searches_alone() {
    for way in [1.0, 1.9, 2.0] {
        let mut rig = Rig::titan();
        search(&mut rig, F1, way, -250.0).expect("found");
        assert!(rig.foot(1)[2] <= -250.0);
        assert_eq!(rig.commanded()[1..], [[0.0, 0.0, 90.0]; 3]);
    }
}

// clauses: 7.45
#[test]
fn type_3_lifts_the_feet_until_they_leave_the_floor() {
    let mut rig = Rig::titan();
    search(&mut rig, Target::All, 3.0, -170.0).expect("found");
    rig.idle(20);
    for leg in 1..=4 {
        let z = rig.foot(leg)[2];
        assert!(z > -170.0 && z < -163.0, "{z}");
    }
    assert!(rig.controller.near(Target::All));
}

// clauses: 7.45
#[test]
fn feet_that_touch_already_are_found_at_once() {
    let mut rig = Rig::titan();
    assert_eq!(search(&mut rig, Target::All, 2.0, 0.0), Some(1));
    assert!(rig.controller.inpos(Target::All) && rig.controller.near(Target::All));
    assert_eq!(rig.commanded(), [[0.0, 0.0, 90.0]; 4]);
}

// clauses: 7.45 2.17 7.42
#[test]
fn a_floor_that_is_not_there_is_never_found() {
    let mut rig = Rig::titan();
    rig.done(Op::EmgOff, NONE, &[]);
    assert_eq!(search(&mut rig, Target::All, 2.0, -1000.0), None);
    let mut rig = Rig::titan();
    assert_eq!(search(&mut rig, Target::All, 2.0, -1000.0), None);
}

// clauses: 7.45
#[test]
fn searches_of_another_type_are_outside_the_domain() {
    for way in [0.0, 0.99, 4.0, -1.0, f64::NAN] {
        let mut rig = Rig::titan();
        assert_eq!(
            rig.fault(Op::DetectFloor, Target::All, &[way]),
            Fault::Domain
        );
        assert!(!rig.controller.near(F1));
    }
    let mut rig = Rig::titan();
    rig.sole(1, f64::NAN);
    assert_eq!(
        rig.fault(Op::DetectFloor, F1, &[2.0]),
        Fault::Sensor(Port::Paw(1))
    );
}

// clauses: 7.17 7.18
#[test]
fn teaching_measures_feet_joints_and_angles() {
    let mut rig = Rig::titan();
    rig.done(Op::PtpAngle, Target::Foot(2), &[10.0, 20.0, 80.0]);
    rig.idle(200);
    let teach = |what, target| {
        let taught = rig.controller.teach(what, target)?;
        Ok::<_, Fault>([taught[0], taught[1], taught[2]])
    };
    let foot = teach(Teach::Position, Target::Foot(2)).expect("such a foot");
    assert!(distance(foot, rig.foot(2)) < 1e-9);
    let hip = teach(Teach::Position, Target::Joint(2, 1)).expect("such a joint");
    assert!(distance(hip, titan8::MODEL.legs[1].base) < 1e-9);
    let (sin, cos) = libm::sincos(10_f64.to_radians());
    let thigh = teach(Teach::Position, Target::Joint(2, 2)).expect("such a joint");
    assert!(distance(thigh, [101.0 + 50.0 * cos, 201.0 + 50.0 * sin, 0.0]) < 1e-9);
    let angles = teach(Teach::Angle, Target::Foot(2)).expect("such a leg");
    assert!(distance(angles, [10.0, 20.0, 80.0]) < 1e-9);
    let knee = teach(Teach::Angle, Target::Joint(2, 3)).expect("such a joint");
    assert!((knee[0] - 80.0).abs() < 1e-9);
    for what in [Teach::Position, Teach::Angle] {
        for target in [
            NONE,
            Target::All,
            Target::Floor,
            Target::Foot(5),
            Target::Joint(1, 4),
        ] {
            assert_eq!(teach(what, target), Err(Fault::Domain));
        }
    }
}

// clauses: 7.18 7.19
#[test]
fn titan_senses_no_torque_and_no_force() {
    let rig = Rig::titan();
    for what in [Teach::Torque, Teach::Force] {
        assert_eq!(rig.controller.teach(what, F1), Err(Fault::Domain));
    }
    let mut rig = Rig::generic();
    rig.sensors.torques[0] = [1.0, 2.0, 3.0];
    rig.idle(1);
    let taught = rig.controller.teach(Teach::Torque, F1).expect("torques");
    assert_eq!(taught[..3], [1.0, 2.0, 3.0]);
    let taught = rig
        .controller
        .teach(Teach::Torque, Target::Joint(1, 2))
        .expect("torques");
    assert_eq!(taught[0], 2.0);
}
