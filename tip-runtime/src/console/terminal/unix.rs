//! Standard input without line editing.

use rustix::termios::{
    InputModes, LocalModes, OptionalActions, SpecialCodeIndex, Termios, tcgetattr, tcsetattr,
};
use std::io::{IsTerminal, stdin};

/// The saved mode of the standard input's terminal, for a host that has to end a process without
/// dropping its [`Terminal`](super::Terminal).
#[derive(Debug)]
pub struct TerminalState(Option<Termios>);

impl TerminalState {
    /// Returns the current mode. If standard input is not a terminal, or refuses, there is nothing
    /// to restore.
    pub fn now() -> Self {
        let input = stdin();
        let state = input.is_terminal().then(|| tcgetattr(&input).ok());
        TerminalState(state.flatten())
    }

    /// Restores the saved mode.
    pub fn restore(&self) {
        if let Some(state) = &self.0 {
            // Nothing is left to be done for a terminal that is gone.
            let _ = tcsetattr(stdin(), OptionalActions::Now, state);
        }
    }
}

/// Standard input without line editing; dropping it restores the former mode.
#[derive(Debug)]
pub(super) struct Raw(TerminalState);

impl Raw {
    /// Switches line editing off; `None` if standard input is not a terminal, or refuses.
    pub(super) fn enter() -> Option<Self> {
        let former = TerminalState::now();
        let mut raw = former.0.clone()?;
        raw.local_modes
            .remove(LocalModes::ICANON | LocalModes::ECHO | LocalModes::ISIG);
        raw.input_modes.remove(InputModes::ICRNL | InputModes::IXON);
        // Reading gives what there is, immediately.
        raw.special_codes[SpecialCodeIndex::VMIN] = 0;
        raw.special_codes[SpecialCodeIndex::VTIME] = 0;
        tcsetattr(stdin(), OptionalActions::Now, &raw).ok()?;
        Some(Raw(former))
    }
}

impl Drop for Raw {
    fn drop(&mut self) {
        self.0.restore();
    }
}
