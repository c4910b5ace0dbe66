//! A crawl gait on the simulated TITAN VIII, compiled. The tests run it beside the reference interpreter.
#![forbid(unsafe_code)]

pub mod options;

// The whole motion program: `Walk`, a type like any other.
tip_macros::include_tip!(pub "motions/walk.prg");

/// The program's text, for the interpreter that the tests compare with.
pub const SOURCE: &str = include_str!("../motions/walk.prg");
