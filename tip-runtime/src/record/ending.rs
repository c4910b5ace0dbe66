//! The end of a run.

use crate::emergency::Emergency;
use crate::program::End;

/// The end of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ending {
    /// The program ended itself.
    Program(End),
    /// Someone pressed Ctrl-C.
    Interrupted,
    /// The requested number of cycles was reached.
    Limit,
    /// Emergency stop.
    Emergency(Emergency),
}
