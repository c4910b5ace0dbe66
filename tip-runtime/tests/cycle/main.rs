//! The whole control cycle: program, controller and simulated plant together.
#![cfg(feature = "control")]

mod motion;
mod no_heap;
mod program;
