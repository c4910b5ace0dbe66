//! Diagnostics of a file, as text.

use std::fmt;
use tipc::message::Lang;
use tipc::{Loaded, render};

/// Writes one line for each diagnostic.
pub(crate) fn write(loaded: &Loaded, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    let diagnostics = loaded.diagnostics.iter();
    let lines =
        diagnostics.map(|diagnostic| render::short(&loaded.source, diagnostic, Lang::English));
    let lines: Vec<String> = lines.map(|line| line.trim_end().to_owned()).collect();
    f.write_str(&lines.join("\n"))
}
