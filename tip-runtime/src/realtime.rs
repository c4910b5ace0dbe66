//! Running a machine in real time.

use crate::console::Console;
use crate::hardware::Hardware;
use crate::machine::{Machine, Status};
use crate::program::Program;
use crate::special::Special;
use std::thread::sleep;
use std::time::{Duration, Instant};

/// Keeps cycles on a grid of time and counts those that ran over.
#[derive(Clone, Copy, Debug)]
pub struct Pacer {
    due: Instant,
    cycles: u64,
    overruns: u64,
    worst: Duration,
}

impl Pacer {
    /// The first cycle starts now.
    pub fn start() -> Self {
        Pacer {
            due: Instant::now(),
            cycles: 0,
            overruns: 0,
            worst: Duration::ZERO,
        }
    }

    /// Waits until a cycle of `period` ms is over. One that is over already is an overrun, and the
    /// grid starts anew: cycles are late, never hurried.
    pub fn wait(&mut self, period: f64) {
        self.cycles += 1;
        self.due += Duration::try_from_secs_f64(period / 1000.0).unwrap_or(Duration::ZERO);
        let now = Instant::now();
        match self.due.checked_duration_since(now) {
            Some(rest) => sleep(rest),
            None => {
                self.overruns += 1;
                self.worst = self.worst.max(now.duration_since(self.due));
                self.due = now;
            }
        }
    }

    /// Cycles so far.
    pub const fn cycles(&self) -> u64 {
        self.cycles
    }

    /// Cycles that took longer than their period.
    pub const fn overruns(&self) -> u64 {
        self.overruns
    }

    /// By how much the worst of them was late.
    pub const fn worst(&self) -> Duration {
        self.worst
    }
}

/// Runs a machine in real time until its program is over.
pub fn run_realtime<P, H, C, S, const L: usize, const J: usize>(
    machine: &mut Machine<'_, P, H, C, S, L, J>,
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
        if !status.is_running() {
            return (status, pacer);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cycles_last_their_period_and_late_ones_are_counted() {
        let begin = Instant::now();
        let mut pacer = Pacer::start();
        for _ in 0..5 {
            pacer.wait(4.0);
        }
        assert!(begin.elapsed() >= Duration::from_millis(20));
        let before = pacer.overruns();
        sleep(Duration::from_millis(5));
        pacer.wait(1.0);
        assert_eq!((pacer.cycles(), pacer.overruns()), (6, before + 1));
        assert!(pacer.worst() >= Duration::from_millis(4));
    }
}
