//! Numbers that are the same in every run.

use tip_sim::search;

/// The generator of `tip-sim`, for places in slices.
pub(crate) struct Random(search::Random);

impl Random {
    /// Generator whose numbers depend on the seed only.
    pub(crate) const fn new(seed: u64) -> Self {
        Random(search::Random::new(seed))
    }

    /// One of 0 … `count` - 1.
    pub(crate) fn below(&mut self, count: usize) -> usize {
        self.0.below(count as u64) as usize
    }
}
