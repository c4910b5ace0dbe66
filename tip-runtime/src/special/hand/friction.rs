//! Active friction control (SPECIAL 10 to 16): fingers vibrate, so that the object that they hold
//! slips in the wanted direction.

use super::{FINGERS, JOINTS, not_negative};
use crate::command::Target;
use crate::fault::Fault;
use crate::model::Range;
use crate::program::Robot;
use crate::vibration::{Vibration, Waveform};

/// Valid frequencies of SPECIAL 14 to 16, Hz.
const FREQUENCIES: Range = Range::new(0.0, 60.0);
/// Default frequency, Hz.
const STANDARD_FREQUENCY: f64 = 30.0;

/// The vibration mode of a finger.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Mode {
    /// 0: nothing; so do 5 and 7, which the language reserves.
    Still,
    /// 1: the fingertip joint.
    Fingertip,
    /// 2: all joints, to and fro together.
    Together,
    /// 3: all joints, in the direction that loosens.
    Loosening,
    /// 4 clockwise, 6 counter-clockwise, as seen with x to the right and y up: the fingertip carries
    /// the object around slowly and slips back fast.
    Rolling { clockwise: bool },
}

impl Mode {
    fn new(number: f64) -> Result<Self, Fault> {
        Ok(match number {
            0.0 | 5.0 | 7.0 => Mode::Still,
            1.0 => Mode::Fingertip,
            2.0 => Mode::Together,
            3.0 => Mode::Loosening,
            4.0 => Mode::Rolling { clockwise: true },
            6.0 => Mode::Rolling { clockwise: false },
            _ => return Err(Fault::Domain),
        })
    }

    /// Returns waveform and share of the amplitude of each joint of finger `n`. Positive is
    /// closing; a fingertip that points to the object moves up then, whichever side it is on.
    fn waves(self, n: u8) -> [Option<(Waveform, f64)>; JOINTS] {
        let fingertip = |waveform, share| [None, None, Some((waveform, share))];
        match self {
            Mode::Still => [None; JOINTS],
            Mode::Fingertip => fingertip(Waveform::Sine, 1.0),
            Mode::Together => [Some((Waveform::Sine, 1.0)); JOINTS],
            Mode::Loosening => [Some((Waveform::OneSided, -1.0)); JOINTS],
            // F1 is on the left of the object, where clockwise is up; the others are opposite.
            Mode::Rolling { clockwise } => {
                let up = clockwise == (n == 1);
                fingertip(Waveform::Sawtooth, if up { 1.0 } else { -1.0 })
            }
        }
    }
}

#[derive(Clone, Copy, Debug)]
struct Finger {
    mode: Mode,
    /// V.
    amplitude: f64,
    /// Hz.
    frequency: f64,
}

#[derive(Clone, Debug)]
pub(super) struct FrictionControl([Finger; FINGERS]);

impl Default for FrictionControl {
    fn default() -> Self {
        let still = Finger {
            mode: Mode::Still,
            amplitude: 0.0,
            frequency: STANDARD_FREQUENCY,
        };
        FrictionControl([still; FINGERS])
    }
}

impl FrictionControl {
    /// SPECIAL 10: stops the vibration of every finger.
    pub(super) fn stop(
        &mut self,
        arguments: [Option<f64>; 2],
        robot: &mut dyn Robot,
    ) -> Result<(), Fault> {
        let [None, None] = arguments else {
            return Err(Fault::Domain);
        };
        for (n, finger) in (1..).zip(&mut self.0) {
            finger.mode = Mode::Still;
            finger.shake(n, robot)?;
        }
        Ok(())
    }

    /// SPECIAL 11 to 13: sets mode and amplitude of finger `n`, from 1, and restarts its wave.
    pub(super) fn switch(
        &mut self,
        n: u8,
        arguments: [Option<f64>; 2],
        robot: &mut dyn Robot,
    ) -> Result<(), Fault> {
        let [Some(mode), Some(amplitude)] = arguments else {
            return Err(Fault::Domain);
        };
        let (mode, amplitude) = (Mode::new(mode)?, not_negative(amplitude)?);
        let finger = self.finger(n)?;
        finger.mode = Mode::Still;
        finger.shake(n, robot)?;
        finger.mode = mode;
        finger.amplitude = amplitude;
        finger.shake(n, robot)
    }

    /// SPECIAL 14 to 16: sets the frequency of finger `n`, from 1; its wave keeps the phase.
    pub(super) fn tune(
        &mut self,
        n: u8,
        arguments: [Option<f64>; 2],
        robot: &mut dyn Robot,
    ) -> Result<(), Fault> {
        let [Some(frequency), None] = arguments else {
            return Err(Fault::Domain);
        };
        if !FREQUENCIES.contains(frequency) {
            return Err(Fault::Domain);
        }
        let finger = self.finger(n)?;
        finger.frequency = frequency;
        finger.shake(n, robot)
    }

    fn finger(&mut self, n: u8) -> Result<&mut Finger, Fault> {
        let at = usize::from(n).wrapping_sub(1);
        self.0.get_mut(at).ok_or(Fault::Domain)
    }
}

impl Finger {
    /// Commands the vibration of finger `n`'s joints.
    fn shake(&self, n: u8, robot: &mut dyn Robot) -> Result<(), Fault> {
        for (m, wave) in (1..).zip(self.mode.waves(n)) {
            let vibration = wave.map(|(waveform, share)| Vibration {
                waveform,
                amplitude: share * self.amplitude,
                frequency: self.frequency,
            });
            robot.vibrate(Target::Joint(n, m), vibration)?;
        }
        Ok(())
    }
}
