//! The operator of a robot at a terminal of this machine: RETURN is the emergency stop, ESC, Ctrl-C and signals are the ordered end.
//!
//! ```no_run
//! use tip_drives::described::{self, Described};
//! use tip_drives::guard::Step;
//! use tip_drives::operator;
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let description = described::read("robot.toml", &std::fs::read("robot.toml")?)?;
//! let robot = Described::new(&description)?;
//! let mut guard = operator::open(&robot, "/dev/ttyUSB0")?;
//! guard.connect()?;
//! if guard.approach(&robot.initial, robot.bus.start)? == Step::Arrived {
//!     // Here it is the `Hardware` of a machine.
//!     operator::leave(&mut guard, &robot)?;
//! }
//! # Ok(())
//! # }
//! ```

use crate::bus::Port;
use crate::described::Described;
use crate::drives::Policy;
use crate::guard::{Host, Outcome, Request, TorqueGuard};
use crate::port::{AnyPort, SIMULATED};
use crate::serial::Serial;
use crate::simulated::MemoryPort;
use core::borrow::BorrowMut;
use core::fmt;
use std::boxed::Box;
use std::collections::VecDeque;
use std::path::Path;
use std::string::String;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread::sleep;
use std::time::Duration;
use std::vec::Vec;
use std::{format, io};
use tip_runtime::console::{Console, Terminal};
use tip_runtime::plant::{Distances, Gap};

/// Bytes of keys.
const RETURN: u8 = 0x0D;
/// RETURN that was pressed before keys were read one by one.
const LINE_FEED: u8 = 0x0A;
const ESCAPE: u8 = 0x1B;
/// The signal for which the key Ctrl-C counts.
const CONTROL_C: usize = signal_hook::consts::SIGINT as usize;
/// Exit status of a process that a signal ends, without the number of the signal.
const BY_SIGNAL: u8 = 128;

/// Opens a robot on a serial port, or on simulated servos if the port is "simulated". From now on signals end nothing: whoever holds
/// the guard asks its host for them.
///
/// # Errors
/// The port cannot be opened, or no robot can have such drives.
pub fn open(
    robot: &Described,
    port: &str,
) -> Result<TorqueGuard<AnyPort, Operator>, Box<dyn core::error::Error>> {
    let opened = match port {
        SIMULATED => AnyPort::Memory(Box::new(MemoryPort::new(robot.simulated()))),
        name => {
            let opened = Serial::open(Path::new(name), robot.bus.baud);
            AnyPort::Serial(opened.map_err(|error| format!("{name}: {error}"))?)
        }
    };
    let drives = robot.drives(opened)?;
    let operator = Operator::new()?.of_robot(robot);
    Ok(TorqueGuard::new(drives, operator, robot.period))
}

/// Leaves a robot in order, or as in an emergency if it was stopped. The keys are read meanwhile.
///
/// # Errors
/// The servos that are not in the state in which they were to be left, or may not be.
pub fn leave<H: Host<AnyPort> + BorrowMut<Operator>>(
    guard: &mut TorqueGuard<AnyPort, H>,
    robot: &Described,
) -> Result<(), Unsettled> {
    if guard.has_torque() {
        if Terminal::is_in_foreground() {
            guard.host_mut().borrow_mut().take_keys();
        }
        guard.leave();
    }
    guard.host_mut().borrow_mut().give_keys();
    match guard.outcome() {
        Some(outcome) if !outcome.is_certain() => Err(Unsettled::new(outcome, robot)),
        _ => Ok(()),
    }
}

/// The servos that are not in the state in which a robot was to be left, or may not be.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unsettled {
    /// The state that they were to have.
    pub policy: Policy,
    /// Names of the joints whose servos have the other state.
    pub other: Vec<String>,
    /// Names of the joints whose servos did not confirm their state.
    pub unknown: Vec<String>,
}

impl Unsettled {
    fn new(outcome: &Outcome, robot: &Described) -> Self {
        Unsettled {
            policy: outcome.policy,
            other: robot.names(&outcome.other),
            unknown: robot.names(&outcome.unknown),
        }
    }
}

impl fmt::Display for Unsettled {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Unsettled {
            policy,
            other,
            unknown,
        } = self;
        let state = match policy {
            Policy::Hold => "hold",
            Policy::Relax => "relax",
        };
        if !other.is_empty() {
            let other = other.join(", ");
            write!(f, "these were to {state}, and do not: {other}. ")?;
        }
        if !unknown.is_empty() {
            let unknown = unknown.join(", ");
            write!(f, "these did not confirm that they {state}: {unknown}. ")?;
        }
        f.write_str("Switch their power off")
    }
}

impl core::error::Error for Unsettled {}

/// Returns the signals that would end or suspend this process, and leave stiff servos. SIGHUP is not one of them where it is ignored:
/// that is what `nohup` is for.
#[cfg(unix)]
pub fn signals() -> Vec<i32> {
    use signal_hook::consts::{
        SIGALRM, SIGHUP, SIGINT, SIGIO, SIGPROF, SIGQUIT, SIGTERM, SIGTSTP, SIGTTIN, SIGTTOU,
        SIGUSR1, SIGUSR2, SIGVTALRM, SIGXCPU,
    };
    let always = [
        SIGINT, SIGTERM, SIGQUIT, SIGALRM, SIGIO, SIGPROF, SIGTSTP, SIGTTIN, SIGTTOU, SIGUSR1,
        SIGUSR2, SIGVTALRM, SIGXCPU,
    ];
    let hangup = Some(SIGHUP).filter(|signal| !is_ignored(*signal));
    always.into_iter().chain(hangup).collect()
}

/// Returns the signals that ask this process to end.
#[cfg(not(unix))]
pub fn signals() -> Vec<i32> {
    use signal_hook::consts::{SIGINT, SIGTERM};
    [SIGINT, SIGTERM].into()
}

/// Returns true if this process ignores a signal, as far as the system says so in a file: elsewhere, none is ignored.
#[cfg(unix)]
#[allow(clippy::disallowed_methods, reason = "Linux tells it in a file")]
pub fn is_ignored(signal: i32) -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let ignored = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let mask = ignored.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
    mask.is_some_and(|mask| mask >> (signal - 1) & 1 == 1)
}

/// Lets a write beyond the limit of a file's size fail, as on a full disk: the signal for it would end the process.
#[cfg(unix)]
pub fn let_writes_fail() {
    let signal = rustix::process::Signal::XFSZ.as_raw();
    // If the system refuses, the signal ends the process as before.
    let _ = signal_hook::flag::register(signal, Arc::default());
}

/// Does nothing: files have no such limit here.
#[cfg(not(unix))]
pub fn let_writes_fail() {}

/// The operator of a robot.
#[derive(Debug)]
pub struct Operator {
    /// Reads the keys, unless somebody else does.
    keyboard: Option<Terminal<io::Sink>>,
    /// Other keys than those that end.
    typed: VecDeque<u8>,
    /// Number of the last signal; 0 before. A key counts as Ctrl-C.
    last: Arc<AtomicUsize>,
    /// Number of the first signal that was noticed.
    signal: Option<u8>,
    /// The distances between the parts of the robot, if they are known.
    distances: Option<Distances>,
}

/// The most keys that are kept.
const MAX_TYPED: usize = 64;

impl Operator {
    /// Takes the keys of the terminal, and the signals that ask this process to end.
    ///
    /// # Errors
    /// The system does not tell of a signal.
    pub fn new() -> io::Result<Self> {
        let last = Arc::new(AtomicUsize::new(0));
        let mut operator = Self::of_signals(Arc::clone(&last));
        // In the background it is suspended here, before any torque.
        operator.take_keys();
        let_writes_fail();
        for signal in signals() {
            let number = usize::try_from(signal).unwrap_or_default();
            signal_hook::flag::register_usize(signal, Arc::clone(&last), number)?;
        }
        Ok(operator)
    }

    /// Returns the operator of a program that handles the signals itself, and writes the number of one here. Ctrl-C as a key is written
    /// here too. The keys are not read yet.
    pub const fn of_signals(last: Arc<AtomicUsize>) -> Self {
        Operator {
            keyboard: None,
            typed: VecDeque::new(),
            last,
            signal: None,
            distances: None,
        }
    }

    /// Judges commands by the distances between the parts of this robot.
    #[must_use]
    pub fn of_robot(mut self, robot: &Described) -> Self {
        self.distances = Some(robot.distances.clone());
        self
    }

    /// Gives the keyboard away, such as to the console of a machine.
    pub fn give_keys(&mut self) -> Option<Terminal<io::Sink>> {
        self.keyboard.take()
    }

    /// Reads the keys from now on, also those of a console that has not let them go.
    pub fn take_keys(&mut self) {
        let open = || Terminal::on(io::sink(), false).report_interrupts();
        self.keyboard.get_or_insert_with(open);
    }

    /// Returns the oldest key that was typed and asks for nothing.
    pub fn key(&mut self) -> Option<u8> {
        self.typed.pop_front()
    }

    /// Returns the number of the first signal that asked this process to end.
    pub fn signal(&mut self) -> Option<u8> {
        let last = u8::try_from(self.last.load(Ordering::Relaxed));
        self.signal = self.signal.or(last.ok().filter(|last| *last > 0));
        self.signal
    }

    /// Returns the exit status of a process that was asked to end, as shells have it: 128 and the number of the first signal. A key
    /// counts as Ctrl-C.
    pub fn status(&mut self) -> u8 {
        BY_SIGNAL + self.signal().unwrap_or(CONTROL_C as u8)
    }
}

impl Host<AnyPort> for Operator {
    fn wait(&mut self, port: &mut AnyPort, until: u64) {
        match port {
            AnyPort::Memory(port) => port.pass(until),
            AnyPort::Serial(port) => {
                let left = until.saturating_sub(port.now());
                sleep(Duration::from_micros(left));
            }
        }
    }

    fn request(&mut self) -> Option<Request> {
        let mut request = None;
        if let Some(keyboard) = &mut self.keyboard {
            while let Some(key) = keyboard.key(0) {
                match key {
                    RETURN | LINE_FEED => return Some(Request::EmergencyStop),
                    ESCAPE => request = Some(Request::End),
                    _ if self.typed.len() < MAX_TYPED => self.typed.push_back(key),
                    _ => {}
                }
            }
            if keyboard.interrupted() {
                let (one, order) = (CONTROL_C, Ordering::Relaxed);
                // A signal that came before stays the first.
                let _ = self.last.compare_exchange(0, one, order, order);
            }
        }
        request.or(self.signal().map(|_| Request::End))
    }

    fn gap(&self, angles: &[f64]) -> Option<Gap> {
        self.distances.as_ref()?.at(angles)
    }
}
