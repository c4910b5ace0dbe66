//! What a whole control cycle costs: a compiled program, its controller and a simulated robot, in the
//! runs of the examples.
#![forbid(unsafe_code)]

pub mod replay;
pub mod runs;
pub mod stopwatch;
