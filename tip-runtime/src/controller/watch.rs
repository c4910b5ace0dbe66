//! What is measured at the start of a cycle, and what is wrong with it.

use super::{Controller, targets};
use crate::fault::Fault;
use crate::hardware::Sensors;
use crate::kinematics::ROUNDING;

impl<const L: usize, const J: usize> Controller<'_, L, J> {
    /// Takes in what the sensors read.
    ///
    /// # Errors
    /// A joint sensor that reads nonsense; a joint beyond its potentiometer's limits, or under
    /// EMG_ON beyond its working limits; what went wrong in the last advance.
    pub fn sense(&mut self, sensors: &Sensors<L, J>) -> Result<(), Fault> {
        let read = self.measure(sensors).and(self.check_sensors());
        for (drive, measured) in self.drives.iter_mut().zip(&self.measured.angles) {
            drive.follow(measured);
        }
        read.and_then(|()| self.check_limits())?;
        self.pending.take().map_or(Ok(()), Err)
    }

    /// Stores the readings; a joint that reads nonsense keeps its last angle.
    fn measure(&mut self, sensors: &Sensors<L, J>) -> Result<(), Fault> {
        let before = self.measured.angles;
        self.measured = *sensors;
        let seconds = self.params.period / 1000.0;
        let mut result = Ok(());
        let legs = self.measured.angles.iter_mut().zip(&mut self.rates);
        for (n, ((angles, rates), before)) in legs.zip(before).enumerate() {
            for (m, ((angle, rate), before)) in angles.iter_mut().zip(rates).zip(before).enumerate()
            {
                if !angle.is_finite() {
                    *angle = before;
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
        self.sensed = true;
        result
    }

    /// Torques and the slider's place, on a robot that has them.
    fn check_sensors(&self) -> Result<(), Fault> {
        if self.model.forces.is_some() {
            for (n, torques) in (1..).zip(&self.measured.torques) {
                if let Some(m) = torques.iter().position(|torque| !torque.is_finite()) {
                    return Err(Fault::JointSensor(n, targets::number(m)));
                }
            }
        }
        let slider = self.measured.slider.iter().all(|at| at.is_finite());
        if self.model.slider.is_some() && !slider {
            return Err(Fault::SliderSensor);
        }
        Ok(())
    }

    fn check_limits(&self) -> Result<(), Fault> {
        for (n, (leg, angles)) in (1..).zip(self.model.legs.iter().zip(&self.measured.angles)) {
            for (m, (joint, angle)) in (1..).zip(leg.joints.iter().zip(angles)) {
                let limits = if self.params.emg {
                    joint.limits
                } else {
                    joint.outer
                };
                if !limits.widened(ROUNDING).contains(*angle) {
                    return Err(Fault::JointLimit(n, m));
                }
            }
        }
        Ok(())
    }
}
