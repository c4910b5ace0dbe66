//! DETECT_FLOOR and DETECT_OBJECT of a hand (T.I.P. 3.1 §7-11-3, §7-11-4): fingers close with a
//! gentle torque or force until something stops them.
//!
//! A finger has found something when its first joint senses at least the contact torque while no
//! joint has turned for [`STILL_CYCLES`]. It goes on pressing until every finger that searches has
//! found something; then all of them hold the angles that are measured.

use super::ControllerView;
use super::drive::{Drive, THIRD};
use super::task::Task;
use super::trajectory::{Goal, Track};
use crate::command::{Command, Poll, Target};
use crate::fault::Fault;
use crate::kinematics::Point;
use crate::model::Forces;

/// How long a joint that meets something stands still before that counts.
const STILL_CYCLES: u16 = 10;

/// A joint that turns no faster stands still: deg/s.
const STILL: f64 = 2.0;

/// The shares of the search torque that joints 1 and 2 close with. As much in joint 2 as in joint 1
/// would lift the fingertip off the floor again.
const SHARES: [f64; 2] = [1.0, 1.0 / 3.0];

impl<const J: usize> ControllerView<'_, J> {
    /// Starts a search, or goes on with it.
    pub(super) fn feel(
        &mut self,
        command: &Command<'_>,
        start: fn(&mut Self, &Command<'_>, &Forces) -> Result<(), Fault>,
    ) -> Result<Poll, Fault> {
        let forces = self.robot.forces.ok_or(Fault::Domain)?;
        if self.task != Task::Feel {
            start(self, command, forces)?;
            self.task = Task::Feel;
            return Ok(Poll::Pending);
        }
        for leg in &mut self.legs {
            let presses = leg
                .torques
                .first()
                .is_some_and(|torque| libm::fabs(*torque) >= forces.contact_torque);
            let stands = leg.rates.iter().all(|rate| libm::fabs(*rate) <= STILL);
            if let Some(still) = &mut leg.search {
                *still = if presses && stands {
                    still.saturating_add(1)
                } else {
                    0
                };
            }
        }
        let mut searching = self.legs.iter().filter_map(|leg| leg.search);
        if searching.all(|still| still >= STILL_CYCLES) {
            self.task = Task::Idle;
            self.stop_where_felt();
            return Ok(Poll::Done);
        }
        Ok(Poll::Pending)
    }

    /// Every finger that searched holds the angles that are measured.
    fn stop_where_felt(&mut self) {
        for leg in &mut self.legs {
            if leg.search.is_some() {
                leg.drive.drive = Drive::Joints(leg.stays().map(held));
            }
        }
    }

    /// DETECT_FLOOR: joint 1 (type 1), or joints 1 and 2 (type 2), close by torque; the others hold
    /// their angles.
    pub(super) fn floor_search(
        &mut self,
        command: &Command<'_>,
        forces: &Forces,
    ) -> Result<(), Fault> {
        let closing = match kind(command)? {
            1 => 1,
            2 => 2,
            _ => return Err(Fault::Domain),
        };
        self.mark_searching(command.target)?;
        for leg in self.legs.iter_mut().filter(|leg| leg.search.is_some()) {
            let mut tracks = leg.stays().map(held);
            for (track, share) in tracks.iter_mut().zip(SHARES).take(closing) {
                *track = track.towards(Goal::Effort([share * forces.search_torque]));
            }
            leg.drive.drive = Drive::Joints(tracks);
        }
        Ok(())
    }

    /// DETECT_OBJECT: fingertips (type 1) or third joints (type 2) close along x by force, which the
    /// fingers of one side share; in type 3 a spring draws the fingertips, and keeps their height.
    pub(super) fn object_search(
        &mut self,
        command: &Command<'_>,
        forces: &Forces,
    ) -> Result<(), Fault> {
        let kind = kind(command)?;
        let point = match kind {
            1 | 3 => Point::Tip,
            2 => Point::Joint(THIRD),
            _ => return Err(Fault::Domain),
        };
        for n in 1..=self.count() {
            let base = self.leg(n)?.model.base;
            let sharing = self
                .legs
                .iter()
                .filter(|other| is_left(other.model.base) == is_left(base));
            let sharing = sharing.count();
            let force = libm::copysign(forces.search_force / sharing as f64, -base[0]);
            if kind == 3 {
                self.draw_inward(n)?;
            } else {
                self.push_point(n, point, [force, 0.0, 0.0])?;
            }
        }
        self.mark_searching(Target::All)
    }

    /// A spring that draws a fingertip to the middle of the palm, at the height that it has.
    fn draw_inward(&mut self, n: u8) -> Result<(), Fault> {
        let from = self.measured_point(n, Point::Tip)?;
        let target = [0.0, from[1], from[2]];
        let spring = Goal::Spring { target, hs: false };
        self.take_point(n, Point::Tip, Track::resting(from).towards(spring))
    }
}

fn is_left(base: [f64; 3]) -> bool {
    base[0].is_sign_negative()
}

/// Angle control at rest.
fn held(angle: f64) -> Track<1> {
    Track::resting([angle]).towards(Goal::Point {
        target: [angle],
        hs: false,
    })
}

/// The type that a search is given, truncated; 0, which is none, for what is below 1 or no number.
fn kind(command: &Command<'_>) -> Result<u8, Fault> {
    match command.values {
        [value] => Ok(value.number() as u8),
        _ => Err(Fault::Domain),
    }
}
