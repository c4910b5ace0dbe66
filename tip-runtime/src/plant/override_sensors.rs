//! Sensor inputs that are set from outside.

use crate::analog::{self, Wire};
use crate::command::Port;
use crate::hardware::{Inputs, SensorsMut};
use crate::model::{Leg, Model, Range};

/// Overrides of the robot's inputs and of the potentiometers of its legs: an array of legs, or a
/// slice.
#[derive(Clone, Copy, Debug)]
pub(super) struct Overrides<S: ?Sized> {
    inputs: Inputs<Option<f64>>,
    /// True for a body that stands on its legs: only such a robot has soles.
    soles: bool,
    legs: S,
}

/// The potentiometers of one leg.
#[derive(Clone, Copy, Debug)]
pub(super) struct LegInputs<const J: usize> {
    /// Ranges of the potentiometers, deg.
    ranges: [Range; J],
    angles: [Option<f64>; J],
}

impl<const J: usize> LegInputs<J> {
    // Out of line, or it would be copied for each number of legs.
    #[inline(never)]
    fn new(leg: &Leg<J>) -> Self {
        LegInputs {
            ranges: leg.joints.map(|joint| joint.outer),
            angles: [None; J],
        }
    }
}

impl<const L: usize, const J: usize> Overrides<[LegInputs<J>; L]> {
    /// Returns overrides that replace nothing.
    pub(super) fn new(model: &Model<L, J>) -> Self {
        let mut overrides = Overrides {
            inputs: Inputs::all(None),
            soles: model.body.is_some(),
            legs: [LegInputs::new(Leg::BLANK); L],
        };
        let view: &mut Overrides<[LegInputs<J>]> = &mut overrides;
        view.put(&model.legs);
        overrides
    }
}

impl<const J: usize> Overrides<[LegInputs<J>]> {
    /// Copies the ranges of the potentiometers from the legs.
    // Out of line, or it would be copied for each number of legs.
    #[inline(never)]
    fn put(&mut self, legs: &[Leg<J>]) {
        for (inputs, leg) in self.legs.iter_mut().zip(legs) {
            *inputs = LegInputs::new(leg);
        }
    }

    /// Overrides an input; returns `false` if the robot lacks it.
    pub(super) fn set(&mut self, port: Port, volts: f64) -> bool {
        let index = |number: u8| usize::from(number).wrapping_sub(1);
        match port {
            Port::Channel(channel) => match analog::wire(channel, self.legs.len(), J) {
                Some(Wire::Joint(leg, joint)) => self.set_joint(leg, joint, volts),
                Some(Wire::Input(port)) => self.set_input(port, volts),
                Some(Wire::Open) | None => false,
            },
            Port::Joint(leg, joint) => self.set_joint(index(leg), index(joint), volts),
            port => self.set_input(port, volts),
        }
    }

    fn set_input(&mut self, port: Port, volts: f64) -> bool {
        let soles = if self.soles { self.legs.len() } else { 0 };
        let lacks = matches!(port, Port::Paw(leg) if usize::from(leg) > soles);
        !lacks && self.inputs.set(port, Some(volts))
    }

    fn set_joint(&mut self, leg: usize, joint: usize, volts: f64) -> bool {
        let Some(leg) = self.legs.get_mut(leg) else {
            return false;
        };
        let range = leg.ranges.get(joint);
        let angle = leg.angles.get_mut(joint);
        let (Some(range), Some(angle)) = (range, angle) else {
            return false;
        };
        *angle = Some(analog::angle_of_volts(*range, volts));
        true
    }

    /// Replaces measurements by the overrides.
    // Out of line, or it would be copied for each number of legs.
    #[inline(never)]
    pub(super) fn apply(&self, sensors: &mut SensorsMut<'_, J>) {
        for (angles, leg) in sensors.angles.iter_mut().zip(&self.legs) {
            for (angle, set) in angles.iter_mut().zip(&leg.angles) {
                *angle = set.unwrap_or(*angle);
            }
        }
        sensors.inputs.replace(&self.inputs);
    }
}
