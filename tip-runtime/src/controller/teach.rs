//! TEACH_ commands (T.I.P. 3.1 §7-5).

use super::drive::THIRD;
use super::{ControllerView, targets};
use crate::command::{MAX, Target, Teach};
use crate::fault::Fault;
use crate::kinematics::LegPoint;

/// Result of TEACH_FORCE where the posture is singular.
const UNAVAILABLE: [f64; 3] = [0.0, 0.0, -1.0];

impl<const J: usize> ControllerView<J> {
    /// Measures: X, Y, Z of a foot or joint in mm; the angles (deg) or torques of a leg, or of a
    /// single joint; the force in N with which a foot, or the end of its second link (`Jn2`),
    /// pushes, which is (0, 0, −1) in a singular posture. Members beyond those are zero.
    ///
    /// # Errors
    /// `Domain` for a target or quantity that the robot lacks.
    pub fn teach(&self, what: Teach, target: Target) -> Result<[f64; MAX], Fault> {
        match what {
            Teach::Position => self.teach_position(target),
            Teach::Torque | Teach::Force if self.robot.forces.is_none() => Err(Fault::Domain),
            Teach::Force => self.teach_force(target),
            Teach::Angle => {
                let (n, joint) = leg_and_joint(target)?;
                of_joints(&self.leg(n)?.angles, joint)
            }
            Teach::Torque => {
                let (n, joint) = leg_and_joint(target)?;
                of_joints(&self.leg(n)?.torques, joint)
            }
        }
    }

    fn teach_force(&self, target: Target) -> Result<[f64; MAX], Fault> {
        let (n, point) = match target {
            Target::Foot(n) => (n, LegPoint::Tip),
            Target::Joint(n, 2) => (n, LegPoint::Joint(THIRD)),
            Target::None | Target::All | Target::Floor | Target::Joint(..) => {
                return Err(Fault::Domain);
            }
        };
        let force = self.sensed_force(n, point)?;
        Ok(members(&force.unwrap_or(UNAVAILABLE)))
    }

    fn teach_position(&self, target: Target) -> Result<[f64; MAX], Fault> {
        let (n, joint) = leg_and_joint(target)?;
        let chain = self.leg(n)?.chain();
        match joint {
            None => Ok(members(&self.robot.inverse.flat(chain.foot()))),
            Some(m) => chain
                .joint(m)
                .map(|place| members(&self.robot.inverse.flat(place)))
                .ok_or(Fault::Domain),
        }
    }
}

/// Returns the leg that a target names, and the joint of it (from 0) if it names one alone.
fn leg_and_joint(target: Target) -> Result<(u8, Option<usize>), Fault> {
    match target {
        Target::Foot(n) => Ok((n, None)),
        Target::Joint(n, m) => Ok((n, Some(targets::index(m)))),
        Target::None | Target::All | Target::Floor => Err(Fault::Domain),
    }
}

/// Returns the values of all joints, or of a single one.
fn of_joints(values: &[f64], joint: Option<usize>) -> Result<[f64; MAX], Fault> {
    match joint {
        None => Ok(members(values)),
        Some(m) => Ok(members(&[*values.get(m).ok_or(Fault::Domain)?])),
    }
}

fn members(values: &[f64]) -> [f64; MAX] {
    let mut members = [0.0; MAX];
    for (member, value) in members.iter_mut().zip(values) {
        *member = *value;
    }
    members
}
