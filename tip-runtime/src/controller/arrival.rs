//! The flags INPOS and NEAR, the commands that wait for them (T.I.P. 3.1 §6-2, §7-4), and SLEEP.

use super::drive::distance;
use super::leg::LegState;
use super::params::{FootParams, JointParams};
use super::trajectory::SetPoint;
use super::{ControllerView, targets};
use crate::command::{Command, Poll, Target};
use crate::fault::Fault;
use crate::kinematics::LegPoint;
use crate::model::Inverse;

/// The distance at which a target counts as reached.
#[derive(Clone, Copy)]
enum Tolerance {
    Just,
    Near,
}

impl Tolerance {
    fn of(self, just: f64, near: f64) -> f64 {
        match self {
            Tolerance::Just => just,
            Tolerance::Near => near,
        }
    }
}

impl<const J: usize> ControllerView<J> {
    /// Returns the flag `INPOS_…`: arrived within JUST; true where nothing is under position or
    /// angle control.
    #[must_use]
    pub fn inpos(&self, target: Target) -> bool {
        self.arrived(target, Tolerance::Just).unwrap_or(true)
    }

    /// Returns the flag `NEAR_…`: arrived within NEAR; false where nothing is under position or
    /// angle control.
    #[must_use]
    pub fn near(&self, target: Target) -> bool {
        self.arrived(target, Tolerance::Near).unwrap_or(false)
    }

    /// Runs WAIT_INPOS.
    pub(super) fn wait_inpos(&self, target: Target) -> Poll {
        done_if(self.inpos(target))
    }

    /// Runs WAIT_NEAR.
    pub(super) fn wait_near(&self, target: Target) -> Result<Poll, Fault> {
        match (self.arrived(target, Tolerance::Near), target) {
            (Some(near), _) => Ok(done_if(near)),
            (None, Target::All) => Ok(Poll::Done),
            (None, _) => Err(Fault::InvalidMode),
        }
    }

    /// Returns true if the target has arrived; `None` where nothing is under position or angle
    /// control.
    fn arrived(&self, target: Target, tolerance: Tolerance) -> Option<bool> {
        let inverse = self.robot.inverse;
        match target {
            Target::All => {
                let legs = self.legs.iter();
                let legs = legs.filter_map(|leg| leg.arrived(inverse, tolerance));
                all(legs.chain(self.slider_arrived(tolerance)))
            }
            Target::Foot(n) => self.leg(n).ok()?.arrived(inverse, tolerance),
            Target::Joint(n, m) => self.leg(n).ok()?.joint_arrived(m, inverse, tolerance),
            Target::None | Target::Floor => None,
        }
    }

    fn slider_arrived(&self, tolerance: Tolerance) -> Option<bool> {
        let target = self.slider.goal().target()?;
        let gap = distance(target, self.slider_at);
        let FootParams { just, near, .. } = self.params.slider;
        Some(gap <= tolerance.of(just, near))
    }
}

impl<const J: usize> LegState<J> {
    /// Returns true if the leg has arrived. Joints under angle control, and a third joint under
    /// position control, decide; otherwise the foot.
    fn arrived(&self, inverse: Inverse, tolerance: Tolerance) -> Option<bool> {
        // A controlled point always moves the first joint.
        let point = self.drive.point_of_joint(0);
        let point = point.and_then(|point| self.point_arrived(point, inverse, tolerance));
        let (first, tracks) = self.drive.own_joints();
        let joints = (first..).zip(tracks);
        let joints = joints.filter_map(|(m, track)| self.angle_arrived(m, track, tolerance));
        all(point.into_iter().chain(joints))
    }

    /// Returns true if a joint has arrived. A joint that moves a controlled point has arrived when the point has.
    fn joint_arrived(&self, m: u8, inverse: Inverse, tolerance: Tolerance) -> Option<bool> {
        let at = targets::index(m);
        let point = match self.drive.point_of_joint(at) {
            Some(point) => self.point_arrived(point, inverse, tolerance),
            None => None,
        };
        let (first, tracks) = self.drive.own_joints();
        let angle = match at.checked_sub(first).and_then(|own| tracks.get(own)) {
            Some(track) => self.angle_arrived(at, track, tolerance),
            None => None,
        };
        match (point, angle) {
            (Some(point), Some(angle)) => Some(point && angle),
            (point, angle) => point.or(angle),
        }
    }

    /// Returns true if joint `m`, counted from 0, has arrived.
    fn angle_arrived(&self, m: usize, track: &SetPoint<1>, tolerance: Tolerance) -> Option<bool> {
        let [target] = track.goal().target()?;
        let JointParams { just, near, .. } = *self.params.joints.get(m)?;
        let measured = self.angles.get(m)?;
        Some(libm::fabs(target - measured) <= tolerance.of(just, near))
    }

    fn point_arrived(
        &self,
        (point, track): (LegPoint, &SetPoint<3>),
        inverse: Inverse,
        tolerance: Tolerance,
    ) -> Option<bool> {
        let target = track.goal().target()?;
        let measured = self.place(point, inverse).ok()?;
        let FootParams { just, near, .. } = self.params.foot;
        Some(distance(target, measured) <= tolerance.of(just, near))
    }
}

/// Returns true if all parts are true; `None` without parts. It stops at the first part that is false.
fn all(parts: impl Iterator<Item = bool>) -> Option<bool> {
    let mut all = None;
    for part in parts {
        all = Some(part);
        if !part {
            break;
        }
    }
    all
}

fn done_if(done: bool) -> Poll {
    if done { Poll::Done } else { Poll::Pending }
}

impl<const J: usize> ControllerView<J> {
    /// Runs SLEEP: at least one cycle, and no time of a cycle too little.
    pub(super) fn sleep(&mut self, command: &Command<'_>) -> Result<Poll, Fault> {
        let sleep = self.tasks.sleep().ok_or(Fault::Domain)?;
        let left = match (*sleep, command.values) {
            (left, _) if left > 0.0 => left,
            (_, [time]) if time.number() >= 0.0 => {
                // The subtrahend compensates the rounding of a division that should be exact.
                libm::ceil(time.number() / self.params.period - 1e-9).max(1.0)
            }
            _ => return Err(Fault::Domain),
        };
        let done = left <= 1.0;
        *sleep = if done { 0.0 } else { left - 1.0 };
        Ok(done_if(done))
    }
}
