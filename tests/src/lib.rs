//! How the tests run motion programs: the reference interpreter and the generated code, each on the
//! simulated robot, traced record by record.
//!
//! A language case is a file `cases/<area>/<name>.prg` beside `<name>.trace` (what a run writes down),
//! `<name>.check` (what the compiler says) or `<name>.stops` (which of its lines stop it, a run for each: see [`stops`]).
//! These begin with `#` lines that name the clauses proved, the options of the run, and the robots if there are
//! several; `...` in a trace stands for any number of records, `"cycle":*` for any cycle.

pub mod clauses;
mod compare;
mod generated;
pub mod random;
mod seek;
pub mod stops;
mod verdict;

pub use compare::matches;
pub use generated::case;
pub use seek::{cases, root};
pub use tip_harness::{Boxed, Settings, run};
pub use verdict::{checked, stopped, traced};

/// The examples of the reference compile and run.
#[cfg(doctest)]
#[doc = include_str!("../../docs/robots.md")]
mod robots {}
