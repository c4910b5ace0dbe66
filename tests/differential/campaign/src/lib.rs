//! The differential campaign: random programs by the thousand, compiled in batches, each run by both engines in
//! lock-step. What differs is shrunk and kept.

pub mod batch;
pub mod build;
pub mod found;
pub mod hunt;
pub mod progress;
pub mod report;
