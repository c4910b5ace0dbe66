//! Simulated servos at the end of a wire in memory, in place of a robot.

use crate::bus::{BROADCAST, DRIVES, Frame, Instruction, LENGTH, Link};
use std::collections::VecDeque;
use tip_runtime::model::titan8;

/// Time constant of the remaining distance, ms.
const TIME_CONSTANT: f64 = 25.0;
/// The most that a servo turns: counts per ms (about 264 deg/s at 4096 counts a turn).
const SPEED: f64 = 3.0;

/// A position servo: it closes part of the distance to its target each time, at a limited speed.
#[derive(Clone, Debug)]
pub struct Servo {
    /// The address on the bus.
    pub id: u8,
    /// Position, counts.
    pub position: f64,
    target: f64,
}

/// A wire in memory with servos at its end, which move for `period` ms at each GO.
#[derive(Clone, Debug)]
pub struct MemoryLink {
    /// The servos on the wire.
    pub servos: Vec<Servo>,
    answers: VecDeque<[u8; LENGTH]>,
    period: f64,
}

impl MemoryLink {
    /// Returns a wire with TITAN VIII's servos where they hold it in its initial posture.
    pub fn titan8() -> Self {
        let angles = titan8::MODEL.legs.iter().flat_map(|leg| leg.initial);
        let servo = |(drive, angle): (&crate::bus::Drive, f64)| Servo {
            id: drive.id,
            position: drive.counts(angle),
            target: drive.counts(angle),
        };
        MemoryLink {
            servos: DRIVES.iter().flatten().zip(angles).map(servo).collect(),
            answers: VecDeque::new(),
            period: titan8::MODEL.standards.period,
        }
    }
}

impl Servo {
    /// Moves towards the target for `period` ms.
    fn run(&mut self, period: f64) {
        let share = period / (period + TIME_CONSTANT);
        let most = SPEED * period;
        self.position += ((self.target - self.position) * share).clamp(-most, most);
    }
}

impl Link for MemoryLink {
    fn send(&mut self, bytes: [u8; LENGTH]) -> bool {
        // Like real servos, these ignore a damaged frame.
        let Some(frame) = Frame::decode(bytes) else {
            return true;
        };
        let is_addressed = |servo: &&mut Servo| [servo.id, BROADCAST].contains(&frame.servo);
        for servo in self.servos.iter_mut().filter(is_addressed) {
            match frame.instruction {
                Instruction::Target => servo.target = f64::from(frame.value),
                Instruction::Go => servo.run(self.period),
                Instruction::Stop => servo.target = servo.position,
                Instruction::Ask => self.answers.push_back(
                    Frame {
                        servo: servo.id,
                        instruction: Instruction::Position,
                        value: servo.position.round() as i16,
                    }
                    .encode(),
                ),
                Instruction::Position => {}
            }
        }
        true
    }

    fn receive(&mut self) -> Option<[u8; LENGTH]> {
        self.answers.pop_front()
    }
}
