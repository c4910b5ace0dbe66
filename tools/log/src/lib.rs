#![doc = include_str!("../README.md")]
#![cfg_attr(docsrs, feature(doc_cfg))]
#![forbid(unsafe_code)]
#![cfg_attr(not(test), warn(clippy::disallowed_methods, clippy::disallowed_macros))]

mod csv;
mod mcap;
mod plot;
mod state;

pub use crate::csv::csv;
pub use crate::mcap::mcap;
pub use crate::plot::{Diagram, NothingToPlot, plot};
