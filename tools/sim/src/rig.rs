//! The simulated hardware of a run under one type for each size, which may fail.

use std::any::Any;
use std::fmt;
use tip_runtime::command::Port;
use tip_runtime::fault::Fault;
use tip_runtime::hardware::{Hardware, HardwareFault, Outputs, Sensors};
use tip_runtime::plant::{Motion, Plant};

/// A plant that may fail.
pub(crate) struct Rig<const L: usize, const J: usize> {
    plant: Box<dyn AnyPlant<L, J>>,
    pub(crate) failures: Failures,
}

/// What is to fail.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Failures {
    /// The next reading.
    pub(crate) read: bool,
    /// Every writing from now on.
    pub(crate) write: bool,
}

trait AnyPlant<const L: usize, const J: usize>: Plant<L, J> {
    fn boxed(&self) -> Box<dyn AnyPlant<L, J>>;
    fn any(&self) -> &dyn Any;
    fn any_mut(&mut self) -> &mut dyn Any;
}

impl<P: Plant<L, J> + Clone + 'static, const L: usize, const J: usize> AnyPlant<L, J> for P {
    fn boxed(&self) -> Box<dyn AnyPlant<L, J>> {
        Box::new(self.clone())
    }

    fn any(&self) -> &dyn Any {
        self
    }

    fn any_mut(&mut self) -> &mut dyn Any {
        self
    }
}

impl<const L: usize, const J: usize> Rig<L, J> {
    pub(crate) fn new(plant: impl Plant<L, J> + Clone + 'static) -> Self {
        Rig {
            plant: Box::new(plant),
            failures: Failures::default(),
        }
    }

    pub(crate) fn plant(&self) -> &dyn Any {
        self.plant.any()
    }

    pub(crate) fn plant_mut(&mut self) -> &mut dyn Any {
        self.plant.any_mut()
    }
}

impl<const L: usize, const J: usize> Clone for Rig<L, J> {
    fn clone(&self) -> Self {
        Rig {
            plant: self.plant.boxed(),
            failures: self.failures,
        }
    }
}

impl<const L: usize, const J: usize> fmt::Debug for Rig<L, J> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a plant of {L} x {J} joints")
    }
}

impl<const L: usize, const J: usize> Hardware<L, J> for Rig<L, J> {
    fn read(&mut self, into: &mut Sensors<L, J>) -> Result<(), HardwareFault> {
        match std::mem::take(&mut self.failures.read) {
            true => Err(HardwareFault("read")),
            false => self.plant.read(into),
        }
    }

    fn write(&mut self, outputs: &Outputs<L, J>) -> Result<(), HardwareFault> {
        match self.failures.write {
            true => Err(HardwareFault("write")),
            false => self.plant.write(outputs),
        }
    }

    fn stop(&mut self, why: &Fault) {
        self.plant.stop(why);
    }
}

impl<const L: usize, const J: usize> Plant<L, J> for Rig<L, J> {
    fn set_sensor(&mut self, port: Port, volts: f64) -> bool {
        self.plant.set_sensor(port, volts)
    }

    fn motion(&self) -> Option<Motion> {
        self.plant.motion()
    }
}
