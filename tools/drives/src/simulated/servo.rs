//! A servo: an output shaft with the firmware of its family, and what can happen to it.

use super::ax_mx::AxMx;
use super::firmware::{Drive, Firmware, ROOM, Reply, Shaft};
use super::lx::Lx;
use super::moteus::Moteus;
use super::sts::Sts;
use super::x::X;
use crate::model::Model;
use std::boxed::Box;
use std::vec::Vec;

/// A simulated servo. Angles are those of its output shaft, in degrees from the middle of its travel; positions and goals are in
/// the counts of its maker, those of a moteus in 10⁻⁵ turns from the middle of ten turns.
#[derive(Debug)]
pub struct Servo {
    pub(super) firmware: Box<dyn Firmware + Send + Sync>,
    pub(super) shaft: Shaft,
    pub(super) is_gone: bool,
    /// The position that it reported last, counts.
    pub(super) reported: Option<i32>,
}

impl Clone for Servo {
    fn clone(&self) -> Self {
        Servo {
            firmware: self.firmware.copy(),
            shaft: self.shaft.clone(),
            is_gone: self.is_gone,
            reported: self.reported,
        }
    }
}

impl Servo {
    /// Creates a servo of a model with an identity, at rest at a position, without torque.
    ///
    /// # Panics
    /// Nobody wrote a table for the model.
    pub fn new(model: &Model, id: u8, position: f64) -> Self {
        Servo::of(model.name, id, position)
    }

    /// Creates a servo by the name of its model.
    ///
    /// # Panics
    /// Nobody wrote a table for the model.
    pub fn of(model: &str, id: u8, position: f64) -> Self {
        let (firmware, top_speed, voltage) = AxMx::of(model, id)
            .or_else(|| X::of(model, id))
            .or_else(|| Sts::of(model, id))
            .or_else(|| Moteus::of(model, id))
            .or_else(|| Lx::of(model, id))
            .unwrap_or_else(|| panic!("no simulated servo {model}"));
        let shaft = Shaft {
            angle: firmware.angle(position),
            velocity: 0.0,
            load: 0.0,
            temperature: ROOM,
            voltage,
            top_speed,
            is_hot: false,
            is_blocked: false,
        };
        let mut servo = Servo {
            firmware,
            shaft,
            is_gone: false,
            reported: None,
        };
        servo.reset();
        servo
    }

    /// Sets a register before the start, and keeps it without power: the servo's user has written it with the maker's tool.
    ///
    /// # Panics
    /// The family has no such register.
    #[must_use]
    pub fn with(mut self, address: u16, value: i64) -> Self {
        self.firmware.preset(address, value);
        self.reset();
        self
    }

    /// Starts anew, without torque and with the values that were saved.
    pub(super) fn reset(&mut self) {
        self.firmware.power_on(&self.shaft);
        self.firmware.sense(&self.shaft, 0);
    }

    /// Returns its identity.
    pub fn id(&self) -> u8 {
        self.firmware.id()
    }

    /// Returns the angle of its shaft, deg from the middle of its travel.
    pub fn angle(&self) -> f64 {
        self.shaft.angle
    }

    /// Places its shaft at an angle before the start, deg from the middle of its travel.
    pub fn place(&mut self, angle: f64) {
        self.shaft.angle = angle;
        self.reset();
    }

    /// Returns its temperature, °C.
    pub fn temperature(&self) -> f64 {
        self.shaft.temperature
    }

    /// Returns the voltage of its supply, V.
    pub fn voltage(&self) -> f64 {
        self.shaft.voltage
    }

    /// Returns its position, counts.
    pub fn position(&self) -> f64 {
        self.firmware.counts(self.shaft.angle)
    }

    /// Returns its speed, deg/s.
    pub fn velocity(&self) -> f64 {
        self.shaft.velocity
    }

    /// Returns the position of its last answer as it was sent, counts.
    pub fn reported(&self) -> Option<i32> {
        self.reported
    }

    /// Returns true if it holds with torque.
    pub fn has_torque(&self) -> bool {
        self.firmware.has_torque()
    }

    /// Returns its goal, counts.
    pub fn goal(&self) -> f64 {
        self.firmware.goal()
    }

    /// Returns its torque limit, from 0 to 1.
    pub fn torque_limit(&self) -> f64 {
        self.firmware.torque_limit()
    }

    /// Returns the speed that it would go to its goal with, deg/s; infinite if nothing but its motor limits it.
    pub fn speed_limit(&self) -> f64 {
        match self.firmware.drive() {
            Drive::To { speed, .. } => speed,
            Drive::Free | Drive::Damped | Drive::Spin(_) => f64::INFINITY,
        }
    }

    /// Returns the bytes of a register as one number, low byte first; `None` if the family has no registers there.
    pub fn register(&self, address: u16, width: u8) -> Option<u32> {
        self.firmware.registers()?.raw(address, width)
    }

    /// Returns the mode of a moteus, which is its register 0; `None` of other families.
    pub fn mode(&self) -> Option<u8> {
        self.firmware.mode()
    }

    pub(super) fn overheat(&mut self) {
        self.shaft.is_hot = true;
    }

    pub(super) fn block(&mut self) {
        self.shaft.is_blocked = true;
    }

    pub(super) fn sag(&mut self) {
        self.shaft.voltage = 7.0;
    }

    /// Turns the shaft by hand, deg, which a servo with torque does not let happen.
    pub(super) fn turn(&mut self, by: f64) {
        if !self.has_torque() {
            self.shaft.angle += by;
        }
    }

    /// Reads registers, and remembers the position among them.
    pub(super) fn read(&mut self, start: u16, length: u16) -> Option<Reply> {
        let registers = self.firmware.registers()?;
        let reply = registers.read(start, length);
        let (address, position) = registers.present_position();
        if (start..start + length).contains(&address) {
            self.reported = Some(position as i32);
        }
        Some(reply)
    }

    /// Executes a frame of a family without registers by address, and remembers the position that it told.
    pub(super) fn serve(&mut self, code: u8, payload: &[u8], now: u64) -> Option<Vec<u8>> {
        let answer = self.firmware.serve(code, payload, &self.shaft, now);
        let tells = |answer: &Vec<u8>| self.firmware.tells_position(code, answer);
        if answer.as_ref().is_some_and(tells) {
            self.reported = Some(libm::round(self.position()) as i32);
        }
        answer
    }

    /// Moves for some time, s, until a time of the bus, µs.
    pub(super) fn advance(&mut self, time: f64, now: u64) {
        self.shaft.advance(self.firmware.drive(), time);
        self.firmware.sense(&self.shaft, now);
    }
}
