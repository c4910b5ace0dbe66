//! Bytes to bytes in the style: the program is read and checked, laid out, read again and compared.

use crate::long::KINDS;
use std::time::Instant;
use tip_lint::format::format;
use tipc::Options;

/// Program lengths, lines.
const LINES: usize = 100_000;
/// Repetitions per program; the shortest time counts, since others were disturbed.
const TIMES: usize = 7;

/// Prints the lines formatted in a second, of programs in small letters, so that every line changes, each with a comment but for
/// messages, whose texts a comment would cut.
pub(crate) fn print() {
    println!("| formatted program of {LINES} lines | ms | lines/s |\n|---|---:|---:|");
    for (name, write) in KINDS {
        let text = write(LINES);
        let lines = text.lines().count() as f64;
        let seconds = (0..TIMES).map(|_| seconds(&text)).fold(f64::MAX, f64::min);
        println!("| {name} | {:.0} | {:.0} |", seconds * 1e3, lines / seconds);
    }
    println!();
}

fn noted(line: &str) -> String {
    let is_message = line.trim_start().starts_with("message");
    let note = if is_message { "" } else { " // note" };
    format!("{line}{note}\n")
}

/// Returns the time to format a program, written as [`print`] says.
pub(crate) fn seconds(text: &str) -> f64 {
    let text: String = text.to_lowercase().lines().map(noted).collect();
    let start = Instant::now();
    let formatted = format("long.prg", text.as_bytes(), &Options::default());
    let seconds = start.elapsed().as_secs_f64();
    let formatted = formatted.expect("a program");
    assert!(formatted != text.as_bytes());
    seconds
}
