//! TEACH_ commands (T.I.P. 3.1 §7-5).

use super::drive::THIRD;
use super::{Controller, targets};
use crate::command::{MAX, Target, Teach};
use crate::fault::Fault;
use crate::kinematics::{Chain, Point};

/// What TEACH_FORCE tells where the posture is singular.
const UNAVAILABLE: [f64; 3] = [0.0, 0.0, -1.0];

impl<const L: usize, const J: usize> Controller<'_, L, J> {
    /// Measures: X, Y, Z of a foot or joint in mm; the angles (deg) or torques of a leg, or of a
    /// single joint; the force in N with which a foot, or the end of its second link (`Jn2`),
    /// pushes, which is (0, 0, −1) in a singular posture. Members beyond those are zero.
    ///
    /// # Errors
    /// `Domain` for a target or quantity that the robot lacks.
    pub fn teach(&self, what: Teach, target: Target) -> Result<[f64; MAX], Fault> {
        match what {
            Teach::Position => self.teach_position(target),
            Teach::Angle => of_joints(&self.measured.angles, target),
            Teach::Torque | Teach::Force if self.model.forces.is_none() => Err(Fault::Domain),
            Teach::Torque => of_joints(&self.measured.torques, target),
            Teach::Force => self.teach_force(target),
        }
    }

    fn teach_force(&self, target: Target) -> Result<[f64; MAX], Fault> {
        let (n, point) = match target {
            Target::Foot(n) => (n, Point::Tip),
            Target::Joint(n, 2) => (n, Point::Joint(THIRD)),
            Target::None | Target::All | Target::Floor | Target::Joint(..) => {
                return Err(Fault::Domain);
            }
        };
        let force = self.sensed_force(n, point)?;
        Ok(members(&force.unwrap_or(UNAVAILABLE)))
    }

    fn teach_position(&self, target: Target) -> Result<[f64; MAX], Fault> {
        let (n, joint) = match target {
            Target::Foot(n) => (n, None),
            Target::Joint(n, m) => (n, Some(m)),
            Target::None | Target::All | Target::Floor => return Err(Fault::Domain),
        };
        let leg = targets::leg(&self.model.legs, n)?;
        let chain = Chain::new(leg, targets::leg(&self.measured.angles, n)?);
        match joint {
            None => Ok(members(&self.model.inverse.flat(chain.foot()))),
            Some(m) => chain
                .joint(targets::index(m))
                .map(|place| members(&self.model.inverse.flat(place)))
                .ok_or(Fault::Domain),
        }
    }
}

fn of_joints<const J: usize>(legs: &[[f64; J]], target: Target) -> Result<[f64; MAX], Fault> {
    match target {
        Target::Foot(n) => Ok(members(targets::leg(legs, n)?)),
        Target::Joint(n, m) => Ok(members(&[*targets::joint(legs, n, m)?])),
        Target::None | Target::All | Target::Floor => Err(Fault::Domain),
    }
}

fn members(values: &[f64]) -> [f64; MAX] {
    let mut members = [0.0; MAX];
    for (member, value) in members.iter_mut().zip(values) {
        *member = *value;
    }
    members
}
