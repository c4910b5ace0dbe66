//! Snapshots to go back to.

use crate::run::Run;
use crate::snapshot::Snapshot;

/// How many cycles are run again at most, as long as there is room.
const SPACING: u64 = 200;

/// How many snapshots there may be: more than ten minutes of 2 ms need.
const MOST: usize = 2048;

/// How many values of variables all snapshots may hold together.
const VALUES: usize = 1 << 24;

/// Snapshots, two hundred cycles apart. When there are too many, every second one goes, and later ones are as far apart as
/// those that stay; so a run of any length needs no more memory than a long one.
#[derive(Debug)]
pub(super) struct Marks {
    marks: Vec<(u64, Snapshot)>,
    spacing: u64,
    most: usize,
}

impl Marks {
    /// None yet, of a program with so many values.
    pub(super) fn new(values: usize) -> Self {
        Marks {
            marks: Vec::new(),
            spacing: SPACING,
            most: (VALUES / values.max(1)).clamp(2, MOST),
        }
    }

    /// Marks a run at a position beyond all others, if it is far enough from the last mark.
    pub(super) fn note(&mut self, at: u64, run: &Run) {
        let due = self.marks.last().map_or(0, |(last, _)| last + self.spacing);
        if at < due {
            return;
        }
        if self.marks.len() >= self.most {
            let mut place = 0;
            self.marks.retain(|_| {
                place += 1;
                place % 2 == 1
            });
            self.spacing *= 2;
        }
        self.marks.push((at, run.snapshot()));
    }

    /// The last mark that is not after a position; the first one is at 0.
    pub(super) fn before(&self, at: u64) -> Option<&(u64, Snapshot)> {
        let behind = self.marks.partition_point(|(mark, _)| *mark <= at);
        self.marks.get(behind.checked_sub(1)?)
    }

    /// Forgets all marks after a position.
    pub(super) fn truncate(&mut self, at: u64) {
        let keep = self.marks.partition_point(|(mark, _)| *mark <= at);
        self.marks.truncate(keep);
    }
}

#[cfg(test)]
mod tests {
    use super::{MOST, Marks, VALUES};

    #[test]
    fn the_more_values_a_program_has_the_fewer_snapshots_there_are() {
        for (values, most) in [(0, MOST), (1_000, MOST), (VALUES / 100, 100), (VALUES, 2)] {
            assert_eq!(Marks::new(values).most, most, "{values}");
        }
    }
}
