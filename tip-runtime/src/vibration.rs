//! Vibration of a joint about what it is commanded (active friction control).
//!
//! ```
//! use tip_runtime::vibration::{Vibration, Waveform};
//!
//! let sine = Vibration { waveform: Waveform::Sine, amplitude: 2.0, frequency: 25.0 };
//! # #[cfg(feature = "control")] {
//! use tip_runtime::command::Target;
//! use tip_runtime::controller::Controller;
//! use tip_runtime::model::hand;
//!
//! // 2 V are 1 deg for the hand; 5 cycles of 2 ms are a quarter of the wave, where a sine is at its top.
//! let mut controller = Controller::new(&hand::MODEL);
//! assert_eq!(controller.vibrate(Target::Joint(1, 1), Some(sine)), Ok(()));
//! for _ in 0..5 {
//!     controller.advance();
//! }
//! let commanded = controller.outputs()[0][0].value();
//! assert!((commanded - (hand::MODEL.legs[0].initial[0] + 1.0)).abs() < 1e-9);
//! # }
//! ```

/// How a vibration goes to and fro. Every wave is 0 at its start.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Waveform {
    /// A sine: as far to one side as to the other.
    Sine,
    /// `(1 − cos) / 2`: from nought to the amplitude and back, to one side only.
    OneSided,
    /// Slowly up and fast down: what a joint touches follows the slow flank and slips on the fast one.
    Sawtooth,
}

/// A vibration of one joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vibration {
    /// How it goes to and fro.
    pub waveform: Waveform,
    /// The most that it departs from the command; a negative one turns the wave over: V. What a
    /// volt does is data of the robot's model.
    pub amplitude: f64,
    /// Waves in each second, by the sampling time: Hz.
    pub frequency: f64,
}
