//! SLEEP (T.I.P. 3.1 §7-4-1).

use super::ControllerView;
use super::arrival::done_if;
use crate::command::{Command, Poll};
use crate::fault::Fault;

impl<const J: usize> ControllerView<J> {
    /// Runs SLEEP: at least one cycle, and no time of a cycle too little.
    pub(super) fn sleep(&mut self, command: &Command<'_>) -> Result<Poll, Fault> {
        let sleep = self.tasks.sleep().ok_or(Fault::Domain)?;
        let left = match (*sleep, command.values) {
            (left, _) if left > 0.0 => left,
            (_, [time]) if time.number() >= 0.0 => {
                // The subtrahend forgives the rounding of a division that should be exact.
                libm::ceil(time.number() / self.params.period - 1e-9).max(1.0)
            }
            _ => return Err(Fault::Domain),
        };
        let done = left <= 1.0;
        *sleep = if done { 0.0 } else { left - 1.0 };
        Ok(done_if(done))
    }
}
