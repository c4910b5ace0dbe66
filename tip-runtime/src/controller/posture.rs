//! INITIAL_POSTURE (T.I.P. 3.1 §7-1-7).

use super::ControllerView;
use super::drive::{Drive, Redundancy};
use super::task::Task;
use super::trajectory::Goal;
use crate::command::Poll;
use crate::kinematics::{Chain, LegPoint};

impl<const J: usize> ControllerView<'_, J> {
    /// Brakes, then sets off for the initial posture with standard parameters.
    pub(super) fn initial_posture(&mut self) -> Poll {
        self.hold();
        if !self.is_at_rest() {
            self.task = Task::Posture;
            return Poll::Pending;
        }
        self.task = Task::Idle;
        self.standardise();
        let inverse = self.robot.inverse;
        for leg in &mut self.legs {
            let initial = Chain::new(leg.model, &leg.model.initial);
            let target = inverse.flat(initial.foot());
            let foot = leg.drive.point(LegPoint::Tip, leg.model, inverse);
            let line = (foot.position(), target);
            leg.drive.redundancy =
                Redundancy::to_initial(inverse, leg.model, &leg.drive.angles, line);
            leg.drive.drive = Drive::Foot(foot.towards(Goal::Point { target, hs: false }));
        }
        if let Some(slider) = self.robot.slider {
            self.slider = self.slider.towards(Goal::Point {
                target: slider.initial,
                hs: false,
            });
        }
        self.release();
        Poll::Done
    }
}
