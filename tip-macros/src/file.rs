//! Finding the file of `include_tip!`.

use std::env;
use std::path::{Path, PathBuf};
use tipc::embed;
use tipc::message::Reading;

/// A source file.
#[derive(Debug)]
pub(crate) struct Found {
    /// Its absolute path.
    pub(crate) path: PathBuf,
    pub(crate) bytes: Vec<u8>,
}

/// Reads the file that `path` names: next to the invoking file, or else below the crate's folder.
pub(crate) fn find(path: &str, invoking: Option<&Path>) -> Result<Found, String> {
    let beside = invoking.and_then(Path::parent).map(Path::to_owned);
    let package = env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from);
    search(Path::new(path), beside.into_iter().chain(package))
}

fn search(path: &Path, folders: impl Iterator<Item = PathBuf>) -> Result<Found, String> {
    let mut tried: Vec<PathBuf> = Vec::new();
    for candidate in folders.map(|folder| folder.join(path)) {
        match embed::read_file(&candidate, embed::LIMIT) {
            Ok(bytes) => {
                let path = std::path::absolute(&candidate).unwrap_or(candidate);
                return Ok(Found { path, bytes });
            }
            // An absolute path is the same below every folder.
            Err(Reading::NoFile) => {
                if !tried.contains(&candidate) {
                    tried.push(candidate);
                }
            }
            Err(reason) => return Err(format!("{}: {reason}", candidate.display())),
        }
    }
    let tried: Vec<String> = tried
        .iter()
        .map(|path| path.display().to_string())
        .collect();
    Err(format!("looked for {}", tried.join(" and ")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_folder_that_has_the_file_wins() {
        let package = Path::new(env!("CARGO_MANIFEST_DIR"));
        let folders = || [package.join("src"), package.to_owned()].into_iter();
        let beside = search(Path::new("lib.rs"), folders()).unwrap();
        assert_eq!(beside.path, package.join("src/lib.rs"));
        let below = search(Path::new("Cargo.toml"), folders()).unwrap();
        assert_eq!(below.path, package.join("Cargo.toml"));
        assert!(!below.bytes.is_empty());
    }

    #[test]
    fn a_file_that_is_nowhere_names_every_place() {
        let folders = ["one", "two"].map(PathBuf::from).into_iter();
        let message = search(Path::new("gone.prg"), folders).unwrap_err();
        assert!(message.contains("gone.prg and "), "{message}");
        let folders = ["one", "two"].map(PathBuf::from).into_iter();
        let message = search(Path::new("/gone.prg"), folders).unwrap_err();
        assert_eq!(message, "looked for /gone.prg");
    }

    #[cfg(unix)]
    #[test]
    fn a_device_is_not_read() {
        let message = search(
            Path::new("/dev/zero"),
            ["one"].map(PathBuf::from).into_iter(),
        );
        let message = message.unwrap_err();
        assert!(
            message.contains("a device, a pipe or a socket"),
            "{message}"
        );
    }
}
