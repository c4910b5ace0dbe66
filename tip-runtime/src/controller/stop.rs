//! Commands and functions that bring the robot to rest (T.I.P. 3.1 §7-1-5, §7-10-3).

use super::ControllerView;
use super::drive::LegDrive;
use super::task::{Stand, Task, Tasks};
use super::trajectory::SetPoint;

/// The hold of all motions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Hold {
    /// No hold: motions go on.
    Off,
    /// ALL_STOP: motions brake and wait; modes and targets stay.
    On,
    /// The program is over: motions brake, then nothing is controlled any more.
    Finishing,
}

impl Hold {
    pub(super) const fn is_on(self) -> bool {
        !matches!(self, Hold::Off)
    }
}

impl<const J: usize> ControllerView<J> {
    /// Runs ALL_STOP: every motion brakes under the limits in force; modes and targets stay.
    pub fn hold(&mut self) {
        if self.hold == Hold::Off {
            self.hold = Hold::On;
        }
    }

    /// Holds the robot like [`hold`](Self::hold). Returns false if it was held already.
    pub(crate) fn take_hold(&mut self) -> bool {
        let holds = !self.is_held();
        if holds {
            self.hold();
        }
        holds
    }

    /// Runs ALL_STOP_RELEASE: every motion continues to its target.
    pub fn release(&mut self) {
        if self.hold == Hold::On {
            self.hold = Hold::Off;
        }
    }

    /// Returns true if ALL_STOP is in force.
    #[must_use]
    pub fn is_held(&self) -> bool {
        self.hold == Hold::On
    }

    /// Ends the program (END and EXIT): every motion brakes under the limits in force; then
    /// parameters are standard and nothing is controlled.
    pub fn finish(&mut self) {
        self.tasks = Tasks::NONE;
        self.still();
        self.hold = Hold::Finishing;
        self.end_if_finished();
    }

    /// Cancels the command that a thread is running: targets stay, and the speed and the hold that the command set end.
    pub(crate) fn give_up(&mut self) {
        if let Some(sleep) = self.tasks.sleep() {
            *sleep = 0.0;
        }
        match self.tasks.current() {
            Task::Idle => {}
            Task::Posture(holds) => {
                if holds {
                    self.release();
                }
            }
            Task::Stand(Stand::Settling) => {}
            Task::Stand(Stand::Moving) => self.set_all_v_max(1.0),
            Task::DetectFloor(_) | Task::DetectTouch => {
                for leg in &mut self.legs {
                    leg.search = None;
                }
            }
        }
        self.tasks.give_up();
    }

    /// Stops in an emergency: commands every joint and the slider to stay where they are measured, and ends all
    /// control. A joint that is measured outside of the outer limits, or a slider outside of its travel, is commanded
    /// to the border. A slider with an invalid reading keeps its command.
    pub fn emergency(&mut self) {
        for leg in &mut self.legs {
            let mut angles = leg.angles;
            for (angle, joint) in angles.iter_mut().zip(&leg.model.joints) {
                *angle = joint.outer.nearest(*angle);
            }
            leg.drive = LegDrive::free(angles);
        }
        let mut slider = self.slider.position();
        let travel = self.robot.slider.map(|slider| slider.travel);
        let axes = self.slider_at.iter().zip(travel.iter().flatten());
        for (at, (measured, travel)) in slider.iter_mut().zip(axes) {
            if measured.is_finite() {
                *at = travel.nearest(*measured);
            }
        }
        self.slider = SetPoint::resting(slider);
        self.still();
        self.tasks = Tasks::NONE;
        self.hold = Hold::Off;
        self.pending = None;
    }

    /// Resets to the state of a new controller, on a robot that is where it was measured.
    pub(crate) fn restart(&mut self) {
        self.emergency();
        self.standardise();
    }

    /// Returns true if no joint command moves.
    pub(super) fn is_at_rest(&self) -> bool {
        self.legs.iter().all(|leg| leg.drive.is_at_rest()) && self.slider.is_at_rest()
    }

    pub(super) fn end_if_finished(&mut self) {
        if self.hold == Hold::Finishing && self.is_at_rest() {
            for leg in &mut self.legs {
                leg.drive = LegDrive::free(leg.drive.angles);
            }
            self.slider = SetPoint::resting(self.slider.position());
            self.standardise();
            self.hold = Hold::Off;
        }
    }
}
