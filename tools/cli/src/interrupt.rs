//! Ctrl-C, and the signals by which the system asks a process to end: SIGINT, SIGTERM, SIGHUP and SIGQUIT. While the torque of a
//! robot may be on, they include every signal that would end the process and can be handled.
//!
//! The first one is a request, which the command obeys. A second one, or time, ends a command that is stuck. Before the process
//! ends so, a robot whose torque is on is left in the state that its file names.

use std::io::{self, Write};
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

/// Leaves the robot whose torque is on, and returns what its operator has to know.
type Leave = Box<dyn FnMut() -> String + Send>;

/// The robot whose torque is on, if there is one.
static ROBOT: Mutex<Option<Leave>> = Mutex::new(None);

/// Time after a signal until a command counts as stuck, in a full pipe or before one that nobody reads.
const PATIENCE: Duration = Duration::from_secs(3);

struct Last {
    terminal: TerminalState,
    /// The unfinished file of a trace, which is removed.
    part: Option<PathBuf>,
}

/// Makes the first signal a request; a second one, or time, ends a command that is stuck.
pub(super) fn catch() {
    static ONCE: Once = Once::new();
    release();
    ONCE.call_once(listen);
}

/// Handles signals in a thread. A signal that was ignored before the process began, as with `nohup` and background jobs, stays
/// ignored.
#[cfg(unix)]
fn listen() {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGQUIT, SIGTERM};
    let signals = [SIGINT, SIGTERM, SIGHUP, SIGQUIT].into_iter();
    listen_for(signals.filter(|signal| !is_ignored(*signal)));
}

/// Handles, while the torque of a robot may be on, all signals that would end the process or whose sender wants it to end. Only
/// SIGHUP stays ignored, because that is what `nohup` is for.
#[cfg(unix)]
fn listen_for_robot() {
    use signal_hook::consts::{
        SIGALRM, SIGINT, SIGIO, SIGPROF, SIGQUIT, SIGTERM, SIGUSR1, SIGUSR2, SIGVTALRM, SIGXCPU,
    };
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        let ignored = [SIGINT, SIGTERM, SIGQUIT].into_iter();
        let ignored = ignored.filter(|signal| is_ignored(*signal));
        let others = [
            SIGALRM, SIGIO, SIGPROF, SIGUSR1, SIGUSR2, SIGVTALRM, SIGXCPU,
        ];
        listen_for(ignored.chain(others));
    });
}

/// Handles some signals in a thread.
#[cfg(unix)]
fn listen_for(signals: impl Iterator<Item = i32>) {
    if let Ok(mut signals) = signal_hook::iterator::Signals::new(signals) {
        thread::spawn(move || {
            for signal in signals.forever() {
                signalled(u8::try_from(signal).unwrap_or(SIGINT));
            }
        });
    }
}

/// Handles Ctrl-C in a thread that looks for it.
#[cfg(not(unix))]
fn listen() {
    use std::sync::Arc;
    let flag = Arc::new(AtomicBool::new(false));
    if signal_hook::flag::register(SIGINT.into(), Arc::clone(&flag)).is_ok() {
        thread::spawn(move || {
            loop {
                thread::sleep(Duration::from_millis(20));
                if flag.swap(false, Ordering::Relaxed) {
                    signalled(SIGINT);
                }
            }
        });
    }
}

/// Returns true if the process ignores a signal, as far as the system says so in a file: elsewhere, none is ignored.
#[cfg(unix)]
fn is_ignored(signal: i32) -> bool {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let ignored = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let mask = ignored.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
    mask.is_some_and(|mask| mask >> (signal - 1) & 1 == 1)
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

/// Returns the exit status of an interrupted command: 130 after Ctrl-C, 143 after SIGTERM, 129 after SIGHUP, 131 after SIGQUIT;
/// 128 and the number of another signal.
pub(super) fn status() -> u8 {
    128 + SIGNAL.load(Ordering::Relaxed)
}

/// Ends the process unless its files are being completed. A robot whose torque is on is left first.
fn end() {
    let left = lock(&ROBOT).as_mut().map(|leave| leave());
    if let Some(last) = last().as_ref() {
        last.terminal.restore();
        if let Some(part) = &last.part {
            // The process ends in any case.
            let _ = fs::remove_file(part);
        }
        tip_sim::end_processes();
        // The process ends in any case.
        let _ = io::stderr().write_all(left.unwrap_or_default().as_bytes());
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

/// Sets the robot whose torque is on. It is left before the process ends for a signal, whatever the rest of the process waits for.
pub(super) fn leaves_first(leave: impl FnMut() -> String + Send + 'static) {
    #[cfg(unix)]
    listen_for_robot();
    *lock(&ROBOT) = Some(Box::new(leave));
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
    lock(&LAST)
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
