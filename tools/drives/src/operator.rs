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
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::sleep;
use std::time::Duration;
use std::vec::Vec;
use std::{format, io};
use tip_runtime::console::{Console, Terminal};

/// Bytes of keys.
const RETURN: u8 = 0x0D;
const ESCAPE: u8 = 0x1B;

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
    /// True after a signal.
    is_signalled: Arc<AtomicBool>,
}

impl Operator {
    /// Takes the keys of the terminal, and the signals that ask this process to end.
    ///
    /// # Errors
    /// The system does not tell of a signal.
    pub fn new() -> io::Result<Self> {
        use signal_hook::consts;
        let is_signalled = Arc::new(AtomicBool::new(false));
        // Each of them would end the process, and leave stiff servos.
        #[cfg(unix)]
        let more = [
            consts::SIGALRM,
            consts::SIGHUP,
            consts::SIGIO,
            consts::SIGPROF,
            consts::SIGQUIT,
            consts::SIGUSR1,
            consts::SIGUSR2,
            consts::SIGVTALRM,
            consts::SIGXCPU,
        ];
        #[cfg(not(unix))]
        let more = [];
        for signal in [consts::SIGINT, consts::SIGTERM].into_iter().chain(more) {
            signal_hook::flag::register(signal, Arc::clone(&is_signalled))?;
        }
        Ok(Operator {
            keyboard: Some(Self::terminal()),
            is_signalled,
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

    /// Returns true after a signal that asks this process to end.
    pub fn is_signalled(&self) -> bool {
        self.is_signalled.load(Ordering::Relaxed)
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
        let mut request = self.is_signalled().then_some(Request::End);
        if let Some(keyboard) = &mut self.keyboard {
            while let Some(key) = keyboard.key(0) {
                match key {
                    RETURN => return Some(Request::EmergencyStop),
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
