#![doc = include_str!("../README.md")]
#![cfg_attr(docsrs, feature(doc_cfg))]
#![forbid(unsafe_code)]
#![cfg_attr(not(test), warn(clippy::disallowed_methods, clippy::disallowed_macros))]

mod allow;
pub mod coverage_points;
pub mod cycles;
mod fix;
pub mod format;
mod lints;
pub mod listing;
pub mod message;
pub mod migrate;
pub mod query;
pub mod repair;
mod words;

pub use tipc::{Loaded, Options};

use tipc::diagnostic::Diagnostic;
use tipc::load::lowered;

/// Reads, checks and lowers a program as [`tipc::load()`] does, and adds lints and the known fixes.
pub fn load(name: &str, bytes: &[u8], options: &Options) -> Loaded {
    let (mut loaded, found) = lowered(name, bytes, options);
    let found = lints::find(&loaded, found, bytes, options);
    loaded.report(found);
    words::advise(&mut loaded);
    fix::attach(
        &loaded.source,
        &loaded.module,
        &mut loaded.diagnostics,
        words::fixer,
    );
    loaded
}

/// Adds warnings that others found about a program, except those that a comment silences.
pub fn add(loaded: &mut Loaded, found: Vec<Diagnostic>) {
    lints::add(loaded, found);
}
