//! TEACH_ commands (T.I.P. 3.1 §7-5).

use super::{Controller, targets};
use crate::command::{MAX, Target, Teach};
use crate::fault::Fault;
use crate::kinematics::Chain;
use crate::model::Family;

impl<const L: usize, const J: usize> Controller<'_, L, J> {
    /// Measures: X, Y, Z of a foot or joint in mm; the angles (deg) or torques of a leg, or of a
    /// single joint. Members beyond those are zero.
    ///
    /// # Errors
    /// `Domain` for a target or quantity that the robot lacks, `InvalidMode` for contact forces,
    /// which are not measured yet.
    pub fn teach(&self, what: Teach, target: Target) -> Result<[f64; MAX], Fault> {
        match (what, self.model.family) {
            (Teach::Position, _) => self.teach_position(target),
            (Teach::Angle, _) => of_joints(&self.measured.angles, target),
            (Teach::Torque | Teach::Force, Family::Titan) => Err(Fault::Domain),
            (Teach::Torque, _) => of_joints(&self.measured.torques, target),
            (Teach::Force, _) => Err(Fault::InvalidMode),
        }
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
            None => Ok(members(&chain.foot())),
            Some(m) => chain
                .joint(targets::index(m))
                .map(|place| members(&place))
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
