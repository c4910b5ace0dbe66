//! DETECT_FLOOR and DETECT_OBJECT by touch.

use crate::rig::{F1, Hand, Wall, close};
use tip_runtime::command::{Op, Poll, Target};
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
        let second = (kind >= 2.0).then_some(20.0);
        for n in [1, 2, 3] {
            assert_eq!(rig.told(n), [Some(60.0), second, None]);
        }
        rig.cycles(Op::DetectFloor, ALL, &[kind])
            .expect("there is a floor");
        for (n, at) in [(1, -130.0), (2, -130.0), (3, -126.0)] {
            assert_eq!(rig.told(n), [None; 3]);
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
    assert_eq!(rig.told(1), [None; 3]);
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
            let third = rig.told(n)[2];
            assert_eq!(third.is_some(), kind != 2.0);
        }
        rig.cycles(Op::DetectObject, object, &[kind])
            .expect("there is an object");
        for n in [1, 2, 3] {
            assert_eq!(rig.told(n), [None; 3]);
            close(rig.tip(n)[0].abs(), 100.0, 0.5);
            if kind == 3.0 {
                close(rig.tip(n)[1], heights[n - 1], 1.0);
            }
        }
        assert!(rig.controller.near(ALL));
    }
}
