//! The simulated hardware of a run under one type for each size, which may fail.

use crate::echo::Echo;
use crate::outside::{Outside, Reading};
use std::any::Any;
use std::fmt;
use std::time::Duration;
use tip_runtime::command::Port;
use tip_runtime::fault::Fault;
use tip_runtime::hardware::{Hardware, HardwareFault, Outputs, Sensors};
use tip_runtime::plant::{Fall, Grasp, Limbs, Motion, Noise, Plant, Pose, Travel};

/// A plant that may fail.
#[derive(Clone)]
pub(crate) struct Rig<const L: usize, const J: usize> {
    simulated: Simulated<L, J>,
    pub(crate) failures: Failures,
}

enum Simulated<const L: usize, const J: usize> {
    /// Of any size, so that it is compiled once.
    Echo(Box<Echo>),
    Plant(Box<dyn AnyPlant<L, J>>),
    Outside(Box<dyn Outside>),
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
}

impl<P: Plant<L, J> + Clone + 'static, const L: usize, const J: usize> AnyPlant<L, J> for P {
    fn boxed(&self) -> Box<dyn AnyPlant<L, J>> {
        Box::new(self.clone())
    }

    fn any(&self) -> &dyn Any {
        self
    }
}

impl<const L: usize, const J: usize> Rig<L, J> {
    pub(crate) fn new(plant: impl Plant<L, J> + Clone + 'static) -> Self {
        Rig {
            simulated: Simulated::Plant(Box::new(plant)),
            failures: Failures::default(),
        }
    }

    pub(crate) fn echo(echo: Echo) -> Self {
        Rig {
            simulated: Simulated::Echo(Box::new(echo)),
            failures: Failures::default(),
        }
    }

    pub(crate) fn outside(outside: Box<dyn Outside>) -> Self {
        Rig {
            simulated: Simulated::Outside(outside),
            failures: Failures::default(),
        }
    }

    /// Waits until the sensors can be read, but not longer than this; whether they can.
    pub(crate) fn is_ready(&mut self, longest: Duration) -> bool {
        match &mut self.simulated {
            Simulated::Echo(_) | Simulated::Plant(_) => true,
            Simulated::Outside(outside) => outside.is_ready(longest),
        }
    }

    /// What simulates it outside of this process, if something does.
    pub(crate) fn elsewhere(&self) -> Option<&dyn Outside> {
        match &self.simulated {
            Simulated::Outside(outside) => Some(outside.as_ref()),
            Simulated::Echo(_) | Simulated::Plant(_) => None,
        }
    }

    /// Where the body is, if that is known.
    pub(crate) fn pose(&self) -> Option<Pose> {
        match self.elsewhere() {
            Some(outside) => outside.pose(),
            None => self.motion().map(|motion| motion.pose),
        }
    }

    /// How far it has come, if that is known.
    pub(crate) fn travel(&self) -> Option<Travel> {
        match self.elsewhere() {
            Some(outside) => outside.travel(),
            None => self.motion().map(|motion| motion.travel),
        }
    }

    pub(crate) fn plant(&self) -> &dyn Any {
        match &self.simulated {
            Simulated::Outside(outside) => outside.any(),
            Simulated::Echo(echo) => echo.as_ref(),
            Simulated::Plant(plant) => plant.any(),
        }
    }

    fn simulated(&self) -> Option<&dyn AnyPlant<L, J>> {
        match &self.simulated {
            Simulated::Echo(_) | Simulated::Outside(_) => None,
            Simulated::Plant(plant) => Some(plant.as_ref()),
        }
    }

    /// Joints that echo, where something is touched when an event says so.
    pub(crate) fn touched(&mut self) -> Option<&mut Echo> {
        match &mut self.simulated {
            Simulated::Echo(echo) => Some(echo),
            Simulated::Plant(_) | Simulated::Outside(_) => None,
        }
    }
}

impl<const L: usize, const J: usize> Clone for Simulated<L, J> {
    fn clone(&self) -> Self {
        match self {
            Simulated::Echo(echo) => Simulated::Echo(echo.clone()),
            Simulated::Plant(plant) => Simulated::Plant(plant.boxed()),
            Simulated::Outside(outside) => Simulated::Outside(outside.boxed()),
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
            false => match &mut self.simulated {
                Simulated::Echo(echo) => {
                    echo.read(into);
                    Ok(())
                }
                Simulated::Plant(plant) => plant.read(into),
                Simulated::Outside(outside) => outside.read(Reading {
                    angles: into.angles.as_flattened_mut(),
                    torques: into.torques.as_flattened_mut(),
                    inputs: &mut into.inputs,
                    slider: &mut into.slider,
                }),
            },
        }
    }

    fn write(&mut self, outputs: &Outputs<L, J>) -> Result<(), HardwareFault> {
        match self.failures.write {
            true => Err(HardwareFault("write")),
            false => match &mut self.simulated {
                Simulated::Echo(echo) => {
                    echo.write(outputs);
                    Ok(())
                }
                Simulated::Plant(plant) => plant.write(outputs),
                Simulated::Outside(outside) => outside.write(
                    outputs.joints.as_flattened(),
                    outputs.slider,
                    outputs.period,
                ),
            },
        }
    }

    fn stop(&mut self, why: &Fault) {
        match &mut self.simulated {
            Simulated::Echo(_) => {}
            Simulated::Plant(plant) => plant.stop(why),
            Simulated::Outside(outside) => outside.stop(),
        }
    }
}

impl<const L: usize, const J: usize> Plant<L, J> for Rig<L, J> {
    fn has_input(&self, port: Port) -> bool {
        match &self.simulated {
            Simulated::Echo(echo) => echo.has_input(port),
            Simulated::Plant(plant) => plant.has_input(port),
            Simulated::Outside(outside) => outside.has_input(port),
        }
    }

    fn can_be_pushed(&self) -> bool {
        (self.simulated()).is_some_and(|plant| plant.can_be_pushed())
    }

    fn can_have_noise(&self) -> bool {
        (self.simulated()).is_some_and(|plant| plant.can_have_noise())
    }

    fn set_sensor(&mut self, port: Port, volts: f64) -> bool {
        match &mut self.simulated {
            Simulated::Echo(echo) => echo.set_sensor(port, volts),
            Simulated::Plant(plant) => plant.set_sensor(port, volts),
            Simulated::Outside(outside) => outside.set_sensor(port, volts),
        }
    }

    fn push(&mut self, force: [f64; 3], cycles: u32) -> bool {
        match &mut self.simulated {
            Simulated::Echo(_) | Simulated::Outside(_) => false,
            Simulated::Plant(plant) => plant.push(force, cycles),
        }
    }

    fn set_noise(&mut self, noise: Noise) -> bool {
        match &mut self.simulated {
            Simulated::Echo(_) | Simulated::Outside(_) => false,
            Simulated::Plant(plant) => plant.set_noise(noise),
        }
    }

    fn motion(&self) -> Option<Motion> {
        self.simulated()?.motion()
    }

    fn first_fall(&self) -> Option<Fall> {
        self.simulated()?.first_fall()
    }

    fn limbs(&self) -> Option<Limbs<L, J>> {
        self.simulated()?.limbs()
    }

    fn grasp(&self) -> Option<Grasp<L>> {
        self.simulated()?.grasp()
    }
}
