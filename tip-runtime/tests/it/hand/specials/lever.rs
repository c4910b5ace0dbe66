//! Lever motion: SPECIAL 1 and 2.

use super::bench::Bench;
use crate::hand::rig::{J11, J13, close, moments};
use tip_runtime::command::{Op, Target};

/// Returns the end of finger `n`'s second link, mm.
fn end(bench: &Bench, n: usize) -> [f64; 3] {
    let chain = bench.robot.hand.chain(n);
    chain.joint(2).expect("three joints")
}

fn carry_on(bench: &mut Bench, stiffness: f64, cycles: usize) {
    for _ in 0..cycles {
        bench.done(2, &[stiffness]);
    }
}

// clauses: 7.43 7.48
#[test]
fn a_spring_draws_the_second_link_to_the_middle() {
    let mut bench = Bench::new();
    bench.done(1, &[]);
    bench.done(2, &[3.0]);
    for n in 1..=3 {
        // 3 N/m over the distance, and no force along the height that is still the one remembered.
        let at = end(&Bench::new(), n);
        let force = [-0.003 * at[0], 0.0];
        let expected = moments(&Bench::new().robot.hand.chain(n), at, force);
        let commanded = bench.robot.hand.commanded(n);
        close(commanded[0].expect("a torque"), expected[0], 1e-9);
        close(commanded[1].expect("a torque"), expected[1], 1e-9);
        assert_eq!(commanded[2], None);
    }
}

// clauses: 7.48
#[test]
fn the_second_link_gets_to_the_middle_and_keeps_its_height() {
    let mut bench = Bench::new();
    bench.done(1, &[]);
    let height = end(&bench, 1)[1];
    for _ in 0..2000 {
        carry_on(&mut bench, 5.0, 1);
        // The pull sideways costs as many mm as it needs from a spring of 0.2 N/mm.
        close(end(&bench, 1)[1], height, 6.0);
        // One call in three cycles is enough.
        bench.idle(2);
    }
    for n in 1..=3 {
        close(end(&bench, n)[0], 0.0, 0.1);
        close(end(&bench, n)[1], height, 0.1);
        assert_eq!(bench.robot.hand.sensors.angles[n - 1][2], 80.0);
    }
}

// clauses: 7.48
#[test]
fn the_stiffness_comes_from_either_call_and_the_parameter_is_left_alone() {
    let commanded = |begin: &[f64], carry: &[f64]| {
        let mut bench = Bench::new();
        bench.done(1, begin);
        bench.done(2, carry);
        bench.robot.hand.commanded(1)
    };
    assert_eq!(commanded(&[3.0], &[]), commanded(&[], &[3.0]));
    assert_eq!(commanded(&[5.0], &[3.0]), commanded(&[], &[3.0]));

    // A spring of the program has the stiffness that the program set.
    let pulled = |lever: bool| {
        let mut bench = Bench::new();
        let stiffness = [0.5, 0.5, 0.0];
        bench
            .robot
            .hand
            .done(Op::SetPositionStiffness, Target::All, &stiffness);
        if lever {
            bench.done(1, &[]);
            bench.done(2, &[0.0]);
        } else {
            bench.idle(2);
        }
        let hand = &mut bench.robot.hand;
        hand.relative(Op::CompliancePosition, J13, &[10.0, 0.0, 0.0]);
        hand.commanded(1)[0].expect("a torque")
    };
    close(pulled(true), pulled(false), 1e-9);
}

// clauses: 7.48
#[test]
fn any_other_motion_ends_it() {
    let mut bench = Bench::new();
    bench.done(1, &[2.0]);
    carry_on(&mut bench, 2.0, 1);
    bench.robot.hand.done(Op::RelPtpAngle, J11, &[0.0]);
    assert_eq!(bench.robot.hand.commanded(1), [None; 3]);
    assert!(bench.robot.hand.commanded(2)[0].is_some());
}

// clauses: 7.43 7.48
#[test]
fn what_makes_no_sense_is_a_domain_error() {
    let mut bench = Bench::new();
    bench.refuse(2, &[&[], &[2.0]]);
    bench.refuse(1, &[&[-1.0], &[f64::INFINITY], &[2.0, 0.0]]);
    bench.done(1, &[]);
    bench.refuse(2, &[&[], &[-1.0], &[2.0, 0.0]]);
    assert_eq!(bench.robot.hand.commanded(1), [None; 3]);
    bench.done(2, &[0.0]);
}
