//! Finished batches: a file of figures for each, so that a stopped campaign can continue.

use lockstep::Figures;
use std::path::PathBuf;
use std::time::Duration;
use std::{fs, io};

/// A folder of figures.
#[derive(Clone, Debug)]
pub struct Progress(pub PathBuf);

impl Progress {
    /// Returns true if a batch is done.
    pub fn has(&self, batch: u64) -> bool {
        self.file(batch).exists()
    }

    /// Keeps the figures of a batch: all of them or, if it is stopped just now, none.
    ///
    /// # Errors
    /// The folder cannot be written.
    pub fn keep(&self, batch: u64, figures: &Figures) -> io::Result<()> {
        fs::create_dir_all(&self.0)?;
        let unfinished = self.0.join("unfinished");
        fs::write(&unfinished, figures.to_string())?;
        fs::rename(unfinished, self.file(batch))
    }

    /// The figures of all batches.
    ///
    /// # Errors
    /// A file cannot be read.
    pub fn sum(&self) -> io::Result<Figures> {
        let mut sum = Figures::default();
        for entry in fs::read_dir(&self.0)? {
            let path = entry?.path();
            if path
                .extension()
                .is_some_and(|extension| extension == "figures")
            {
                sum.merge(&Figures::parse(&fs::read_to_string(path)?));
            }
        }
        Ok(sum)
    }

    fn file(&self, batch: u64) -> PathBuf {
        self.0.join(format!("{batch:06}.figures"))
    }
}

/// Returns the estimated time of `left` batches if `done` took this long.
pub fn time_left(elapsed: Duration, done: u32, left: u32) -> String {
    let minutes = (elapsed / done.max(1))
        .saturating_mul(left)
        .as_secs()
        .div_ceil(60);
    match (minutes / 60, minutes % 60) {
        (0, minutes) => format!("{minutes} min"),
        (hours, minutes) => format!("{hours} h {minutes} min"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rest_takes_as_long_as_what_was_done() {
        let minutes = |n: u64| Duration::from_secs(60 * n);
        assert_eq!(time_left(minutes(10), 5, 20), "40 min");
        assert_eq!(time_left(minutes(10), 5, 61), "2 h 2 min");
        assert_eq!(time_left(minutes(10), 5, 0), "0 min");
        assert_eq!(time_left(minutes(0), 0, 9), "0 min");
    }
}
