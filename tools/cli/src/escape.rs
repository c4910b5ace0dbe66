//! JSON that acts on no terminal, whatever its strings say.

use std::fmt::Write as _;
use tip_runtime::printable::acts;

/// The text of a JSON value, with escapes for characters that could act on a terminal. They occur in strings only.
pub(super) fn json(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for char in text.chars() {
        match char {
            '\n' => out.push(char),
            // Writing to a String cannot fail. All such characters are below 0x10000.
            _ if acts(char) => drop(write!(out, "\\u{:04x}", u32::from(char))),
            _ => out.push(char),
        }
    }
    out
}
