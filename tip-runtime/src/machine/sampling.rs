//! Whether a cycle goes into TITAN.LOG.

/// The state of LOG_START, LOG_STOP and LOG_ONE_SHOT.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Sampling {
    running: bool,
    once: bool,
}

impl Sampling {
    pub(super) const fn start(&mut self) {
        self.running = true;
    }

    pub(super) const fn stop(&mut self) {
        self.running = false;
    }

    pub(super) const fn one_shot(&mut self) {
        self.once = true;
    }

    /// Whether this cycle is sampled.
    pub(super) const fn take(&mut self) -> bool {
        let once = self.once;
        self.once = false;
        self.running || once
    }
}
