//! The commands themselves: what each number means.

use crate::circle::Circle;
use tip_runtime::command::{Poll, Port};
use tip_runtime::fault::Fault;
use tip_runtime::program::Robot;
use tip_runtime::special::{Call, Special};

/// `SPECIAL 30 radius turns` sways the body along a circle of so many mm, so many times around,
/// and ends where it began.
pub const SWAY: u8 = 30;

/// `SPECIAL 31 volts` sets `SPECIAL_FLAG0` if each sole reads more than that, and clears it if not.
pub const FEEL: u8 = 31;

/// The special commands of this robot.
#[derive(Clone, Debug, Default)]
pub struct Native {
    /// The circle in progress.
    circle: Option<Circle>,
}

impl Special for Native {
    fn poll(&mut self, call: Call, robot: &mut dyn Robot) -> Result<Poll, Fault> {
        match (call.number, call.arguments) {
            (SWAY, [Some(radius), Some(turns)]) => {
                let circle = match &mut self.circle {
                    Some(circle) if !call.first => circle,
                    circle => circle.insert(Circle::new(radius, turns, robot)?),
                };
                circle.poll(robot)
            }
            (FEEL, [Some(volts), None]) => feel(volts, robot),
            _ => Err(Fault::Domain),
        }
    }
}

fn feel(volts: f64, robot: &mut dyn Robot) -> Result<Poll, Fault> {
    let mut all = true;
    for foot in 1..=4 {
        all &= robot.analog(Port::Paw(foot))? > volts;
    }
    robot.set_special_flag(0, all);
    Ok(Poll::Done)
}
