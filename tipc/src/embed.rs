//! Shared code of macros, build scripts and commands. It is the only module that opens input files, and it chooses the
//! language of errors.

use crate::message::Reading;
use std::fs::{self, File};
use std::io::{self, Read};
use std::path::Path;

/// The environment variable that names the language of errors in a build. They are in English without it, whatever the
/// locale: a build's output is searched for, and sent to others.
pub const LANG: &str = "TIP_LANG";

/// The size limit of programs, descriptions, scenes and `tip.toml`, MiB.
pub const LIMIT: usize = 16;

/// Reads a regular file of at most `limit` MiB, which is opened once.
///
/// # Errors
/// Returns the reason, as a message.
pub fn read_file(path: &Path, limit: usize) -> Result<Vec<u8>, Reading> {
    read_stream(open_file(path)?, limit)
}

/// Opens a regular file to be read.
///
/// Devices, pipes and sockets are refused: reading them may never end, and a checkout may hold links to them.
///
/// # Errors
/// Returns the reason, as a message.
#[expect(
    clippy::disallowed_methods,
    reason = "the one place that opens input files"
)]
pub fn open_file(path: &Path) -> Result<File, Reading> {
    // Opening a device may have effects already. The file that is opened may be another one, so it is tested again.
    require_regular(&fs::metadata(path).map_err(unreadable)?)?;
    let mut options = File::options();
    options.read(true);
    do_not_wait(&mut options);
    let file = options.open(path).map_err(unreadable)?;
    require_regular(&file.metadata().map_err(unreadable)?)?;
    Ok(file)
}

/// Reads a stream to its end, which must come within `limit` MiB.
///
/// # Errors
/// Returns the reason, as a message.
pub fn read_stream(stream: impl Read, limit: usize) -> Result<Vec<u8>, Reading> {
    let most = (limit as u64) << 20;
    let mut bytes = Vec::new();
    let read = stream.take(most + 1).read_to_end(&mut bytes);
    read.map_err(unreadable)?;
    match bytes.len() as u64 > most {
        true => Err(Reading::TooLarge { limit }),
        false => Ok(bytes),
    }
}

fn require_regular(found: &fs::Metadata) -> Result<(), Reading> {
    match (found.is_file(), found.is_dir()) {
        (true, _) => Ok(()),
        (_, true) => Err(Reading::Folder),
        _ => Err(Reading::NotRegular),
    }
}

/// Opens a pipe that has taken the place of a file without waiting for its writer.
#[cfg(unix)]
fn do_not_wait(options: &mut fs::OpenOptions) {
    use std::os::unix::fs::OpenOptionsExt;
    options.custom_flags(libc::O_NONBLOCK);
}

#[cfg(not(unix))]
fn do_not_wait(_: &mut fs::OpenOptions) {}

fn unreadable(error: io::Error) -> Reading {
    match error.kind() {
        io::ErrorKind::IsADirectory => Reading::Folder,
        io::ErrorKind::NotFound => Reading::NoFile,
        io::ErrorKind::PermissionDenied => Reading::NotAllowed,
        _ => Reading::System {
            error: error.to_string().into(),
        },
    }
}
