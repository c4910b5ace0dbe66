//! INITIAL_POSTURE (T.I.P. 3.1 §7-1-7).

use super::Controller;
use super::drive::Drive;
use super::params::Params;
use super::task::Task;
use super::trajectory::Goal;
use crate::command::Poll;
use crate::kinematics::{Chain, Point};

impl<const L: usize, const J: usize> Controller<'_, L, J> {
    /// Brakes, then sets off for the initial posture with standard parameters.
    pub(super) fn initial_posture(&mut self) -> Poll {
        self.hold();
        if !self.is_at_rest() {
            self.task = Task::Posture;
            return Poll::Pending;
        }
        self.task = Task::Idle;
        self.params = Params::standard(self.model);
        let inverse = self.model.inverse;
        for (leg, drive) in self.model.legs.iter().zip(&mut self.drives) {
            let target = inverse.flat(Chain::new(leg, &leg.initial).foot());
            let foot = drive.point(Point::Tip, leg, inverse);
            drive.drive = Drive::Foot(foot.towards(Goal::Point { target, hs: false }));
        }
        if let Some(slider) = &self.model.slider {
            self.slider = self.slider.towards(Goal::Point {
                target: slider.initial,
                hs: false,
            });
        }
        self.release();
        Poll::Done
    }
}
