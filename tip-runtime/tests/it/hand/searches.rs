//! DETECT_FLOOR and DETECT_OBJECT by touch.

use crate::hand::rig::{F1, Hand, Wall, all_close, close, moments, transposed};
use tip_runtime::command::{Command, Op, Poll, Target, Value};
use tip_runtime::fault::Fault;

const ALL: Target = Target::All;

fn floor(at: f64) -> Option<Wall> {
    Some(Wall {
        normal: [0.0, 1.0],
        at,
    })
}

// clauses: 7.45
#[test]
fn fingers_close_until_they_feel_the_floor() {
    for kind in [1.0, 2.0, 2.7] {
        let mut rig = Hand::new();
        rig.walls = [floor(-130.0), floor(-130.0), floor(-126.0)];
        assert_eq!(rig.run(Op::DetectFloor, ALL, &[kind]), Ok(Poll::Pending));
        // Of two joints the one with the longer lever has 60 mN·m: joint 1, whose fingertip is
        // 70 sin 40 + 50 sin 40 − 40 sin 40 = 51.42 mm outside of it, and 6.43 mm outside of joint 2.
        let second = (kind >= 2.0).then_some(60.0 * 6.43 / 51.42);
        for n in [1, 2, 3] {
            let [first, of_second, third] = rig.commanded(n);
            close(first.expect("a torque"), 60.0, 1e-9);
            assert_eq!((of_second.is_some(), third), (second.is_some(), None));
            if let Some((commanded, expected)) = of_second.zip(second) {
                close(commanded, expected, 0.01);
            }
        }
        rig.cycles(Op::DetectFloor, ALL, &[kind])
            .expect("there is a floor");
        for (n, at) in [(1, -130.0), (2, -130.0), (3, -126.0)] {
            assert_eq!(rig.commanded(n), [None; 3]);
            close(rig.tip(n)[1], at, 1.0);
            close(rig.sensors.angles[n - 1][2], 80.0, 1e-9);
        }
        assert!(rig.controller.near(ALL));
    }
}

// clauses: 7.45
#[test]
fn one_finger_searches_alone_and_never_ends_in_the_air() {
    let mut rig = Hand::new();
    rig.walls[0] = floor(-130.0);
    rig.cycles(Op::DetectFloor, F1, &[1.0])
        .expect("there is a floor");
    assert_eq!(rig.sensors.angles[1], [-40.0, 0.0, 80.0]);
    let mut rig = Hand::new();
    rig.done(Op::EmgOff, Target::None, &[]);
    for _ in 0..100 {
        assert_eq!(rig.run(Op::DetectFloor, F1, &[1.0]), Ok(Poll::Pending));
    }
}

// clauses: 7.45 7.46
#[test]
fn other_types_are_refused() {
    let mut rig = Hand::new();
    for kind in [0.0, 0.9, 3.0, -1.0, f64::NAN] {
        assert_eq!(rig.fault(Op::DetectFloor, ALL, &[kind]), Fault::Domain);
    }
    for kind in [0.0, 4.0, 5.0, -1.0] {
        assert_eq!(
            rig.fault(Op::DetectObject, Target::None, &[kind]),
            Fault::Domain
        );
    }
    assert_eq!(rig.commanded(1), [None; 3]);
}

// clauses: 7.46
#[test]
fn fingers_close_until_they_feel_the_object() {
    for kind in [1.0, 2.0, 3.0] {
        let mut rig = Hand::new();
        let heights = [1, 2, 3].map(|n| rig.tip(n)[1]);
        let wall = |normal: f64| {
            Some(Wall {
                normal: [normal, 0.0],
                at: 100.0,
            })
        };
        // Something firm between x = −100 and 100.
        rig.walls = [wall(-1.0), wall(1.0), wall(1.0)];
        let object = Target::None;
        assert_eq!(
            rig.run(Op::DetectObject, object, &[kind]),
            Ok(Poll::Pending)
        );
        for n in [1, 2, 3] {
            let third = rig.commanded(n)[2];
            assert_eq!(third.is_some(), kind != 2.0);
        }
        rig.cycles(Op::DetectObject, object, &[kind])
            .expect("there is an object");
        for n in [1, 2, 3] {
            assert_eq!(rig.commanded(n), [None; 3]);
            close(rig.tip(n)[0].abs(), 100.0, 0.5);
            if kind == 3.0 {
                close(rig.tip(n)[1], heights[n - 1], 1.0);
            }
        }
        assert!(rig.controller.near(ALL));
    }
}

// clauses: 7.46
#[test]
fn the_fingers_of_one_side_share_its_force() {
    for kind in [1.0, 2.0] {
        let mut rig = Hand::new();
        assert_eq!(
            rig.run(Op::DetectObject, Target::None, &[kind]),
            Ok(Poll::Pending)
        );
        // 0.5 N to the right by F1, as much to the left by F2 and F3.
        for (n, force) in [(1, 0.5), (2, -0.25), (3, -0.25)] {
            let chain = Hand::new().chain(n);
            let commanded = rig.commanded(n);
            if kind == 1.0 {
                let expected = transposed(&chain, [force, 0.0, 0.0]);
                all_close(commanded.map(Option::unwrap_or_default), expected, 1e-9);
            } else {
                let third = chain.joint(2).expect("a third joint");
                let expected = moments(&chain, third, [force, 0.0]);
                close(commanded[0].expect("a torque"), expected[0], 1e-9);
                close(commanded[1].expect("a torque"), expected[1], 1e-9);
            }
        }
    }
}

/// Returns the number of cycles until F1, whose joint 1 presses and turns at `rate` (deg/s), is
/// found to have stopped.
fn cycles_at(rate: f64) -> Option<usize> {
    let mut rig = Hand::new();
    // Times and angles without rounding.
    rig.done(Op::SetSamplingTime, Target::None, &[62.5]);
    rig.sensors.torques[0][0] = 10.0;
    let values = [Value::Absolute(1.0)];
    let search = Command {
        op: Op::DetectFloor,
        hs: false,
        target: F1,
        values: &values,
    };
    (1..40).find(|_| {
        rig.sensors.angles[0][0] += rate * 0.0625;
        rig.controller.sense(&rig.sensors).expect("good sensors");
        let poll = rig.controller.command(&search).expect("no fault");
        rig.controller.advance();
        poll == Poll::Done
    })
}

// clauses: 7.45
#[test]
fn a_finger_has_stopped_that_turns_no_faster_than_2_deg_a_second_for_10_cycles() {
    // The cycle before those sets the finger off.
    for rate in [0.0, 2.0, -2.0] {
        assert_eq!(cycles_at(rate), Some(11), "{rate}");
    }
    assert_eq!(cycles_at(2.125), None);
}
