//! The controls of a robot on servos: its driver and its emergency stop. The threads of connections set them, and the control cycle
//! looks at them; neither waits for the hub.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};
use tip_view::live::{ClientRequest, Driver, Driving, Rules, Stage};

/// The state that pages and the control cycle share. Its lock is held for a few instructions only.
#[derive(Debug)]
pub(super) struct Controls {
    begin: Instant,
    driver: Mutex<Driver>,
    /// True from an emergency stop until the robot is ready for another run.
    stop: Arc<AtomicBool>,
    /// Time of the first emergency stop since then, µs after `begin`; 0 if there was none.
    stopped: AtomicU64,
}

impl Controls {
    pub(super) fn new(rules: Rules, stop: Arc<AtomicBool>) -> Self {
        Controls {
            begin: Instant::now(),
            driver: Mutex::new(Driver::new(rules)),
            stop,
            stopped: AtomicU64::new(0),
        }
    }

    /// Asks for the emergency stop. The control cycle obeys in the cycle that comes next.
    pub(super) fn stop(&self) {
        let now = u64::try_from(self.now().as_micros()).unwrap_or(u64::MAX);
        let order = Ordering::Relaxed;
        // Only the first one is timed.
        let _ = self.stopped.compare_exchange(0, now.max(1), order, order);
        self.stop.store(true, Ordering::Relaxed);
    }

    /// Does what a viewer asks for as the driver; returns the answer. A sign of life has none unless it is refused.
    pub(super) fn drive(
        &self,
        viewer: u64,
        driving: Driving,
        asked: &ClientRequest,
    ) -> Option<String> {
        let now = self.now();
        let mut driver = self.driver();
        let is_own = driver.holder() == Some(viewer);
        Some(match driving {
            Driving::Take => {
                driver.take(viewer, now);
                asked.done()
            }
            _ if !is_own => asked.refused_watching(),
            Driving::Sign(sign) => {
                driver.sign(viewer, sign, now);
                return None;
            }
            Driving::Give => {
                driver.give(viewer, now);
                asked.done()
            }
            Driving::Pause => {
                driver.pause(viewer);
                asked.done()
            }
            Driving::Resume if driver.resume(viewer) => asked.done(),
            Driving::Resume => asked.refused_hold(),
        })
    }

    /// Forgets a viewer that has left.
    pub(super) fn leave(&self, viewer: u64) {
        self.driver().leave(viewer, self.now());
    }

    pub(super) fn driver(&self) -> MutexGuard<'_, Driver> {
        self.driver.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub(super) fn now(&self) -> Duration {
        self.begin.elapsed()
    }

    /// Returns what the robot may do now.
    pub(super) fn stage(&self) -> Stage {
        let now = self.now();
        self.driver().stage(now)
    }

    /// Returns true if somebody has asked for the emergency stop.
    pub(super) fn is_stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }

    /// Returns the time since the emergency stop, ms; `None` if there was none.
    pub(super) fn since_stop(&self) -> Option<f64> {
        let stopped = self.stopped.load(Ordering::Relaxed);
        let since = self.now().saturating_sub(Duration::from_micros(stopped));
        (stopped > 0).then_some(since.as_secs_f64() * 1000.0)
    }

    /// Forgets an emergency stop and a press that came before now.
    pub(super) fn reset(&self) {
        self.driver().disarm();
        self.stopped.store(0, Ordering::Relaxed);
        self.stop.store(false, Ordering::Relaxed);
    }
}
