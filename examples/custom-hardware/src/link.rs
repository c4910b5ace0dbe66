//! The wire: a trait, and an in-memory wire with simulated servos at its end.

use crate::protocol::{BROADCAST, Frame, Instruction, LENGTH};
use crate::servo::Servo;
use std::collections::VecDeque;

/// Byte stream of the bus. A serial port implements it.
pub trait Link {
    /// Sends one frame's bytes; false if the wire is dead.
    fn send(&mut self, bytes: [u8; LENGTH]) -> bool;
    /// The next frame's bytes, or `None` when nothing came in time.
    fn receive(&mut self) -> Option<[u8; LENGTH]>;
}

/// A wire in memory with simulated servos at its end.
#[derive(Clone, Debug)]
pub struct MemoryLink {
    servos: Vec<Servo>,
    answers: VecDeque<[u8; LENGTH]>,
    period: f64,
}

impl MemoryLink {
    /// A wire with these servos, which move for `period` ms at each GO.
    pub fn new(servos: Vec<Servo>, period: f64) -> Self {
        MemoryLink {
            servos,
            answers: VecDeque::new(),
            period,
        }
    }

    /// Takes a servo off the wire: it answers no more.
    pub fn unplug(&mut self, id: u8) {
        self.servos.retain(|servo| servo.id() != id);
    }

    /// The servos on the wire.
    pub fn servos(&self) -> &[Servo] {
        &self.servos
    }

    fn deliver(&mut self, frame: Frame) {
        let all = frame.servo == BROADCAST;
        let listeners = self.servos.iter_mut();
        for servo in listeners.filter(|servo| all || servo.id() == frame.servo) {
            match frame.instruction {
                Instruction::Target => servo.aim(frame.value),
                Instruction::Go => servo.run(self.period),
                Instruction::Ask => self.answers.push_back(servo.answer().encode()),
                Instruction::Stop => servo.hold(),
                Instruction::Position => {}
            }
        }
    }
}

impl Link for MemoryLink {
    fn send(&mut self, bytes: [u8; LENGTH]) -> bool {
        // Like real servos, these ignore a damaged frame.
        if let Some(frame) = Frame::decode(bytes) {
            self.deliver(frame);
        }
        true
    }

    fn receive(&mut self) -> Option<[u8; LENGTH]> {
        self.answers.pop_front()
    }
}
