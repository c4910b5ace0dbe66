//! INITIAL_POSTURE (T.I.P. 3.1 §7-1-7).

use super::ControllerView;
use super::drive::{Drive, Redundancy};
use super::task::Task;
use super::trajectory::Goal;
use crate::command::Poll;
use crate::fault::Fault;
use crate::kinematics::{Chain, LegPoint};

impl<const J: usize> ControllerView<J> {
    /// Brakes, then sets off for the initial posture with standard parameters.
    ///
    /// # Errors
    /// `InvalidMode` while another thread stands in a command of this kind.
    pub(super) fn initial_posture(&mut self) -> Result<Poll, Fault> {
        let holds = match self.tasks.current() {
            Task::Posture(holds) => {
                self.hold();
                holds
            }
            _ => {
                self.tasks.begin()?;
                self.take_hold()
            }
        };
        if !self.is_at_rest() {
            self.tasks.set(Task::Posture(holds));
            return Ok(Poll::Pending);
        }
        self.tasks.set(Task::Idle);
        self.standardise();
        let inverse = self.robot.inverse;
        for leg in &mut self.legs {
            let initial = Chain::new(&leg.model, &leg.model.initial);
            let target = inverse.flat(initial.foot());
            let foot = leg.drive.point(LegPoint::Tip, &leg.model, inverse);
            let line = (foot.position(), target);
            leg.drive.redundancy =
                Redundancy::to_initial(inverse, &leg.model, &leg.drive.angles, line);
            leg.drive.drive = Drive::Foot(foot.towards(Goal::Point { target, hs: false }));
        }
        if let Some(slider) = self.robot.slider {
            self.slider = self.slider.towards(Goal::Point {
                target: slider.initial,
                hs: false,
            });
        }
        self.release();
        Ok(Poll::Done)
    }
}
