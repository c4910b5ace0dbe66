//! How a run ended.

use crate::emergency::Emergency;
use crate::program::End;

/// How a run ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ending {
    /// The program ended itself.
    Program(End),
    /// Someone pressed Ctrl-C.
    Interrupted,
    /// The asked number of cycles is used up.
    Limit,
    /// Emergency stop.
    Emergency(Emergency),
}
