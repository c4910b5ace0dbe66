//! Processes that end with this one, and that signals of the terminal do not reach.

use std::io;
use std::process::{Child, Command, ExitStatus};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

/// Time between two checks that a process has ended.
const POLL_INTERVAL: Duration = Duration::from_millis(5);

/// The processes that were started here and have not been ended.
static RUNNING: Mutex<Vec<u32>> = Mutex::new(Vec::new());

/// Ends immediately all processes that were started here, and those that they started. A command calls it before an
/// exit that drops no values.
pub fn end_processes() {
    for id in running().drain(..) {
        kill(id);
    }
}

/// A process in a group of its own: Ctrl-C of the terminal is for this process, which then ends the other, and all that
/// it started, when it is dropped.
#[derive(Debug)]
pub(crate) struct ProcessGroup {
    child: Child,
    is_over: bool,
}

impl ProcessGroup {
    /// Starts a process.
    pub(crate) fn start(command: &mut Command) -> io::Result<Self> {
        lead(command);
        let child = command.spawn()?;
        running().push(child.id());
        Ok(ProcessGroup {
            child,
            is_over: false,
        })
    }

    /// Returns the process that was started itself.
    pub(crate) fn child(&mut self) -> &mut Child {
        &mut self.child
    }

    /// Waits up to a time for the end of the process that was started directly.
    pub(crate) fn wait(&mut self, longest: Duration) -> Option<ExitStatus> {
        let child = &mut self.child;
        wait(longest, || child.try_wait().ok().flatten())
    }

    /// Waits up to a time for the end of all processes, then ends them.
    pub(crate) fn end(&mut self, grace: Duration) {
        if std::mem::replace(&mut self.is_over, true) {
            return;
        }
        let id = self.child.id();
        let child = &mut self.child;
        let left = || child.try_wait().ok()?.filter(|_| !is_there(id)).map(drop);
        if wait(grace, left).is_none() {
            kill(id);
            // One that has ended meanwhile cannot be killed.
            let _ = self.child.kill();
            let _ = self.child.wait();
        }
        running().retain(|other| *other != id);
    }
}

impl Drop for ProcessGroup {
    fn drop(&mut self) {
        self.end(Duration::ZERO);
    }
}

/// Waits up to a time until `look` returns a value.
fn wait<T>(longest: Duration, mut look: impl FnMut() -> Option<T>) -> Option<T> {
    let begin = Instant::now();
    loop {
        match look() {
            None if begin.elapsed() < longest => thread::sleep(POLL_INTERVAL),
            seen => return seen,
        }
    }
}

fn running() -> MutexGuard<'static, Vec<u32>> {
    RUNNING.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(unix)]
fn lead(command: &mut Command) {
    use std::os::unix::process::CommandExt;
    command.process_group(0);
}

/// Returns true if there is a process in the group that this one leads, or led.
#[cfg(unix)]
fn is_there(id: u32) -> bool {
    group(id).is_some_and(|group| rustix::process::test_kill_process_group(group).is_ok())
}

/// Ends the processes in the group that this one leads, or led.
#[cfg(unix)]
fn kill(id: u32) {
    if let Some(group) = group(id) {
        // Those that have ended meanwhile cannot be killed.
        let _ = rustix::process::kill_process_group(group, rustix::process::Signal::KILL);
    }
}

#[cfg(unix)]
fn group(id: u32) -> Option<rustix::process::Pid> {
    rustix::process::Pid::from_raw(i32::try_from(id).ok()?)
}

#[cfg(not(unix))]
fn lead(_: &mut Command) {}

#[cfg(not(unix))]
fn is_there(_: u32) -> bool {
    false
}

#[cfg(not(unix))]
fn kill(_: u32) {}
