//! Ctrl-C, and the signals by which the system asks a process to end: SIGINT, SIGTERM, SIGHUP and SIGQUIT. While the torque of a
//! robot may be on, they include every signal that would end the process and can be handled. SIGXFSZ is no request: the write fails.
//!
//! The first one is a request, which the command obeys. A second one, or time, ends a command that is stuck. Before the process
//! ends so, a robot whose torque is on is left in the state that its file names.
//!
//! A robot whose control loop stands still, before an output that nobody takes for example, cannot hear its operator: the terminal
//! gives no signals while keys are read one by one. It is left as in an emergency.

use crate::Status;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, AtomicU32, AtomicUsize, Ordering};
use std::sync::{Arc, LazyLock, Mutex, MutexGuard, Once, PoisonError, mpsc};
use std::time::Duration;
use std::{fs, process, thread};
use tip_runtime::console::TerminalState;

/// The number of the first signal; 0 before. A key counts as Ctrl-C. The operator of a robot reads it, and writes it.
static FIRST: LazyLock<Arc<AtomicUsize>> = LazyLock::new(Arc::default);

/// The number of SIGINT on every system.
const SIGINT: usize = 2;

/// The cleanup of a process that ends immediately; `None` while files are being completed.
static LAST: Mutex<Option<Last>> = Mutex::new(None);

/// The reason to end the process before its command has returned.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Cause {
    /// A second signal, or a command that does not obey the first one.
    Signal,
    /// The control loop of a robot stands still.
    Stall,
}

/// Leaves the robot whose torque is on, and returns the messages for its operator. It returns `None`, and does nothing, if the control
/// loop is running again.
type Leave = Box<dyn FnMut(Cause) -> Option<String> + Send>;

/// The robot whose torque is on, if there is one.
static ROBOT: Mutex<Option<Leave>> = Mutex::new(None);

/// Time after a signal, or after the last control cycle of a robot, until a command counts as stuck, in a full pipe or before one that
/// nobody reads.
const PATIENCE: Duration = Duration::from_secs(3);

/// Naps until the control loop of a robot counts as standing still. Each cycle sets them anew. They are counted, because a host that is
/// suspended does not nap.
static NAPS: AtomicU32 = AtomicU32::new(0);
const NAP: Duration = Duration::from_millis(100);

/// True while the torque of a robot may be on.
static HAS_TORQUE: AtomicBool = AtomicBool::new(false);

/// Time in which the last words of a process are written: nobody may read them.
const LAST_WORDS: Duration = Duration::from_millis(500);

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

/// Hears the signals of this process.
#[cfg(unix)]
static LISTENER: Mutex<Option<signal_hook::iterator::Handle>> = Mutex::new(None);

/// Handles signals in a thread. A signal that was ignored before the process began, as with `nohup` and background jobs, stays
/// ignored.
#[cfg(unix)]
fn listen() {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGQUIT, SIGTERM};
    let signals = [SIGINT, SIGTERM, SIGHUP, SIGQUIT].into_iter();
    let signals = signals.filter(|signal| !tip_drives::operator::is_ignored(*signal));
    let Ok(mut signals) = signal_hook::iterator::Signals::new(signals) else {
        return;
    };
    *lock(&LISTENER) = Some(signals.handle());
    thread::spawn(move || {
        for signal in signals.forever() {
            if suspends(signal) && !HAS_TORQUE.load(Ordering::Relaxed) {
                // Nothing is left to be done if the system refuses.
                let _ = signal_hook::low_level::emulate_default_handler(signal);
            } else {
                signalled(usize::try_from(signal).unwrap_or(SIGINT as usize));
            }
        }
    });
}

/// Hears all signals of a robot's operator from now on, those included that were ignored.
#[cfg(unix)]
fn listen_for_robot() {
    if let Some(listener) = lock(&LISTENER).as_ref() {
        for signal in tip_drives::operator::signals() {
            // A signal that the system does not tell of ends the process as before.
            let _ = listener.add_signal(signal);
        }
    }
}

/// Returns true for a signal that suspends a process. It ends one whose robot has torque: suspended, it could not leave the robot.
#[cfg(unix)]
fn suspends(signal: i32) -> bool {
    use signal_hook::consts::{SIGTSTP, SIGTTIN, SIGTTOU};
    matches!(signal, SIGTSTP | SIGTTIN | SIGTTOU)
}

/// Handles Ctrl-C in a thread that looks for it.
#[cfg(not(unix))]
fn listen() {
    let flag = Arc::new(AtomicBool::new(false));
    if signal_hook::flag::register(signal_hook::consts::SIGINT, Arc::clone(&flag)).is_ok() {
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

fn signalled(signal: usize) {
    if !first(signal) {
        return end(Cause::Signal);
    }
    thread::spawn(|| {
        loop {
            thread::sleep(PATIENCE);
            end(Cause::Signal);
        }
    });
}

/// Returns the exit status of an interrupted command: 130 after Ctrl-C, 143 after SIGTERM, 129 after SIGHUP, 131 after SIGQUIT;
/// 128 and the number of another signal.
pub(super) fn status() -> u8 {
    let signal = match FIRST.load(Ordering::Relaxed) {
        0 => SIGINT,
        signal => signal,
    };
    128 + signal as u8
}

/// Ends the process unless its files are being completed. A robot whose torque is on is left first.
fn end(cause: Cause) {
    let left = lock(&ROBOT).as_mut().map(|leave| leave(cause));
    let Some(words) = left.unwrap_or_else(|| Some(String::new())) else {
        return;
    };
    if let Some(last) = last().as_ref() {
        last.terminal.restore();
        if let Some(part) = &last.part {
            // The process ends in any case.
            let _ = fs::remove_file(part);
        }
        tip_sim::end_processes();
        complain_briefly(words);
        process::exit(match cause {
            Cause::Signal => status().into(),
            Cause::Stall => Status::Emergency as i32,
        });
    }
}

/// Writes to standard error, but not for long.
fn complain_briefly(words: String) {
    let (done, is_done) = mpsc::channel();
    thread::spawn(move || {
        // The process ends in any case.
        let _ = io::stderr().write_all(words.as_bytes());
        let _ = done.send(());
    });
    let _ = is_done.recv_timeout(LAST_WORDS);
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

/// Sets the robot whose torque is on. It is left before the process ends for a signal, whatever the rest of the process waits for, and
/// with `is_watched` when its control loop stands still.
pub(super) fn leaves_first(
    is_watched: bool,
    leave: impl FnMut(Cause) -> Option<String> + Send + 'static,
) {
    #[cfg(unix)]
    listen_for_robot();
    *lock(&ROBOT) = Some(Box::new(leave));
    cycle(0.0);
    HAS_TORQUE.store(true, Ordering::Relaxed);
    if is_watched {
        thread::spawn(watch);
    }
}

/// Looks after the control loop until the robot was left.
fn watch() {
    while HAS_TORQUE.load(Ordering::Relaxed) {
        thread::sleep(NAP);
        let next = |naps: u32| naps.checked_sub(1);
        if NAPS
            .fetch_update(Ordering::Relaxed, Ordering::Relaxed, next)
            .is_err()
        {
            // Who asked for the end wants the ordered one.
            end(match is_requested() {
                true => Cause::Signal,
                false => Cause::Stall,
            });
        }
    }
}

/// Tells of a control cycle of the robot, and when the next one comes, ms.
pub(super) fn cycle(period: f64) {
    let naps = (PATIENCE.as_secs_f64() * 1000.0 + period) / NAP.as_secs_f64() / 1000.0;
    NAPS.store(naps.ceil() as u32, Ordering::Relaxed);
}

/// Returns true if the control loop of the robot stands still.
pub(super) fn is_stalled() -> bool {
    NAPS.load(Ordering::Relaxed) == 0
}

/// Tells that the robot was left.
pub(super) fn is_left() {
    HAS_TORQUE.store(false, Ordering::Relaxed);
}

/// Ends the run as Ctrl-C does.
pub(super) fn request() {
    first(SIGINT);
}

/// Keeps the number of the first signal; returns false for another one.
fn first(signal: usize) -> bool {
    let order = Ordering::Relaxed;
    FIRST.compare_exchange(0, signal, order, order).is_ok()
}

/// Returns the place of the number of the first signal.
pub(super) fn signal() -> Arc<AtomicUsize> {
    Arc::clone(&FIRST)
}

/// Returns true if the command should end.
pub(super) fn is_requested() -> bool {
    FIRST.load(Ordering::Relaxed) > 0
}

fn last() -> MutexGuard<'static, Option<Last>> {
    lock(&LAST)
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
