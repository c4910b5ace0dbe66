//! Robots as URDF text, and the names and frames of exported files. [`import`](crate::import) reads
//! such files.

mod export;
pub mod frame;
pub mod xml;

pub use export::export;
pub(crate) use export::{loadable, rod_moments};
