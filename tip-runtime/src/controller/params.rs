//! The parameters of the SET_ commands (T.I.P. 3.1 §7-8), and the rules by which they are set.

use super::trajectory::Limits;
use super::{ControllerView, targets};
use crate::command::{Command, Op, Target, Value};
use crate::fault::Fault;
use crate::kinematics::LegPoint;
use crate::model::{Forces, Joint, ModelFacts, Standards, TorqueUnit};

/// Parameters of one foot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct FootParams {
    pub(super) v_max: f64,
    pub(super) a_max: f64,
    pub(super) just: f64,
    pub(super) near: f64,
    /// Stiffness along each axis, for the foot and the third joint alike, N/mm.
    pub(super) stiffness: [f64; 3],
    /// Largest pull of a spring at the foot, N.
    foot_limit: Option<[f64; 3]>,
    /// Largest pull of a spring at the third joint, N.
    third_limit: Option<[f64; 3]>,
}

/// Parameters of one joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct JointParams {
    pub(super) omega_max: f64,
    pub(super) omega_dot_max: f64,
    pub(super) just: f64,
    pub(super) near: f64,
    /// `TORQUE_MAX`.
    pub(super) torque_max: f64,
    /// Stiffness, torque per degree.
    pub(super) stiffness: f64,
    /// Maximum torque of its spring.
    pub(super) limit: Option<f64>,
}

/// Placeholder for a robot without commands of force.
const NO_FORCES: Forces = Forces {
    unit: TorqueUnit::NewtonMetre,
    torque_max: 0.0,
    angle_stiffness: 0.0,
    position_stiffness: 0.0,
    search_torque: 0.0,
    search_force: 0.0,
    contact_torque: 0.0,
};

fn forces(robot: &ModelFacts) -> &Forces {
    robot.forces.as_ref().unwrap_or(&NO_FORCES)
}

impl FootParams {
    const fn standard(standards: &Standards, forces: &Forces) -> Self {
        FootParams {
            v_max: standards.v_max,
            a_max: standards.a_max,
            just: standards.just_position,
            near: standards.near_position,
            stiffness: [forces.position_stiffness; 3],
            foot_limit: None,
            third_limit: None,
        }
    }

    /// Returns the largest pull of a spring at a point, N.
    pub(super) const fn limit(&self, point: LegPoint) -> Option<[f64; 3]> {
        match point {
            LegPoint::Tip => self.foot_limit,
            LegPoint::Joint(_) => self.third_limit,
        }
    }

    pub(super) const fn limits(&self) -> Limits {
        Limits {
            speed: self.v_max,
            acceleration: self.a_max,
        }
    }
}

impl JointParams {
    const fn standard(standards: &Standards, forces: &Forces) -> Self {
        JointParams {
            omega_max: standards.omega_max,
            omega_dot_max: standards.omega_dot_max,
            just: standards.just_angle,
            near: standards.near_angle,
            torque_max: forces.torque_max,
            stiffness: forces.angle_stiffness,
            limit: None,
        }
    }

    /// Returns the maximum torque of a command to `joint`, which is at most that of its motor, in the robot's torque
    /// unit.
    pub(super) const fn most_torque(&self, joint: &Joint, torque_unit: f64) -> f64 {
        self.torque_max.min(joint.torque * torque_unit)
    }

    pub(super) const fn limits(&self) -> Limits {
        Limits {
            speed: self.omega_max,
            acceleration: self.omega_dot_max,
        }
    }
}

/// Parameters of one leg.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct LegParams<const J: usize> {
    pub(super) foot: FootParams,
    pub(super) joints: [JointParams; J],
}

impl<const J: usize> LegParams<J> {
    pub(super) fn standard(robot: &ModelFacts) -> Self {
        let (standards, forces) = (&robot.standards, forces(robot));
        LegParams {
            foot: FootParams::standard(standards, forces),
            joints: [JointParams::standard(standards, forces); J],
        }
    }
}

/// Parameters and switches of the robot as a whole.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Params {
    /// Limits of the slider.
    pub(super) slider: FootParams,
    /// Sampling time, ms.
    pub(super) period: f64,
    /// True under EMG_ON: a joint at its working limit is an emergency.
    pub(super) emg: bool,
}

impl Params {
    pub(super) fn standard(robot: &ModelFacts) -> Self {
        Params {
            slider: FootParams::standard(&robot.standards, forces(robot)),
            period: robot.standards.period,
            emg: true,
        }
    }
}

type FootField = fn(&mut FootParams) -> &mut f64;
type JointField = fn(&mut JointParams) -> &mut f64;

/// The parameter that a command sets.
enum Field {
    Foot(FootField),
    Joint(JointField),
}

/// The source of the new value.
enum Source {
    /// The operand.
    Operand,
    /// The operand as a percentage of the standard value.
    Rate,
    /// A share of the standard value.
    Share(f64),
}

const SLOW: Source = Source::Share(0.5);
const FAST: Source = Source::Share(1.5);
const NORMAL: Source = Source::Share(1.0);

/// Returns the meaning of a SET_ command of feet and joints.
fn setting(op: Op) -> Option<(Field, Source)> {
    use Field::{Foot, Joint};
    use Source::{Operand, Rate};
    const V_MAX: FootField = |foot| &mut foot.v_max;
    const A_MAX: FootField = |foot| &mut foot.a_max;
    const OMEGA_MAX: JointField = |joint| &mut joint.omega_max;
    const OMEGA_DOT_MAX: JointField = |joint| &mut joint.omega_dot_max;
    const TORQUE_MAX: JointField = |joint| &mut joint.torque_max;
    Some(match op {
        Op::SetAMax => (Foot(A_MAX), Operand),
        Op::SetAMaxRate => (Foot(A_MAX), Rate),
        Op::SetAMaxSlow => (Foot(A_MAX), SLOW),
        Op::SetAMaxFast => (Foot(A_MAX), FAST),
        Op::SetAMaxNormal => (Foot(A_MAX), NORMAL),
        Op::SetVMax => (Foot(V_MAX), Operand),
        Op::SetVMaxRate => (Foot(V_MAX), Rate),
        Op::SetVMaxSlow => (Foot(V_MAX), SLOW),
        Op::SetVMaxFast => (Foot(V_MAX), FAST),
        Op::SetVMaxNormal => (Foot(V_MAX), NORMAL),
        Op::SetJustPosition => (Foot(|foot| &mut foot.just), Operand),
        Op::SetNearPosition => (Foot(|foot| &mut foot.near), Operand),
        Op::SetOmegaMax => (Joint(OMEGA_MAX), Operand),
        Op::SetOmegaMaxRate => (Joint(OMEGA_MAX), Rate),
        Op::SetOmegaMaxSlow => (Joint(OMEGA_MAX), SLOW),
        Op::SetOmegaMaxFast => (Joint(OMEGA_MAX), FAST),
        Op::SetOmegaMaxNormal => (Joint(OMEGA_MAX), NORMAL),
        Op::SetOmegaDotMax => (Joint(OMEGA_DOT_MAX), Operand),
        Op::SetOmegaDotMaxRate => (Joint(OMEGA_DOT_MAX), Rate),
        Op::SetOmegaDotMaxSlow => (Joint(OMEGA_DOT_MAX), SLOW),
        Op::SetOmegaDotMaxFast => (Joint(OMEGA_DOT_MAX), FAST),
        Op::SetOmegaDotMaxNormal => (Joint(OMEGA_DOT_MAX), NORMAL),
        Op::SetTorqueMax => (Joint(TORQUE_MAX), Operand),
        Op::SetTorqueMaxRate => (Joint(TORQUE_MAX), Rate),
        Op::SetTorqueMaxSoft => (Joint(TORQUE_MAX), SLOW),
        Op::SetTorqueMaxFirmly => (Joint(TORQUE_MAX), FAST),
        Op::SetTorqueMaxNormal => (Joint(TORQUE_MAX), NORMAL),
        Op::SetAngleStiffness => (Joint(|joint| &mut joint.stiffness), Operand),
        Op::SetJustAngle => (Joint(|joint| &mut joint.just), Operand),
        Op::SetNearAngle => (Joint(|joint| &mut joint.near), Operand),
        _ => return None,
    })
}

/// Checked operands of a parameter command.
struct Checked<'a> {
    command: &'a Command<'a>,
    source: Source,
}

impl<'a> Checked<'a> {
    fn new(command: &'a Command<'a>, source: Source) -> Result<Self, Fault> {
        let in_domain = |v: f64| match source {
            Source::Operand => v >= 0.0 && v.is_finite(),
            Source::Rate => v > 0.0 && v <= 100.0,
            Source::Share(_) => true,
        };
        if command.values.iter().all(|value| in_domain(value.number())) {
            Ok(Checked { command, source })
        } else {
            Err(Fault::Domain)
        }
    }

    /// Returns the value for the `i`th joint of a leg; a single operand serves all.
    fn value(&self, i: usize, standard: f64) -> Result<f64, Fault> {
        let operand = match self.command.values {
            [one] => Some(one),
            each => each.get(i),
        };
        Ok(match self.source {
            Source::Operand => operand.ok_or(Fault::Domain)?.number(),
            Source::Rate => standard * operand.ok_or(Fault::Domain)?.number() / 100.0,
            Source::Share(share) => standard * share,
        })
    }
}

impl<const J: usize> ControllerView<J> {
    /// Resets every parameter and switch, as INITIAL_POSTURE and the end of a program do.
    pub(super) fn standardise(&mut self) {
        self.params = Params::standard(&self.robot);
        let standard = LegParams::standard(&self.robot);
        for leg in &mut self.legs {
            leg.params = standard;
            leg.reset_switches();
        }
    }

    /// Runs a parameter command; `None` for another command.
    pub(super) fn set_parameter(&mut self, command: &Command<'_>) -> Option<Result<(), Fault>> {
        if let Some(set) = self.set_spring(command) {
            return Some(set);
        }
        if let Some((field, source)) = setting(command.op) {
            let operands = Checked::new(command, source);
            return Some(operands.and_then(|operands| match field {
                Field::Foot(field) => self.set_foot_field(&operands, field),
                Field::Joint(field) => self.set_joint_field(&operands, field),
            }));
        }
        match command.op {
            Op::SetSamplingTime => Some(self.set_period(command, |time| time)),
            Op::SetSamplingFreq => Some(self.set_period(command, |frequency| 1000.0 / frequency)),
            Op::EmgOn | Op::EmgOff => {
                self.params.emg = command.op == Op::EmgOn;
                Some(Ok(()))
            }
            _ => None,
        }
    }

    fn set_foot_field(&mut self, operands: &Checked<'_>, field: FootField) -> Result<(), Fault> {
        let mut standard = FootParams::standard(&self.robot.standards, forces(&self.robot));
        let value = operands.value(0, *field(&mut standard))?;
        let target = operands.command.target;
        if target == Target::Floor {
            self.robot.slider.ok_or(Fault::Domain)?;
        } else {
            for leg in targets::feet(&mut self.legs, target)? {
                *field(&mut leg.params.foot) = value;
            }
        }
        if matches!(target, Target::All | Target::Floor) {
            *field(&mut self.params.slider) = value;
        }
        Ok(())
    }

    fn set_joint_field(&mut self, operands: &Checked<'_>, field: JointField) -> Result<(), Fault> {
        let mut standard = JointParams::standard(&self.robot.standards, forces(&self.robot));
        let standard = *field(&mut standard);
        if let Target::Joint(n, m) = operands.command.target {
            let ([_] | []) = operands.command.values else {
                return Err(Fault::Domain);
            };
            let leg = targets::leg_mut(&mut self.legs, n)?;
            *field(targets::leg_mut(&mut leg.params.joints, m)?) = operands.value(0, standard)?;
            return Ok(());
        }
        let mut values = [0.0; J];
        for (i, value) in values.iter_mut().enumerate() {
            *value = operands.value(i, standard)?;
        }
        for leg in targets::feet(&mut self.legs, operands.command.target)? {
            for (joint, value) in leg.params.joints.iter_mut().zip(values) {
                *field(joint) = value;
            }
        }
        Ok(())
    }

    fn set_period(&mut self, command: &Command<'_>, to_ms: fn(f64) -> f64) -> Result<(), Fault> {
        let [value] = command.values else {
            return Err(Fault::Domain);
        };
        let period = to_ms(value.number());
        if !self.robot.periods.contains(period) {
            return Err(Fault::Domain);
        }
        self.params.period = period;
        Ok(())
    }

    /// Sets V_MAX of every foot to a share of its standard value.
    pub(super) fn set_all_v_max(&mut self, share: f64) {
        for leg in &mut self.legs {
            leg.params.foot.v_max = self.robot.standards.v_max * share;
        }
    }
}

/// Three operands along x, y and z.
type Axes = [f64; 3];

impl<const J: usize> ControllerView<J> {
    /// Runs a command of springs and their limits; `None` for another command.
    fn set_spring(&mut self, command: &Command<'_>) -> Option<Result<(), Fault>> {
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

    /// Checks three operands; z is not checked if it does not count.
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
