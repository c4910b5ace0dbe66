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
use crate::guard::{Host, Request, TorqueGuard};
use crate::port::{AnyPort, SIMULATED};
use crate::serial::Serial;
use crate::simulated::MemoryPort;
use std::boxed::Box;
use std::path::Path;
use std::string::String;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread::sleep;
use std::time::Duration;
use std::vec::Vec;
use std::{format, io};
use tip_runtime::console::{Console, Terminal};

/// Bytes of keys.
const RETURN: u8 = 0x0D;
/// RETURN that was pressed before keys were read one by one.
const LINE_FEED: u8 = 0x0A;
const ESCAPE: u8 = 0x1B;
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
        name => AnyPort::Serial(Serial::open(Path::new(name), robot.bus.baud)?),
    };
    let drives = robot.drives(opened)?;
    Ok(TorqueGuard::new(drives, Operator::new()?, robot.period))
}

/// Leaves a robot in order, or as in an emergency if it was stopped. The keys are read meanwhile.
///
/// # Errors
/// A text that names the servos that did not confirm the state in which they were to be left.
pub fn leave(guard: &mut TorqueGuard<AnyPort, Operator>, robot: &Described) -> Result<(), String> {
    guard.host_mut().take_keys();
    guard.leave();
    guard.host_mut().give_keys();
    let Some(outcome) = guard.outcome().filter(|outcome| !outcome.is_certain()) else {
        return Ok(());
    };
    let servo = |joint: &usize| {
        let id = robot.joints.get(*joint).map_or(0, |joint| joint.id);
        format!("{} (servo {id})", robot.name(*joint))
    };
    let servos: Vec<String> = outcome
        .other
        .iter()
        .chain(&outcome.unknown)
        .map(servo)
        .collect();
    let state = match outcome.policy {
        Policy::Hold => "hold",
        Policy::Relax => "relax",
    };
    let servos = servos.join(", ");
    Err(format!(
        "these were to {state}, and perhaps do not: {servos}. Switch their power off"
    ))
}

/// The operator of a robot.
#[derive(Debug)]
pub struct Operator {
    /// Reads the keys, unless somebody else does.
    keyboard: Option<Terminal<io::Sink>>,
    /// Number of the last signal; 0 before.
    last: Arc<AtomicUsize>,
    /// Number of the first signal that was noticed.
    signal: Option<u8>,
}

impl Operator {
    /// Takes the keys of the terminal, and the signals that ask this process to end.
    ///
    /// # Errors
    /// The system does not tell of a signal.
    pub fn new() -> io::Result<Self> {
        use signal_hook::consts;
        let last = Arc::new(AtomicUsize::new(0));
        // Each of them would end or suspend the process, and leave stiff servos.
        #[cfg(unix)]
        let more = [
            consts::SIGALRM,
            consts::SIGHUP,
            consts::SIGIO,
            consts::SIGPROF,
            consts::SIGQUIT,
            consts::SIGTSTP,
            consts::SIGTTIN,
            consts::SIGTTOU,
            consts::SIGUSR1,
            consts::SIGUSR2,
            consts::SIGVTALRM,
            consts::SIGXCPU,
            // A file has become longer than its limit.
            rustix::process::Signal::XFSZ.as_raw(),
        ];
        #[cfg(not(unix))]
        let more = [];
        for signal in [consts::SIGINT, consts::SIGTERM].into_iter().chain(more) {
            let number = usize::try_from(signal).unwrap_or_default();
            signal_hook::flag::register_usize(signal, Arc::clone(&last), number)?;
        }
        Ok(Operator {
            keyboard: Some(Self::terminal()),
            last,
            signal: None,
        })
    }

    fn terminal() -> Terminal<io::Sink> {
        Terminal::on(io::sink(), false).report_interrupts()
    }

    /// Gives the keys away: the console of a machine reads them.
    pub fn give_keys(&mut self) {
        self.keyboard = None;
    }

    /// Takes the keys again, after the console of a machine has left them.
    pub fn take_keys(&mut self) {
        self.keyboard = Some(Self::terminal());
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
        BY_SIGNAL + self.signal().unwrap_or(signal_hook::consts::SIGINT as u8)
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
        let mut request = self.signal().map(|_| Request::End);
        if let Some(keyboard) = &mut self.keyboard {
            while let Some(key) = keyboard.key(0) {
                match key {
                    RETURN | LINE_FEED => return Some(Request::EmergencyStop),
                    ESCAPE => request = Some(Request::End),
                    _ => {}
                }
            }
            if keyboard.interrupted() {
                request = Some(Request::End);
            }
        }
        request
    }
}
