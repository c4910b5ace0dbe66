//! A servo: an output shaft that turns with lag, and the firmware of a family.

use super::ax_mx::AxMx;
use super::lx::Lx;
use super::moteus::Moteus;
use super::sts::Sts;
use super::wire::Wire;
use super::x::X;
use crate::model::Model;
use std::boxed::Box;
use std::fmt::Debug;
use std::vec::Vec;

/// Time constant of a servo's remaining distance, s.
const LAG: f64 = 0.02;
/// Rise of the temperature at full load, °C per s.
const HEATING: f64 = 0.5;
/// Temperature of a servo that rests, °C.
const ROOM: f64 = 30.0;
/// Temperature of a servo that was made to overheat, °C.
const HOT: f64 = 90.0;

/// The task of a motor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Drive {
    /// It turns freely.
    Free,
    /// It brakes the shaft and holds no angle.
    Damped,
    /// It goes to an angle, deg, with a speed, deg/s, and a part of its torque at most.
    To { goal: f64, speed: f64, torque: f64 },
    /// It turns on and on, deg/s.
    Spin(f64),
}

/// The mechanics of a servo, in degrees from the middle of its travel.
#[derive(Clone, Debug)]
pub(super) struct Shaft {
    pub(super) angle: f64,
    /// deg/s
    pub(super) velocity: f64,
    /// Load, as a part of the stall torque.
    pub(super) load: f64,
    /// °C
    pub(super) temperature: f64,
    /// V
    pub(super) voltage: f64,
    /// The fastest without load, deg/s.
    top_speed: f64,
    is_hot: bool,
    /// Something holds it: it does not turn, with all its torque.
    is_blocked: bool,
}

impl Shaft {
    fn advance(&mut self, drive: Drive, time: f64) {
        let from = self.angle;
        let is_pushing = match drive {
            Drive::Free | Drive::Damped => false,
            Drive::Spin(speed) => {
                if !self.is_blocked {
                    self.angle += speed.clamp(-self.top_speed, self.top_speed) * time;
                }
                speed != 0.0
            }
            Drive::To {
                goal,
                speed,
                torque,
            } => {
                let speed = speed.min(self.top_speed);
                // Less does not overcome the gears.
                if torque > 0.02 && !self.is_blocked {
                    let share = time / (time + LAG);
                    let most = speed * time;
                    self.angle += ((goal - from) * share).clamp(-most, most);
                }
                true
            }
        };
        if time > 0.0 {
            self.velocity = (self.angle - from) / time;
        }
        self.load = match self.is_blocked && is_pushing {
            true => 1.0,
            false => 0.5 * (self.velocity / self.top_speed).clamp(-1.0, 1.0),
        };
        let (target, rate) = match self.is_hot {
            true => (HOT, 20.0),
            false => (ROOM + 40.0 * self.load.abs().min(0.5), HEATING),
        };
        self.temperature += (target - self.temperature).clamp(-rate * time, rate * time);
    }
}

/// An answer to a request: parameters, or an error of the instruction alone.
pub(super) struct Reply {
    /// Bits of the error byte that concern this instruction.
    pub(super) error: u8,
    pub(super) parameters: Vec<u8>,
}

impl Reply {
    pub(super) const fn of(parameters: Vec<u8>) -> Self {
        Reply {
            error: 0,
            parameters,
        }
    }

    pub(super) const fn error(error: u8) -> Self {
        Reply {
            error,
            parameters: Vec::new(),
        }
    }
}

/// The registers of a servo that is read and written by address.
pub(super) trait Registers {
    /// Reads registers.
    fn read(&self, start: u16, length: u16) -> Reply;
    /// Writes registers, if the servo takes all of them.
    fn write(&mut self, start: u16, bytes: &[u8]) -> Reply;
    /// Returns the parameters of an answer to a ping.
    fn ping(&self) -> Vec<u8>;
    /// Returns the error byte of a servo that executes everything.
    fn alarm(&self) -> u8;
    /// Returns the delay of its answers, µs.
    fn return_delay(&self) -> u64;
    /// Returns true if it answers to reading and to writing.
    fn answers(&self) -> (bool, bool);
    /// Returns the error of an instruction that does not exist.
    fn instruction_error(&self) -> u8;
    /// Returns the first address of the present position, and its value.
    fn present_position(&self) -> (u16, i64);
    /// Returns the raw value of the bytes at an address.
    fn raw(&self, address: u16, width: u8) -> Option<u32>;
    /// Sets a register, whatever may be written there, and keeps it without power.
    fn preset(&mut self, address: u16, value: i64);
}

/// A firmware: what a family's manual says of its servos.
pub(super) trait Firmware: Debug {
    /// Returns the frames that it understands.
    fn wire(&self) -> Wire;
    fn id(&self) -> u8;
    /// Returns the servo's position at an angle, counts.
    fn counts(&self, angle: f64) -> f64;
    /// Returns the angle at a position, deg.
    fn angle(&self, counts: f64) -> f64;
    /// Starts anew at an angle, as after a time without power.
    fn power_on(&mut self, shaft: &Shaft);
    /// Takes over what its sensors measure at a time, µs, and protects itself.
    fn sense(&mut self, shaft: &Shaft, now: u64);
    /// Is told that a request for it came, µs.
    fn hear(&mut self, _now: u64) {}
    fn drive(&self) -> Drive;
    fn has_torque(&self) -> bool;
    /// Returns its goal as it was sent, counts.
    fn goal(&self) -> f64;
    /// Returns its torque limit, from 0 to 1.
    fn torque_limit(&self) -> f64;
    fn copy(&self) -> Box<dyn Firmware + Send + Sync>;
    /// Returns the mode of a moteus.
    fn mode(&self) -> Option<u8> {
        None
    }
    fn registers(&self) -> Option<&dyn Registers> {
        None
    }
    fn registers_mut(&mut self) -> Option<&mut dyn Registers> {
        None
    }
    /// Executes a frame of a family that has no registers by address, and returns the payload of its answer.
    fn serve(&mut self, _code: u8, _payload: &[u8], _shaft: &Shaft, _now: u64) -> Option<Vec<u8>> {
        None
    }
    /// Returns true if an answer to such a frame holds the position.
    fn tells_position(&self, _code: u8, answer: &[u8]) -> bool {
        !answer.is_empty()
    }
}

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
    /// The family has no registers.
    #[must_use]
    pub fn with(mut self, address: u16, value: i64) -> Self {
        let registers = self.firmware.registers_mut();
        registers
            .expect("a family with registers")
            .preset(address, value);
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
