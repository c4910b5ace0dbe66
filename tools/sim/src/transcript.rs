//! How long the transcript of a run's console was.

use tip_runtime::console::Transcript;

/// The lengths of what only grows.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lengths {
    messages: usize,
    silent: usize,
    log: usize,
    variables: usize,
    stopped: bool,
    ended: u32,
}

impl Lengths {
    pub(crate) fn of(shown: &Transcript) -> Self {
        Lengths {
            messages: shown.messages.len(),
            silent: shown.silent.len(),
            log: shown.log.len(),
            variables: shown.variables.len(),
            stopped: shown.emergency.is_some(),
            ended: shown.ended,
        }
    }

    /// Takes away what came later.
    pub(crate) fn restore(self, shown: &mut Transcript) {
        shown.messages.truncate(self.messages);
        shown.silent.truncate(self.silent);
        shown.log.truncate(self.log);
        shown.variables.truncate(self.variables);
        shown.emergency.take_if(|_| !self.stopped);
        shown.ended = self.ended;
    }
}
