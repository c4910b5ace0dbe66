//! Standard input without line editing: not available on this system.

/// How the terminal of standard input behaves: here it is never changed.
#[derive(Debug)]
pub struct TerminalState;

impl TerminalState {
    /// As it is now.
    pub fn now() -> Self {
        TerminalState
    }

    /// Nothing is to be restored.
    pub fn restore(&self) {}
}

#[derive(Debug)]
pub(super) struct Raw;

impl Raw {
    pub(super) fn enter() -> Option<Self> {
        None
    }
}
