//! Ctrl-C, and the polite signals of the system.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;
use std::{fs, process, thread};
use tip_runtime::console::TerminalState;

static REQUESTED: AtomicBool = AtomicBool::new(false);

/// What a process that ends at once leaves in order; none where it would only disturb the completion of files.
static LAST: Mutex<Option<Last>> = Mutex::new(None);

/// A run that does not end by itself so long after a signal is stuck: in a full pipe, or before one that nobody reads.
const PATIENCE: Duration = Duration::from_secs(3);

struct Last {
    terminal: TerminalState,
    /// Of a trace, which is given up.
    part: Option<PathBuf>,
}

/// From now on a first Ctrl-C is a request; a second one, or time, ends a command that is stuck.
pub(super) fn catch() {
    release();
    // Where handlers are not to be had, Ctrl-C keeps its usual meaning.
    let _ = ctrlc::set_handler(|| {
        if REQUESTED.swap(true, Ordering::Relaxed) {
            end();
        } else {
            thread::spawn(|| {
                loop {
                    thread::sleep(PATIENCE);
                    end();
                }
            });
        }
    });
}

/// Ends the process unless its files are being completed.
fn end() {
    if let Some(last) = last().as_ref() {
        last.terminal.restore();
        if let Some(part) = &last.part {
            // The process ends in any case.
            let _ = fs::remove_file(part);
        }
        tip_sim::end_processes();
        process::exit(130);
    }
}

/// A process that ends at once does not leave this part of a file.
pub(super) fn discards(part: Option<&Path>) {
    if let Some(last) = last().as_mut() {
        last.part = part.map(Path::to_owned);
    }
}

/// The run is over: what it leaves is completed, whoever presses Ctrl-C.
pub(super) fn hold() {
    *last() = None;
}

/// No file is left to complete: what is still written may never find a reader.
pub(super) fn release() {
    *last() = Some(Last {
        terminal: TerminalState::now(),
        part: None,
    });
}

/// Ends the run as Ctrl-C does.
pub(super) fn request() {
    REQUESTED.store(true, Ordering::Relaxed);
}

/// Whether the command is to end.
pub(super) fn is_requested() -> bool {
    REQUESTED.load(Ordering::Relaxed)
}

fn last() -> MutexGuard<'static, Option<Last>> {
    LAST.lock().unwrap_or_else(PoisonError::into_inner)
}
