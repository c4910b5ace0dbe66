//! Commands of a robot's owner, written in Rust, for `SPECIAL`: a program uses them like any other.
#![forbid(unsafe_code)]

mod circle;
pub mod native;
pub mod run;

// The motion program: `Dance`, a type like any other.
tip_macros::include_tip!(pub "motions/dance.prg");

/// The program's text, for the interpreter.
pub const SOURCE: &str = include_str!("../motions/dance.prg");
