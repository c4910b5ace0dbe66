//! Cases: which values they have.

use crate::{LIFT, spec, sweep};
use tip_sweep::{Sampling, Spec, Sweep};

fn values(sweep: &Sweep) -> Vec<Vec<f64>> {
    let cases = (0..sweep.cases()).map(|number| sweep.case(number).expect("a case").values);
    cases.collect()
}

#[test]
fn listed_axes_are_combined_and_the_last_one_varies_fastest() {
    let sweep = sweep(LIFT, &["Z=10,20", "friction=0.5,0.7,0.9"]).expect("a sweep");
    let expected = [
        [10.0, 0.5],
        [10.0, 0.7],
        [10.0, 0.9],
        [20.0, 0.5],
        [20.0, 0.7],
        [20.0, 0.9],
    ];
    assert_eq!(values(&sweep), expected);
}

#[test]
fn repeats_of_a_combination_are_neighbours() {
    let spec = Spec {
        repeat: 2,
        ..spec(LIFT, &["Z=10,20"])
    };
    let sweep = Sweep::new(spec).expect("a sweep");
    assert_eq!(values(&sweep), [[10.0], [10.0], [20.0], [20.0]]);
}

#[test]
fn samples_depend_on_seed_and_case_alone() {
    let with = |seed, repeat| {
        let spec = Spec {
            seed,
            repeat,
            ..spec(LIFT, &["Z=uniform(10,30)", "friction=normal(0.6,0.05)"])
        };
        values(&Sweep::new(spec).expect("a sweep"))
    };
    let (long, short) = (with(7, 50), with(7, 20));
    assert_eq!(long[..20], short, "more repeats change no earlier case");
    assert_ne!(with(8, 20), short);
    assert!(long.iter().all(|case| (10.0..30.0).contains(&case[0])));
}

/// The mean of n uniform samples over a width w is within 5 w / √(12 n) of the middle, but for one seed in a million; that of normal
/// ones within 5 s / √n.
#[test]
fn samples_have_the_mean_and_spread_of_their_distribution() {
    let count = 4000.0;
    let spec = Spec {
        repeat: 4000,
        ..spec(LIFT, &["Z=uniform(10,30)", "friction=normal(2,0.2)"])
    };
    let cases = values(&Sweep::new(spec).expect("a sweep"));
    let mean = |axis: usize| cases.iter().map(|case| case[axis]).sum::<f64>() / count;
    assert!((mean(0) - 20.0).abs() < 5.0 * 20.0 / (12.0_f64 * count).sqrt());
    assert!((mean(1) - 2.0).abs() < 5.0 * 0.2 / count.sqrt());
    // 68.27 % of normal samples are within one standard deviation.
    let within = cases
        .iter()
        .filter(|case| (case[1] - 2.0).abs() < 0.2)
        .count();
    assert!((within as f64 / count - 0.6827).abs() < 5.0 * (0.6827_f64 * 0.3173 / count).sqrt());
}

#[test]
fn a_latin_hypercube_has_one_sample_in_each_interval() {
    for repeat in [1, 7, 16, 100] {
        let spec = Spec {
            repeat,
            sampling: Sampling::LatinHypercube,
            ..spec(LIFT, &["Z=uniform(0,1)", "friction=uniform(0,1)"])
        };
        let cases = values(&Sweep::new(spec).expect("a sweep"));
        for axis in 0..2 {
            let intervals = cases.iter().map(|case| (case[axis] * repeat as f64) as u64);
            let mut intervals: Vec<u64> = intervals.collect();
            intervals.sort_unstable();
            assert_eq!(intervals, (0..repeat).collect::<Vec<_>>());
        }
    }
}
