//! Hardware behind one trait, so that the control loop is compiled once for all numbers of legs.

use crate::fault::Fault;
use crate::hardware::{
    Hardware, HardwareFault, JointCommand, Outputs, OutputsView, Sensors, SensorsView,
};

/// A robot with any number of legs of `J` joints: what it measured last, and what it is sent.
pub(super) trait DynHardware<const J: usize> {
    fn read(&mut self) -> Result<(), HardwareFault>;
    fn sensors(&self) -> SensorsView<'_, J>;
    fn outputs(&mut self) -> OutputsView<'_, J>;
    fn commands(&self) -> &[[JointCommand; J]];
    fn write(&mut self) -> Result<(), HardwareFault>;
    fn stop(&mut self, why: &Fault);
}

/// Hardware of a known size, and what goes in and out.
pub(super) struct OfSize<'a, H, const L: usize, const J: usize> {
    pub(super) hardware: &'a mut H,
    pub(super) sensors: &'a mut Sensors<L, J>,
    pub(super) outputs: &'a mut Outputs<L, J>,
}

impl<H: Hardware<L, J>, const L: usize, const J: usize> DynHardware<J> for OfSize<'_, H, L, J> {
    fn read(&mut self) -> Result<(), HardwareFault> {
        self.hardware.read(self.sensors)
    }

    fn sensors(&self) -> SensorsView<'_, J> {
        self.sensors.view()
    }

    fn outputs(&mut self) -> OutputsView<'_, J> {
        self.outputs.view()
    }

    fn commands(&self) -> &[[JointCommand; J]] {
        &self.outputs.joints
    }

    fn write(&mut self) -> Result<(), HardwareFault> {
        self.hardware.write(self.outputs)
    }

    fn stop(&mut self, why: &Fault) {
        self.hardware.stop(why);
    }
}
