//! How the tests run motion programs: the reference interpreter and the generated code, each on the
//! simulated robot, traced record by record.
//!
//! A language case is a file `cases/<area>/<name>.prg` beside `<name>.trace` (what a run writes down)
//! or `<name>.check` (what the compiler says). Both begin with `#` lines that name the clauses proved,
//! and the options of the run; `...` in a trace stands for any number of records, `"cycle":*` for any cycle.

pub mod clauses;
mod compare;
mod engine;
mod generated;
pub mod random;
mod run;
mod seek;
mod settings;
mod verdict;

pub use compare::matches;
pub use engine::Boxed;
pub use generated::{case, random as random_program};
pub use run::run;
pub use seek::{cases, root};
pub use settings::Settings;
pub use verdict::{checked, differential, random_settings, traced};

/// The examples of the reference compile and run.
#[cfg(doctest)]
#[doc = include_str!("../../docs/robots.md")]
mod robots {}
