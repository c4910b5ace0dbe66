//! Inputs that read what was set for them.

use crate::analog::{self, Wire};
use crate::command::Port;
use crate::hardware::{Inputs, SensorsMut};
use crate::model::{Leg, Model, Range};

/// Inputs of the robot as a whole, and the potentiometers of its legs: an array of them, or a slice.
#[derive(Clone, Copy, Debug)]
pub(super) struct Overrides<S: ?Sized> {
    inputs: Inputs<Option<f64>>,
    /// Only a body that stands on its legs has soles.
    soles: bool,
    legs: S,
}

/// The potentiometers of one leg.
#[derive(Clone, Copy, Debug)]
pub(super) struct LegInputs<const J: usize> {
    /// What the potentiometers cover: deg.
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

    fn has(&self, joint: usize) -> bool {
        joint < self.ranges.len()
    }

    fn set(&mut self, joint: usize, volts: f64) -> bool {
        let joint = self.ranges.get(joint).zip(self.angles.get_mut(joint));
        let set = joint.map(|(range, angle)| *angle = Some(analog::angle_of_volts(*range, volts)));
        set.is_some()
    }
}

impl<const L: usize, const J: usize> Overrides<[LegInputs<J>; L]> {
    /// Everything is measured.
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
    /// Takes what the potentiometers cover from the legs.
    // Out of line, or it would be copied for each number of legs.
    #[inline(never)]
    fn put(&mut self, legs: &[Leg<J>]) {
        for (inputs, leg) in self.legs.iter_mut().zip(legs) {
            *inputs = LegInputs::new(leg);
        }
    }

    /// Returns true if the robot has this input.
    pub(super) fn has(&self, port: Port) -> bool {
        match self.wire(port) {
            Wire::Joint(leg, joint) => self.legs.get(leg).is_some_and(|it| it.has(joint)),
            Wire::Input(port) => self.has_named(port),
            Wire::Open => false,
        }
    }

    /// `false` if the robot lacks the input.
    pub(super) fn set(&mut self, port: Port, volts: f64) -> bool {
        match self.wire(port) {
            Wire::Joint(leg, joint) => {
                let leg = self.legs.get_mut(leg);
                leg.is_some_and(|leg| leg.set(joint, volts))
            }
            Wire::Input(port) => self.has_named(port) && self.inputs.set(port, Some(volts)),
            Wire::Open => false,
        }
    }

    /// Returns the source that an input reads, by whichever name.
    fn wire(&self, port: Port) -> Wire {
        let index = |number: u8| usize::from(number).wrapping_sub(1);
        match port {
            Port::Channel(channel) => {
                analog::wire(channel, self.legs.len(), J).unwrap_or(Wire::Open)
            }
            Port::Joint(leg, joint) => Wire::Joint(index(leg), index(joint)),
            port => Wire::Input(port),
        }
    }

    /// Returns true if the robot has an input that is not a joint's.
    fn has_named(&self, port: Port) -> bool {
        let soles = if self.soles { self.legs.len() } else { 0 };
        let lacks = matches!(port, Port::Paw(leg) if usize::from(leg) > soles);
        !lacks && port.place().is_some()
    }

    /// Puts what was set in place of what was measured.
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
