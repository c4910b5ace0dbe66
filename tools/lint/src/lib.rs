#![doc = include_str!("../README.md")]
#![cfg_attr(docsrs, feature(doc_cfg))]
#![forbid(unsafe_code)]
#![cfg_attr(not(test), warn(clippy::disallowed_methods, clippy::disallowed_macros))]

pub mod ask;
pub mod cycles;
mod fix;
pub mod format;
pub mod listing;
pub mod message;
pub mod migrate;
pub mod repair;
pub mod spots;

pub use tipc::{Loaded, Options};

/// Reads, checks and lowers a program as [`tipc::load()`] does, and attaches the known fixes to its diagnostics.
pub fn load(name: &str, bytes: &[u8], options: &Options) -> Loaded {
    let mut loaded = tipc::load(name, bytes, options);
    fix::attach(&loaded.source, &loaded.module, &mut loaded.diagnostics);
    loaded
}
