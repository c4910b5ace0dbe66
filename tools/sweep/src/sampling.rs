//! Random numbers of a case. They depend on seed, case and axis alone, so that any split of a sweep gives the same cases.

use crate::spec::{Sampling, Values};

/// Identity of a random number.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Draw {
    pub(crate) seed: u64,
    /// Combination of listed values, from 0.
    pub(crate) combination: u64,
    /// Repeat of that combination, from 0.
    pub(crate) repeat: u64,
    /// Number of repeats.
    pub(crate) repeats: u64,
    /// Axis, from 0.
    pub(crate) axis: u64,
}

impl Draw {
    /// Returns the sample of a random axis; `None` for a listed one.
    pub(crate) fn sample(self, values: &Values, sampling: Sampling) -> Option<f64> {
        match *values {
            Values::List(_) | Values::Range { .. } => None,
            Values::Uniform { low, high } => Some(low + (high - low) * self.unit(sampling)),
            Values::Normal { mean, deviation } => {
                Some(mean + deviation * standard_normal(self.unit(sampling)))
            }
        }
    }

    /// Returns a number in 0…1, both ends excluded.
    fn unit(self, sampling: Sampling) -> f64 {
        let own = hash([self.seed, self.combination, self.repeat, self.axis]);
        let unit = fraction(own);
        match sampling {
            Sampling::Random => unit,
            Sampling::LatinHypercube => {
                let key = hash([self.seed, self.combination, u64::MAX, self.axis]);
                let interval = permuted(self.repeat, self.repeats, key);
                (interval as f64 + unit) / self.repeats as f64
            }
        }
    }
}

/// Returns a seed for the sensor noise of a case.
pub(crate) fn noise_seed(seed: u64, case: u64) -> u64 {
    hash([seed, case, 0, u64::MAX])
}

/// Hashes words one after the other with the finaliser of SplitMix64 (Steele, Lea, Flood 2014).
pub(crate) fn hash(words: [u64; 4]) -> u64 {
    words.into_iter().fold(0, |state, word| {
        let mut mixed = (state ^ word).wrapping_add(0x9E37_79B9_7F4A_7C15);
        mixed = (mixed ^ mixed >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        mixed = (mixed ^ mixed >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
        mixed ^ mixed >> 31
    })
}

/// Maps a word to 0…1, both ends excluded: 52 bits and a half.
fn fraction(word: u64) -> f64 {
    ((word >> 12) as f64 + 0.5) / (1_u64 << 52) as f64
}

/// Returns the place of `index` in a permutation of 0…count: a Feistel network over the next power of four, walked until the
/// result is below `count` (Black and Rogaway 2002).
fn permuted(index: u64, count: u64, key: u64) -> u64 {
    let bits = 64 - (count - 1).leading_zeros();
    let half = bits.div_ceil(2).max(1);
    let mask = (1_u64 << half) - 1;
    let mut place = index;
    loop {
        let (mut left, mut right) = (place >> half, place & mask);
        for round in 0..4 {
            (left, right) = (right, left ^ hash([key, round, right, 0]) & mask);
        }
        place = left << half | right;
        if place < count {
            return place;
        }
    }
}

/// Returns the standard normal quantile of a probability (Acklam's rational approximation, relative error below 1.2e-9).
fn standard_normal(p: f64) -> f64 {
    const A: [f64; 6] = [
        -3.969_683_028_665_376e1,
        2.209_460_984_245_205e2,
        -2.759_285_104_469_687e2,
        1.383_577_518_672_69e2,
        -3.066_479_806_614_716e1,
        2.506_628_277_459_239,
    ];
    const B: [f64; 6] = [
        -5.447_609_879_822_406e1,
        1.615_858_368_580_409e2,
        -1.556_989_798_598_866e2,
        6.680_131_188_771_972e1,
        -1.328_068_155_288_572e1,
        1.0,
    ];
    const C: [f64; 6] = [
        -7.784_894_002_430_293e-3,
        -3.223_964_580_411_365e-1,
        -2.400_758_277_161_838,
        -2.549_732_539_343_734,
        4.374_664_141_464_968,
        2.938_163_982_698_783,
    ];
    const D: [f64; 5] = [
        7.784_695_709_041_462e-3,
        3.224_671_290_700_398e-1,
        2.445_134_137_142_996,
        3.754_408_661_907_416,
        1.0,
    ];
    const TAIL: f64 = 0.024_25;
    let polynomial =
        |coefficients: &[f64], x: f64| coefficients.iter().fold(0.0, |sum, c| sum * x + c);
    let tail = |p: f64| {
        let q = libm::sqrt(-2.0 * libm::log(p));
        polynomial(&C, q) / polynomial(&D, q)
    };
    if p < TAIL {
        tail(p)
    } else if p > 1.0 - TAIL {
        -tail(1.0 - p)
    } else {
        let q = p - 0.5;
        polynomial(&A, q * q) * q / polynomial(&B, q * q)
    }
}
