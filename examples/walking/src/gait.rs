//! The gait diagram: which foot is up when.

use std::fmt;

/// Width of the diagram's feet, characters.
const COLUMNS: usize = 72;

/// Which feet touched the floor in each control cycle. Shown, it is a picture in text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Gait<const L: usize> {
    cycles: Vec<[bool; L]>,
}

impl<const L: usize> Gait<L> {
    /// Notes which feet touch the floor in one more cycle.
    pub fn push(&mut self, touching: [bool; L]) {
        self.cycles.push(touching);
    }

    /// The cycles noted so far.
    pub fn cycles(&self) -> &[[bool; L]] {
        &self.cycles
    }

    /// Cycles that one column of the diagram stands for.
    pub fn column(&self) -> usize {
        self.cycles.len().div_ceil(COLUMNS).max(1)
    }

    fn mark(&self, chunk: &[[bool; L]], foot: usize) -> char {
        let touching = chunk.iter().filter(|feet| feet[foot]).count();
        if 2 * touching >= chunk.len() {
            '#'
        } else {
            '.'
        }
    }
}

impl<const L: usize> fmt::Display for Gait<L> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for foot in 0..L {
            let chunks = self.cycles.chunks(self.column());
            let marks: String = chunks.map(|chunk| self.mark(chunk, foot)).collect();
            writeln!(f, "  F{}  {marks}", foot + 1)?;
        }
        Ok(())
    }
}
