//! Files that appear complete or not at all.
#![allow(clippy::disallowed_methods, reason = "this is for writing files")]

use std::fs::{self, File, Permissions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use tempfile::{Builder, NamedTempFile};

/// A file that takes its place when [`commit`](Self::commit) says so; until then the earlier one stays as it was.
///
/// It is written next to its place, as `.tip-RANDOM.part`, and then renamed; it is nobody's file before, and gets the mode
/// of the file that it replaces. Dropped without `commit` it leaves nothing. A device or a pipe has no content to lose and
/// is written straight.
#[derive(Debug)]
pub struct WholeFile(Target);

#[derive(Debug)]
enum Target {
    Straight(File),
    Part { file: NamedTempFile, place: PathBuf },
}

impl WholeFile {
    /// Begins a file; its folder has to exist. It never waits: a pipe without a reader is refused.
    ///
    /// # Errors
    /// The folder cannot be written, or `path` is a folder, a read-only file, or a pipe that nobody reads.
    pub fn create(path: &Path) -> io::Result<Self> {
        match fs::metadata(path) {
            Ok(found) if !found.is_file() => Ok(WholeFile(Target::Straight(open(path)?))),
            // To rename asks the folder for leave only.
            Ok(found) if found.permissions().readonly() => {
                Err(io::ErrorKind::PermissionDenied.into())
            }
            // What a link leads to is replaced, not the link.
            Ok(found) => Self::beside(fs::canonicalize(path)?, Some(found.permissions())),
            // Under the name of a part it could be written, and never take its place.
            Err(error) if is_no_name(&error) => Err(error),
            Err(_) => Self::beside(path.to_path_buf(), None),
        }
    }

    fn beside(place: PathBuf, mode: Option<Permissions>) -> io::Result<Self> {
        place.file_name().ok_or(io::ErrorKind::InvalidInput)?;
        let folder = match place.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder,
            _ => Path::new("."),
        };
        // A folder that is missing is not reported by the name of a part.
        fs::metadata(folder.join("."))?;
        let mut builder = Builder::new();
        builder.prefix(".tip-").suffix(".part");
        let file = usual_mode(&mut builder).tempfile_in(folder)?;
        if let Some(mode) = mode {
            file.as_file().set_permissions(mode)?;
        }
        Ok(WholeFile(Target::Part { file, place }))
    }

    /// Where it is written, if it is not written straight: what a process leaves that is ended at once.
    pub fn part(&self) -> Option<&Path> {
        match &self.0 {
            Target::Straight(_) => None,
            Target::Part { file, .. } => Some(file.path()),
        }
    }

    /// Puts the file in its place.
    ///
    /// # Errors
    /// The disk did not take all of it; the earlier file stays.
    pub fn commit(self) -> io::Result<()> {
        if let Target::Part { file, place } = self.0 {
            file.as_file().sync_all()?;
            file.persist(place)?;
        }
        Ok(())
    }
}

/// Too long, or with a NUL in it.
fn is_no_name(error: &io::Error) -> bool {
    use io::ErrorKind::{InvalidFilename, InvalidInput};
    matches!(error.kind(), InvalidFilename | InvalidInput)
}

/// What a new file may be: all that the user's mask leaves.
#[cfg(unix)]
fn usual_mode<'b, 'p, 's>(builder: &'b mut Builder<'p, 's>) -> &'b mut Builder<'p, 's> {
    use std::os::unix::fs::PermissionsExt;
    builder.permissions(Permissions::from_mode(0o666))
}

#[cfg(not(unix))]
fn usual_mode<'b, 'p, 's>(builder: &'b mut Builder<'p, 's>) -> &'b mut Builder<'p, 's> {
    builder
}

/// Opens a device or a pipe without waiting for its other end; writing waits for a reader that is slow.
#[cfg(unix)]
fn open(path: &Path) -> io::Result<File> {
    use rustix::fs::{Mode, OFlags, fcntl_getfl, fcntl_setfl};
    let flags = OFlags::WRONLY | OFlags::NONBLOCK | OFlags::NOCTTY | OFlags::CLOEXEC;
    let file = rustix::fs::open(path, flags, Mode::empty())?;
    fcntl_setfl(&file, fcntl_getfl(&file)? - OFlags::NONBLOCK)?;
    Ok(file.into())
}

#[cfg(not(unix))]
fn open(path: &Path) -> io::Result<File> {
    File::options().write(true).open(path)
}

impl Write for WholeFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match &mut self.0 {
            Target::Straight(file) => file.write(bytes),
            Target::Part { file, .. } => file.as_file_mut().write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match &mut self.0 {
            Target::Straight(file) => file.flush(),
            Target::Part { file, .. } => file.as_file_mut().flush(),
        }
    }
}
