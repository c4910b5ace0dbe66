//! The readings at the start of a cycle, and the checks of them.

use super::{ControllerView, targets};
use crate::command::Port;
use crate::fault::Fault;
use crate::hardware::SensorsView;
use crate::kinematics::ROUNDING;

impl<const J: usize> ControllerView<J> {
    /// Takes in the readings, like [`sense`](super::Controller::sense), for a controller of any
    /// size.
    pub(crate) fn sense_view(&mut self, sensors: &SensorsView<'_, J>) -> Result<(), Fault> {
        let read = self.measure(sensors).and(self.check_sensors());
        for leg in &mut self.legs {
            if leg.switches.has_outside() {
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

    /// Stores the readings; a joint that reads nonsense keeps its last angle.
    fn measure(&mut self, sensors: &SensorsView<'_, J>) -> Result<(), Fault> {
        let seconds = self.params.period / 1000.0;
        let mut result = Ok(());
        let soles = sensors.inputs.of(Port::Paw(1));
        let readings = sensors.angles.iter().zip(sensors.torques).zip(soles);
        for (n, (leg, ((angles, torques), paw))) in self.legs.iter_mut().zip(readings).enumerate() {
            leg.torques = *torques;
            leg.paw = *paw;
            let joints = leg.angles.iter_mut().zip(&mut leg.rates).zip(angles);
            for (m, ((angle, rate), read)) in joints.enumerate() {
                let before = *angle;
                if read.is_finite() {
                    *angle = *read;
                } else {
                    let fault = Fault::JointSensor(targets::number(n), targets::number(m));
                    result = result.and(Err(fault));
                }
                *rate = if self.sensed {
                    (*angle - before) / seconds
                } else {
                    0.0
                };
            }
        }
        self.slider_at = sensors.slider;
        self.sensed = true;
        result
    }

    /// Torques and the slider's place, on a robot that has them.
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
