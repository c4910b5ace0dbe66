//! Processes that a signal of the terminal does not reach.

use std::process::Command;

/// Ctrl-C of the terminal is for this process, which then ends the other.
#[cfg(unix)]
pub(crate) fn apart(command: &mut Command) {
    use std::os::unix::process::CommandExt;
    command.process_group(0);
}

#[cfg(not(unix))]
pub(crate) fn apart(_: &mut Command) {}
