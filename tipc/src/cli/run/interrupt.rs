//! Ctrl-C, and the polite signals of the system.

use std::process;
use std::sync::atomic::{AtomicBool, Ordering};

static REQUESTED: AtomicBool = AtomicBool::new(false);

/// From now on a first Ctrl-C is a request, a second one ends the process at once.
pub(super) fn catch() {
    // Where handlers are not to be had, Ctrl-C keeps its usual meaning.
    let _ = ctrlc::set_handler(|| {
        if REQUESTED.swap(true, Ordering::Relaxed) {
            process::exit(130);
        }
    });
}

/// Ends the run as Ctrl-C does.
pub(super) fn request() {
    REQUESTED.store(true, Ordering::Relaxed);
}

/// Whether the run is to end.
pub(super) fn is_requested() -> bool {
    REQUESTED.load(Ordering::Relaxed)
}
