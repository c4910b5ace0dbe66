//! Properties that hold for any bytes, one file for each reader of outside files. The fuzzer of `tests/fuzz` finds the
//! bytes; the test `fuzz` tries those that it found before.
#![forbid(unsafe_code)]

pub mod compile;
pub mod dap;
pub mod description;
pub mod editing;
#[cfg(unix)]
pub mod files;
pub mod fix;
pub mod format;
pub mod load;
mod lossless;
pub mod lsp;
pub mod migrate;
pub mod names;
pub mod repetitions;
pub mod requests;
pub mod run;
pub mod scene;
pub mod terminal;
pub mod units;
pub mod urdf;
