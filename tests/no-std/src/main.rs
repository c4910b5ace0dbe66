//! A compiled program on the simulated robot, on bare metal as far as a Linux process can be.
//!
//! Exit status 0: the program ended itself and the robot did not fall. No panic path may be left,
//! which the linker proves: the panic handler calls a function that does not exist. (A MESSAGE that
//! shows a number would bring in the bounds checks of `core`'s formatting, hence none here.)
#![no_std]
#![no_main]

mod memory;
mod start;

use tip_runtime::machine::{Machine, Status};
use tip_runtime::model::titan8;
use tip_runtime::plant::SimulatedPlant;
use tip_runtime::program::End;

tip_macros::tip!(
    Squat,
    r#"3.1
Rises, measures, sinks
DEF_VAR N, HEIGHT
DEF_POS P
HEIGHT = 40
FOR N = 1 TO 2
  STAND_UP HEIGHT
  TEACH_POSITION F1 P
  HEIGHT = ABS P.Z
  HEIGHT -= 200
  SIT_DOWN HEIGHT
NEXT N
MESSAGE down again
PTP_ANGLE F2 20 45 40
WAIT_INPOS ALL
INITIAL_POSTURE
WAIT_INPOS ALL
END
"#
);

/// More cycles than the program needs.
const LIMIT: u32 = 5000;

/// What the process ends with.
pub(crate) fn run() -> u8 {
    let plant = SimulatedPlant::new(&titan8::MODEL);
    let Ok(mut machine) = Machine::new(Squat::new(), &titan8::MODEL, plant, (), ()) else {
        return 2;
    };
    for _ in 0..LIMIT {
        match machine.cycle() {
            Status::Running => {}
            Status::Finished(End::End) => return u8::from(machine.hardware().falls() > 0),
            Status::Finished(End::Exit) | Status::Emergency => return 3,
        }
    }
    4
}
