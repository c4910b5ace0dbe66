//! A described hexapod walks on two tripods, run by the compiled program and by the reference
//! interpreter side by side.
#![forbid(unsafe_code)]

use tip_sim::Robot;

// The robot and the program that was checked for it: `HEXAPOD`, a constant, and `Tripod`, a type.
tip_macros::include_robot!(pub "hexapod.toml" as HEXAPOD);
tip_macros::include_tip!(pub "motions/tripod.prg", robot = "hexapod.toml");

/// The program's text, for the interpreter.
pub const SOURCE: &str = include_str!("../motions/tripod.prg");

/// The hexapod, simulated.
pub fn hexapod() -> Robot {
    Robot::of(&HEXAPOD)
}
