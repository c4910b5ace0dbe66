//! A gait with a thread that watches a sensor, in edition 3.2, compiled. The tests run it beside the reference interpreter.
#![forbid(unsafe_code)]

// The gait and its thread: `Feeler`, a type like any other.
tip_macros::include_tip!(pub "motions/feeler.prg");

/// The program's text, for the interpreter that the tests compare with.
pub const SOURCE: &str = include_str!("../motions/feeler.prg");
