//! Vibration of a joint about what it is commanded (active friction control).

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
