//! The gait diagram: which foot is up when.

use std::fmt;

/// How many characters a line of the diagram has for its feet.
const COLUMNS: usize = 72;

const FEET: [&str; 4] = [
    "F1 front left ",
    "F2 front right",
    "F3 rear left  ",
    "F4 rear right ",
];

/// Which feet touched the floor in each control cycle. Shown, it is a picture in text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Gait {
    cycles: Vec<[bool; 4]>,
}

impl Gait {
    /// Notes which feet touch the floor in one more cycle.
    pub fn push(&mut self, touching: [bool; 4]) {
        self.cycles.push(touching);
    }

    /// The cycles noted so far.
    pub fn cycles(&self) -> &[[bool; 4]] {
        &self.cycles
    }

    /// Cycles that one column of the diagram stands for.
    pub fn column(&self) -> usize {
        self.cycles.len().div_ceil(COLUMNS).max(1)
    }

    fn mark(&self, chunk: &[[bool; 4]], foot: usize) -> char {
        let touching = chunk.iter().filter(|feet| feet[foot]).count();
        if 2 * touching >= chunk.len() {
            '#'
        } else {
            '.'
        }
    }
}

impl fmt::Display for Gait {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (foot, name) in FEET.iter().enumerate() {
            let chunks = self.cycles.chunks(self.column());
            let marks: String = chunks.map(|chunk| self.mark(chunk, foot)).collect();
            writeln!(f, "  {name}  {marks}")?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_short_gait_has_a_column_for_each_cycle() {
        let mut gait = Gait::default();
        gait.push([true, true, false, true]);
        gait.push([false, true, true, true]);
        assert_eq!(
            gait.to_string(),
            "  F1 front left   #.\n  F2 front right  ##\n  F3 rear left    .#\n  F4 rear right   ##\n"
        );
    }

    #[test]
    fn a_long_gait_fits_the_width_and_shows_what_lasts_longer() {
        let mut gait = Gait::default();
        for cycle in 0..720 {
            gait.push([cycle % 10 < 6, cycle % 10 < 4, true, false]);
        }
        assert_eq!(gait.column(), 10);
        let picture = gait.to_string();
        let marks: Vec<&str> = picture.lines().map(|line| &line[18..]).collect();
        assert_eq!(
            marks,
            [
                "#".repeat(72),
                ".".repeat(72),
                "#".repeat(72),
                ".".repeat(72)
            ]
        );
    }

    #[test]
    fn no_cycles_make_an_empty_picture() {
        assert!(
            Gait::default()
                .to_string()
                .lines()
                .all(|line| line.ends_with(' '))
        );
    }
}
