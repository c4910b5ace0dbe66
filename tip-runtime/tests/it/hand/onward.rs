//! Points that are sent on while the joints of their finger still turn, each independently.

use crate::hand::paths::search::{Place, fingertip_goes, third_joint_goes};
use crate::hand::paths::{End, go_on, of_finger, resting};
use crate::hand::rig::{F1, Hand, J13, all_close};
use tip_runtime::command::{Op, Target};
use tip_runtime::random::Random;

/// A function that returns true if a point can go straight from a posture to a place.
type Goes = fn([f64; 3], Place) -> bool;

/// Lines from each posture and moment.
const LINES: usize = 4;

/// The start posture of most fingers.
const INITIAL: [f64; 3] = [-40.0, 0.0, 80.0];

/// Returns the finger on its way to a posture, as soon as its joints are within 5 (NEAR) or 1 deg
/// (JUST) of it.
fn arriving(posture: [f64; 3], wait: Op) -> Hand {
    let mut rig = resting(1, INITIAL);
    rig.done(Op::PtpAngle, F1, &posture);
    rig.cycles(wait, F1, &[]).expect("it arrives");
    rig
}

/// Returns the angles at which the joints come to rest after immediate braking.
fn rest(mut rig: Hand) -> [f64; 3] {
    rig.done(Op::RelPtpAngle, F1, &[0.0; 3]);
    rig.idle(500);
    rig.sensors.angles[0]
}

// clauses: 2.24 7.2
#[test]
fn a_point_whose_joints_still_turn_arrives_wherever_it_does_from_rest() {
    let mut random = Random::new(0x2545_F491_4F6C_DD1D);
    let points: [(Target, f64, Goes); 2] =
        [(F1, 160.0, fingertip_goes), (J13, 120.0, third_joint_goes)];
    for (point, reach, goes) in points {
        // Stretched from base to tip, up to joint 3, and bent.
        for posture in [[0.0, 0.0, 0.0], [-20.0, 0.0, 40.0], [-30.0, 40.0, 40.0]] {
            for wait in [Op::WaitNear, Op::WaitInpos] {
                let start = rest(arriving(posture, wait));
                let mut lines = 0;
                while lines < LINES {
                    let place = [random.within(-reach, reach), random.within(-reach, 0.0)];
                    if goes(start, place) {
                        let end = go_on(&mut arriving(posture, wait), 1, point, place);
                        let line = format!("{point:?} {posture:?} {wait:?} {place:?}");
                        assert_eq!(end, End::Arrived, "{line}");
                        lines += 1;
                    }
                }
            }
        }
    }
}

// clauses: 2.24 7.2
#[test]
fn joints_brake_no_harder_than_they_may_before_their_point_sets_off() {
    let mut rig = arriving([0.0; 3], Op::WaitInpos);
    let mut angles = vec![rig.sensors.angles[0]];
    rig.idle(1);
    angles.push(rig.sensors.angles[0]);
    rig.done(Op::Ptp, F1, &of_finger(1, [-40.0, -120.0]));
    for _ in 0..10 {
        angles.push(rig.sensors.angles[0]);
        rig.idle(1);
    }
    let bends =
        |[before, at, after]: [[f64; 3]; 3]| [0, 1, 2].map(|m| after[m] - 2.0 * at[m] + before[m]);
    // Joint 3 still turns by 25 deg/s, and brakes by 360 deg/s² in cycles of 2 ms.
    assert!(angles[1][2] - angles[0][2] < -0.05, "{angles:?}");
    for three in angles.windows(3) {
        let bends = bends([three[0], three[1], three[2]]);
        assert!(
            bends
                .iter()
                .all(|bend| bend.abs() < 360.0 * 0.002 * 0.002 + 1e-9),
            "{bends:?}"
        );
    }
    rig.cycles(Op::WaitInpos, F1, &[]).expect("it arrives");
}

// clauses: 2.24 7.3
#[test]
fn a_stop_at_full_stretch_is_where_the_joints_come_to_rest() {
    for (point, posture) in [(F1, [0.0; 3]), (J13, [-20.0, 0.0, 40.0])] {
        let start = rest(arriving(posture, Op::WaitNear));
        let mut rig = arriving(posture, Op::WaitNear);
        rig.done(Op::RelPtp, point, &[0.0; 3]);
        // A second stop changes nothing.
        rig.idle(3);
        rig.done(Op::RelPtp, point, &[0.0; 3]);
        rig.idle(500);
        assert!(rig.controller.inpos(point));
        all_close(rig.sensors.angles[0], start, 1e-3);
    }
}
