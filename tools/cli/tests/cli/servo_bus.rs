//! Simulated servos on a pseudo-terminal of the test itself: their registers can be read while a command runs, and after it is gone.

use rustix::event::{PollFd, PollFlags, Timespec, poll};
use rustix::io::{read, write};
use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
use std::os::fd::OwnedFd;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread::{JoinHandle, sleep, spawn};
use std::time::{Duration, Instant};
use tip_drives::Model;
use tip_drives::bus::Timing;
use tip_drives::model::MODELS;
use tip_drives::simulated::{Servo, SimulatedBus};
use tip_runtime::model::Range;
use tipc::description::{self, Description};

/// A bus in real time; its thread ends with it, and with [`hang_up`](Self::hang_up).
pub(crate) struct ServoBus {
    port: String,
    /// `None` when the adapter was pulled out.
    bus: Arc<Mutex<Option<Timed>>>,
    thread: Option<JoinHandle<()>>,
    /// The last state of the servos before it was pulled out.
    left: Option<Timed>,
}

/// Servos and their time, µs.
struct Timed {
    bus: SimulatedBus,
    now: u64,
    seen: Instant,
}

impl Timed {
    /// Brings the servos up to now, by `most` at most: on a busy machine requests wait in the pseudo-terminal, and a watchdog must
    /// not expire for that.
    fn advance(&mut self, most: Duration) -> u64 {
        let seen = Instant::now();
        let passed = (seen - self.seen).min(most);
        self.seen = seen;
        self.now += passed.as_micros() as u64;
        self.bus.advance(self.now);
        self.now
    }
}

/// The longest time in which nobody serves the bus.
const LEAP: Duration = Duration::from_millis(20);

/// Returns a description that has a bus.
pub(crate) fn described(text: &str) -> Description {
    let servo = |model: &Model| description::Servo {
        name: model.name,
        family: model.family.name(),
        travel: Range::new(model.angle(0.0), model.angle(model.largest.into())),
    };
    let servos: Vec<_> = MODELS.iter().map(servo).collect();
    let read = description::parse_for_servos("robot.toml", text.as_bytes(), &servos);
    read.unwrap_or_else(|loaded| panic!("{:?}", loaded.diagnostics))
}

impl ServoBus {
    /// Puts servos on a new pseudo-terminal.
    pub(crate) fn new(servos: Vec<Servo>, baud: u32) -> Self {
        let timing = Timing {
            baud,
            return_delay: 0,
            latency: 0,
        };
        // No command that a test starts keeps it open.
        let flags = OpenptFlags::RDWR | OpenptFlags::NOCTTY | OpenptFlags::CLOEXEC;
        let pty = openpt(flags).expect("a pseudo terminal");
        grantpt(&pty).expect("ours");
        unlockpt(&pty).expect("ours");
        let port = ptsname(&pty, Vec::new()).expect("a name");
        let port = port.into_string().expect("ASCII");
        let bus = Arc::new(Mutex::new(Some(Timed {
            bus: SimulatedBus::new(servos, timing),
            now: 0,
            seen: Instant::now(),
        })));
        let served = Arc::clone(&bus);
        ServoBus {
            port,
            bus,
            thread: Some(spawn(move || serve(&pty, &served))),
            left: None,
        }
    }

    /// Puts the servos of a description on a new pseudo-terminal, each joint this far from its initial posture, deg.
    pub(crate) fn of(text: &str, beside: f64) -> Self {
        let description = described(text);
        let bus = description.bus().expect("a bus");
        let description = tip_sim::Robot::described(&description).description();
        let initial = description.legs.iter().flat_map(|leg| leg.initial.clone());
        let servos = bus.drives.iter().zip(initial).map(|(drive, initial)| {
            let model = Model::named(&drive.model).expect("checked");
            let angle = (initial + beside).clamp(drive.limits.min, drive.limits.max);
            let motor = drive.sign * drive.gear * angle + drive.offset;
            Servo::new(model, drive.id, model.counts(motor).round())
        });
        ServoBus::new(servos.collect(), bus.baud)
    }

    /// The name of the port.
    pub(crate) fn port(&self) -> &str {
        &self.port
    }

    fn lock(&self) -> MutexGuard<'_, Option<Timed>> {
        self.bus.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Looks at the servos, or lets something happen to them.
    pub(crate) fn with<T>(&mut self, act: impl FnOnce(&mut SimulatedBus) -> T) -> T {
        if let Some(left) = &mut self.left {
            left.advance(Duration::MAX);
            return act(&mut left.bus);
        }
        let mut bus = self.lock();
        act(&mut bus.as_mut().expect("served").bus)
    }

    /// Returns the identities of the servos whose torque is on.
    pub(crate) fn stiff(&mut self) -> Vec<u8> {
        self.with(|bus| {
            let on = bus.servos().iter().filter(|servo| servo.has_torque());
            on.map(Servo::id).collect()
        })
    }

    /// Waits until something is true of the servos.
    pub(crate) fn await_that(&mut self, what: &str, is_so: impl Fn(&SimulatedBus) -> bool) {
        let begin = Instant::now();
        while !self.with(|bus| is_so(bus)) {
            assert!(begin.elapsed() < Duration::from_secs(60), "never: {what}");
            sleep(Duration::from_millis(2));
        }
    }

    /// Pulls the adapter out of the computer. The servos live on.
    pub(crate) fn hang_up(&mut self) {
        let bus = self.lock().take();
        self.left = bus.or(self.left.take());
        if let Some(thread) = self.thread.take() {
            thread.join().expect("it serves");
        }
    }
}

impl Drop for ServoBus {
    fn drop(&mut self) {
        self.hang_up();
    }
}

fn serve(pty: &OwnedFd, bus: &Mutex<Option<Timed>>) {
    loop {
        let wait = {
            let mut bus = bus.lock().unwrap_or_else(PoisonError::into_inner);
            let Some(timed) = bus.as_mut() else { return };
            let now = timed.advance(LEAP);
            let due = timed.bus.take_bytes(now, 4096);
            let mut left = &due[..];
            while !left.is_empty() {
                // Nobody may listen any more.
                let Ok(count) = write(pty, left) else { break };
                left = &left[count..];
            }
            let next = timed.bus.next_byte();
            next.map_or(2000, |at| at.saturating_sub(now).min(2000))
        };
        let wait = Timespec {
            tv_sec: 0,
            tv_nsec: wait as i64 * 1000,
        };
        let mut polled = [PollFd::new(pty, PollFlags::IN)];
        let _ = poll(&mut polled, Some(&wait));
        let events = polled[0].revents();
        let mut bytes = [0; 1024];
        if events.contains(PollFlags::IN)
            && let Ok(count) = read(pty, &mut bytes)
        {
            let mut bus = bus.lock().unwrap_or_else(PoisonError::into_inner);
            let Some(timed) = bus.as_mut() else { return };
            let now = timed.advance(LEAP);
            timed.bus.receive(&bytes[..count], now);
        } else if events.contains(PollFlags::HUP) {
            sleep(Duration::from_millis(1));
        }
    }
}
