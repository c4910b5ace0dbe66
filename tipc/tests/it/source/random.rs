//! Numbers that are the same in every run.

/// A small generator (Marsaglia's xorshift); begins with any number but 0.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    /// Returns a number from 0 to `count` - 1.
    pub(crate) fn below(&mut self, count: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        usize::try_from(self.0 >> 33).expect("31 bits") % count
    }
}
