//! An output shaft that turns with lag, and the interface of a family's firmware.

use super::wire::Wire;
use std::boxed::Box;
use std::fmt::Debug;
use std::vec::Vec;

/// Time constant of a servo's remaining distance, s.
const LAG: f64 = 0.02;
/// Rise of the temperature at full load, °C per s.
const HEATING: f64 = 0.5;
/// Temperature of a servo that rests, °C.
pub(super) const ROOM: f64 = 30.0;
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
    pub(super) top_speed: f64,
    pub(super) is_hot: bool,
    /// Something holds it: it does not turn, with all its torque.
    pub(super) is_blocked: bool,
}

impl Shaft {
    pub(super) fn advance(&mut self, drive: Drive, time: f64) {
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
    /// Sets a register before the start.
    ///
    /// # Panics
    /// It has no such register.
    fn preset(&mut self, address: u16, value: i64) {
        let registers = self.registers_mut();
        registers
            .expect("a family with registers")
            .preset(address, value);
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
