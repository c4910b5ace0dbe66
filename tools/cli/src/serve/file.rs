//! The file that is served: the only one that is read or written.

use super::super::output;
use std::fs;
use std::path::{Path, PathBuf};
use tip_view::live::Host;

/// A program's file, by the path of the command line.
#[derive(Debug)]
pub(super) struct ServedFile(PathBuf);

impl ServedFile {
    pub(super) fn new(path: &Path) -> Self {
        ServedFile(path.to_owned())
    }
}

impl Host for ServedFile {
    fn write(&mut self, bytes: &[u8]) -> Result<(), String> {
        output::replace(&self.0, bytes).map_err(|error| error.to_string())
    }

    fn read(&mut self) -> Result<Vec<u8>, String> {
        fs::read(&self.0).map_err(|error| error.to_string())
    }
}
