//! Files that appear complete or not at all.
#![allow(clippy::disallowed_methods, reason = "this is for writing files")]

use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process;

/// A file that takes its place when [`commit`](Self::commit) says so; until then the earlier one stays as it was.
///
/// It is written next to its place, as `.NAME.PROCESS.part`, and then renamed. Dropped without `commit` it leaves
/// nothing. A device or a pipe has no content to lose and is written straight.
#[derive(Debug)]
pub struct WholeFile {
    file: File,
    part: Option<Part>,
}

/// What is written, and the place that it is for.
#[derive(Debug)]
struct Part {
    path: PathBuf,
    place: PathBuf,
}

impl WholeFile {
    /// Begins a file; its folder has to exist.
    ///
    /// # Errors
    /// The folder cannot be written, or `path` is a folder or a read-only file.
    pub fn create(path: &Path) -> io::Result<Self> {
        match fs::metadata(path) {
            Ok(found) if !found.is_file() => Ok(WholeFile {
                file: File::options().write(true).open(path)?,
                part: None,
            }),
            // To rename asks the folder for leave only.
            Ok(found) if found.permissions().readonly() => {
                Err(io::ErrorKind::PermissionDenied.into())
            }
            // What a link leads to is replaced, not the link.
            Ok(_) => Self::beside(fs::canonicalize(path)?),
            Err(_) => Self::beside(path.to_path_buf()),
        }
    }

    fn beside(place: PathBuf) -> io::Result<Self> {
        let name = place.file_name().ok_or(io::ErrorKind::InvalidInput)?;
        let mut part = OsString::from(".");
        part.push(name);
        part.push(std::format!(".{}.part", process::id()));
        let path = place.with_file_name(part);
        Ok(WholeFile {
            file: File::create(&path)?,
            part: Some(Part { path, place }),
        })
    }

    /// Where it is written, if it is not written straight: what a process leaves that is ended at once.
    pub fn part(&self) -> Option<&Path> {
        self.part.as_ref().map(|part| part.path.as_path())
    }

    /// Puts the file in its place.
    ///
    /// # Errors
    /// The disk did not take all of it; the earlier file stays.
    pub fn commit(mut self) -> io::Result<()> {
        let Some(part) = &self.part else {
            return Ok(());
        };
        self.file.sync_all()?;
        fs::rename(&part.path, &part.place)?;
        self.part = None;
        Ok(())
    }
}

impl Write for WholeFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

impl Drop for WholeFile {
    fn drop(&mut self) {
        if let Some(part) = &self.part {
            // What is left of a failed attempt is useless, and there is no one to report it to.
            let _ = fs::remove_file(&part.path);
        }
    }
}
