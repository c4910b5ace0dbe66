//! Cost of a whole control cycle: a compiled program, its controller and a simulated robot, in the
//! runs of the examples.
#![forbid(unsafe_code)]

pub mod replay;
pub mod runs;
pub mod stopwatch;
