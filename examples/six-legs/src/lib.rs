//! A described hexapod walks on two tripods, compiled. The tests run it beside the reference interpreter.
#![forbid(unsafe_code)]

// The robot and the program that was checked for it: `HEXAPOD`, a constant, and `Tripod`, a type.
tip_macros::include_robot!(pub "hexapod.toml" as HEXAPOD);
tip_macros::include_tip!(pub "motions/tripod.prg", robot = "hexapod.toml");

/// The program's text, for the interpreter that the tests compare with.
pub const SOURCE: &str = include_str!("../motions/tripod.prg");
