//! How far a movement has come.

/// How far a movement has come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// Cycles that are done or searched.
    pub done: u64,
    /// Of how many; none where nobody knows.
    pub of: Option<u64>,
}
