//! The readings at the start of a cycle and their checks, and the measurements of TEACH_ commands (T.I.P. 3.1 §7-5).

use super::drive::THIRD;
use super::{ControllerView, targets};
use crate::command::{MAX, Port, Target, Teach};
use crate::fault::Fault;
use crate::hardware::SensorsView;
use crate::kinematics::{LegPoint, ROUNDING};

impl<const J: usize> ControllerView<J> {
    /// Takes the readings, like [`sense`](super::Controller::sense), for a controller of any size.
    pub(crate) fn sense_view(&mut self, sensors: &SensorsView<'_, J>) -> Result<(), Fault> {
        let read = self.measure(sensors).and(self.check_sensors());
        for leg in &mut self.legs {
            if leg.switches.any_outside {
                leg.note_inside();
            }
            if leg.drive.pushes() {
                let stays = leg.stays();
                leg.drive.follow(&stays);
            }
        }
        read.and_then(|()| self.check_limits())?;
        self.pending.take().map_or(Ok(()), Err)
    }

    /// Stores the readings. A joint with an invalid reading keeps its last angle.
    fn measure(&mut self, sensors: &SensorsView<'_, J>) -> Result<(), Fault> {
        let seconds = self.params.period / 1000.0;
        let mut result = Ok(());
        let soles = sensors.inputs.of(Port::Paw(1));
        let angles = sensors.angles.iter().zip(sensors.ages);
        let readings = angles.zip(sensors.torques).zip(soles);
        for (n, (leg, (((angles, ages), torques), paw))) in
            self.legs.iter_mut().zip(readings).enumerate()
        {
            leg.torques = *torques;
            leg.paw = *paw;
            let states = leg.angles.iter_mut().zip(&mut leg.rates);
            let joints = states.zip(&mut leg.unmeasured).zip(angles.iter().zip(ages));
            for (m, (((angle, rate), unmeasured), (read, age))) in joints.enumerate() {
                let before = *angle;
                *unmeasured += seconds;
                if read.is_finite() {
                    *angle = *read;
                } else {
                    let fault = Fault::JointSensor(targets::number(n), targets::number(m));
                    result = result.and(Err(fault));
                }
                if *age > 0 {
                    continue;
                }
                *rate = if self.sensed {
                    (*angle - before) / *unmeasured
                } else {
                    0.0
                };
                *unmeasured = 0.0;
            }
        }
        self.slider_at = sensors.slider;
        self.sensed = true;
        result
    }

    /// Checks torques and the slider's place, on a robot that has them.
    fn check_sensors(&self) -> Result<(), Fault> {
        if self.robot.forces.is_some() {
            for (n, leg) in (1..).zip(&self.legs) {
                if let Some(m) = leg.torques.iter().position(|torque| !torque.is_finite()) {
                    return Err(Fault::JointSensor(n, targets::number(m)));
                }
            }
        }
        let slider = self.slider_at.iter().all(|at| at.is_finite());
        if self.robot.slider.is_some() && !slider {
            return Err(Fault::SliderSensor);
        }
        Ok(())
    }

    fn check_limits(&self) -> Result<(), Fault> {
        for (n, leg) in (1..).zip(&self.legs) {
            for (m, (joint, angle)) in (1..).zip(leg.model.joints.iter().zip(&leg.angles)) {
                let limits = if self.params.emg {
                    joint.limits
                } else {
                    joint.outer
                };
                let is_inside = limits.widened(ROUNDING).contains(*angle);
                if !is_inside && !leg.may_be_outside(targets::index(m), *angle) {
                    return Err(Fault::JointLimit(n, m));
                }
            }
        }
        Ok(())
    }
}

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

/// Returns the values as the members of a struct of the language; the rest is zero.
pub(super) fn members(values: &[f64]) -> [f64; MAX] {
    let mut members = [0.0; MAX];
    for (member, value) in members.iter_mut().zip(values) {
        *member = *value;
    }
    members
}
