//! Dynamixel AX and MX with protocol 1.
//!
//! Sources: ROBOTIS e-Manual, "AX-12A", "AX-18A", "MX-28", "MX-64" and "MX-106" (protocol 1.0), sections "Specifications",
//! "Control Table of EEPROM Area", "Control Table of RAM Area" and "Control Table Description"; "DYNAMIXEL Protocol 1.0",
//! section "Error".
//!
//! That a goal switches the torque on is not in the manual. Users of both series report it, and libraries for them rely on it.

use super::firmware::{Drive, Firmware, Registers, Reply, Shaft};
use super::table::{Coding, Item, Refusal, Table, read_only, writable};
use super::wire::Wire;
use std::boxed::Box;
use std::vec;
use std::vec::Vec;

/// "Control Table": model number, EEPROM and RAM.
mod at {
    pub(super) const MODEL: u16 = 0;
    pub(super) const ID: u16 = 3;
    pub(super) const RETURN_DELAY: u16 = 5;
    pub(super) const CW_LIMIT: u16 = 6;
    pub(super) const CCW_LIMIT: u16 = 8;
    pub(super) const TEMPERATURE_LIMIT: u16 = 11;
    pub(super) const MIN_VOLTAGE: u16 = 12;
    pub(super) const MAX_VOLTAGE: u16 = 13;
    pub(super) const MAX_TORQUE: u16 = 14;
    pub(super) const STATUS_RETURN_LEVEL: u16 = 16;
    pub(super) const SHUTDOWN: u16 = 18;
    pub(super) const TORQUE_ENABLE: u16 = 24;
    pub(super) const GOAL: u16 = 30;
    pub(super) const SPEED: u16 = 32;
    pub(super) const TORQUE_LIMIT: u16 = 34;
    pub(super) const POSITION: u16 = 36;
    pub(super) const PRESENT_SPEED: u16 = 38;
    pub(super) const LOAD: u16 = 40;
    pub(super) const VOLTAGE: u16 = 42;
    pub(super) const TEMPERATURE: u16 = 43;
    pub(super) const MOVING: u16 = 46;
    pub(super) const LOCK: u16 = 47;
}

/// Bits of the error byte.
mod error {
    pub(super) const VOLTAGE: u8 = 1 << 0;
    pub(super) const ANGLE_LIMIT: u8 = 1 << 1;
    pub(super) const OVERHEATING: u8 = 1 << 2;
    pub(super) const RANGE: u8 = 1 << 3;
    pub(super) const INSTRUCTION: u8 = 1 << 6;
}

/// First address of the RAM.
const RAM: u16 = 24;

/// Data of a model.
#[derive(Clone, Copy, Debug)]
struct Sheet {
    number: i64,
    /// Last position, at the end of the travel.
    last: i64,
    /// Travel from 0 to the last position, deg.
    travel: f64,
    /// Unit of speeds, rev/min.
    speed_unit: f64,
    /// Speed without load, rev/min.
    top_speed: f64,
    temperature_limit: i64,
    max_voltage: i64,
    max_torque: i64,
    /// It has a multi-turn mode.
    is_mx: bool,
}

const AX_12A: Sheet = Sheet {
    number: 12,
    last: 1023,
    travel: 300.0,
    speed_unit: 0.111,
    top_speed: 59.0,
    temperature_limit: 70,
    max_voltage: 140,
    max_torque: 1023,
    is_mx: false,
};

const MX_28: Sheet = Sheet {
    number: 29,
    last: 4095,
    travel: 360.0 * 4095.0 / 4096.0,
    speed_unit: 0.114,
    top_speed: 55.0,
    temperature_limit: 80,
    max_voltage: 160,
    max_torque: 1023,
    is_mx: true,
};

impl Sheet {
    fn of(model: &str) -> Option<Self> {
        Some(match model {
            "AX-12" => AX_12A,
            "AX-18" => Sheet {
                number: 18,
                top_speed: 97.0,
                temperature_limit: 75,
                max_torque: 983,
                ..AX_12A
            },
            "MX-28" => MX_28,
            "MX-64" => Sheet {
                number: 310,
                top_speed: 63.0,
                ..MX_28
            },
            "MX-106" => Sheet {
                number: 320,
                top_speed: 45.0,
                ..MX_28
            },
            _ => return None,
        })
    }

    fn table(&self) -> Table {
        let last = self.last;
        let mut items: Vec<Item> = vec![
            read_only(at::MODEL, 2, self.number),
            read_only(2, 1, 24),
            writable(at::ID, 1, 1, 0, 253),
            writable(4, 1, 1, 0, 254),
            writable(at::RETURN_DELAY, 1, 250, 0, 254),
            writable(at::CW_LIMIT, 2, 0, 0, last),
            writable(at::CCW_LIMIT, 2, last, 0, last),
            writable(at::TEMPERATURE_LIMIT, 1, self.temperature_limit, 0, 150),
            writable(at::MIN_VOLTAGE, 1, 60, 50, 250),
            writable(at::MAX_VOLTAGE, 1, self.max_voltage, 50, 250),
            writable(at::MAX_TORQUE, 2, self.max_torque, 0, 1023),
            writable(at::STATUS_RETURN_LEVEL, 1, 2, 0, 2),
            writable(17, 1, 36, 0, 127),
            writable(at::SHUTDOWN, 1, 36, 0, 127),
            writable(at::TORQUE_ENABLE, 1, 0, 0, 1),
            writable(25, 1, 0, 0, 1),
            writable(26, 1, 1, 0, 254),
            writable(27, 1, 1, 0, 254),
            writable(28, 1, 32, 0, 254),
            writable(29, 1, 32, 0, 254),
            writable(at::SPEED, 2, 0, 0, 2047),
            writable(at::TORQUE_LIMIT, 2, self.max_torque, 0, 1023),
            read_only(at::PRESENT_SPEED, 2, 0),
            read_only(at::LOAD, 2, 0),
            read_only(at::VOLTAGE, 1, 0),
            read_only(at::TEMPERATURE, 1, 0),
            read_only(44, 1, 0),
            read_only(at::MOVING, 1, 0),
            writable(at::LOCK, 1, 0, 0, 1),
            writable(48, 2, 32, 0, 1023),
        ];
        // "Multi-turn mode: -28,672 ~ 28,672", in two's complement.
        match self.is_mx {
            true => items.extend([
                writable(20, 2, 0, -24_576, 24_576).coded(Coding::Signed),
                writable(22, 1, 1, 1, 4),
                writable(at::GOAL, 2, 0, -28_672, 28_672).coded(Coding::Signed),
                read_only(at::POSITION, 2, 0).coded(Coding::Signed),
                writable(73, 1, 0, 0, 254),
            ]),
            false => items.extend([
                writable(at::GOAL, 2, 0, 0, last),
                read_only(at::POSITION, 2, 0),
            ]),
        }
        Table::new(items, RAM)
    }
}

/// The firmware of an AX or MX servo.
#[derive(Clone, Debug)]
pub(super) struct AxMx {
    sheet: Sheet,
    table: Table,
}

/// The three modes that the angle limits choose.
#[derive(Clone, Copy, PartialEq)]
enum Mode {
    Joint,
    Wheel,
    MultiTurn,
}

impl AxMx {
    /// Creates the firmware of a model, and returns its top speed, deg/s, and the voltage of its supply.
    pub(super) fn of(model: &str, id: u8) -> Option<(Box<dyn Firmware + Send + Sync>, f64, f64)> {
        let sheet = Sheet::of(model)?;
        let mut table = sheet.table();
        table.set(at::ID, id.into());
        // As the guide to wiring tells users to write it.
        table.set(at::RETURN_DELAY, 0);
        table.save();
        let top_speed = sheet.top_speed * 6.0;
        Some((Box::new(AxMx { sheet, table }), top_speed, 12.0))
    }

    fn mode(&self) -> Mode {
        match (self.table.get(at::CW_LIMIT), self.table.get(at::CCW_LIMIT)) {
            (0, 0) => Mode::Wheel,
            (4095, 4095) if self.sheet.is_mx => Mode::MultiTurn,
            _ => Mode::Joint,
        }
    }

    fn degree(&self) -> f64 {
        self.sheet.last as f64 / self.sheet.travel
    }

    /// Returns the middle of the travel, counts: 150° of an AX, 180° (2048) of an MX.
    fn middle(&self) -> f64 {
        match self.sheet.is_mx {
            true => 2048.0,
            false => self.sheet.last as f64 / 2.0,
        }
    }

    fn refuses(&self, values: &[(Item, i64)]) -> u8 {
        let is_locked = self.table.get(at::LOCK) == 1 || self.table.get(at::TORQUE_ENABLE) == 1;
        for (item, value) in values {
            let (min, max) = item.range.unwrap_or_default();
            if self.table.is_kept(item.address) && is_locked {
                return error::RANGE;
            }
            let is_joint_goal = item.address == at::GOAL && self.mode() == Mode::Joint;
            let limits = self.table.get(at::CW_LIMIT)..=self.table.get(at::CCW_LIMIT);
            if is_joint_goal && !limits.contains(value) {
                return error::ANGLE_LIMIT;
            }
            if !(min..=max).contains(value) {
                return error::RANGE;
            }
        }
        0
    }
}

impl Firmware for AxMx {
    fn wire(&self) -> Wire {
        Wire::Dynamixel1
    }

    fn id(&self) -> u8 {
        self.table.get(at::ID) as u8
    }

    fn counts(&self, angle: f64) -> f64 {
        angle * self.degree() + self.middle()
    }

    fn angle(&self, counts: f64) -> f64 {
        (counts - self.middle()) / self.degree()
    }

    fn power_on(&mut self, shaft: &Shaft) {
        self.table.power_on();
        let max_torque = self.table.get(at::MAX_TORQUE);
        self.table.set(at::TORQUE_LIMIT, max_torque);
        let here = libm::round(self.counts(shaft.angle)) as i64;
        self.table.set(at::GOAL, here.clamp(0, self.sheet.last));
    }

    fn sense(&mut self, shaft: &Shaft, _now: u64) {
        let counts = libm::round(self.counts(shaft.angle)) as i64;
        let position = match self.mode() {
            Mode::MultiTurn => counts,
            _ => counts.clamp(0, self.sheet.last),
        };
        // Bit 10 is the direction: set clockwise, which is downwards.
        let directed = |value: f64| {
            let magnitude = (libm::round(value.abs()) as i64).min(1023);
            magnitude | i64::from(value < 0.0) << 10
        };
        let speed = shaft.velocity / 6.0 / self.sheet.speed_unit;
        self.table.set(at::POSITION, position);
        self.table.set(at::PRESENT_SPEED, directed(speed));
        self.table.set(at::LOAD, directed(shaft.load * 1000.0));
        self.table.set(at::VOLTAGE, (shaft.voltage * 10.0) as i64);
        self.table.set(at::TEMPERATURE, shaft.temperature as i64);
        self.table
            .set(at::MOVING, i64::from(shaft.velocity.abs() > 1.0));
        // "Alarm Shutdown: the motor output becomes 0 % by making the value of Torque Limit as 0."
        if self.alarm() & self.table.get(at::SHUTDOWN) as u8 != 0 {
            self.table.set(at::TORQUE_LIMIT, 0);
        }
    }

    fn drive(&self) -> Drive {
        let units = self.table.get(at::SPEED);
        if !self.has_torque() {
            return Drive::Free;
        }
        if self.mode() == Mode::Wheel {
            // AX: "the unit is about 0.1 % of the maximum output"; bit 10 is the direction.
            let share = (units & 1023) as f64 / 1023.0;
            let sign = if units & 1024 == 0 { 1.0 } else { -1.0 };
            return Drive::Spin(sign * share * self.sheet.top_speed * 6.0);
        }
        Drive::To {
            goal: self.angle(self.goal()),
            speed: match units & 1023 {
                0 => f64::INFINITY,
                units => units as f64 * self.sheet.speed_unit * 6.0,
            },
            torque: self.torque_limit(),
        }
    }

    fn has_torque(&self) -> bool {
        self.table.get(at::TORQUE_ENABLE) == 1
    }

    fn goal(&self) -> f64 {
        self.table.get(at::GOAL) as f64
    }

    fn torque_limit(&self) -> f64 {
        self.table.get(at::TORQUE_LIMIT) as f64 / 1023.0
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

impl Registers for AxMx {
    fn read(&self, start: u16, length: u16) -> Reply {
        match self.table.bytes(start, length) {
            Some(bytes) => Reply {
                error: 0,
                parameters: bytes.to_vec(),
            },
            None => Reply::error(error::RANGE),
        }
    }

    fn write(&mut self, start: u16, bytes: &[u8]) -> Reply {
        let values = match self.table.parse(start, bytes) {
            Ok(values) => values,
            Err(Refusal::Access | Refusal::Length) => return Reply::error(error::RANGE),
        };
        let refused = self.refuses(&values);
        if refused == 0 {
            for (item, value) in values {
                self.table.set(item.address, value);
                if item.address == at::GOAL {
                    self.table.set(at::TORQUE_ENABLE, 1);
                }
            }
            self.table.save();
        }
        Reply::error(refused)
    }

    fn ping(&self) -> Vec<u8> {
        Vec::new()
    }

    fn alarm(&self) -> u8 {
        let is_hot = self.table.get(at::TEMPERATURE) > self.table.get(at::TEMPERATURE_LIMIT);
        let allowed = self.table.get(at::MIN_VOLTAGE)..=self.table.get(at::MAX_VOLTAGE);
        let is_wrong_supply = !allowed.contains(&self.table.get(at::VOLTAGE));
        u8::from(is_hot) * error::OVERHEATING + u8::from(is_wrong_supply) * error::VOLTAGE
    }

    fn return_delay(&self) -> u64 {
        self.table.get(at::RETURN_DELAY) as u64 * 2
    }

    fn answers(&self) -> (bool, bool) {
        let level = self.table.get(at::STATUS_RETURN_LEVEL);
        (level >= 1, level >= 2)
    }

    fn instruction_error(&self) -> u8 {
        error::INSTRUCTION
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
