//! Sensor readings of plants: inputs that are set from outside, and noise.

use crate::analog::{self, Connection};
use crate::command::Port;
use crate::hardware::{Inputs, SensorsMut};
use crate::model::{Leg, Model, Range};
use crate::plant::Noise;
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

    /// Overrides an input; returns `false` if the robot lacks it.
    pub(super) fn set(&mut self, port: Port, volts: f64) -> bool {
        let index = |number: u8| usize::from(number).wrapping_sub(1);
        match port {
            Port::Channel(channel) => match analog::connection(channel, self.legs.len(), J) {
                Some(Connection::Joint(leg, joint)) => self.set_joint(leg, joint, volts),
                Some(Connection::Input(port)) => self.set_input(port, volts),
                Some(Connection::Open) | None => false,
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

/// A source of noise: random numbers by SplitMix64 (Steele, Lea and Flood, *Fast Splittable
/// Pseudorandom Number Generators*, 2014).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SensorNoise {
    noise: Noise,
    state: u64,
}

impl SensorNoise {
    pub(super) const fn of(noise: Noise) -> Self {
        SensorNoise {
            noise,
            state: noise.seed,
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
        let (radius, angle) = (1.0 - self.uniform(), self.uniform());
        libm::sqrt(-2.0 * libm::log(radius)) * libm::cos(TAU * angle)
    }

    /// Returns a number from 0 up to, but not including, 1.
    fn uniform(&mut self) -> f64 {
        self.state = self.state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut mixed = self.state;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        mixed ^= mixed >> 31;
        (mixed >> 11) as f64 / (1_u64 << 53) as f64
    }
}
