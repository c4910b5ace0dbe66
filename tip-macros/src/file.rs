//! Finding the file of `include_tip!`.

use crate::literal::Text;
use std::path::{Path, PathBuf};
use std::{env, fs};
use tipc::embed;
use tipc::message::Reading;

/// A source file.
#[derive(Debug)]
pub(crate) struct Found {
    /// Its absolute path.
    pub(crate) path: PathBuf,
    pub(crate) bytes: Vec<u8>,
}

/// The reason for which no file is read.
#[derive(Debug)]
pub(crate) enum Fault {
    /// It is not there, or may not be read.
    NotRead(Reading),
    /// The path leads to two files.
    Two(Reading),
}

/// Reads the file that a literal names: next to the file that the literal is written in, or else below the crate's folder.
/// `invoking` stands for the literal's file where the compiler does not know that.
pub(crate) fn find(path: &Text, invoking: Option<&Path>) -> Result<Found, Fault> {
    let written = path.file().or_else(|| invoking.map(Path::to_owned));
    let beside = written
        .as_deref()
        .and_then(Path::parent)
        .map(Path::to_owned);
    let package = env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from);
    search(Path::new(&path.value), beside.into_iter().chain(package))
}

/// Reads the one file that the path leads to from some of the folders. A second one would replace the first without a
/// word when that goes, or comes, and nothing would build the crate again.
fn search(path: &Path, folders: impl Iterator<Item = PathBuf>) -> Result<Found, Fault> {
    let mut tried: Vec<PathBuf> = Vec::new();
    let mut found: Option<Found> = None;
    for candidate in folders.map(|folder| folder.join(path)) {
        // An absolute path is the same below every folder.
        if tried.contains(&candidate) {
            continue;
        }
        match (embed::read_file(&candidate, embed::LIMIT), &found) {
            (Ok(_), Some(first)) if is_same(&first.path, &candidate) => {}
            (Ok(_), Some(first)) => {
                return Err(Fault::Two(Reading::TwoFiles {
                    first: first.path.display().to_string().into(),
                    second: absolute(&candidate).display().to_string().into(),
                }));
            }
            (Ok(bytes), None) => {
                let path = absolute(&candidate);
                found = Some(Found { path, bytes });
            }
            (Err(Reading::NoFile), _) => {}
            (Err(reason), _) => {
                let error = format!("{}: {reason}", candidate.display()).into();
                return Err(Fault::NotRead(Reading::System { error }));
            }
        }
        tried.push(candidate);
    }
    found.ok_or_else(|| {
        let tried: Vec<String> = tried
            .iter()
            .map(|path| path.display().to_string())
            .collect();
        let error = format!("looked for {}", tried.join(" and ")).into();
        Fault::NotRead(Reading::System { error })
    })
}

fn absolute(path: &Path) -> PathBuf {
    std::path::absolute(path).unwrap_or_else(|_| path.to_owned())
}

/// Returns true if two paths lead to the same file.
fn is_same(one: &Path, other: &Path) -> bool {
    let real = |path: &Path| fs::canonicalize(path).ok();
    real(one).is_some_and(|one| Some(one) == real(other))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_looked_for_in_each_folder() {
        let package = Path::new(env!("CARGO_MANIFEST_DIR"));
        let folders = || [package.join("src"), package.to_owned()].into_iter();
        let beside = search(Path::new("lib.rs"), folders()).unwrap();
        assert_eq!(beside.path, package.join("src/lib.rs"));
        let below = search(Path::new("Cargo.toml"), folders()).unwrap();
        assert_eq!(below.path, package.join("Cargo.toml"));
        assert!(!below.bytes.is_empty());
    }

    #[test]
    fn a_path_that_leads_to_two_files_names_both() {
        let package = Path::new(env!("CARGO_MANIFEST_DIR"));
        let (here, there) = (package.join("src"), package.join("../tipc/src"));
        let folders = [here.clone(), there.clone()].into_iter();
        let fault = search(Path::new("lib.rs"), folders).unwrap_err();
        let two = Reading::TwoFiles {
            first: here.join("lib.rs").display().to_string().into(),
            second: there.join("lib.rs").display().to_string().into(),
        };
        assert!(
            matches!(&fault, Fault::Two(told) if *told == two),
            "{fault:?}"
        );
        // One file by two paths.
        let folders = [here.clone(), here.join("../src")].into_iter();
        let found = search(Path::new("lib.rs"), folders).unwrap();
        assert_eq!(found.path, here.join("lib.rs"));
    }

    #[test]
    fn a_missing_file_names_every_searched_folder() {
        let looked = |path: &str| {
            let folders = ["one", "two"].map(PathBuf::from).into_iter();
            match search(Path::new(path), folders) {
                Err(Fault::NotRead(told)) => told.to_string(),
                other => panic!("{other:?}"),
            }
        };
        let message = looked("gone.prg");
        assert!(message.contains("gone.prg and "), "{message}");
        assert_eq!(looked("/gone.prg"), "looked for /gone.prg");
    }

    #[cfg(unix)]
    #[test]
    fn a_device_is_not_read() {
        let message = search(
            Path::new("/dev/zero"),
            ["one"].map(PathBuf::from).into_iter(),
        );
        let Err(Fault::NotRead(reason)) = message else {
            panic!("{message:?}")
        };
        let message = reason.to_string();
        assert!(
            message.contains("a device, a pipe or a socket"),
            "{message}"
        );
    }
}
