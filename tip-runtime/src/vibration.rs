//! Vibration of a joint about its command (active friction control).
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

/// The waveform of a vibration. Every wave is 0 at its start.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Waveform {
    /// A sine, symmetric about the command.
    Sine,
    /// `(1 − cos) / 2`: from 0 to the amplitude and back, to one side only.
    OneSided,
    /// Slowly up and fast down: a touched object follows the slow flank and slips on the fast one.
    Sawtooth,
}

/// A vibration of one joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vibration {
    /// The waveform.
    pub waveform: Waveform,
    /// The greatest departure from the command, V; a negative one turns the wave over. The effect
    /// of a volt is data of the robot's model.
    pub amplitude: f64,
    /// Frequency by the sampling time, Hz.
    pub frequency: f64,
}
