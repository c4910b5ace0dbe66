//! Inputs that read what was set for them.

use crate::analog::{self, Wire};
use crate::command::Port;
use crate::hardware::Sensors;
use crate::model::Model;

#[derive(Clone, Copy, Debug)]
pub(super) struct Overrides<const L: usize, const J: usize> {
    angles: [[Option<f64>; J]; L],
    knobs: [f64; 3],
    paws: [Option<f64>; L],
    antenna: Option<f64>,
}

impl<const L: usize, const J: usize> Overrides<L, J> {
    /// Knobs read 0, everything else is measured.
    pub(super) const fn new() -> Self {
        Overrides {
            angles: [[None; J]; L],
            knobs: [0.0; 3],
            paws: [None; L],
            antenna: None,
        }
    }

    /// `false` if the robot lacks the input.
    pub(super) fn set(&mut self, model: &Model<L, J>, port: Port, volts: f64) -> bool {
        let index = |number: u8| usize::from(number).wrapping_sub(1);
        match port {
            Port::Channel(channel) => match analog::wire(channel, L, J) {
                Some(Wire::Joint(leg, joint)) => self.set_joint(model, leg, joint, volts),
                Some(Wire::Knob(knob)) => put(self.knobs.get_mut(knob), volts),
                Some(Wire::Open) | None => false,
            },
            Port::Knob(knob) => put(self.knobs.get_mut(index(knob)), volts),
            Port::Joint(leg, joint) => self.set_joint(model, index(leg), index(joint), volts),
            Port::Paw(leg) => put(self.paws.get_mut(index(leg)), Some(volts)),
            Port::Antenna => put(Some(&mut self.antenna), Some(volts)),
        }
    }

    fn set_joint(&mut self, model: &Model<L, J>, leg: usize, joint: usize, volts: f64) -> bool {
        let range = model.legs.get(leg).and_then(|leg| leg.joints.get(joint));
        let angle = self.angles.get_mut(leg).and_then(|leg| leg.get_mut(joint));
        range.is_some_and(|joint| put(angle, Some(analog::angle_of_volts(joint.outer, volts))))
    }

    /// Puts what was set in place of what was measured.
    pub(super) fn apply(&self, sensors: &mut Sensors<L, J>) {
        for (measured, set) in sensors.angles.iter_mut().zip(&self.angles) {
            put_all(measured, set);
        }
        put_all(&mut sensors.paws, &self.paws);
        sensors.knobs = self.knobs;
        sensors.antenna = self.antenna.unwrap_or(sensors.antenna);
    }
}

/// Puts the values that are set in place of those that are there.
fn put_all<const N: usize>(values: &mut [f64; N], set: &[Option<f64>; N]) {
    for (value, set) in values.iter_mut().zip(set) {
        *value = set.unwrap_or(*value);
    }
}

/// Whether there was a place to put it.
fn put<T>(place: Option<&mut T>, value: T) -> bool {
    place.map(|place| *place = value).is_some()
}
