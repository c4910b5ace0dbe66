//! Pacing of a machine by the wall clock.
//!
//! ```
//! use std::time::{Duration, Instant};
//! use tip_runtime::realtime::Pacer;
//!
//! let begin = Instant::now();
//! let mut pacer = Pacer::start();
//! for _ in 0..3 {
//!     pacer.wait(4.0);
//! }
//! assert_eq!(pacer.cycles(), 3);
//! assert!(begin.elapsed() >= Duration::from_millis(12));
//! ```

use crate::console::Console;
use crate::hardware::Hardware;
use crate::machine::{Machine, Status};
use crate::program::Program;
use crate::special::Special;
use std::thread::sleep;
use std::time::{Duration, Instant};

/// Keeps cycles on a time grid and counts overruns.
///
/// Deadlines are absolute: a cycle is due one period after the deadline of the previous one,
/// whenever that woke up. A cycle that overruns gives up the deadlines that it missed, so that
/// cycles are late, never hurried, and stay on the grid.
#[derive(Clone, Copy, Debug)]
pub struct Pacer {
    due: Instant,
    cycles: u64,
    overruns: u64,
    worst: Duration,
}

impl Pacer {
    /// Starts the first cycle now.
    pub fn start() -> Self {
        Self::from(Instant::now())
    }

    const fn from(due: Instant) -> Self {
        Pacer {
            due,
            cycles: 0,
            overruns: 0,
            worst: Duration::ZERO,
        }
    }

    /// Waits until a cycle of `period` ms is over. Periods are at most a day; a period of 0 or less
    /// does not wait.
    pub fn wait(&mut self, period: f64) {
        let due = self.due(period);
        sleep(due.saturating_duration_since(Instant::now()));
    }

    /// Counts a cycle of `period` ms and returns its end, for hosts that wait in their own way.
    pub fn due(&mut self, period: f64) -> Instant {
        self.next(period, Instant::now())
    }

    /// Returns the end of the cycle that ended `now`.
    fn next(&mut self, period: f64, now: Instant) -> Instant {
        let period = duration(period);
        self.cycles += 1;
        self.due += period;
        if let Some(late) = now
            .checked_duration_since(self.due)
            .filter(|late| !late.is_zero())
        {
            self.overruns += 1;
            self.worst = self.worst.max(late);
            self.due = match late.as_nanos().checked_rem(period.as_nanos()) {
                Some(since) => now + period - Duration::from_nanos(since as u64),
                None => now,
            };
        }
        self.due
    }

    /// Returns the number of cycles so far.
    pub const fn cycles(&self) -> u64 {
        self.cycles
    }

    /// Returns the number of cycles that took longer than their period.
    pub const fn overruns(&self) -> u64 {
        self.overruns
    }

    /// Returns the greatest lateness of a cycle.
    pub const fn worst(&self) -> Duration {
        self.worst
    }
}

/// The longest period. No clock can represent the end of a much longer one.
const MAX_PERIOD: Duration = Duration::from_secs(24 * 60 * 60);

/// Converts a period in ms: 0 for one below 0 or not a number, a day for a longer one.
fn duration(period: f64) -> Duration {
    let seconds = (period / 1000.0).clamp(0.0, MAX_PERIOD.as_secs_f64());
    Duration::try_from_secs_f64(seconds).unwrap_or(Duration::ZERO)
}

/// Runs a machine in real time until `stop` returns true; it is called after each cycle with the
/// state of the program.
///
/// A robot has to be held after END as well, and stopped repeatedly in an emergency: the servo loop
/// outlives the program. For a simulated robot, `|status| !status.is_running()` is enough.
pub fn run_realtime<P, H, C, S, const L: usize, const J: usize>(
    machine: &mut Machine<P, H, C, S, L, J>,
    mut stop: impl FnMut(Status) -> bool,
) -> (Status, Pacer)
where
    P: Program,
    H: Hardware<L, J>,
    C: Console,
    S: Special,
{
    let mut pacer = Pacer::start();
    loop {
        let status = machine.cycle();
        pacer.wait(machine.period());
        if stop(status) {
            return (status, pacer);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MS: Duration = Duration::from_millis(1);

    #[test]
    fn deadlines_are_on_the_grid_whenever_a_cycle_ended() {
        let begin = Instant::now();
        let mut pacer = Pacer::from(begin);
        assert_eq!(pacer.next(4.0, begin + 3 * MS), begin + 4 * MS);
        // It woke up late, at 5 ms, and was ready at 8 ms.
        assert_eq!(pacer.next(4.0, begin + 8 * MS), begin + 8 * MS);
        assert_eq!((pacer.cycles(), pacer.overruns()), (2, 0));
        // Another sampling time from now on.
        assert_eq!(pacer.next(2.0, begin + 9 * MS), begin + 10 * MS);
    }

    #[test]
    fn an_overrun_gives_up_the_deadlines_that_it_missed() {
        let begin = Instant::now();
        let mut pacer = Pacer::from(begin);
        // Due at 4 ms, ready at 13 ms: those at 4, 8 and 12 ms are gone.
        assert_eq!(pacer.next(4.0, begin + 13 * MS), begin + 16 * MS);
        assert_eq!((pacer.overruns(), pacer.worst()), (1, 9 * MS));
        assert_eq!(pacer.next(4.0, begin + 17 * MS), begin + 20 * MS);
        assert_eq!(pacer.next(4.0, begin + 25 * MS), begin + 28 * MS);
        assert_eq!((pacer.overruns(), pacer.worst()), (2, 9 * MS));
    }

    #[test]
    fn without_a_period_no_cycle_waits() {
        let begin = Instant::now();
        let mut pacer = Pacer::from(begin);
        assert_eq!(pacer.next(0.0, begin + MS), begin + MS);
        for (after, period) in (2..).zip([f64::NAN, -4.0, f64::NEG_INFINITY, -0.0, 1e-300]) {
            let now = begin + after * MS;
            assert_eq!(pacer.next(period, now), now, "{period}");
        }
    }

    #[test]
    fn no_period_is_longer_than_a_day() {
        let begin = Instant::now();
        for period in [1e22, f64::MAX, f64::INFINITY, 1e9] {
            let mut pacer = Pacer::from(begin);
            let due = pacer.next(period, begin + MS);
            assert_eq!(due - begin, MAX_PERIOD, "{period}");
            // Again and again, it stays within what a clock holds.
            for _ in 0..100 {
                pacer.next(period, begin + MS);
            }
        }
    }
}
