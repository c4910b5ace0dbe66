//! Where the program comes from.

/// The file of the program, which only the one who holds the session can reach.
pub trait Host {
    /// Gives the file these bytes, all of them or none.
    ///
    /// # Errors
    /// Why not, in words for the viewer.
    fn write(&mut self, bytes: &[u8]) -> Result<(), String>;

    /// What is in the file now.
    ///
    /// # Errors
    /// Why it cannot be read, in words for the viewer.
    fn read(&mut self) -> Result<Vec<u8>, String>;
}

/// No file: the program is only in the page.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoFile;

impl Host for NoFile {
    fn write(&mut self, _: &[u8]) -> Result<(), String> {
        Err("there is no file".to_owned())
    }

    fn read(&mut self) -> Result<Vec<u8>, String> {
        Err("there is no file".to_owned())
    }
}
