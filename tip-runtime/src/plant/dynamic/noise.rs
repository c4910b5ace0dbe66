//! Sensor noise.

use crate::command::Port;
use crate::hardware::SensorsMut;
use crate::plant::Noise;
use core::f64::consts::TAU;

/// A source of noise: random numbers by SplitMix64 (Steele, Lea and Flood, *Fast Splittable
/// Pseudorandom Number Generators*, 2014).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Disturbance {
    noise: Noise,
    state: u64,
}

impl Disturbance {
    pub(super) const fn of(noise: Noise) -> Self {
        Disturbance {
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
