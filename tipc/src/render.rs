//! Diagnostics as people and tools read them.

#[cfg(feature = "build")]
mod human;
#[cfg(feature = "build")]
mod json;
mod plain;
#[cfg(feature = "build")]
mod short;

#[cfg(feature = "build")]
pub use human::{Style, human};
#[cfg(feature = "build")]
pub use json::{json, push_member, push_number, push_string};
pub use plain::plain;
#[cfg(feature = "build")]
pub use short::{classical, short};

use std::fmt::Display;
use tip_runtime::printable::Printable;

/// The most bytes of a line that are shown.
const SHOWN: usize = 4096;

/// Returns the part of a line that is shown.
fn shown(line: &str) -> &str {
    let mut end = line.len().min(SHOWN);
    while !line.is_char_boundary(end) {
        end -= 1;
    }
    &line[..end]
}

/// Formats a text for display: what could act on a terminal is escaped.
fn printable(text: impl Display) -> String {
    Printable::line(text).to_string()
}

#[cfg(all(test, feature = "build"))]
mod tests;
