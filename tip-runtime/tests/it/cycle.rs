//! The whole control cycle: program, controller and simulated plant together.

mod motion;
mod no_heap;
mod program;
