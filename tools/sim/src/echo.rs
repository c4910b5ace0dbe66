//! A robot that is cheap to simulate: joints are at once where they are commanded to be.

use tip_runtime::command::Port;
use tip_runtime::hardware::{Inputs, JointCommand, Outputs, Sensors};
use tip_runtime::model::{self, Forces, Leg, Model, Point, Range, Slider};

/// How far a joint with all its torque turns in a cycle: deg.
const DRIFT: f64 = 0.3;

/// A robot of any size, leg by leg.
#[derive(Debug)]
pub(crate) struct Echo {
    joints: Vec<Joint>,
    /// V.
    inputs: Inputs,
    /// How many soles it has: one on each leg, if it stands on them.
    soles: usize,
    /// mm.
    slider: Point,
    /// What a joint drives its link with while something is touched, in the robot's torque unit.
    resistance: f64,
    /// The most that a joint can do, in the same unit.
    torque_max: f64,
    touches: bool,
}

#[derive(Clone, Copy, Debug)]
struct Joint {
    limits: Range,
    /// deg.
    angle: f64,
    /// In the robot's torque unit.
    torque: f64,
}

impl Echo {
    pub(crate) fn new<const L: usize, const J: usize>(model: &Model<L, J>) -> Self {
        let mut echo = Self::of(&model.legs, model.forces.as_ref(), model.slider.as_ref());
        // Only a body that stands on its legs has soles.
        if model.body.is_none() {
            echo.soles = 0;
        }
        echo
    }

    // Out of line, or it would be copied for each number of legs.
    #[inline(never)]
    fn of<const J: usize>(
        legs: &[Leg<J>],
        forces: Option<&Forces>,
        slider: Option<&Slider>,
    ) -> Self {
        let resting = |(joint, angle): (&model::Joint, &f64)| Joint {
            limits: joint.limits,
            angle: *angle,
            torque: 0.0,
        };
        let joints = legs
            .iter()
            .flat_map(|leg| leg.joints.iter().zip(&leg.initial));
        Echo {
            joints: joints.map(resting).collect(),
            inputs: Inputs::all(0.0),
            soles: legs.len(),
            slider: slider.map_or([0.0; 3], |slider| slider.initial),
            resistance: forces.map_or(0.0, |forces| 2.0 * forces.search_torque),
            torque_max: forces.map_or(1.0, |forces| forces.torque_max),
            touches: false,
        }
    }

    /// Every foot or finger begins to feel something, or ceases to.
    pub(crate) fn touch(&mut self, on: bool) {
        self.touches = on;
    }

    pub(crate) fn read<const L: usize, const J: usize>(&self, into: &mut Sensors<L, J>) {
        let angles = into.angles.as_flattened_mut();
        self.measure(angles, into.torques.as_flattened_mut());
        into.inputs = self.inputs;
        into.slider = self.slider;
    }

    pub(crate) fn write<const L: usize, const J: usize>(&mut self, outputs: &Outputs<L, J>) {
        self.drive(outputs.joints.as_flattened());
        self.slider = outputs.slider;
    }

    /// What joints read, leg by leg.
    // Out of line, or it would be copied for each number of legs.
    #[inline(never)]
    fn measure(&self, angles: &mut [f64], torques: &mut [f64]) {
        for (joint, (angle, torque)) in self.joints.iter().zip(angles.iter_mut().zip(torques)) {
            (*angle, *torque) = (joint.angle, joint.torque);
        }
    }

    // Out of line, or it would be copied for each number of legs.
    #[inline(never)]
    fn drive(&mut self, commands: &[JointCommand]) {
        let resistance = if self.touches { self.resistance } else { 0.0 };
        for (joint, command) in self.joints.iter_mut().zip(commands) {
            match *command {
                JointCommand::Angle { angle, .. } => {
                    joint.torque = resistance + (angle - joint.angle);
                    joint.angle = angle;
                }
                JointCommand::Torque(torque) => {
                    joint.torque = torque;
                    // What it touches stops it.
                    let drift = if resistance > 0.0 { 0.0 } else { DRIFT };
                    let turned = joint.angle + drift * torque / self.torque_max;
                    joint.angle = turned.clamp(joint.limits.min, joint.limits.max);
                }
            }
        }
    }

    /// Returns true if the robot has this input.
    pub(crate) fn has_input(&self, port: Port) -> bool {
        let lacks = matches!(port, Port::Paw(leg) if usize::from(leg) > self.soles);
        !lacks && port.place().is_some()
    }

    /// Makes an input read `volts` from now on; `false` if the robot lacks it.
    pub(crate) fn set_sensor(&mut self, port: Port, volts: f64) -> bool {
        self.has_input(port) && self.inputs.set(port, volts)
    }
}

impl Clone for Echo {
    // Out of line, or it would be copied for each size of robot.
    #[inline(never)]
    fn clone(&self) -> Self {
        Echo {
            joints: self.joints.clone(),
            ..*self
        }
    }
}
