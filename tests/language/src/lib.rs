//! The tests that need generated code: language cases, compiled by the build script, run beside the reference
//! interpreter. `tip-harness` defines what a case is.

mod differential;
mod generated;

pub use differential::{stopped, traced};
pub use generated::case;
pub use tip_harness::{Settings, cases, checked, clauses, each_use, matches, root, run, stops};

/// The examples of the reference compile and run.
#[cfg(doctest)]
#[doc = include_str!("../../../docs/robots.md")]
mod robots {}

/// The front page of the macros compiles and runs; its programs are in `motions`.
#[cfg(doctest)]
#[doc = include_str!("../../../tip-macros/README.md")]
mod macros {}
