//! A crawl gait on the simulated TITAN VIII, run by the compiled program and by the reference
//! interpreter side by side.
#![forbid(unsafe_code)]

pub mod options;

// The whole motion program: `Walk`, a type like any other.
tip_macros::include_tip!(pub "motions/walk.prg");

/// The program's text, for the interpreter.
pub const SOURCE: &str = include_str!("../motions/walk.prg");
