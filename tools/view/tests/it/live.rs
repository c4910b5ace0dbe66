//! Live sessions: what viewers see of a run, and what they do to it.

mod bench;
mod driven;
mod editing;
mod page;
mod past;
mod running;
