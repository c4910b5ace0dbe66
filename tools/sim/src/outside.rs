//! A robot that is simulated outside of this process, whatever its size.

use crate::motion::Limbs;
use std::any::Any;
use std::time::Duration;
use tip_runtime::command::Port;
use tip_runtime::hardware::{HardwareFault, Inputs, JointCommand};
use tip_runtime::model::Point;
use tip_runtime::plant::{Pose, Travel};

/// What such a robot fills in, leg by leg.
pub(crate) struct Reading<'a> {
    pub(crate) angles: &'a mut [f64],
    pub(crate) torques: &'a mut [f64],
    pub(crate) inputs: &'a mut Inputs,
    pub(crate) slider: &'a mut Point,
}

/// The seam to it: of any size, and compiled where a run is put on one only.
pub(crate) trait Outside {
    /// A copy, which is connected to nothing.
    fn boxed(&self) -> Box<dyn Outside>;
    fn any(&self) -> &dyn Any;
    /// Waits until the sensors can be read, but not longer than this; whether they can.
    fn is_ready(&mut self, longest: Duration) -> bool;
    fn read(&mut self, into: Reading<'_>) -> Result<(), HardwareFault>;
    fn write(
        &mut self,
        joints: &[JointCommand],
        slider: Point,
        period: f64,
    ) -> Result<(), HardwareFault>;
    fn stop(&mut self);
    fn has_input(&self, port: Port) -> bool;
    /// `false` if the robot lacks the input.
    fn set_sensor(&mut self, port: Port, volts: f64) -> bool;
    /// Where the body is, if that is known.
    fn pose(&self) -> Option<Pose>;
    fn travel(&self) -> Option<Travel>;
    /// Its legs or fingers, if anything is known of them.
    fn limbs(&self) -> Option<Limbs>;
}
