//! A folder that appears with all its files, or not at all.

use super::files::File;
use super::name::Place;
use crate::message::Making;
use std::path::{Path, PathBuf};
use std::{fs, io, process};

/// Writes the files into a new folder.
///
/// # Errors
/// The folder is taken, has nowhere to be, or cannot be written; then there is none.
pub(super) fn write(place: &Place, files: &[File]) -> Result<(), Making> {
    let folder = place.folder();
    let named = |path: &Path| path.display().to_string().into();
    if !is_free(folder) {
        return Err(Making::FolderTaken {
            folder: named(folder),
        });
    }
    let parent = match folder.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    if !parent.is_dir() {
        return Err(Making::NoFolder {
            folder: named(parent),
        });
    }
    let beside = Beside(parent.join(format!(".{}-{}", place.name(), process::id())));
    beside.fill(files, folder).map_err(|error| Making::NotMade {
        folder: named(folder),
        error: error.to_string().into(),
        name: place.name().to_owned(),
    })
}

/// Whether nothing is there, or an empty folder.
fn is_free(folder: &Path) -> bool {
    match fs::read_dir(folder) {
        Ok(mut entries) => entries.next().is_none(),
        Err(error) => error.kind() == io::ErrorKind::NotFound && folder.symlink_metadata().is_err(),
    }
}

/// A folder beside the one that is to appear; nothing stays of it.
struct Beside(PathBuf);

impl Beside {
    fn fill(&self, files: &[File], folder: &Path) -> io::Result<()> {
        fs::create_dir(&self.0)?;
        for file in files {
            let path = self.0.join(&file.name);
            path.parent().map_or(Ok(()), fs::create_dir_all)?;
            fs::write(path, &file.content)?;
        }
        // An empty folder in its place is given up only now.
        match fs::remove_dir(folder) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
            _ => fs::rename(&self.0, folder),
        }
    }
}

impl Drop for Beside {
    fn drop(&mut self) {
        // After its renaming it is not there.
        let _ = fs::remove_dir_all(&self.0);
    }
}
