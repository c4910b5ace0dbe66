//! A greeting: the belly rests on the floor and the front right foot waves.
#![forbid(unsafe_code)]

use tip_runtime::console::Console;
use tip_runtime::machine::Machine;
use tip_runtime::plant::SimulatedPlant;

tip_macros::tip!(pub Wave, r#"3.1
A greeting with the front right foot; the belly carries the robot
DEF_VAR N

MESSAGE hello
PTP_ANGLE F2 20 45 40     // yaw forward, thigh up, knee nearly straight
WAIT_INPOS F2
FOR N = 1 TO 3
  PTP_ANGLE J21 40
  WAIT_NEAR J21
  PTP_ANGLE J21 0
  WAIT_NEAR J21
NEXT N

MESSAGE goodbye
INITIAL_POSTURE
WAIT_INPOS ALL
END
"#);

/// The program on the simulated robot.
pub fn waving<C: Console>(console: C) -> Machine<Wave, SimulatedPlant<4, 3>, 4, 3, C> {
    Machine::simulated(Wave::new()).with_console(console)
}
