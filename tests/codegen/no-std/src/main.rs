//! Compiled programs on simulated robots, on bare metal as far as a Linux process can be. The traces
//! go to standard output.
//!
//! Exit status 0: the programs ended themselves. No panic path may be left, which the linker proves:
//! the panic handler calls a function that does not exist.
#![no_std]
#![no_main]

mod memory;
mod start;

use start::Output;

/// Exit status.
pub(crate) fn run() -> u8 {
    let walked = robots::walker().is_ok_and(|mut robot| robots::run(&mut robot, &mut Output));
    let grasped = robots::hand().is_ok_and(|mut robot| robots::run(&mut robot, &mut Output));
    let swung =
        robots::heavy_walker().is_ok_and(|mut robot| robots::run(&mut robot, &mut Output));
    u8::from(!(walked && grasped && swung))
}
