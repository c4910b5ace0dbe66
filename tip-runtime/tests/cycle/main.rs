//! The whole control cycle: program, controller and simulated plant together.
#![cfg(feature = "control")]

#[path = "../list/mod.rs"]
mod list;
mod motion;
mod no_heap;
mod program;
