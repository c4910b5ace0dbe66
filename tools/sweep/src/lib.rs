#![doc = include_str!("../README.md")]
#![cfg_attr(docsrs, feature(doc_cfg))]
#![forbid(unsafe_code)]

mod columns;
mod error;
mod goal;
mod measure;
mod quantity;
mod saved;
mod spec;
mod sweep;

pub use columns::{Cell, Column, Kind, LIMIT, Meaning, Outcome, Row, Table};
pub use error::{SweepError, Texts};
pub use goal::{Condition, Front, Goal, Operator, Ranking};
pub use quantity::{Noise, Push, Quantity};
pub use saved::Saved;
pub use spec::{ArgumentError, Axis, PlantSpec, RobotSpec, Sampling, Spec, Text, Values};
pub use sweep::{Case, Sweep};

use std::sync::Arc;

/// Runs some cases of a sweep: the pure function that every executor calls.
///
/// # Errors
/// The specification is wrong, there is no such case, or robot or scene do not allow its values.
pub fn run_chunk(spec: &Spec, first: u64, count: u64) -> Result<Table, SweepError> {
    let sweep = Sweep::new(spec.clone())?;
    Ok(Table {
        rows: sweep.run(first, count)?,
        columns: Arc::clone(sweep.columns()),
    })
}
