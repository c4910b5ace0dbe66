//! Watches files for changes.

use super::error::Error;
use super::interrupt;
use notify::{Event, RecommendedWatcher, RecursiveMode, Watcher};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

/// Maximum delay of Ctrl-C.
const NAP: Duration = Duration::from_millis(100);
/// Maximum time between the steps in which an editor writes a file, which are one change.
const QUIET: Duration = Duration::from_millis(50);
/// Maximum time of such a change.
const MAX_CHANGE: Duration = Duration::from_secs(1);

/// The watched files.
pub(super) struct Watch {
    /// The watcher; dropping it ends the watch.
    watcher: RecommendedWatcher,
    events: Receiver<notify::Result<Event>>,
    files: BTreeSet<PathBuf>,
}

impl Watch {
    /// Starts to watch. Folders are watched, since editors replace files.
    ///
    /// # Errors
    /// A file is in no folder that exists, or the system does not report changes.
    pub(super) fn begin<'a>(files: impl IntoIterator<Item = &'a Path>) -> Result<Self, Error> {
        let failed = |file: &Path, error: &dyn std::fmt::Display| {
            Error::Failed(format!("{}: {error}", file.display()))
        };
        let (sender, events) = channel();
        let watcher = notify::recommended_watcher(sender)
            .map_err(|error| Error::Failed(error.to_string()))?;
        let mut watch = Watch {
            watcher,
            events,
            files: BTreeSet::new(),
        };
        for file in files {
            watch.add(file).map_err(|error| failed(file, &error))?;
        }
        Ok(watch)
    }

    /// Watches more files, as far as the system allows it.
    pub(super) fn extend(&mut self, files: impl IntoIterator<Item = PathBuf>) {
        for file in files {
            // A check could not read files in a folder that cannot be watched.
            let _ = self.add(&file);
        }
    }

    fn add(&mut self, file: &Path) -> Result<(), Box<dyn std::error::Error>> {
        let real = real(file)?;
        // A link may be changed, and so may what it leads to.
        let target = fs::canonicalize(file).ok();
        for path in [Some(real), target].into_iter().flatten() {
            if !self.files.contains(&path) {
                if let Some(folder) = path.parent() {
                    self.watcher.watch(folder, RecursiveMode::NonRecursive)?;
                }
                self.files.insert(path);
            }
        }
        Ok(())
    }

    /// Waits for a change of a file; returns false if Ctrl-C comes first.
    pub(super) fn changed(&self) -> bool {
        while !interrupt::is_requested() {
            if self.is_changed_within(NAP) {
                let change = Instant::now();
                while self.is_changed_within(QUIET) && change.elapsed() < MAX_CHANGE {}
                return true;
            }
        }
        false
    }

    fn is_changed_within(&self, time: Duration) -> bool {
        let end = Instant::now() + time;
        loop {
            let left = end.saturating_duration_since(Instant::now());
            match self.events.recv_timeout(left) {
                // The check itself opens the files.
                Ok(Ok(event)) if event.kind.is_access() => {}
                Ok(Ok(event)) if !event.paths.iter().any(|path| self.files.contains(path)) => {}
                // Missed events may be changes.
                Ok(_) => return true,
                Err(_) => return false,
            }
        }
    }
}

/// Returns the path of a file, which need not exist, in its folder without links.
fn real(file: &Path) -> std::io::Result<PathBuf> {
    let folder = file
        .parent()
        .filter(|folder| !folder.as_os_str().is_empty());
    let folder = fs::canonicalize(folder.unwrap_or(Path::new(".")))?;
    Ok(folder.join(file.file_name().unwrap_or_default()))
}
