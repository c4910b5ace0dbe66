//! Feetech STS.
//!
//! Sources: Feetech, "Magnetic Encoding STS Servo: Memory Table Analysis", sections "Version Information", "EPROM Configuration",
//! "SRAM Control", "SRAM Feedback" and "Special Byte Explanation"; "SCS Servo Communication Protocol". The model number of an
//! STS3215 (777), the sign bits (15 of positions and speeds, 11 of the offset, 10 of loads) and the usual phase byte (12) are those
//! of LeRobot's tables.
//!
//! That a goal switches the torque on is not in the table; users report it.

use super::firmware::{Drive, Firmware, Registers, Reply, Shaft};
use super::table::{Coding, Item, Table, read_only, writable};
use super::wire::Wire;
use std::boxed::Box;
use std::vec;
use std::vec::Vec;

/// The memory table.
mod at {
    pub(super) const MODEL: u16 = 3;
    pub(super) const ID: u16 = 5;
    pub(super) const RETURN_DELAY: u16 = 7;
    pub(super) const RESPONSE_LEVEL: u16 = 8;
    pub(super) const MIN_ANGLE: u16 = 9;
    pub(super) const MAX_ANGLE: u16 = 11;
    pub(super) const MAX_TEMPERATURE: u16 = 13;
    pub(super) const MAX_VOLTAGE: u16 = 14;
    pub(super) const MIN_VOLTAGE: u16 = 15;
    pub(super) const MAX_TORQUE: u16 = 16;
    pub(super) const PHASE: u16 = 18;
    pub(super) const UNLOAD_CONDITIONS: u16 = 19;
    pub(super) const OFFSET: u16 = 31;
    pub(super) const MODE: u16 = 33;
    pub(super) const PROTECTIVE_TORQUE: u16 = 34;
    pub(super) const PROTECTION_TIME: u16 = 35;
    pub(super) const OVERLOAD_TORQUE: u16 = 36;
    pub(super) const TORQUE_ENABLE: u16 = 40;
    pub(super) const GOAL: u16 = 42;
    pub(super) const TIME: u16 = 44;
    pub(super) const SPEED: u16 = 46;
    pub(super) const TORQUE_LIMIT: u16 = 48;
    pub(super) const LOCK: u16 = 55;
    pub(super) const POSITION: u16 = 56;
    pub(super) const PRESENT_SPEED: u16 = 58;
    pub(super) const LOAD: u16 = 60;
    pub(super) const VOLTAGE: u16 = 62;
    pub(super) const TEMPERATURE: u16 = 63;
    pub(super) const STATUS: u16 = 65;
    pub(super) const MOVING: u16 = 66;
}

/// Bits of the status, which is the error byte too, and of the conditions that unload the motor.
mod status {
    pub(super) const VOLTAGE: i64 = 1 << 0;
    pub(super) const TEMPERATURE: i64 = 1 << 2;
    pub(super) const OVERLOAD: i64 = 1 << 5;
}

/// First address of the RAM.
const RAM: u16 = 40;
/// Steps of a turn.
const TURN: f64 = 4096.0;
/// "128: calibrate the current position to 2048".
const CALIBRATE: i64 = 128;

fn table(number: i64) -> Table {
    let signed = |item: Item, bit| item.coded(Coding::SignBit(bit));
    let items: Vec<Item> = vec![
        read_only(0, 1, 3),
        read_only(1, 1, 10),
        read_only(2, 1, 0),
        read_only(at::MODEL, 2, number),
        writable(at::ID, 1, 1, 0, 253),
        writable(6, 1, 0, 0, 7),
        writable(at::RETURN_DELAY, 1, 0, 0, 254),
        writable(at::RESPONSE_LEVEL, 1, 1, 0, 1),
        writable(at::MIN_ANGLE, 2, 0, 0, 4094),
        writable(at::MAX_ANGLE, 2, 4095, 0, 4095),
        writable(at::MAX_TEMPERATURE, 1, 70, 0, 100),
        writable(at::MAX_VOLTAGE, 1, 140, 0, 254),
        writable(at::MIN_VOLTAGE, 1, 40, 0, 254),
        writable(at::MAX_TORQUE, 2, 1000, 0, 1000),
        writable(at::PHASE, 1, 12, 0, 254),
        writable(at::UNLOAD_CONDITIONS, 1, 44, 0, 254),
        writable(20, 1, 47, 0, 254),
        writable(21, 1, 32, 0, 254),
        writable(22, 1, 32, 0, 254),
        writable(23, 1, 0, 0, 254),
        writable(24, 2, 16, 0, 1000),
        writable(26, 1, 1, 0, 16),
        writable(27, 1, 1, 0, 16),
        writable(28, 2, 500, 0, 2047),
        writable(30, 1, 1, 1, 128),
        signed(writable(at::OFFSET, 2, 0, -2047, 2047), 11),
        writable(at::MODE, 1, 0, 0, 3),
        writable(at::PROTECTIVE_TORQUE, 1, 20, 0, 254),
        writable(at::PROTECTION_TIME, 1, 200, 0, 254),
        writable(at::OVERLOAD_TORQUE, 1, 80, 0, 254),
        writable(37, 1, 10, 0, 254),
        writable(38, 1, 200, 0, 254),
        writable(39, 1, 200, 0, 254),
        writable(at::TORQUE_ENABLE, 1, 0, 0, 128),
        writable(41, 1, 0, 0, 254),
        signed(writable(at::GOAL, 2, 0, -30_719, 30_719), 15),
        writable(at::TIME, 2, 0, 0, 65_535),
        signed(writable(at::SPEED, 2, 0, -32_767, 32_767), 15),
        writable(at::TORQUE_LIMIT, 2, 1000, 0, 1000),
        writable(at::LOCK, 1, 1, 0, 1),
        signed(read_only(at::POSITION, 2, 0), 15),
        signed(read_only(at::PRESENT_SPEED, 2, 0), 15),
        signed(read_only(at::LOAD, 2, 0), 10),
        read_only(at::VOLTAGE, 1, 0),
        read_only(at::TEMPERATURE, 1, 0),
        read_only(64, 1, 0),
        read_only(at::STATUS, 1, 0),
        read_only(at::MOVING, 1, 0),
        read_only(69, 2, 0),
    ];
    Table::new(items, RAM)
}

/// The firmware of an STS servo.
#[derive(Clone, Debug)]
pub(super) struct Sts {
    table: Table,
    /// The last angle of the shaft, deg.
    angle: f64,
    now: u64,
    /// Time since when the load is above the overload torque, µs.
    overloaded_since: Option<u64>,
}

impl Sts {
    /// Creates the firmware of a model, and returns its top speed, deg/s, and the voltage of its supply.
    pub(super) fn of(model: &str, id: u8) -> Option<(Box<dyn Firmware + Send + Sync>, f64, f64)> {
        // Rev/min without load; Feetech states no model number of an STS3032.
        let (number, top_speed) = match model {
            "STS3215" => (777, 45.0),
            "STS3032" => (0, 90.0),
            _ => return None,
        };
        let mut table = table(number);
        table.set(at::ID, id.into());
        table.save();
        let sts = Sts {
            table,
            angle: 0.0,
            now: 0,
            overloaded_since: None,
        };
        Some((Box::new(sts), top_speed * 6.0, 12.0))
    }

    /// Returns the unit of speeds, deg/s: "0.0146 rpm" is a step in a second, "0.732 rpm" are fifty.
    fn speed_unit(&self) -> f64 {
        let steps = if self.table.get(at::PHASE) & 4 != 0 {
            1.0
        } else {
            50.0
        };
        steps * 360.0 / TURN
    }

    /// Returns true if the angle limits are off, for several turns.
    fn is_multi_turn(&self) -> bool {
        self.table.get(at::MIN_ANGLE) == 0 && self.table.get(at::MAX_ANGLE) == 0
    }

    fn is_overloaded(&self) -> bool {
        self.table.get(at::STATUS) & status::OVERLOAD != 0
    }

    /// Takes a value over: what is out of range is clipped to it.
    fn take(&mut self, item: &Item, value: i64) {
        let (min, max) = item.range.unwrap_or_default();
        let value = value.clamp(min, max);
        match item.address {
            at::TORQUE_ENABLE if value == CALIBRATE => {
                let actual = self.angle * TURN / 360.0;
                self.table.set(at::OFFSET, libm::round(actual) as i64);
            }
            at::TORQUE_ENABLE if value > 2 => {}
            at::GOAL => {
                let value = match self.is_multi_turn() {
                    true => value,
                    false => {
                        let [min, max] =
                            [at::MIN_ANGLE, at::MAX_ANGLE].map(|it| self.table.get(it));
                        value.clamp(min, max.max(min))
                    }
                };
                self.table.set(at::GOAL, value);
                self.table.set(at::TORQUE_ENABLE, 1);
            }
            address => self.table.set(address, value),
        }
    }
}

impl Firmware for Sts {
    fn wire(&self) -> Wire {
        Wire::Dynamixel1
    }

    fn id(&self) -> u8 {
        self.table.get(at::ID) as u8
    }

    fn counts(&self, angle: f64) -> f64 {
        angle * TURN / 360.0 + TURN / 2.0 - self.table.get(at::OFFSET) as f64
    }

    fn angle(&self, counts: f64) -> f64 {
        (counts - TURN / 2.0 + self.table.get(at::OFFSET) as f64) * 360.0 / TURN
    }

    fn power_on(&mut self, shaft: &Shaft) {
        self.table.power_on();
        let torque = self.table.get(at::MAX_TORQUE);
        self.table.set(at::TORQUE_LIMIT, torque);
        self.angle = shaft.angle;
        let here = libm::round(self.counts(shaft.angle)) as i64;
        self.table.set(at::GOAL, here);
        self.overloaded_since = None;
    }

    fn sense(&mut self, shaft: &Shaft, now: u64) {
        (self.angle, self.now) = (shaft.angle, now);
        let counts = libm::round(self.counts(shaft.angle)) as i64;
        // "Angle feedback mode: single turn" unless the phase byte says otherwise.
        let position = match self.table.get(at::PHASE) & 16 != 0 {
            true => counts,
            false => counts.rem_euclid(4096),
        };
        for (address, value) in [
            (at::POSITION, position),
            (
                at::PRESENT_SPEED,
                libm::round(shaft.velocity / self.speed_unit()) as i64,
            ),
            (at::LOAD, (shaft.load * 1000.0) as i64),
            (at::VOLTAGE, (shaft.voltage * 10.0) as i64),
            (at::TEMPERATURE, shaft.temperature as i64),
            (at::MOVING, i64::from(shaft.velocity.abs() > 1.0)),
        ] {
            self.table.set(address, value);
        }
        let overload = self.table.get(at::OVERLOAD_TORQUE) as f64 / 100.0;
        let since = match shaft.load.abs() > overload {
            true => Some(*self.overloaded_since.get_or_insert(now)),
            false => None,
        };
        self.overloaded_since = since;
        let allowed = self.table.get(at::PROTECTION_TIME) as u64 * 10_000;
        let mut bits = 0;
        if since.is_some_and(|since| now - since > allowed) {
            bits |= status::OVERLOAD;
        }
        if self.table.get(at::TEMPERATURE) > self.table.get(at::MAX_TEMPERATURE) {
            bits |= status::TEMPERATURE;
        }
        let volts = self.table.get(at::MIN_VOLTAGE)..=self.table.get(at::MAX_VOLTAGE);
        if !volts.contains(&self.table.get(at::VOLTAGE)) {
            bits |= status::VOLTAGE;
        }
        self.table.set(at::STATUS, bits);
        // An overload leaves the protective torque; the rest unloads the motor.
        let unloads = self.table.get(at::UNLOAD_CONDITIONS) & !status::OVERLOAD;
        if bits & unloads != 0 {
            self.table.set(at::TORQUE_ENABLE, 0);
        }
    }

    fn drive(&self) -> Drive {
        let units = self.table.get(at::SPEED);
        match (self.table.get(at::TORQUE_ENABLE), self.table.get(at::MODE)) {
            (1, 0) => {
                let is_fast = units == 0 && self.table.get(at::PHASE) & 8 != 0;
                Drive::To {
                    goal: self.angle(self.goal()),
                    speed: match is_fast {
                        true => f64::INFINITY,
                        false => units.abs() as f64 * self.speed_unit(),
                    },
                    torque: self.torque_limit(),
                }
            }
            (1, 1) => Drive::Spin(units as f64 * self.speed_unit()),
            (1 | 2, _) => Drive::Damped,
            _ => Drive::Free,
        }
    }

    fn has_torque(&self) -> bool {
        self.table.get(at::TORQUE_ENABLE) == 1
    }

    fn goal(&self) -> f64 {
        self.table.get(at::GOAL) as f64
    }

    fn torque_limit(&self) -> f64 {
        let own = self.table.get(at::TORQUE_LIMIT) as f64 / 1000.0;
        match self.is_overloaded() {
            true => own.min(self.table.get(at::PROTECTIVE_TORQUE) as f64 / 100.0),
            false => own,
        }
    }

    fn copy(&self) -> Box<dyn Firmware + Send + Sync> {
        Box::new(self.clone())
    }

    fn registers(&self) -> Option<&dyn Registers> {
        Some(self)
    }

    fn registers_mut(&mut self) -> Option<&mut dyn Registers> {
        Some(self)
    }
}

impl Registers for Sts {
    fn read(&self, start: u16, length: u16) -> Reply {
        let bytes = self.table.bytes(start, length);
        Reply {
            error: 0,
            parameters: bytes.map(<[u8]>::to_vec).unwrap_or_default(),
        }
    }

    /// While the lock is closed, the registers of the EPROM change until the power goes off. Bytes that are not whole registers
    /// change nothing.
    fn write(&mut self, start: u16, bytes: &[u8]) -> Reply {
        if let Ok(values) = self.table.parse(start, bytes) {
            for (item, value) in values {
                self.take(&item, value);
                if self.table.get(at::LOCK) == 0 {
                    self.table.save();
                }
            }
        }
        Reply::error(0)
    }

    fn ping(&self) -> Vec<u8> {
        Vec::new()
    }

    fn alarm(&self) -> u8 {
        self.table.get(at::STATUS) as u8
    }

    fn return_delay(&self) -> u64 {
        self.table.get(at::RETURN_DELAY) as u64 * 2
    }

    fn answers(&self) -> (bool, bool) {
        (true, self.table.get(at::RESPONSE_LEVEL) == 1)
    }

    fn instruction_error(&self) -> u8 {
        0
    }

    fn present_position(&self) -> (u16, i64) {
        (at::POSITION, self.table.get(at::POSITION))
    }

    fn raw(&self, address: u16, width: u8) -> Option<u32> {
        self.table.raw(address, width)
    }

    fn preset(&mut self, address: u16, value: i64) {
        self.table.preset(address, value);
    }
}
