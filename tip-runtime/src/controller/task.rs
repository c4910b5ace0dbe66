//! What a command that takes several cycles remembers between them.

use super::Controller;
use super::arrival::done_if;
use super::detect::Search;
use super::feel::Feeling;
use super::stand::Stand;
use crate::command::{Command, Poll};
use crate::fault::Fault;

/// The command under way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Task<const L: usize> {
    /// None.
    Idle,
    /// SLEEP: the cycles that are left.
    Sleep(f64),
    /// INITIAL_POSTURE: braking.
    Posture,
    /// STAND_UP and SIT_DOWN.
    Stand(Stand),
    /// DETECT_FLOOR by soles.
    Detect(Search<L>),
    /// DETECT_FLOOR and DETECT_OBJECT by touch.
    Feel(Feeling<L>),
}

impl<const L: usize, const J: usize> Controller<'_, L, J> {
    /// SLEEP: at least one cycle, and no time of a cycle too little (T.I.P. 3.1 §7-4-1).
    pub(super) fn sleep(&mut self, command: &Command<'_>) -> Result<Poll, Fault> {
        let left = match (self.task, command.values) {
            (Task::Sleep(left), _) => left,
            (_, [time]) if time.number() >= 0.0 => {
                // The subtrahend forgives the rounding of a division that should be exact.
                libm::ceil(time.number() / self.params.period - 1e-9).max(1.0)
            }
            _ => return Err(Fault::Domain),
        };
        let done = left <= 1.0;
        self.task = if done {
            Task::Idle
        } else {
            Task::Sleep(left - 1.0)
        };
        Ok(done_if(done))
    }
}
