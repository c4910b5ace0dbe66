//! STAND_UP and SIT_DOWN (T.I.P. 3.1 §7-11-1, §7-11-2): the feet push the body up, or let it down.

use super::ControllerView;
use super::targets::unlocked;
use super::task::{Stand, Task};
use crate::command::{Command, Poll, Target};
use crate::fault::Fault;
use crate::kinematics::LegPoint;
use crate::model::Point;

/// V_MAX during the move, as a share of its standard value (SLOW).
const SLOW: f64 = 0.5;

impl<const J: usize> ControllerView<J> {
    /// Moves every foot by the operand times `direction` along z.
    pub(super) fn stand(&mut self, command: &Command<'_>, direction: f64) -> Result<Poll, Fault> {
        let [height] = command.values else {
            return Err(Fault::Domain);
        };
        let rise = direction * height.number();
        let stage = match self.tasks.current() {
            Task::Stand(stage) => stage,
            _ => {
                self.tasks.begin()?;
                self.settle(rise)?;
                Stand::Settling
            }
        };
        match stage {
            _ if !self.inpos(Target::All) => self.tasks.set(Task::Stand(stage)),
            Stand::Settling => {
                self.shift_feet(rise)?;
                self.set_all_v_max(SLOW);
                self.tasks.set(Task::Stand(Stand::Moving));
            }
            Stand::Moving => {
                self.set_all_v_max(1.0);
                self.tasks.set(Task::Idle);
                return Ok(Poll::Done);
            }
        }
        Ok(Poll::Pending)
    }

    /// Puts every foot under position control where it comes to rest, if it can rise from there.
    ///
    /// # Errors
    /// `InvalidMode` while a torque, force or spring decides about any joint, or one is locked;
    /// `OutOfReach`.
    fn settle(&mut self, rise: f64) -> Result<(), Fault> {
        if self.legs.iter().any(|leg| leg.drive.is_soft()) {
            return Err(Fault::InvalidMode);
        }
        self.require_unlocked_feet()?;
        for n in 1..=self.count() {
            let raised = raised(self.foot_rest_point(n)?, rise)?;
            self.require_reach(n, LegPoint::Tip, raised)?;
        }
        for n in 1..=self.count() {
            self.send_foot(n, self.foot_rest_point(n)?, false)?;
        }
        Ok(())
    }

    fn shift_feet(&mut self, rise: f64) -> Result<(), Fault> {
        self.require_unlocked_feet()?;
        for n in 1..=self.count() {
            let target = raised(self.point_target(n, LegPoint::Tip)?, rise)?;
            self.send_foot(n, target, false)?;
        }
        Ok(())
    }

    fn require_unlocked_feet(&self) -> Result<(), Fault> {
        unlocked(self.legs.iter().any(|leg| leg.switches.has_locked()))
    }
}

fn raised([x, y, z]: Point, rise: f64) -> Result<Point, Fault> {
    Ok([x, y, crate::ops::add(z, rise)?])
}
