//! Push-ups: a program that the build script compiled.
#![forbid(unsafe_code)]

use tip_runtime::console::Console;
use tip_runtime::machine::{Machine, Mismatch};
use tip_runtime::model::titan8;
use tip_runtime::plant::SimulatedPlant;

// `PushUp`, in a file that people can read: target/…/out/push_up.rs.
include!(concat!(env!("OUT_DIR"), "/push_up.rs"));

/// The program on the simulated robot.
///
/// # Errors
/// Never, unless the robot's model changes: the program was checked for this one.
pub fn pushing_up<C: Console>(
    console: C,
) -> Result<Machine<PushUp, SimulatedPlant<4, 3>, C, (), 4, 3>, Mismatch> {
    let plant = SimulatedPlant::new(&titan8::MODEL);
    Machine::new(PushUp::new(), &titan8::MODEL, plant, console, ())
}
