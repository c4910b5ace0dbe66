//! Simulated servos in place of real ones: the faults that happen to them, and their bus on a pseudo-terminal.

use crate::Status;
use crate::error::Error;
use crate::message::Driving;
use tip_drives::simulated::{Faults, SimulatedBus};
use tipc::message::Lang;

/// The angle by which a hand turns a servo, deg.
const TURN: f64 = 20.0;

type Fault = fn(&mut SimulatedBus, u8);

/// Faults of a simulated bus: `faults=0.01,unplug=3@1.5`, or `corrupt=0.01`.
#[derive(Clone, Debug, Default)]
pub(crate) struct FaultInjection {
    /// Probabilities of what happens to an answer.
    pub(super) faults: Faults,
    /// Events of servos: time, s, in any order; event; identity.
    events: Vec<(f64, Fault, u8)>,
}

impl FaultInjection {
    /// Reads a list of faults on a bus with servos of these identities.
    ///
    /// # Errors
    /// The list is malformed, or a fault can never happen.
    pub(crate) fn new(text: &str, ids: &[u8]) -> Result<Self, Driving> {
        let wrong = || Driving::NotSimulated {
            text: text.to_owned(),
        };
        let mut injection = FaultInjection::default();
        if text.is_empty() {
            return Ok(injection);
        }
        for part in text.split(',') {
            let (name, value) = part.split_once('=').ok_or_else(wrong)?;
            let faults = &mut injection.faults;
            let probability = match name {
                "corrupt" => Some(&mut faults.corrupt),
                "drop" => Some(&mut faults.drop),
                "duplicate" => Some(&mut faults.duplicate),
                "delay" => Some(&mut faults.delay),
                "truncate" => Some(&mut faults.truncate),
                _ => None,
            };
            if name == "faults" || probability.is_some() {
                let part = value.parse().ok();
                let part = part.filter(|it| (0.0..=1.0).contains(it));
                let part = part.ok_or_else(wrong)?;
                match probability {
                    Some(probability) => *probability = part,
                    None => *faults = Faults::evenly(part),
                }
                continue;
            }
            let fault: Fault = match name {
                "unplug" => SimulatedBus::unplug,
                "reset" => SimulatedBus::reset,
                "overheat" => SimulatedBus::overheat,
                "block" => SimulatedBus::block,
                "sag" => SimulatedBus::sag,
                "turn" => |bus, id| bus.turn(id, TURN),
                _ => return Err(wrong()),
            };
            let (id, time) = value.split_once('@').ok_or_else(wrong)?;
            let time = time.parse().ok().filter(|time: &f64| time.is_finite());
            let event = id.parse().ok().zip(time.filter(|time| *time >= 0.0));
            let (id, time): (u8, f64) = event.ok_or_else(wrong)?;
            if !ids.contains(&id) {
                let text = part.to_owned();
                return Err(Driving::NoServoToFail {
                    text,
                    id: id.into(),
                });
            }
            injection.events.push((time, fault, id));
        }
        Ok(injection)
    }

    /// Injects the faults whose time has come, µs.
    pub(crate) fn inject(&mut self, bus: &mut SimulatedBus, now: u64) {
        self.events.retain(|(time, fault, id)| {
            let is_due = *time * 1e6 <= now as f64;
            if is_due {
                fault(bus, *id);
            }
            !is_due
        });
    }
}

/// Serves a bus on a pseudo-terminal until it is interrupted; `announce` gets the name of its port.
#[cfg(unix)]
pub(super) fn serve(
    mut bus: SimulatedBus,
    mut injection: FaultInjection,
    _: Lang,
    announce: impl FnOnce(String) -> Result<(), Error>,
) -> Result<Status, Error> {
    use crate::interrupt;
    use rustix::event::{PollFd, PollFlags, Timespec, poll};
    use rustix::io::{Errno, read, write};
    use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
    use std::time::{Duration, Instant};
    use std::{io, thread};
    let failed = |error: Errno| Error::Failed(io::Error::from(error).to_string());

    let pty = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY).map_err(failed)?;
    grantpt(&pty).map_err(failed)?;
    unlockpt(&pty).map_err(failed)?;
    let name = ptsname(&pty, Vec::new()).map_err(failed)?;
    announce(name.to_string_lossy().into_owned())?;

    let start = Instant::now();
    while !interrupt::is_requested() {
        let now = start.elapsed().as_micros() as u64;
        bus.advance(now);
        injection.inject(&mut bus, now);
        let due = bus.take_bytes(now, 4096);
        let mut left = &due[..];
        while !left.is_empty() {
            match write(&pty, left) {
                Ok(count) => left = &left[count..],
                Err(Errno::INTR) => {}
                // The master is gone.
                Err(Errno::IO) => break,
                Err(error) => return Err(failed(error)),
            }
        }
        let until = bus.next_byte().unwrap_or(now + 5000);
        let wait = Timespec::try_from(Duration::from_micros(until.saturating_sub(now))).ok();
        let mut polled = [PollFd::new(&pty, PollFlags::IN)];
        match poll(&mut polled, wait.as_ref()) {
            Ok(0) | Err(Errno::INTR) => continue,
            Ok(_) => {}
            Err(error) => return Err(failed(error)),
        }
        let mut bytes = [0; 1024];
        match read(&pty, &mut bytes) {
            Ok(count) => bus.receive(&bytes[..count], start.elapsed().as_micros() as u64),
            // No master has it open: this end stays open, so that masters can come and go.
            Err(Errno::IO) => thread::sleep(Duration::from_millis(1)),
            Err(Errno::INTR | Errno::AGAIN) => {}
            Err(error) => return Err(failed(error)),
        }
    }
    Ok(Status::Interrupted)
}

#[cfg(not(unix))]
pub(super) fn serve(
    _: SimulatedBus,
    _: FaultInjection,
    lang: Lang,
    _: impl FnOnce(String) -> Result<(), Error>,
) -> Result<Status, Error> {
    Err(Error::failed(Driving::NotHere, lang))
}
