//! The hardware of a run: a robot of any size that is simulated, here or in another process, over slices leg by leg.

use crate::motion::{Grasp, Limbs};
use std::any::Any;
use std::ops::{Deref, DerefMut};
use std::time::Duration;
use tip_runtime::command::{MAX, Port};
use tip_runtime::fault::Fault;
use tip_runtime::hardware::{Hardware, HardwareFault, Inputs, JointCommand, Outputs, Sensors};
use tip_runtime::model::Point;
use tip_runtime::plant::{Fall, Gap, Motion, Noise, Plant, Pose, Travel};

/// Reading of a sole's sensor on the ground, V.
const PRESSED: f64 = 2.0;

/// The sensors of a robot, to be filled in.
pub(crate) struct Reading<'a> {
    pub(crate) angles: &'a mut [f64],
    pub(crate) ages: &'a mut [u32],
    pub(crate) torques: &'a mut [f64],
    pub(crate) inputs: &'a mut Inputs,
    pub(crate) slider: &'a mut Point,
}

/// The commands to a robot in a cycle.
pub(crate) struct Commands<'a> {
    pub(crate) joints: &'a [JointCommand],
    pub(crate) slider: Point,
    pub(crate) lamps: [u32; 8],
    /// ms.
    pub(crate) period: f64,
}

/// Returns true if a robot with so many soles may have this input by its name.
pub(crate) fn has_input(soles: usize, port: Port) -> bool {
    let lacks = matches!(port, Port::Paw(leg) if usize::from(leg) > soles);
    !lacks && port.place().is_some()
}

/// A simulated robot of any size. A method that is not overridden belongs to a robot that lacks it.
pub(crate) trait DynHardware: Send {
    fn boxed(&self) -> Box<dyn DynHardware>;
    /// Returns the plant or process behind it.
    fn plant(&self) -> &dyn Any;
    fn read(&mut self, into: Reading<'_>) -> Result<(), HardwareFault>;
    fn write(&mut self, commands: &Commands<'_>) -> Result<(), HardwareFault>;
    fn stop(&mut self, why: &Fault) -> Result<(), HardwareFault>;

    /// Returns true if the robot has this input.
    fn has_input(&self, port: Port) -> bool;

    /// Makes an input read `volts` from now on; `false` if the robot lacks it.
    fn set_sensor(&mut self, port: Port, volts: f64) -> bool;

    fn can_be_pushed(&self) -> bool {
        false
    }

    fn can_have_noise(&self) -> bool {
        false
    }

    /// Returns true if it simulates a robot whose body cannot move.
    fn is_bolted_down(&self) -> bool {
        false
    }

    /// Waits up to a time until the sensors can be read. Returns true if they can.
    fn is_ready(&mut self, longest: Duration) -> bool {
        let _ = longest;
        true
    }

    /// Switches the contacts of joints on or off, if the simulation has no contacts of its own.
    fn touch(&mut self, on: bool) {
        let _ = on;
    }

    fn push(&mut self, force: [f64; 3], cycles: u32) -> bool {
        let _ = (force, cycles);
        false
    }

    fn set_noise(&mut self, noise: Noise) -> bool {
        let _ = noise;
        false
    }

    fn motion(&self) -> Option<Motion> {
        None
    }

    fn pose(&self) -> Option<Pose> {
        self.motion().map(|motion| motion.pose)
    }

    fn travel(&self) -> Option<Travel> {
        self.motion().map(|motion| motion.travel)
    }

    fn first_fall(&self) -> Option<Fall> {
        None
    }

    fn gap(&self) -> Option<Gap> {
        None
    }

    fn limbs(&self) -> Option<Limbs> {
        None
    }

    fn grasp(&self) -> Option<Grasp> {
        None
    }
}

impl Clone for Box<dyn DynHardware> {
    fn clone(&self) -> Self {
        self.as_ref().boxed()
    }
}

/// A plant of a known size.
#[derive(Clone)]
pub(crate) struct OfSize<P, const L: usize, const J: usize> {
    plant: P,
    /// The last readings: the plant need not fill in everything each time.
    sensors: Sensors<L, J>,
}

impl<P: Plant<L, J> + Clone + Send + 'static, const L: usize, const J: usize> OfSize<P, L, J> {
    pub(crate) fn boxed(plant: P) -> Box<dyn DynHardware> {
        Box::new(OfSize {
            plant,
            sensors: Sensors::ZERO,
        })
    }
}

impl<P, const L: usize, const J: usize> DynHardware for OfSize<P, L, J>
where
    P: Plant<L, J> + Clone + Send + 'static,
{
    fn boxed(&self) -> Box<dyn DynHardware> {
        Box::new(self.clone())
    }

    fn plant(&self) -> &dyn Any {
        &self.plant
    }

    fn read(&mut self, into: Reading<'_>) -> Result<(), HardwareFault> {
        let read = self.plant.read(&mut self.sensors);
        let measured = &self.sensors;
        into.angles.copy_from_slice(measured.angles.as_flattened());
        into.torques
            .copy_from_slice(measured.torques.as_flattened());
        *into.inputs = measured.inputs;
        *into.slider = measured.slider;
        read
    }

    fn write(&mut self, commands: &Commands<'_>) -> Result<(), HardwareFault> {
        let mut outputs = Outputs {
            joints: [[JointCommand::at(0.0); J]; L],
            slider: commands.slider,
            lamps: commands.lamps,
            period: commands.period,
        };
        let joints = outputs.joints.as_flattened_mut();
        joints.copy_from_slice(commands.joints);
        self.plant.write(&outputs)
    }

    fn stop(&mut self, why: &Fault) -> Result<(), HardwareFault> {
        self.plant.stop(why)
    }

    fn has_input(&self, port: Port) -> bool {
        self.plant.has_input(port)
    }

    fn set_sensor(&mut self, port: Port, volts: f64) -> bool {
        self.plant.set_sensor(port, volts)
    }

    fn can_be_pushed(&self) -> bool {
        self.plant.can_be_pushed()
    }

    fn can_have_noise(&self) -> bool {
        self.plant.can_have_noise()
    }

    fn push(&mut self, force: [f64; 3], cycles: u32) -> bool {
        self.plant.push(force, cycles)
    }

    fn set_noise(&mut self, noise: Noise) -> bool {
        self.plant.set_noise(noise)
    }

    fn is_bolted_down(&self) -> bool {
        self.plant.motion().is_none() && self.plant.limbs().is_some()
    }

    fn motion(&self) -> Option<Motion> {
        self.plant.motion()
    }

    fn first_fall(&self) -> Option<Fall> {
        self.plant.first_fall()
    }

    fn gap(&self) -> Option<Gap> {
        self.plant.gap()
    }

    fn limbs(&self) -> Option<Limbs> {
        self.plant.limbs().map(Limbs::from)
    }

    fn grasp(&self) -> Option<Grasp> {
        self.plant.grasp().map(Grasp::from)
    }
}

/// A simulated robot that may fail.
#[derive(Clone)]
pub(crate) struct SimHardware {
    simulated: Box<dyn DynHardware>,
    /// The next reading fails.
    pub(crate) read_fails: bool,
    /// Every write from now on fails.
    pub(crate) write_fails: bool,
}

impl SimHardware {
    pub(crate) fn new(simulated: Box<dyn DynHardware>) -> Self {
        SimHardware {
            simulated,
            read_fails: false,
            write_fails: false,
        }
    }

    /// Switches the contact sensors of all feet or fingers on or off. Simulated joints feel real contacts; on their
    /// robots only the readings of soles change.
    pub(crate) fn touch(&mut self, on: bool) {
        let volts = if on { PRESSED } else { 0.0 };
        for leg in (1..).take(MAX) {
            self.simulated.set_sensor(Port::Paw(leg), volts);
        }
        self.simulated.touch(on);
    }

    fn measure(&mut self, into: Reading<'_>) -> Result<(), HardwareFault> {
        match std::mem::take(&mut self.read_fails) {
            true => Err(HardwareFault::new("read")),
            false => self.simulated.read(into),
        }
    }

    fn drive(&mut self, commands: &Commands<'_>) -> Result<(), HardwareFault> {
        match self.write_fails {
            true => Err(HardwareFault::new("write")),
            false => self.simulated.write(commands),
        }
    }
}

impl Deref for SimHardware {
    type Target = dyn DynHardware;

    fn deref(&self) -> &Self::Target {
        self.simulated.as_ref()
    }
}

impl DerefMut for SimHardware {
    fn deref_mut(&mut self) -> &mut Self::Target {
        self.simulated.as_mut()
    }
}

impl<const L: usize, const J: usize> Hardware<L, J> for SimHardware {
    fn read(&mut self, into: &mut Sensors<L, J>) -> Result<(), HardwareFault> {
        self.measure(Reading {
            angles: into.angles.as_flattened_mut(),
            ages: into.ages.as_flattened_mut(),
            torques: into.torques.as_flattened_mut(),
            inputs: &mut into.inputs,
            slider: &mut into.slider,
        })
    }

    fn write(&mut self, outputs: &Outputs<L, J>) -> Result<(), HardwareFault> {
        self.drive(&Commands {
            joints: outputs.joints.as_flattened(),
            slider: outputs.slider,
            lamps: outputs.lamps,
            period: outputs.period,
        })
    }

    fn stop(&mut self, why: &Fault) -> Result<(), HardwareFault> {
        self.simulated.stop(why)
    }
}
