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
    bus: Arc<Mutex<Option<SimulatedBus>>>,
    start: Instant,
    thread: Option<JoinHandle<()>>,
    /// The last state of the servos before it was pulled out.
    left: Option<SimulatedBus>,
}

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
        let bus = Arc::new(Mutex::new(Some(SimulatedBus::new(servos, timing))));
        let start = Instant::now();
        let served = Arc::clone(&bus);
        ServoBus {
            port,
            bus,
            start,
            thread: Some(spawn(move || serve(&pty, &served, start))),
            left: None,
        }
    }

    /// Puts the servos of a description on a new pseudo-terminal, each joint this far from its initial posture, deg.
    pub(crate) fn of(text: &str, beside: f64) -> Self {
        let description = described(text);
        let bus = description.bus().expect("a bus");
        let anatomy = tip_sim::Robot::described(&description).anatomy();
        let initial = anatomy.legs.iter().flat_map(|leg| leg.initial.clone());
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

    fn lock(&self) -> MutexGuard<'_, Option<SimulatedBus>> {
        self.bus.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Looks at the servos, or lets something happen to them; their time is brought up to now first.
    pub(crate) fn with<T>(&mut self, act: impl FnOnce(&mut SimulatedBus) -> T) -> T {
        let now = self.start.elapsed().as_micros() as u64;
        if let Some(left) = &mut self.left {
            left.advance(now);
            return act(left);
        }
        let mut bus = self.lock();
        let bus = bus.as_mut().expect("served");
        bus.advance(now);
        act(bus)
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

fn serve(pty: &OwnedFd, bus: &Mutex<Option<SimulatedBus>>, start: Instant) {
    let now = || start.elapsed().as_micros() as u64;
    loop {
        let next = {
            let mut bus = bus.lock().unwrap_or_else(PoisonError::into_inner);
            let Some(bus) = bus.as_mut() else { return };
            bus.advance(now());
            let due = bus.take_bytes(now(), 4096);
            let mut left = &due[..];
            while !left.is_empty() {
                // Nobody may listen any more.
                let Ok(count) = write(pty, left) else { break };
                left = &left[count..];
            }
            bus.next_byte()
        };
        let wait = next.map_or(2000, |at| at.saturating_sub(now()).min(2000));
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
            let Some(bus) = bus.as_mut() else { return };
            bus.receive(&bytes[..count], now());
        } else if events.contains(PollFlags::HUP) {
            sleep(Duration::from_millis(1));
        }
    }
}
