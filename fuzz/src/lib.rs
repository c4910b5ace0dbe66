//! The targets, which the tests of `tipc` define.

#[path = "../../tipc/tests/fuzz/targets/mod.rs"]
mod targets;

pub use targets::*;
