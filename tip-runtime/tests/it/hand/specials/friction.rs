//! Active friction control: SPECIAL 10 to 16.

use super::bench::Bench;
use crate::hand::rig::{F1, Hand, close};
use tip_runtime::command::{Op, Target};

const INITIAL: [f64; 3] = [-40.0, 0.0, 80.0];

/// Returns the measured distances of the joints of finger `n` from the initial posture in each of
/// the next cycles, deg.
fn departures(bench: &mut Bench, n: usize, cycles: usize) -> Vec<[f64; 3]> {
    let mut next = || {
        bench.idle(1);
        let angles = bench.robot.hand.sensors.angles[n - 1];
        core::array::from_fn(|m| angles[m] - INITIAL[m])
    };
    (0..cycles).map(|_| next()).collect()
}

/// Returns the number of times in a second that the fingertip joint of finger `n` crosses its
/// command.
fn crossings(bench: &mut Bench, n: usize) -> usize {
    let seconds = departures(bench, n, 500);
    let above: Vec<bool> = seconds.iter().map(|joints| joints[2] > 0.0).collect();
    above.windows(2).filter(|pair| pair[0] != pair[1]).count()
}

fn most(departures: &[[f64; 3]], m: usize) -> f64 {
    departures
        .iter()
        .fold(0.0, |most, joints| joints[m].max(most))
}

fn least(departures: &[[f64; 3]], m: usize) -> f64 {
    departures
        .iter()
        .fold(0.0, |least, joints| joints[m].min(least))
}

// clauses: 7.48
#[test]
fn each_finger_vibrates_at_its_own_frequency() {
    let mut bench = Bench::new();
    for (number, frequency) in [(14, 30.0), (15, 40.5), (16, 60.0)] {
        bench.done(number, &[frequency]);
    }
    assert_eq!(crossings(&mut bench, 1), 0);
    for number in [11, 12, 13] {
        bench.done(number, &[1.0, 2.0]);
    }
    // Two in each wave; one more or less where the second begins or ends on one.
    for (n, frequency) in [(1, 30.0), (2, 40.5), (3, 60.0)] {
        let counted = crossings(&mut bench, n) as f64;
        close(counted, 2.0 * frequency, 1.0);
    }
    // A new frequency counts immediately, and does not switch on what is off.
    bench.done(14, &[7.0]);
    close(crossings(&mut bench, 1) as f64, 14.0, 1.0);
    bench.done(12, &[0.0, 0.0]);
    bench.done(15, &[7.0]);
    assert_eq!(crossings(&mut bench, 2), 0);
    bench.done(16, &[0.0]);
    assert_eq!(crossings(&mut bench, 3), 0);
    bench.done(10, &[]);
    for n in 1..=3 {
        assert_eq!(departures(&mut bench, n, 3), [[0.0; 3]; 3]);
    }
}

// clauses: 7.48
#[test]
fn the_modes_move_their_joints() {
    let shaken = |mode: f64| {
        let mut bench = Bench::new();
        // A frequency of which no wave comes out even in the sampling time, so that all of it is seen.
        bench.done(15, &[17.0]);
        bench.done(12, &[mode, 2.0]);
        departures(&mut bench, 2, 500)
    };
    for none in [0.0, 5.0, 7.0] {
        assert!(shaken(none).iter().all(|joints| *joints == [0.0; 3]));
    }
    // Half a degree for each volt; fingertip joint alone.
    let fingertip = shaken(1.0);
    close(most(&fingertip, 2), 1.0, 0.01);
    close(least(&fingertip, 2), -1.0, 0.01);
    assert!(fingertip.iter().all(|joints| joints[..2] == [0.0; 2]));
    for joints in shaken(2.0) {
        close(joints[0], joints[1], 1e-9);
        close(joints[0], joints[2], 1e-9);
    }
    close(most(&shaken(2.0), 0), 1.0, 0.01);
    let loosening = shaken(3.0);
    for m in 0..3 {
        assert!(most(&loosening, m) <= 1e-12);
        close(least(&loosening, m), -1.0, 0.01);
    }
}

// clauses: 7.48
#[test]
fn rolling_goes_slowly_where_it_carries_and_fast_where_it_slips() {
    // Whether the fingertip of finger n goes up for longer than down.
    let rises = |n: u8, mode: f64| {
        let mut bench = Bench::new();
        bench.done(13 + n, &[10.0]);
        bench.done(10 + n, &[mode, 2.0]);
        let finger = usize::from(n);
        let mut heights = vec![bench.robot.hand.tip(finger)[1]];
        for _ in 0..250 {
            let [joints] = departures(&mut bench, finger, 1)[..] else {
                panic!("one cycle")
            };
            assert_eq!(joints[..2], [0.0; 2]);
            heights.push(bench.robot.hand.tip(finger)[1]);
        }
        let up = heights.windows(2).filter(|pair| pair[1] > pair[0]).count();
        // Four fifths of the time in one direction.
        assert!((45..=55).contains(&up) || (195..=205).contains(&up), "{up}");
        up > 125
    };
    // Clockwise is up on the left of an object, where F1 is, and down on the right.
    assert!(rises(1, 4.0) && !rises(2, 4.0) && !rises(3, 4.0));
    assert!(!rises(1, 6.0) && rises(2, 6.0) && rises(3, 6.0));
}

// clauses: 7.9 7.48
#[test]
fn a_grasp_by_torque_vibrates_and_loosening_never_tightens_it() {
    let commanded = |mode: f64| {
        let mut bench = Bench::new();
        bench.robot.hand.done(Op::Torque, F1, &[0.0, 60.0, 0.0]);
        bench.done(11, &[mode, 2.0]);
        let mut commanded = Vec::new();
        for _ in 0..100 {
            // Something holds the joints where they are.
            bench.robot.hand.sensors = Hand::new().sensors;
            bench.idle(1);
            commanded.push(bench.robot.hand.commanded(1)[1].expect("a torque"));
        }
        let (low, high) = (
            commanded.iter().copied().fold(90.0, f64::min),
            commanded.iter().copied().fold(0.0, f64::max),
        );
        (low, high)
    };
    // Ten mN·m for each volt.
    let (low, high) = commanded(2.0);
    close(low, 40.0, 0.2);
    close(high, 80.0, 0.2);
    let (low, high) = commanded(3.0);
    close(low, 40.0, 0.2);
    assert!(high <= 60.0);
    assert_eq!(commanded(1.0), (60.0, 60.0));
}

// clauses: 7.43 7.48
#[test]
fn what_makes_no_sense_is_a_domain_error() {
    let mut bench = Bench::new();
    for number in [11, 12, 13] {
        let wrong: [&[f64]; 7] = [
            &[],
            &[1.0],
            &[-1.0, 2.0],
            &[8.0, 2.0],
            &[1.5, 2.0],
            &[1.0, -0.1],
            &[1.0, f64::INFINITY],
        ];
        bench.refuse(number, &wrong);
        bench.done(number, &[7.0, 2.0]);
        bench.done(number, &[0.0, 0.0]);
    }
    for number in [14, 15, 16] {
        bench.refuse(number, &[&[], &[30.0, 1.0], &[-0.1], &[60.1], &[f64::NAN]]);
        bench.done(number, &[0.0]);
        bench.done(number, &[60.0]);
    }
    bench.refuse(10, &[&[0.0], &[0.0, 0.0]]);
    assert_eq!(departures(&mut bench, 1, 3), [[0.0; 3]; 3]);
}

// clauses: 7.48
#[test]
fn the_frequency_is_30_hz_until_it_is_set() {
    let mut bench = Bench::new();
    bench.done(11, &[1.0, 2.0]);
    close(crossings(&mut bench, 1) as f64, 60.0, 1.0);
    let still = bench
        .robot
        .hand
        .fault(Op::PtpAngle, Target::Joint(4, 1), &[0.0]);
    assert_eq!(still, tip_runtime::fault::Fault::Domain);
}
