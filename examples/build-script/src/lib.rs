//! Push-ups: a program that the build script compiled.
#![forbid(unsafe_code)]

use tip_runtime::console::Console;
use tip_runtime::machine::Machine;
use tip_runtime::plant::SimulatedPlant;

// `PushUp`, in a file that people can read: target/…/out/push_up.rs.
include!(concat!(env!("OUT_DIR"), "/push_up.rs"));

/// The program on the simulated robot.
pub fn pushing_up<C: Console>(console: C) -> Machine<PushUp, SimulatedPlant<4, 3>, 4, 3, C> {
    Machine::simulated(PushUp::new()).with_console(console)
}
