//! Output to files that appear completely or not at all, and of formatted text to any writer.
#![allow(clippy::disallowed_methods, reason = "this is for writing files")]

use core::fmt;
use std::fs::{self, File, Metadata};
use std::io::{self, Seek, Write};
use std::path::{Path, PathBuf};
use tempfile::{Builder, NamedTempFile};

/// A file that replaces the earlier one at [`commit`](Self::commit); until then the earlier one
/// stays unchanged.
///
/// It is written next to its place, as `.tip-RANDOM.part`, and then renamed; it gets owner and permissions of the file
/// that it replaces, without set-user-ID and set-group-ID. A link is kept and its target is replaced, unless it leads
/// nowhere. Dropped without `commit` it leaves nothing. A device or a pipe has no content to lose and is written
/// straight.
///
/// A file with several names (hard links), or with an owner that a new file cannot have, keeps them: once all of it is in the
/// part, the content is copied into the file. Only a crash in this last step can leave the file incomplete, with the part
/// beside it.
#[derive(Debug)]
pub struct AtomicFile(Target);

#[derive(Debug)]
enum Target {
    Straight(File),
    Part {
        file: NamedTempFile,
        place: PathBuf,
        /// The file that receives the content, if it is not replaced.
        kept: Option<File>,
    },
}

impl AtomicFile {
    /// Begins a file; its folder has to exist. The call never blocks: a pipe without a reader is
    /// refused.
    ///
    /// # Errors
    /// The folder cannot be written, or `path` is a folder, a read-only file, or a pipe that nobody reads.
    pub fn create(path: &Path) -> io::Result<Self> {
        match fs::metadata(path) {
            Ok(found) if !found.is_file() => Ok(AtomicFile(Target::Straight(open(path)?))),
            // A rename needs only the permission of the folder, so the file is checked.
            Ok(found) if found.permissions().readonly() => {
                Err(io::ErrorKind::PermissionDenied.into())
            }
            Ok(found) => Self::beside(fs::canonicalize(path)?, Some(&found)),
            // A part could be written under its own name, but never renamed to this one.
            Err(error) if is_no_name(&error) => Err(error),
            // A link that leads nowhere is itself replaced.
            Err(_) => Self::beside(path.to_path_buf(), None),
        }
    }

    fn beside(place: PathBuf, replaced: Option<&Metadata>) -> io::Result<Self> {
        place.file_name().ok_or(io::ErrorKind::InvalidInput)?;
        let folder = match place.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder,
            _ => Path::new("."),
        };
        // The error of a missing folder must not name the part.
        fs::metadata(folder.join("."))?;
        let mut builder = Builder::new();
        builder.prefix(".tip-").suffix(".part");
        let file = usual_mode(&mut builder).tempfile_in(folder)?;
        let takes_place = replaced.is_none_or(|replaced| adopt(file.as_file(), replaced));
        let kept = match takes_place {
            true => None,
            false => Some(File::options().write(true).open(&place)?),
        };
        Ok(AtomicFile(Target::Part { file, place, kept }))
    }

    /// Returns the path of the temporary file, unless the file is written directly: a process that
    /// is killed leaves it behind.
    pub fn part(&self) -> Option<&Path> {
        match &self.0 {
            Target::Straight(_) => None,
            Target::Part { file, .. } => Some(file.path()),
        }
    }

    /// Puts the file in its place.
    ///
    /// # Errors
    /// The disk did not take all of the content; the earlier file stays.
    pub fn commit(self) -> io::Result<()> {
        if let Target::Part { file, place, kept } = self.0 {
            file.as_file().sync_all()?;
            match kept {
                None => file.persist(place).map(drop)?,
                Some(kept) => copy(file, kept)?,
            }
        }
        Ok(())
    }
}

/// The permission bits that a file keeps with new content: those to read, write and execute.
#[cfg(unix)]
const KEPT: u32 = 0o777;

/// Gives a part owner and permissions of the file that it is to replace. Returns false if it cannot
/// replace it: the file has other names, which would keep the earlier content, or an owner that the
/// part cannot have.
#[cfg(unix)]
fn adopt(part: &File, replaced: &Metadata) -> bool {
    use std::os::unix::fs::{MetadataExt, PermissionsExt, fchown};
    let owner = |found: &Metadata| (found.uid(), found.gid());
    let is_own = part
        .metadata()
        .is_ok_and(|it| owner(&it) == owner(replaced));
    let is_owned = is_own || fchown(part, Some(replaced.uid()), Some(replaced.gid())).is_ok();
    let mode = fs::Permissions::from_mode(replaced.mode() & KEPT);
    is_owned && part.set_permissions(mode).is_ok() && replaced.nlink() == 1
}

#[cfg(not(unix))]
fn adopt(part: &File, replaced: &Metadata) -> bool {
    part.set_permissions(replaced.permissions()).is_ok()
}

/// Copies a part into the file that is kept; where the system can reserve space, it does so before
/// the first byte.
fn copy(mut part: NamedTempFile, mut kept: File) -> io::Result<()> {
    reserve(&kept, part.as_file().metadata()?.len())?;
    part.rewind()?;
    let length = io::copy(&mut part, &mut kept)?;
    kept.set_len(length)?;
    #[cfg(unix)]
    {
        use std::os::unix::fs::{MetadataExt, PermissionsExt};
        let mode = kept.metadata()?.mode();
        if mode & 0o6000 != 0 {
            kept.set_permissions(fs::Permissions::from_mode(mode & KEPT))?;
        }
    }
    kept.sync_all()
}

#[cfg(target_os = "linux")]
fn reserve(file: &File, length: u64) -> io::Result<()> {
    use rustix::fs::{FallocateFlags, fallocate};
    use rustix::io::Errno;
    if length == 0 {
        return Ok(());
    }
    match fallocate(file, FallocateFlags::KEEP_SIZE, 0, length) {
        Err(error @ (Errno::NOSPC | Errno::DQUOT | Errno::FBIG)) => Err(error.into()),
        // Some file systems cannot reserve space.
        _ => Ok(()),
    }
}

#[cfg(not(target_os = "linux"))]
fn reserve(_: &File, _: u64) -> io::Result<()> {
    Ok(())
}

/// Returns true if the name is too long or holds a NUL.
fn is_no_name(error: &io::Error) -> bool {
    use io::ErrorKind::{InvalidFilename, InvalidInput};
    matches!(error.kind(), InvalidFilename | InvalidInput)
}

/// Sets the permissions of a new file: all that the user's mask leaves.
#[cfg(unix)]
fn usual_mode<'b, 'p, 's>(builder: &'b mut Builder<'p, 's>) -> &'b mut Builder<'p, 's> {
    use std::os::unix::fs::PermissionsExt;
    builder.permissions(fs::Permissions::from_mode(0o666))
}

#[cfg(not(unix))]
fn usual_mode<'b, 'p, 's>(builder: &'b mut Builder<'p, 's>) -> &'b mut Builder<'p, 's> {
    builder
}

/// Opens a device or a pipe without waiting for its other end; a write waits for a slow reader.
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

impl Write for AtomicFile {
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

/// An adapter that makes any [`io::Write`] a [`fmt::Write`] and keeps the error that `fmt::Write`
/// cannot report.
#[derive(Debug)]
pub struct Stream<W> {
    writer: W,
    error: Option<io::Error>,
}

impl<W: io::Write> Stream<W> {
    /// Writes to `writer`, which does its own buffering.
    pub fn new(writer: W) -> Self {
        Stream {
            writer,
            error: None,
        }
    }

    /// Flushes, and returns the first error of all writing so far.
    ///
    /// # Errors
    /// The first error of the writer; output after it was not written.
    pub fn finish(&mut self) -> io::Result<()> {
        match self.error.take() {
            Some(error) => Err(error),
            None => self.writer.flush(),
        }
    }

    /// Returns the writer.
    pub fn into_inner(self) -> W {
        self.writer
    }
}

impl<W: io::Write> fmt::Write for Stream<W> {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        if self.error.is_some() {
            return Err(fmt::Error);
        }
        self.writer.write_all(text.as_bytes()).map_err(|error| {
            self.error = Some(error);
            fmt::Error
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::fmt::Write;
    use std::vec::Vec;

    #[test]
    fn text_goes_through() {
        let mut stream = Stream::new(Vec::new());
        assert_eq!(write!(stream, "a{}", 1), Ok(()));
        assert!(stream.finish().is_ok());
        assert_eq!(stream.writer, b"a1");
    }

    #[test]
    fn the_first_error_is_kept_and_ends_all_writing() {
        let mut room = [0; 3];
        let mut stream = Stream::new(room.as_mut_slice());
        assert_eq!(stream.write_str("abc"), Ok(()));
        assert!(stream.write_str("d").is_err());
        assert!(stream.write_str("").is_err());
        let error = stream.finish().expect_err("no room");
        assert_eq!(error.kind(), io::ErrorKind::WriteZero);
    }
}
