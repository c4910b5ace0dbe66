//! INPOS and NEAR: whether what a target names has arrived (T.I.P. 3.1 §6-2, §7-4).

use super::drive::Drive;
use super::params::{FootParams, JointParams};
use super::trajectory::Goal;
use super::{Controller, targets};
use crate::command::{Poll, Target};
use crate::fault::Fault;

/// How close counts.
#[derive(Clone, Copy)]
enum Tolerance {
    Just,
    Near,
}

impl Tolerance {
    fn of_foot(self, params: &FootParams) -> f64 {
        match self {
            Tolerance::Just => params.just,
            Tolerance::Near => params.near,
        }
    }

    fn of_joint(self, params: &JointParams) -> f64 {
        match self {
            Tolerance::Just => params.just,
            Tolerance::Near => params.near,
        }
    }
}

impl<const L: usize, const J: usize> Controller<'_, L, J> {
    /// `INPOS_…`: arrived within JUST; true where nothing is under position or angle control.
    #[must_use]
    pub fn inpos(&self, target: Target) -> bool {
        self.arrived(target, Tolerance::Just).unwrap_or(true)
    }

    /// `NEAR_…`: arrived within NEAR; false where nothing is under position or angle control.
    #[must_use]
    pub fn near(&self, target: Target) -> bool {
        self.arrived(target, Tolerance::Near).unwrap_or(false)
    }

    /// WAIT_INPOS.
    pub(super) fn wait_inpos(&self, target: Target) -> Poll {
        done_if(self.inpos(target))
    }

    /// WAIT_NEAR.
    pub(super) fn wait_near(&self, target: Target) -> Result<Poll, Fault> {
        match (self.arrived(target, Tolerance::Near), target) {
            (Some(near), _) => Ok(done_if(near)),
            (None, Target::All) => Ok(Poll::Done),
            (None, _) => Err(Fault::InvalidMode),
        }
    }

    /// `None` where nothing is under position or angle control.
    fn arrived(&self, target: Target, tolerance: Tolerance) -> Option<bool> {
        match target {
            Target::All => {
                let legs = (1..=targets::number(L.wrapping_sub(1)))
                    .filter_map(|n| self.leg_arrived(n, tolerance));
                legs.reduce(|all, leg| all && leg)
            }
            Target::Foot(n) => self.leg_arrived(n, tolerance),
            Target::Joint(n, m) => self.joint_arrived(n, m, tolerance),
            Target::None | Target::Floor => None,
        }
    }

    /// Joints under angle control decide; else the foot.
    fn leg_arrived(&self, n: u8, tolerance: Tolerance) -> Option<bool> {
        match targets::leg(&self.drives, n).ok()?.drive {
            Drive::Foot(_) => self.foot_arrived(n, tolerance),
            Drive::Joints(_) => (1..=targets::number(J.wrapping_sub(1)))
                .filter_map(|m| self.joint_arrived(n, m, tolerance))
                .reduce(|all, joint| all && joint),
        }
    }

    /// A joint that serves its foot has arrived when the foot has.
    fn joint_arrived(&self, n: u8, m: u8, tolerance: Tolerance) -> Option<bool> {
        let params = targets::joint(&self.params.joints, n, m).ok()?;
        let Drive::Joints(tracks) = &targets::leg(&self.drives, n).ok()?.drive else {
            return self.foot_arrived(n, tolerance);
        };
        let Goal::Point {
            target: [target], ..
        } = tracks.get(targets::index(m))?.goal()
        else {
            return None;
        };
        let measured = targets::joint(&self.measured.angles, n, m).ok()?;
        Some(libm::fabs(target - measured) <= tolerance.of_joint(params))
    }

    fn foot_arrived(&self, n: u8, tolerance: Tolerance) -> Option<bool> {
        let Drive::Foot(foot) = &targets::leg(&self.drives, n).ok()?.drive else {
            return None;
        };
        let Goal::Point { target, .. } = foot.goal() else {
            return None;
        };
        let measured = self.measured_foot(n).ok()?;
        let squares = target.iter().zip(measured).map(|(a, b)| (a - b) * (a - b));
        let distance = libm::sqrt(squares.sum());
        Some(distance <= tolerance.of_foot(targets::leg(&self.params.feet, n).ok()?))
    }
}

pub(super) fn done_if(done: bool) -> Poll {
    if done { Poll::Done } else { Poll::Pending }
}
