//! Inputs that read what was set for them.

use crate::analog::{self, Wire};
use crate::command::{KNOBS, Port};
use crate::hardware::SensorsMut;
use crate::model::{Leg, Model, Range};

/// Inputs of the robot as a whole, and of its legs: an array of them, or a slice.
#[derive(Clone, Copy, Debug)]
pub(super) struct Overrides<S: ?Sized> {
    knobs: [f64; KNOBS],
    antenna: Option<f64>,
    /// Only a body that stands on its legs has soles.
    soles: bool,
    legs: S,
}

/// Inputs of one leg.
#[derive(Clone, Copy, Debug)]
pub(super) struct LegInputs<const J: usize> {
    /// What the potentiometers cover: deg.
    ranges: [Range; J],
    angles: [Option<f64>; J],
    paw: Option<f64>,
}

impl<const J: usize> LegInputs<J> {
    // Out of line, or it would be copied for each number of legs.
    #[inline(never)]
    fn new(leg: &Leg<J>) -> Self {
        LegInputs {
            ranges: leg.joints.map(|joint| joint.outer),
            angles: [None; J],
            paw: None,
        }
    }
}

impl<const L: usize, const J: usize> Overrides<[LegInputs<J>; L]> {
    /// Knobs read 0, everything else is measured.
    pub(super) fn new(model: &Model<L, J>) -> Self {
        let mut overrides = Overrides {
            knobs: [0.0; KNOBS],
            antenna: None,
            soles: model.body.is_some(),
            legs: [LegInputs::new(Leg::BLANK); L],
        };
        let view: &mut Overrides<[LegInputs<J>]> = &mut overrides;
        view.put(&model.legs);
        overrides
    }
}

impl<const J: usize> Overrides<[LegInputs<J>]> {
    /// Takes what the potentiometers cover from the legs.
    // Out of line, or it would be copied for each number of legs.
    #[inline(never)]
    fn put(&mut self, legs: &[Leg<J>]) {
        for (inputs, leg) in self.legs.iter_mut().zip(legs) {
            *inputs = LegInputs::new(leg);
        }
    }

    /// `false` if the robot lacks the input.
    pub(super) fn set(&mut self, port: Port, volts: f64) -> bool {
        let index = |number: u8| usize::from(number).wrapping_sub(1);
        match port {
            Port::Channel(channel) => match analog::wire(channel, self.legs.len(), J) {
                Some(Wire::Joint(leg, joint)) => self.set_joint(leg, joint, volts),
                Some(Wire::Knob(knob)) => put(self.knobs.get_mut(knob), volts),
                Some(Wire::Open) | None => false,
            },
            Port::Knob(knob) => put(self.knobs.get_mut(index(knob)), volts),
            Port::Joint(leg, joint) => self.set_joint(index(leg), index(joint), volts),
            Port::Paw(leg) => {
                let leg = self.legs.get_mut(index(leg)).filter(|_| self.soles);
                put(leg.map(|leg| &mut leg.paw), Some(volts))
            }
            Port::Antenna => put(Some(&mut self.antenna), Some(volts)),
        }
    }

    fn set_joint(&mut self, leg: usize, joint: usize, volts: f64) -> bool {
        let Some(leg) = self.legs.get_mut(leg) else {
            return false;
        };
        let range = leg.ranges.get(joint);
        let angle = leg.angles.get_mut(joint);
        range.is_some_and(|range| put(angle, Some(analog::angle_of_volts(*range, volts))))
    }

    /// Puts what was set in place of what was measured.
    // Out of line, or it would be copied for each number of legs.
    #[inline(never)]
    pub(super) fn apply(&self, sensors: &mut SensorsMut<'_, J>) {
        let measured = sensors.angles.iter_mut().zip(sensors.paws.iter_mut());
        for ((angles, paw), leg) in measured.zip(&self.legs) {
            for (angle, set) in angles.iter_mut().zip(&leg.angles) {
                *angle = set.unwrap_or(*angle);
            }
            *paw = leg.paw.unwrap_or(*paw);
        }
        *sensors.knobs = self.knobs;
        *sensors.antenna = self.antenna.unwrap_or(*sensors.antenna);
    }
}

/// Whether there was a place to put it.
fn put<T>(place: Option<&mut T>, value: T) -> bool {
    place.map(|place| *place = value).is_some()
}
