//! Runner of language cases: a file `cases/<area>/<name>.prg` beside `<name>.trace` (the trace of a run),
//! `<name>.check` (what the compiler says) or `<name>.stops` (which of its lines stop it, a run for each: see [`stops`]).
//! These begin with `#` lines that name the clauses proved, the options of the run, and the robots if there are
//! several; `...` in a trace stands for any number of records, `"cycle":*` for any cycle.

pub mod clauses;
mod compare;
mod run;
pub mod stops;
mod verdict;

pub use case_files::{Settings, cases, root};
pub use compare::matches;
pub use run::{both, run};
pub use verdict::{Compiled, checked, each_use, stopped, traced};
