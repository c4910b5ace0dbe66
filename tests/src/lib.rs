//! The tests that need generated code: every language case and a batch of random programs, compiled by the build
//! script, run beside the reference interpreter. What a case is, `tip-harness` says.

mod differential;
mod generated;
pub mod random;

pub use differential::{stopped, traced};
pub use generated::case;
pub use tip_harness::{Settings, cases, checked, clauses, each_use, matches, root, run, stops};

/// The examples of the reference compile and run.
#[cfg(doctest)]
#[doc = include_str!("../../docs/robots.md")]
mod robots {}
