//! Stiffness of positions, and the limits of compliance (T.I.P. 3.1 §7-8-3-5 to §7-8-3-9).

use super::JointParams;
use crate::command::{Command, Op, Target, Value};
use crate::controller::{ControllerView, targets};
use crate::fault::Fault;
use crate::kinematics::LegPoint;

/// Three operands along x, y and z.
type Axes = [f64; 3];

impl<const J: usize> ControllerView<J> {
    /// Carries out a command of springs and their limits; `None` if the command is none.
    pub(super) fn set_spring(&mut self, command: &Command<'_>) -> Option<Result<(), Fault>> {
        Some(match command.op {
            Op::SetPositionStiffness => self.set_position_stiffness(command),
            Op::SetComplianceTorqueLimit => self.limit_torques(command),
            Op::ResetComplianceTorqueLimit => self.unlimit_torques(command.target),
            Op::SetComplianceForceLimit => self.limit_forces(command),
            Op::ResetComplianceForceLimit => self.put_force_limit(command.target, None),
            _ => return None,
        })
    }

    fn set_position_stiffness(&mut self, command: &Command<'_>) -> Result<(), Fault> {
        let stiffness = self.axes(command.values, |v| v >= 0.0)?;
        for leg in targets::feet(&mut self.legs, command.target)? {
            leg.params.foot.stiffness = stiffness;
        }
        Ok(())
    }

    fn limit_torques(&mut self, command: &Command<'_>) -> Result<(), Fault> {
        let positive = |value: &Value| value.number() > 0.0 && value.number().is_finite();
        if !command.values.iter().all(positive) {
            return Err(Fault::Domain);
        }
        match (command.target, command.values) {
            (Target::Joint(n, m), [limit]) => {
                self.joint_params(n, m)?.limit = Some(limit.number());
            }
            (Target::All, [limit]) => {
                for joint in self.legs.iter_mut().flat_map(|leg| &mut leg.params.joints) {
                    joint.limit = Some(limit.number());
                }
            }
            (target @ (Target::Foot(_) | Target::All), limits) if limits.len() == J => {
                for leg in targets::feet(&mut self.legs, target)? {
                    for (joint, limit) in leg.params.joints.iter_mut().zip(limits) {
                        joint.limit = Some(limit.number());
                    }
                }
            }
            _ => return Err(Fault::Domain),
        }
        Ok(())
    }

    fn unlimit_torques(&mut self, target: Target) -> Result<(), Fault> {
        if let Target::Joint(n, m) = target {
            self.joint_params(n, m)?.limit = None;
            return Ok(());
        }
        let legs = targets::feet(&mut self.legs, target)?;
        for joint in legs.iter_mut().flat_map(|leg| &mut leg.params.joints) {
            joint.limit = None;
        }
        Ok(())
    }

    fn limit_forces(&mut self, command: &Command<'_>) -> Result<(), Fault> {
        let limit = self.axes(command.values, |v| v > 0.0)?;
        self.put_force_limit(command.target, Some(limit))
    }

    fn put_force_limit(&mut self, target: Target, limit: Option<Axes>) -> Result<(), Fault> {
        if target == Target::All {
            for leg in &mut self.legs {
                leg.params.foot.foot_limit = limit;
                leg.params.foot.third_limit = limit;
            }
            return Ok(());
        }
        let (n, point) = self.point_of(target)?;
        let foot = &mut targets::leg_mut(&mut self.legs, n)?.params.foot;
        match point {
            LegPoint::Tip => foot.foot_limit = limit,
            LegPoint::Joint(_) => foot.third_limit = limit,
        }
        Ok(())
    }

    fn joint_params(&mut self, n: u8, m: u8) -> Result<&mut JointParams, Fault> {
        let leg = targets::leg_mut(&mut self.legs, n)?;
        targets::leg_mut(&mut leg.params.joints, m)
    }

    /// Reads three operands in their domain; z goes unchecked where it does not count.
    fn axes(&self, values: &[Value], in_domain: fn(f64) -> bool) -> Result<Axes, Fault> {
        let [x, y, z]: [Value; 3] = values.try_into().map_err(|_| Fault::Domain)?;
        let good = |value: Value| value.number().is_finite() && in_domain(value.number());
        let [_, _, space] = self.robot.inverse.axes();
        if good(x) && good(y) && (!space || good(z)) {
            Ok([x.number(), y.number(), z.number()])
        } else {
            Err(Fault::Domain)
        }
    }
}
