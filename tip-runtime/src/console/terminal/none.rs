//! Standard input without line editing: not available on this system.

/// The saved mode of the standard input's terminal: on this system it is never changed.
#[derive(Debug)]
pub struct TerminalState;

impl TerminalState {
    /// Returns the current mode.
    pub fn now() -> Self {
        TerminalState
    }

    /// Does nothing: there is nothing to restore.
    pub fn restore(&self) {}
}

#[derive(Debug)]
pub(super) struct Raw;

impl Raw {
    pub(super) fn enter() -> Option<Self> {
        None
    }
}
