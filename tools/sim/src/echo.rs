//! A robot that is cheap to simulate: joints are at once where they are commanded to be.

use tip_runtime::command::Port;
use tip_runtime::fault::Fault;
use tip_runtime::hardware::{Hardware, HardwareFault, JointCommand, Outputs, Sensors};
use tip_runtime::model::Model;
use tip_runtime::plant::Plant;

/// How far a joint with all its torque turns in a cycle: deg.
const DRIFT: f64 = 0.3;

#[derive(Clone, Debug)]
pub(crate) struct Echo<const L: usize, const J: usize> {
    model: &'static Model<L, J>,
    sensors: Sensors<L, J>,
    /// What a joint drives its link with while something is touched.
    resistance: f64,
}

impl<const L: usize, const J: usize> Echo<L, J> {
    pub(crate) fn new(model: &'static Model<L, J>) -> Self {
        let mut sensors = Sensors::ZERO;
        for (angles, leg) in sensors.angles.iter_mut().zip(&model.legs) {
            *angles = leg.initial;
        }
        if let Some(slider) = model.slider {
            sensors.slider = slider.initial;
        }
        Echo {
            model,
            sensors,
            resistance: 0.0,
        }
    }

    pub(crate) fn touch(&mut self, on: bool) {
        let Some(forces) = &self.model.forces else {
            return;
        };
        self.resistance = if on { 2.0 * forces.search_torque } else { 0.0 };
    }
}

impl<const L: usize, const J: usize> Hardware<L, J> for Echo<L, J> {
    fn read(&mut self, into: &mut Sensors<L, J>) -> Result<(), HardwareFault> {
        *into = self.sensors;
        Ok(())
    }

    fn write(&mut self, outputs: &Outputs<L, J>) -> Result<(), HardwareFault> {
        let angles = self.sensors.angles.as_flattened_mut().iter_mut();
        let torques = self.sensors.torques.as_flattened_mut().iter_mut();
        let joints = self.model.legs.iter().flat_map(|leg| &leg.joints);
        let commands = outputs.joints.as_flattened();
        for (((angle, torque), joint), command) in angles.zip(torques).zip(joints).zip(commands) {
            match *command {
                JointCommand::Angle {
                    angle: commanded, ..
                } => {
                    *torque = self.resistance + (commanded - *angle);
                    *angle = commanded;
                }
                JointCommand::Torque(commanded) => {
                    *torque = commanded;
                    let most = self.model.forces.map_or(1.0, |forces| forces.torque_max);
                    // What it touches stops it.
                    let way = if self.resistance > 0.0 { 0.0 } else { DRIFT };
                    let turned = *angle + way * commanded / most;
                    *angle = turned.clamp(joint.limits.min, joint.limits.max);
                }
            }
        }
        self.sensors.slider = outputs.slider;
        Ok(())
    }

    fn stop(&mut self, _why: &Fault) {}
}

impl<const L: usize, const J: usize> Plant<L, J> for Echo<L, J> {
    fn set_sensor(&mut self, port: Port, volts: f64) -> bool {
        let Sensors {
            knobs,
            paws,
            antenna,
            ..
        } = &mut self.sensors;
        let input = match port {
            Port::Knob(n) => knobs.get_mut(usize::from(n).wrapping_sub(1)),
            Port::Paw(n) => paws.get_mut(usize::from(n).wrapping_sub(1)),
            Port::Antenna => Some(antenna),
            Port::Channel(_) | Port::Joint(..) => None,
        };
        input.map(|input| *input = volts).is_some()
    }
}
