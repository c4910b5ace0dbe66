//! Sensor readings of plants: inputs that are set from outside, and noise.

use crate::analog::{self, Connection};
use crate::command::Port;
use crate::hardware::{Inputs, SensorsMut};
use crate::model::{Leg, Model, Range};
use crate::plant::Noise;
use crate::random::Random;
use core::f64::consts::TAU;

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
        view.copy_ranges(&model.legs);
        overrides
    }
}

impl<const J: usize> Overrides<[LegInputs<J>]> {
    /// Copies the ranges of the potentiometers from the legs.
    // Out of line, or it would be copied for each number of legs.
    #[inline(never)]
    fn copy_ranges(&mut self, legs: &[Leg<J>]) {
        for (inputs, leg) in self.legs.iter_mut().zip(legs) {
            *inputs = LegInputs::new(leg);
        }
    }

    /// Returns true if the robot has this input.
    pub(super) fn has(&self, port: Port) -> bool {
        match self.connection(port) {
            Connection::Joint(leg, joint) => leg < self.legs.len() && joint < J,
            Connection::Input(port) => self.has_named(port),
            Connection::Open => false,
        }
    }

    /// Overrides an input; returns `false` if the robot lacks it.
    pub(super) fn set(&mut self, port: Port, volts: f64) -> bool {
        match self.connection(port) {
            Connection::Joint(leg, joint) => {
                let Some(leg) = self.legs.get_mut(leg) else {
                    return false;
                };
                let joint = leg.ranges.get(joint).zip(leg.angles.get_mut(joint));
                joint
                    .map(|(range, angle)| *angle = Some(analog::angle_of_volts(*range, volts)))
                    .is_some()
            }
            Connection::Input(port) => self.has_named(port) && self.inputs.set(port, Some(volts)),
            Connection::Open => false,
        }
    }

    /// Returns the source that an input reads, by whichever name.
    fn connection(&self, port: Port) -> Connection {
        let index = |number: u8| usize::from(number).wrapping_sub(1);
        match port {
            Port::Channel(channel) => {
                analog::connection(channel, self.legs.len(), J).unwrap_or(Connection::Open)
            }
            Port::Joint(leg, joint) => Connection::Joint(index(leg), index(joint)),
            port => Connection::Input(port),
        }
    }

    /// Returns true if the robot has an input that is not a joint's.
    fn has_named(&self, port: Port) -> bool {
        let soles = if self.soles { self.legs.len() } else { 0 };
        let lacks = matches!(port, Port::Paw(leg) if usize::from(leg) > soles);
        !lacks && port.place().is_some()
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

/// A source of noise.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct SensorNoise {
    noise: Noise,
    random: Random,
}

impl SensorNoise {
    pub(super) const fn of(noise: Noise) -> Self {
        SensorNoise {
            noise,
            random: Random::new(noise.seed),
        }
    }

    /// Adds noise to the readings of joints and soles.
    pub(super) fn apply<const J: usize>(&mut self, sensors: &mut SensorsMut<'_, J>) {
        let Noise { angle, volts, .. } = self.noise;
        for read in sensors.angles.iter_mut().flatten() {
            *read += angle * self.normal();
        }
        for (leg, _) in (1..).zip(sensors.angles.iter()) {
            let error = volts * self.normal();
            if let Some(read) = sensors.inputs.get_mut(Port::Paw(leg)) {
                *read += error;
            }
        }
    }

    /// Returns a number of the standard normal distribution (Box and Muller, 1958).
    fn normal(&mut self) -> f64 {
        let (radius, angle) = (1.0 - self.random.uniform(), self.random.uniform());
        libm::sqrt(-2.0 * libm::log(radius)) * libm::cos(TAU * angle)
    }
}
