//! Live sessions: what viewers see of a run, and what they do to it.

mod bench;
mod editing;
mod page;
mod past;
mod running;
