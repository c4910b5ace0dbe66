//! Joints that reach their commanded angle in the next cycle: a simulation at low cost.

use crate::model::RobotDescription;
use crate::sim_hardware::{Commands, DynHardware, Reading, has_input};
use std::any::Any;
use tip_runtime::command::Port;
use tip_runtime::fault::Fault;
use tip_runtime::hardware::{HardwareFault, Inputs, JointCommand};
use tip_runtime::model::{Point, Range};

/// Turn of a joint with all its torque in a cycle, deg.
const DRIFT: f64 = 0.3;

/// A robot of any size without mass, leg by leg.
#[derive(Clone, Debug)]
pub(crate) struct IdealJoints {
    joints: Vec<Joint>,
    /// V.
    inputs: Inputs,
    /// Number of soles: one on each leg, if it stands on them.
    soles: usize,
    /// Place of the slider, mm.
    slider: Point,
    /// Torque of a joint on its link while something is touched, in the robot's torque unit.
    resistance: f64,
    /// Maximum torque of a joint, in the same unit.
    torque_max: f64,
    touches: bool,
}

#[derive(Clone, Copy, Debug)]
struct Joint {
    limits: Range,
    /// Angle of the joint, deg.
    angle: f64,
    /// Torque, in the robot's torque unit.
    torque: f64,
}

impl IdealJoints {
    pub(crate) fn new(description: &RobotDescription) -> Self {
        let legs = description.legs.iter();
        let joints = legs.flat_map(|leg| leg.joints.iter().zip(&leg.initial));
        let resting = joints.map(|(joint, angle)| Joint {
            limits: joint.limits,
            angle: *angle,
            torque: 0.0,
        });
        let (forces, slider) = (description.forces, description.slider);
        IdealJoints {
            joints: resting.collect(),
            inputs: Inputs::all(0.0),
            // Only a body that stands on its legs has soles.
            soles: description.body.map_or(0, |_| description.legs.len()),
            slider: slider.map_or([0.0; 3], |slider| slider.initial),
            resistance: forces.map_or(0.0, |forces| 2.0 * forces.search_torque),
            torque_max: forces.map_or(1.0, |forces| forces.torque_max),
            touches: false,
        }
    }
}

impl DynHardware for IdealJoints {
    fn boxed(&self) -> Box<dyn DynHardware> {
        Box::new(self.clone())
    }

    fn plant(&self) -> &dyn Any {
        self
    }

    fn is_bolted_down(&self) -> bool {
        self.soles == 0
    }

    fn read(&mut self, into: Reading<'_>) -> Result<(), HardwareFault> {
        let measured = into.angles.iter_mut().zip(into.torques);
        for (joint, (angle, torque)) in self.joints.iter().zip(measured) {
            (*angle, *torque) = (joint.angle, joint.torque);
        }
        *into.inputs = self.inputs;
        *into.slider = self.slider;
        Ok(())
    }

    fn write(&mut self, commands: &Commands<'_>) -> Result<(), HardwareFault> {
        let resistance = if self.touches { self.resistance } else { 0.0 };
        for (joint, command) in self.joints.iter_mut().zip(commands.joints) {
            match *command {
                JointCommand::Angle { angle, .. } => {
                    joint.torque = resistance + (angle - joint.angle);
                    joint.angle = angle;
                }
                JointCommand::Torque(torque) => {
                    joint.torque = torque;
                    // A contact stops it.
                    let drift = if resistance > 0.0 { 0.0 } else { DRIFT };
                    let turned = joint.angle + drift * torque / self.torque_max;
                    joint.angle = turned.clamp(joint.limits.min, joint.limits.max);
                }
            }
        }
        self.slider = commands.slider;
        Ok(())
    }

    fn stop(&mut self, _why: &Fault) -> Result<(), HardwareFault> {
        Ok(())
    }

    fn has_input(&self, port: Port) -> bool {
        has_input(self.soles, port)
    }

    fn set_sensor(&mut self, port: Port, volts: f64) -> bool {
        self.has_input(port) && self.inputs.set(port, volts)
    }

    fn touch(&mut self, on: bool) {
        self.touches = on;
    }
}
