//! INPOS and NEAR: whether what a target names has arrived (T.I.P. 3.1 §6-2, §7-4).

use super::params::{FootParams, JointParams};
use super::trajectory::Track;
use super::{Controller, targets};
use crate::command::{Poll, Target};
use crate::fault::Fault;
use crate::kinematics::Point;

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
                all(legs.chain(self.slider_arrived(tolerance)))
            }
            Target::Foot(n) => self.leg_arrived(n, tolerance),
            Target::Joint(n, m) => self.joint_arrived(n, m, tolerance),
            Target::None | Target::Floor => None,
        }
    }

    /// Joints under angle control, and a third joint under position control, decide; else the foot.
    fn leg_arrived(&self, n: u8, tolerance: Tolerance) -> Option<bool> {
        let drive = targets::leg(&self.drives, n).ok()?;
        // A point that decides about any joint decides about the first.
        let point = drive.point_of_joint(0);
        let point = point.and_then(|point| self.point_arrived(n, point, tolerance));
        let (first, tracks) = drive.own_joints();
        let joints = (targets::number(first)..).zip(tracks);
        let joints = joints.filter_map(|(m, track)| self.angle_arrived(n, m, track, tolerance));
        all(point.into_iter().chain(joints))
    }

    /// A joint that serves a point has arrived when the point has.
    fn joint_arrived(&self, n: u8, m: u8, tolerance: Tolerance) -> Option<bool> {
        let drive = targets::leg(&self.drives, n).ok()?;
        let at = targets::index(m);
        let point = match drive.point_of_joint(at) {
            Some((point, track)) => self.point_arrived(n, (point, track), tolerance),
            None => None,
        };
        let (first, tracks) = drive.own_joints();
        let angle = match at.checked_sub(first).and_then(|own| tracks.get(own)) {
            Some(track) => self.angle_arrived(n, m, track, tolerance),
            None => None,
        };
        match (point, angle) {
            (Some(point), Some(angle)) => Some(point && angle),
            (point, angle) => point.or(angle),
        }
    }

    fn angle_arrived(&self, n: u8, m: u8, track: &Track<1>, tolerance: Tolerance) -> Option<bool> {
        let [target] = track.goal().target()?;
        let params = targets::joint(&self.params.joints, n, m).ok()?;
        let measured = targets::joint(&self.measured.angles, n, m).ok()?;
        Some(libm::fabs(target - measured) <= tolerance.of_joint(params))
    }

    fn point_arrived(
        &self,
        n: u8,
        (point, track): (Point, &Track<3>),
        tolerance: Tolerance,
    ) -> Option<bool> {
        let target = track.goal().target()?;
        let measured = self.measured_point(n, point).ok()?;
        let params = targets::leg(&self.params.feet, n).ok()?;
        Some(distance(target, measured) <= tolerance.of_foot(params))
    }

    fn slider_arrived(&self, tolerance: Tolerance) -> Option<bool> {
        let target = self.slider.goal().target()?;
        let gap = distance(target, self.measured.slider);
        Some(gap <= tolerance.of_foot(&self.params.slider))
    }
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    let squares = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b));
    libm::sqrt(squares.sum())
}

/// Whether all parts are true, looking no farther than the first that is not; `None` of nothing.
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

pub(super) fn done_if(done: bool) -> Poll {
    if done { Poll::Done } else { Poll::Pending }
}
