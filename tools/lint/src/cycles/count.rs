//! Numbers of control cycles, from the least to the most.

/// Number of cycles that a part of a program takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Count {
    /// The least.
    pub min: u64,
    /// The most, outside waits; `None` if nothing bounds it.
    pub max: Option<u64>,
    /// Some path through the part waits: there it may take longer.
    pub waits: bool,
}

impl Count {
    /// Creates an exact number.
    pub(super) const fn exactly(cycles: u64) -> Self {
        Count {
            min: cycles,
            max: Some(cycles),
            waits: false,
        }
    }

    /// Adds another number: this, and then that.
    pub(super) fn then(self, other: Count) -> Count {
        Count {
            min: self.min.saturating_add(other.min),
            max: self.max.zip(other.max).map(|(a, b)| a.saturating_add(b)),
            waits: self.waits || other.waits,
        }
    }

    /// Multiplies by a number of turns.
    pub(super) fn times(self, turns: u64) -> Count {
        Count {
            min: self.min.saturating_mul(turns),
            max: self.max.map(|max| max.saturating_mul(turns)),
            waits: self.waits,
        }
    }

    /// Multiplies by up to a number of turns, or none.
    pub(super) fn at_most(self, turns: u64) -> Count {
        match turns {
            0 => Count::exactly(0),
            _ => Count {
                min: 0,
                ..self.times(turns)
            },
        }
    }

    /// Removes the upper bound.
    pub(super) fn unbounded(self) -> Count {
        Count { max: None, ..self }
    }
}
