#![doc = include_str!("../README.md")]
#![cfg_attr(docsrs, feature(doc_cfg))]
#![forbid(unsafe_code)]

mod columns;
mod error;
mod quantity;
mod spec;
mod sweep;

pub use columns::{Column, Columns, Data};
pub use error::SweepError;
pub use quantity::{Noise, Push, Quantity};
pub use spec::{Axis, AxisError, PlantSpec, RobotSpec, Sampling, Spec, Text, Values};
pub use sweep::{Case, LIMIT, Sweep};

/// Runs some cases of a sweep: the pure function that every executor calls.
///
/// # Errors
/// The specification is wrong, there is no such case, or robot or scene do not allow its values.
pub fn run_chunk(spec: &Spec, first: u64, count: u64) -> Result<Columns, SweepError> {
    Sweep::new(spec.clone())?.run(first, count)
}
