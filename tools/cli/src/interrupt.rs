//! Ctrl-C, and the signals by which the system asks a process to end: SIGINT, SIGTERM and SIGHUP.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, AtomicU8, Ordering};
use std::sync::{Mutex, MutexGuard, Once, PoisonError};
use std::time::Duration;
use std::{fs, process, thread};
use tip_runtime::console::TerminalState;

static REQUESTED: AtomicBool = AtomicBool::new(false);

/// The first signal, which the exit status names. A key counts as Ctrl-C.
static SIGNAL: AtomicU8 = AtomicU8::new(SIGINT);

/// The number of SIGINT on every system.
const SIGINT: u8 = 2;

/// The cleanup of a process that ends immediately; `None` while files are being completed.
static LAST: Mutex<Option<Last>> = Mutex::new(None);

/// Time after a signal until a command counts as stuck, in a full pipe or before one that nobody reads.
const PATIENCE: Duration = Duration::from_secs(3);

struct Last {
    terminal: TerminalState,
    /// The unfinished file of a trace, which is removed.
    part: Option<PathBuf>,
}

/// Makes the first Ctrl-C a request; a second one, or time, ends a command that is stuck.
pub(super) fn catch() {
    static ONCE: Once = Once::new();
    release();
    ONCE.call_once(listen);
}

/// Handles signals in a thread. A signal that was ignored before the process began, as with `nohup` and background jobs, stays
/// ignored. Blocked signals wait for the thread, so that none is lost while it starts, as it could be between installing a handler
/// and its data. The standard library unblocks them in child processes.
#[cfg(unix)]
fn listen() {
    use nix::sys::signal::{SigSet, Signal};
    let signals = [Signal::SIGINT, Signal::SIGTERM, Signal::SIGHUP].into_iter();
    let signals: SigSet = signals
        .filter(|signal| !is_ignored(*signal as i32))
        .collect();
    if signals.thread_block().is_ok() {
        thread::spawn(move || {
            while let Ok(signal) = signals.wait() {
                signalled(u8::try_from(signal as i32).unwrap_or(SIGINT));
            }
        });
    }
}

#[cfg(not(unix))]
fn listen() {
    let _ = ctrlc::set_handler(|| signalled(SIGINT));
}

/// Returns true if the process ignores a signal, according to the system or to a shell that it starts.
#[cfg(unix)]
fn is_ignored(signal: i32) -> bool {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let ignored = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    match ignored.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()) {
        Some(mask) => mask >> (signal - 1) & 1 == 1,
        None => {
            let mut shell = process::Command::new("sh");
            shell.arg("-c").arg(format!("kill -{signal} $$"));
            shell.stdin(process::Stdio::null());
            shell.status().is_ok_and(|status| status.success())
        }
    }
}

fn signalled(signal: u8) {
    if REQUESTED.load(Ordering::Relaxed) {
        return end();
    }
    SIGNAL.store(signal, Ordering::Relaxed);
    request();
    thread::spawn(|| {
        loop {
            thread::sleep(PATIENCE);
            end();
        }
    });
}

/// Returns the exit status of an interrupted command: 130 after Ctrl-C, 143 after SIGTERM, 129 after SIGHUP.
pub(super) fn status() -> u8 {
    128 + SIGNAL.load(Ordering::Relaxed)
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
        process::exit(status().into());
    }
}

/// Sets the unfinished file that a process removes when it ends immediately.
pub(super) fn discards(part: Option<&Path>) {
    if let Some(last) = last().as_mut() {
        last.part = part.map(Path::to_owned);
    }
}

/// Lets the command complete its files after the run, whatever signals come.
pub(super) fn hold() {
    *last() = None;
}

/// Lets a signal end the process: no file is left to complete, and output may wait for a reader.
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

/// Returns true if the command should end.
pub(super) fn is_requested() -> bool {
    REQUESTED.load(Ordering::Relaxed)
}

fn last() -> MutexGuard<'static, Option<Last>> {
    LAST.lock().unwrap_or_else(PoisonError::into_inner)
}
