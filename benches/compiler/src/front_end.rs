//! Bytes to a resolved program: decoding, parsing, checking, lowering, analysis.

use crate::long::KINDS;
use std::time::Instant;
use tipc::{Options, load};

/// Program lengths, lines.
const LINES: usize = 100_000;
/// Repetitions per program; the shortest time counts, since others were disturbed.
const TIMES: usize = 7;

/// Prints the lines loaded in a second.
pub(crate) fn print() {
    println!("| program of {LINES} lines | ms | lines/s |\n|---|---:|---:|");
    for (name, write) in KINDS {
        let text = write(LINES);
        let lines = text.lines().count() as f64;
        let seconds = (0..TIMES).map(|_| seconds(&text)).fold(f64::MAX, f64::min);
        println!("| {name} | {:.0} | {:.0} |", seconds * 1e3, lines / seconds);
    }
    println!();
}

/// Returns the time to load a program.
pub(crate) fn seconds(text: &str) -> f64 {
    let start = Instant::now();
    let loaded = load("long.prg", text.as_bytes(), &Options::default());
    let seconds = start.elapsed().as_secs_f64();
    assert!(loaded.program.is_some(), "{:?}", loaded.diagnostics.first());
    seconds
}
