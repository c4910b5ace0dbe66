//! Random numbers that are the same in every run, for noise, campaigns, sweeps and tests.
//!
//! ```
//! use tip_runtime::random::Random;
//!
//! let mut random = Random::new(7);
//! assert!((0.0..1.0).contains(&random.uniform()));
//! assert!(random.below(6) < 6);
//! assert_eq!(Random::new(7).next_u64(), Random::new(7).next_u64());
//! ```

/// A seeded generator: SplitMix64 (Steele, Lea and Flood, *Fast Splittable Pseudorandom Number
/// Generators*, OOPSLA 2014).
///
/// The sequence of a seed never changes, because traces and tables of sweeps depend on it.
/// Not for cryptography.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Random(u64);

impl Random {
    /// Creates a generator. Every seed is as good as any other.
    pub const fn new(seed: u64) -> Self {
        Random(seed)
    }

    /// Draws 64 random bits.
    pub const fn next_u64(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        mixed ^ (mixed >> 31)
    }

    /// Draws a number from 0 up to, but not including, 1: a multiple of 2⁻⁵³.
    pub const fn uniform(&mut self) -> f64 {
        (self.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Draws a number between two others.
    pub const fn within(&mut self, min: f64, max: f64) -> f64 {
        min + (max - min) * self.uniform()
    }

    /// Draws one of 0, 1, … `count` − 1; 0 if `count` is 0. Small numbers are more likely by
    /// `count` / 2⁶⁴ at most.
    pub fn below(&mut self, count: u64) -> u64 {
        self.next_u64().checked_rem(count).unwrap_or(0)
    }

    /// Draws an index into a slice of `len` elements; 0 if it is empty.
    pub fn index(&mut self, len: usize) -> usize {
        self.below(len as u64) as usize
    }

    /// Returns true once in `n` times on average.
    pub fn once_in(&mut self, n: u64) -> bool {
        self.below(n) == 0
    }

    /// Draws an element; `None` if there is none.
    pub fn pick<'a, T>(&mut self, from: &'a [T]) -> Option<&'a T> {
        from.get(self.index(from.len()))
    }
}

#[cfg(test)]
mod tests {
    use super::Random;

    /// Vigna's `splitmix64.c` from this state, as published at Rosetta Code ("Pseudo-random numbers/Splitmix64").
    #[test]
    fn the_sequence_is_that_of_splitmix64() {
        let mut random = Random::new(1_234_567);
        for number in [
            6_457_827_717_110_365_317,
            3_203_168_211_198_807_973,
            9_817_491_932_198_370_423,
            4_593_380_528_125_082_431,
            16_408_922_859_458_223_821,
        ] {
            assert_eq!(random.next_u64(), number);
        }
    }

    #[test]
    fn numbers_are_in_their_ranges() {
        let mut random = Random::new(0);
        let mut found = [0_u32; 3];
        for _ in 0..3000 {
            assert!((0.0..1.0).contains(&random.uniform()));
            assert!((-2.0..5.0).contains(&random.within(-2.0, 5.0)));
            found[random.index(3)] += 1;
        }
        assert!(
            found.iter().all(|count| (900..1100).contains(count)),
            "{found:?}"
        );
        assert_eq!((random.below(0), random.index(0)), (0, 0));
        assert_eq!(random.pick::<u8>(&[]), None);
        assert_eq!(random.pick(&[4]), Some(&4));
    }
}
