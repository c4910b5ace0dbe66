//! What is done already: a file of figures for each batch, so that a stopped campaign goes on where it was.

use lockstep::Figures;
use std::path::PathBuf;
use std::{fs, io};

/// A folder of figures.
#[derive(Clone, Debug)]
pub struct Progress(pub PathBuf);

impl Progress {
    /// Whether a batch is done.
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
