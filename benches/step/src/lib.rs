//! The implementations that are measured, the run loop, and the trace.
#![forbid(unsafe_code)]

mod asked;
mod lua;
mod rhai;
pub mod roster;
mod rune;

use native::Entrant;
use native::robot::{Answering, Trace};
use tip_runtime::program::Context;

/// Runs some control cycles.
///
/// # Panics
/// If a step fails; no motion here does.
#[inline(never)]
pub fn drive(entrant: &mut dyn Entrant, robot: &mut dyn Context, cycles: u64) {
    for _ in 0..cycles {
        entrant.cycle(robot).expect("a motion without faults");
    }
}

/// The hash over every command and its values of every cycle.
///
/// # Panics
/// If a step fails; no motion here does.
pub fn trace(entrant: &mut dyn Entrant, cycles: u64) -> u64 {
    let mut robot = Answering(Trace::default());
    for cycle in 0..cycles {
        robot.0.cycle = cycle;
        drive(entrant, &mut robot, 1);
    }
    robot.0.hash
}
