//! A simulated position servo: it closes part of the distance each time, at a limited speed.

use crate::protocol::{Frame, Instruction};

/// Time constant of the remaining distance, ms.
const TIME_CONSTANT: f64 = 25.0;

/// The most that a servo turns: counts per ms (about 264 deg/s at 4096 counts a turn).
const SPEED: f64 = 3.0;

/// A simulated servo.
#[derive(Clone, Debug)]
pub struct Servo {
    id: u8,
    position: f64,
    target: f64,
}

impl Servo {
    /// The servo with this address, at rest at a count.
    pub fn new(id: u8, counts: f64) -> Self {
        Servo {
            id,
            position: counts,
            target: counts,
        }
    }

    /// Its address.
    pub fn id(&self) -> u8 {
        self.id
    }

    /// Position, counts.
    pub fn position(&self) -> f64 {
        self.position
    }

    /// Remembers a target.
    pub(crate) fn aim(&mut self, counts: i16) {
        self.target = f64::from(counts);
    }

    /// Stays where it is.
    pub(crate) fn hold(&mut self) {
        self.target = self.position;
    }

    /// Moves towards its target for `period` ms.
    pub(crate) fn run(&mut self, period: f64) {
        let share = period / (period + TIME_CONSTANT);
        let most = SPEED * period;
        self.position += ((self.target - self.position) * share).clamp(-most, most);
    }

    /// Reports its position, as exactly as its encoder can.
    pub(crate) fn answer(&self) -> Frame {
        Frame {
            servo: self.id,
            instruction: Instruction::Position,
            value: self.position.round() as i16,
        }
    }
}
