//! Active force closure of the second kind: SPECIAL 5 and 6.

use super::bench::Bench;
use crate::hand::rig::{F1, all_close, close, transposed};
use tip_runtime::command::{Op, Target};
use tip_runtime::fault::Fault;
use tip_runtime::kinematics::Chain;
use tip_runtime::model::hand;

fn torques(bench: &Bench, n: usize) -> [f64; 3] {
    bench
        .robot
        .hand
        .commanded(n)
        .map(|torque| torque.expect("a torque"))
}

// clauses: 7.48
#[test]
fn fingertips_are_told_to_go_on_by_the_velocity() {
    let mut bench = Bench::new();
    let from = bench.robot.hand.tip(2);
    bench.done(5, &[4.0, 50.0]);
    // The first call begins; each of the others comes 2 ms later.
    bench.done(6, &[10.0, -5.0]);
    assert_eq!(torques(&bench, 2), [0.0; 3]);
    for calls in 1..=20 {
        let measured = bench.robot.hand.sensors.angles[1];
        bench.done(6, &[10.0, -5.0]);
        // τ = 4 (θ_d − θ), and θ_d puts the fingertip where it should be.
        let commanded = torques(&bench, 2);
        let desired = core::array::from_fn(|m| measured[m] + commanded[m] / 4.0);
        let tip = Chain::new(&hand::MODEL.legs[1], &desired).foot();
        let seconds = 0.002 * f64::from(calls);
        close(tip[0], from[0] + 10.0 * seconds, 1e-6);
        close(tip[1], from[1] - 5.0 * seconds, 1e-6);
    }
    // The time between calls counts, not their number.
    bench.idle(9);
    let measured = bench.robot.hand.sensors.angles[1];
    bench.done(6, &[10.0, -5.0]);
    let desired = core::array::from_fn(|m| measured[m] + torques(&bench, 2)[m] / 4.0);
    let tip = Chain::new(&hand::MODEL.legs[1], &desired).foot();
    close(tip[0], from[0] + 10.0 * 0.060, 1e-6);
}

// clauses: 7.48
#[test]
fn the_steady_torques_are_those_commanded_else_sensed() {
    let mut bench = Bench::new();
    bench.robot.hand.done(Op::Torque, F1, &[1.0, 2.0, 3.0]);
    bench.robot.hand.pull[1] = [0.1, 0.05, 0.0];
    bench.idle(1);
    let load = transposed(&bench.robot.hand.chain(2), bench.robot.hand.pull[1]);
    bench.done(5, &[0.0]);
    bench.done(6, &[0.0, 0.0]);
    assert_eq!(torques(&bench, 1), [1.0, 2.0, 3.0]);
    all_close(torques(&bench, 2), load.map(|torque| -torque), 1e-9);
    assert_eq!(torques(&bench, 3), [0.0; 3]);
}

// clauses: 5.1 7.48
#[test]
fn the_flag_rises_when_the_fingertips_have_really_gone_so_far() {
    let mut bench = Bench::new();
    bench.robot.flags[0] = true;
    bench.done(5, &[5.0, 3.0]);
    assert!(!bench.robot.flags[0]);
    let from: Vec<_> = (1..=3).map(|n| bench.robot.hand.tip(n)).collect();
    let gone = |bench: &Bench| -> f64 {
        let along = |n: usize| bench.robot.hand.tip(n)[1] - from[n - 1][1];
        (1..=3).map(along).sum::<f64>() / 3.0
    };
    let mut before = 0.0;
    let calls = (1..5000).find(|_| {
        before = gone(&bench);
        bench.done(6, &[0.0, 20.0]);
        bench.robot.flags[0]
    });
    // At 20 mm/s it takes 75 calls at the least.
    assert!(calls.is_some_and(|calls| calls > 75));
    assert!((3.0..3.2).contains(&before), "{before}");
    // It stays there, not much farther than what it was commanded by then.
    for _ in 0..2000 {
        bench.done(6, &[0.0, 20.0]);
    }
    let rest = gone(&bench);
    for _ in 0..500 {
        bench.done(6, &[0.0, 20.0]);
    }
    close(gone(&bench), rest, 0.01);
    assert!(rest < 6.0, "{rest}");
    // Pulled back for a second, they are not sent on either.
    bench.robot.hand.pull = [[0.0, -0.5, 0.0]; 3];
    for _ in 0..500 {
        bench.done(6, &[0.0, 20.0]);
    }
    assert!(gone(&bench) < 3.0);
    bench.robot.hand.pull = [[0.0; 3]; 3];
    for _ in 0..2500 {
        bench.done(6, &[0.0, 20.0]);
    }
    close(gone(&bench), rest, 0.05);
    bench.done(5, &[5.0, 3.0]);
    assert!(!bench.robot.flags[0]);
}

// clauses: 2.22 7.48
#[test]
fn a_fingertip_that_cannot_go_on_is_out_of_reach() {
    let mut bench = Bench::new();
    bench.done(5, &[0.1]);
    let fault = (0..1000).find_map(|_| bench.call(6, &[0.0, -1000.0]).err());
    assert_eq!(fault, Some(Fault::OutOfReach(Target::Foot(1))));
    assert!(!bench.robot.flags[0]);
}

// clauses: 7.43 7.48
#[test]
fn what_makes_no_sense_is_a_domain_error() {
    let mut bench = Bench::new();
    bench.refuse(6, &[&[], &[1.0, -5.0]]);
    bench.refuse(5, &[&[], &[-1.0], &[1.0, -1.0], &[f64::INFINITY]]);
    bench.done(5, &[1.0]);
    bench.refuse(6, &[&[], &[1.0], &[f64::INFINITY, 0.0]]);
    bench.done(6, &[1.0, -5.0]);
}
