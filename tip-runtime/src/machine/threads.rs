//! The threads and the timers of a program, and the requests of steps to them.

use crate::command::Poll;
use crate::fault::Fault;

/// The threads of a program, one bit each: bit n is thread n, bit 0 the main program.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Threads {
    /// Threads that have or had a turn in this cycle and are not over.
    running: u8,
    /// Threads that end with this cycle.
    stopped: u8,
    /// Threads that begin in the next cycle.
    started: u8,
}

impl Threads {
    /// Returns true if a thread has been started and is not over.
    pub(super) const fn runs(&self, thread: u8) -> bool {
        (self.running | self.started) & bit(thread) != 0
    }

    /// Iterates over the threads that run now.
    pub(super) fn running(&self) -> impl Iterator<Item = u8> + use<> {
        of(self.running)
    }

    /// Runs START_THREAD.
    pub(super) fn start(&mut self, thread: u8) -> Result<(), Fault> {
        let goes_on = (self.running & !self.stopped) | self.started;
        if goes_on & bit(thread) != 0 {
            return Err(Fault::InvalidMode);
        }
        self.started |= bit(thread);
        Ok(())
    }

    /// Runs STOP_THREAD. A thread that was started in this cycle does not begin.
    pub(super) fn stop(&mut self, thread: u8) {
        self.started &= !bit(thread);
        self.stopped |= self.running & bit(thread);
    }

    /// Runs WAIT_THREAD in the thread `by`.
    pub(super) fn wait(&self, thread: u8, by: u8) -> Result<Poll, Fault> {
        if thread == by {
            return Err(Fault::InvalidMode);
        }
        Ok(if self.runs(thread) {
            Poll::Pending
        } else {
            Poll::Done
        })
    }

    /// Ends a thread.
    pub(super) fn end(&mut self, thread: u8) {
        self.running &= !bit(thread);
        self.stopped &= !bit(thread);
    }

    /// Returns true if threads end with this cycle or begin in the next one.
    pub(super) const fn change(&self) -> bool {
        self.stopped | self.started != 0
    }

    /// Ends the cycle: returns the threads that were stopped, then those that begin.
    pub(super) fn turn_over(
        &mut self,
    ) -> (
        impl Iterator<Item = u8> + use<>,
        impl Iterator<Item = u8> + use<>,
    ) {
        let (stopped, started) = (self.stopped, self.started);
        self.running = (self.running & !stopped) | started;
        (self.stopped, self.started) = (0, 0);
        (of(stopped), of(started))
    }
}

/// Returns the bit of a thread, or of the main program.
pub(super) const fn bit(thread: u8) -> u8 {
    match 1_u8.checked_shl(thread as u32) {
        Some(bit) => bit,
        None => 0,
    }
}

/// Iterates over the threads of a set, in the order of the text.
fn of(mut set: u8) -> impl Iterator<Item = u8> + use<> {
    core::iter::from_fn(move || {
        let thread = set.trailing_zeros() as u8;
        set &= !bit(thread);
        (thread < u8::BITS as u8).then_some(thread)
    })
}

/// Number of timers of a program.
const TIMERS: usize = 8;

/// The timers of a program.
#[derive(Clone, Copy, Debug)]
pub(super) struct Timers {
    /// Times, ms.
    times: [f64; TIMERS],
    /// Bit n: timer n runs.
    running: u8,
}

impl Timers {
    pub(super) const HALTED: Self = Timers {
        times: [0.0; TIMERS],
        running: 0,
    };

    /// Returns the time of a timer, ms.
    pub(super) fn time(&self, n: u8) -> f64 {
        self.times.get(usize::from(n)).copied().unwrap_or(0.0)
    }

    /// Sets a timer to zero if `resets`, and starts or halts it if `runs` is given.
    ///
    /// # Errors
    /// `Domain` for a timer that does not exist.
    pub(super) fn set(&mut self, n: u8, resets: bool, runs: Option<bool>) -> Result<(), Fault> {
        let time = self.times.get_mut(usize::from(n)).ok_or(Fault::Domain)?;
        if resets {
            *time = 0.0;
        }
        match runs {
            Some(true) => self.running |= bit(n),
            Some(false) => self.running &= !bit(n),
            None => {}
        }
        Ok(())
    }

    /// Adds a cycle of `period` ms to running timers.
    pub(super) fn grow(&mut self, period: f64) {
        if self.running == 0 {
            return;
        }
        for (n, time) in (0..).zip(&mut self.times) {
            if self.running & bit(n) != 0 {
                *time += period;
            }
        }
    }
}
