//! Ctrl-C, and the signals by which the system asks a process to end: SIGINT, SIGTERM and SIGHUP.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, AtomicU8, Ordering};
use std::sync::{Mutex, MutexGuard, Once, PoisonError};
use std::time::Duration;
use std::{fs, process, thread};
use tip_runtime::console::TerminalState;

static REQUESTED: AtomicBool = AtomicBool::new(false);

/// The signal that asked first, which the exit status names. A key asks as Ctrl-C does.
static SIGNAL: AtomicU8 = AtomicU8::new(SIGINT);

/// The number of SIGINT on every system.
const SIGINT: u8 = 2;

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
    static ONCE: Once = Once::new();
    release();
    ONCE.call_once(listen);
}

/// Listens to signals. One that was ignored before the process began, as `nohup` and background jobs have it, stays ignored.
/// Where handlers are not to be had, Ctrl-C keeps its usual meaning.
#[cfg(unix)]
fn listen() {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    let signals = [SIGINT, SIGTERM, SIGHUP].into_iter();
    let signals = signals.filter(|signal| !is_ignored(*signal));
    if let Ok(mut signals) = signal_hook::iterator::Signals::new(signals) {
        thread::spawn(move || {
            for signal in signals.forever() {
                signalled(u8::try_from(signal).unwrap_or(self::SIGINT));
            }
        });
    }
}

#[cfg(not(unix))]
fn listen() {
    let _ = ctrlc::set_handler(|| signalled(SIGINT));
}

/// Returns true if the process ignores a signal: by the system's own word, or else because a shell that it starts does.
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

/// A signal came.
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

/// The exit status of an interrupted command: 130 after Ctrl-C, 143 after SIGTERM, 129 after SIGHUP.
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
