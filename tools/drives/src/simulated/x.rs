//! Dynamixel X.
//!
//! Sources: ROBOTIS e-Manual, "XL430-W250", "2XL430-W250", "XL330-M288", "XM430-W210", "XM430-W350" and "XM540-W270", sections
//! "Specifications", "Control Table of EEPROM Area", "Control Table of RAM Area" and "Control Table Description", there "Drive
//! Mode(10)", "Homing Offset(20)", "Min/Max Position Limit(48, 52)", "Shutdown(63)", "Torque Enable(64)", "Bus Watchdog(98)"; and
//! "DYNAMIXEL Protocol 2.0", section "Error".

use super::firmware::{Drive, Firmware, Registers, Reply, Shaft};
use super::table::{Coding, Item, Refusal, Table, read_only, writable};
use super::wire::Wire;
use std::boxed::Box;
use std::vec;
use std::vec::Vec;

/// "Control Table": model number, EEPROM and RAM.
mod at {
    pub(super) const MODEL: u16 = 0;
    pub(super) const FIRMWARE: u16 = 6;
    pub(super) const ID: u16 = 7;
    pub(super) const RETURN_DELAY: u16 = 9;
    pub(super) const DRIVE_MODE: u16 = 10;
    pub(super) const OPERATING_MODE: u16 = 11;
    pub(super) const HOMING_OFFSET: u16 = 20;
    pub(super) const TEMPERATURE_LIMIT: u16 = 31;
    pub(super) const MAX_VOLTAGE: u16 = 32;
    pub(super) const MIN_VOLTAGE: u16 = 34;
    pub(super) const PWM_LIMIT: u16 = 36;
    pub(super) const CURRENT_LIMIT: u16 = 38;
    pub(super) const MAX_POSITION: u16 = 48;
    pub(super) const MIN_POSITION: u16 = 52;
    pub(super) const SHUTDOWN: u16 = 63;
    pub(super) const TORQUE_ENABLE: u16 = 64;
    pub(super) const STATUS_RETURN_LEVEL: u16 = 68;
    pub(super) const HARDWARE_ERROR: u16 = 70;
    pub(super) const BUS_WATCHDOG: u16 = 98;
    pub(super) const GOAL_PWM: u16 = 100;
    pub(super) const GOAL_CURRENT: u16 = 102;
    pub(super) const GOAL_VELOCITY: u16 = 104;
    pub(super) const PROFILE_VELOCITY: u16 = 112;
    pub(super) const GOAL: u16 = 116;
    pub(super) const MOVING: u16 = 122;
    pub(super) const PRESENT_PWM: u16 = 124;
    pub(super) const LOAD: u16 = 126;
    pub(super) const PRESENT_VELOCITY: u16 = 128;
    pub(super) const POSITION: u16 = 132;
    pub(super) const VOLTAGE: u16 = 144;
    pub(super) const TEMPERATURE: u16 = 146;
}

/// Numbers in the error byte.
mod error {
    pub(super) const RESULT_FAIL: u8 = 1;
    pub(super) const INSTRUCTION: u8 = 2;
    pub(super) const DATA_RANGE: u8 = 4;
    pub(super) const DATA_LENGTH: u8 = 5;
    pub(super) const DATA_LIMIT: u8 = 6;
    pub(super) const ACCESS: u8 = 7;
    /// There has been a problem with the hardware.
    pub(super) const ALERT: u8 = 0x80;
}

/// Bits of "Hardware Error Status(70)" and "Shutdown(63)".
mod hardware {
    pub(super) const VOLTAGE: i64 = 1 << 0;
    pub(super) const OVERHEATING: i64 = 1 << 2;
}

/// First address of the RAM.
const RAM: u16 = 64;
/// Pulses of a turn.
const TURN: f64 = 4096.0;
/// Unit of velocities, rev/min.
const VELOCITY_UNIT: f64 = 0.229;
/// "Bus Watchdog(98)": the unit, µs, and the value after a time-out.
const WATCHDOG_UNIT: u64 = 20_000;
const WATCHDOG_ERROR: i64 = -1;

/// Data of a model.
#[derive(Clone, Copy, Debug)]
struct Sheet {
    number: i64,
    /// Speed without load, rev/min, at `voltage`.
    top_speed: f64,
    voltage: f64,
    temperature_limit: i64,
    /// 0.1 V
    voltages: (i64, i64),
    shutdown: i64,
    velocity_limit: i64,
    /// "Current Limit(38)" of models that measure the current, and the reading at stall.
    current: Option<(i64, f64)>,
}

const XL430: Sheet = Sheet {
    number: 1060,
    top_speed: 61.0,
    voltage: 12.0,
    temperature_limit: 72,
    voltages: (60, 140),
    shutdown: 52,
    velocity_limit: 265,
    current: None,
};

impl Sheet {
    fn of(model: &str) -> Option<Self> {
        Some(match model {
            "XL430-W250" => XL430,
            "2XL430-W250" => Sheet {
                number: 1090,
                ..XL430
            },
            // 1.47 A at 5 V, in 1 mA.
            "XL330-M288" => Sheet {
                number: 1200,
                top_speed: 103.0,
                voltage: 5.0,
                temperature_limit: 70,
                voltages: (35, 70),
                shutdown: 53,
                velocity_limit: 445,
                current: Some((1750, 1470.0)),
            },
            // 2.3 A at 12 V, in 2.69 mA.
            "XM430-W210" => Sheet {
                number: 1030,
                top_speed: 77.0,
                temperature_limit: 80,
                voltages: (95, 160),
                velocity_limit: 330,
                current: Some((1193, 855.0)),
                ..XL430
            },
            "XM430-W350" => Sheet {
                number: 1020,
                top_speed: 46.0,
                temperature_limit: 80,
                voltages: (95, 160),
                velocity_limit: 200,
                current: Some((1193, 855.0)),
                ..XL430
            },
            // 4.4 A at 12 V, in 2.69 mA.
            "XM540-W270" => Sheet {
                number: 1120,
                top_speed: 30.0,
                temperature_limit: 80,
                voltages: (95, 160),
                velocity_limit: 128,
                current: Some((2047, 1636.0)),
                ..XL430
            },
            _ => return None,
        })
    }

    fn table(&self) -> Table {
        let signed = |item: Item| item.coded(Coding::Signed);
        let (min_voltage, max_voltage) = self.voltages;
        let velocity = self.velocity_limit;
        let mut items: Vec<Item> = vec![
            read_only(at::MODEL, 2, self.number),
            read_only(2, 4, 0),
            read_only(at::FIRMWARE, 1, 45),
            writable(at::ID, 1, 1, 0, 252),
            writable(8, 1, 1, 0, 7),
            writable(at::RETURN_DELAY, 1, 250, 0, 254),
            writable(at::DRIVE_MODE, 1, 0, 0, 13),
            writable(at::OPERATING_MODE, 1, 3, 0, 16),
            writable(12, 1, 255, 0, 255),
            writable(13, 1, 2, 1, 2),
            signed(writable(at::HOMING_OFFSET, 4, 0, -1_044_479, 1_044_479)),
            writable(24, 4, 10, 0, 1023),
            writable(at::TEMPERATURE_LIMIT, 1, self.temperature_limit, 0, 100),
            writable(at::MAX_VOLTAGE, 2, max_voltage, min_voltage, max_voltage),
            writable(at::MIN_VOLTAGE, 2, min_voltage, min_voltage, max_voltage),
            writable(at::PWM_LIMIT, 2, 885, 0, 885),
            writable(44, 4, velocity, 0, 2047),
            writable(at::MAX_POSITION, 4, 4095, 0, 4095),
            writable(at::MIN_POSITION, 4, 0, 0, 4095),
            writable(60, 1, 0, 0, 3),
            writable(at::SHUTDOWN, 1, self.shutdown, 0, 63),
            writable(at::TORQUE_ENABLE, 1, 0, 0, 1),
            writable(65, 1, 0, 0, 1),
            writable(at::STATUS_RETURN_LEVEL, 1, 2, 0, 2),
            read_only(69, 1, 0),
            read_only(at::HARDWARE_ERROR, 1, 0),
            writable(76, 2, 1000, 0, 16_383),
            writable(78, 2, 100, 0, 16_383),
            writable(80, 2, 4000, 0, 16_383),
            writable(82, 2, 0, 0, 16_383),
            writable(84, 2, 640, 0, 16_383),
            writable(88, 2, 0, 0, 16_383),
            writable(90, 2, 0, 0, 16_383),
            signed(writable(at::BUS_WATCHDOG, 1, 0, 0, 127)),
            signed(writable(at::GOAL_PWM, 2, 885, -885, 885)),
            signed(writable(at::GOAL_VELOCITY, 4, 0, -velocity, velocity)),
            writable(108, 4, 0, 0, 32_767),
            writable(at::PROFILE_VELOCITY, 4, 0, 0, 32_767),
            signed(writable(at::GOAL, 4, 0, -1_048_575, 1_048_575)),
            read_only(120, 2, 0),
            read_only(at::MOVING, 1, 0),
            read_only(123, 1, 0),
            signed(read_only(at::PRESENT_PWM, 2, 0)),
            signed(read_only(at::LOAD, 2, 0)),
            signed(read_only(at::PRESENT_VELOCITY, 4, 0)),
            signed(read_only(at::POSITION, 4, 0)),
            signed(read_only(136, 4, 0)),
            signed(read_only(140, 4, 0)),
            read_only(at::VOLTAGE, 2, 0),
            read_only(at::TEMPERATURE, 1, 0),
            read_only(147, 1, 0),
        ];
        if let Some((limit, _)) = self.current {
            items.extend([
                writable(at::CURRENT_LIMIT, 2, limit, 0, limit),
                signed(writable(at::GOAL_CURRENT, 2, limit, -limit, limit)),
            ]);
        }
        Table::new(items, RAM)
    }
}

/// The firmware of an X servo.
#[derive(Clone, Debug)]
pub(super) struct X {
    sheet: Sheet,
    table: Table,
    /// Time of the last instruction, µs.
    heard: u64,
    /// The last angle of the shaft, deg.
    angle: f64,
    /// Distance to the goal when it was written, deg.
    distance: f64,
    /// After a shutdown nothing but a reboot switches the torque on.
    is_shut_down: bool,
}

impl X {
    /// Creates the firmware of a model, and returns its top speed, deg/s, and the voltage of its supply.
    pub(super) fn of(model: &str, id: u8) -> Option<(Box<dyn Firmware + Send + Sync>, f64, f64)> {
        let sheet = Sheet::of(model)?;
        let mut table = sheet.table();
        table.set(at::ID, id.into());
        // As the guide to wiring tells users to write it.
        table.set(at::RETURN_DELAY, 0);
        table.save();
        let x = X {
            sheet,
            table,
            heard: 0,
            angle: 0.0,
            distance: 0.0,
            is_shut_down: false,
        };
        Some((Box::new(x), sheet.top_speed * 6.0, sheet.voltage))
    }

    fn is_in_position_mode(&self) -> bool {
        self.table.get(at::OPERATING_MODE) == 3
    }

    /// Returns true if "Drive Mode(10)" inverts the direction.
    fn is_reverse(&self) -> bool {
        self.table.get(at::DRIVE_MODE) & 1 != 0
    }

    /// Returns the offset that is added to the position. In the position mode, values beyond a quarter of a turn are ignored.
    fn offset(&self) -> f64 {
        let offset = self.table.get(at::HOMING_OFFSET);
        match self.is_in_position_mode() && !(-1024..=1024).contains(&offset) {
            true => 0.0,
            false => offset as f64,
        }
    }

    fn here(&self) -> i64 {
        libm::round(self.counts(self.angle)) as i64
    }

    fn is_timed_out(&self) -> bool {
        self.table.get(at::BUS_WATCHDOG) == WATCHDOG_ERROR
    }

    fn refuses(&self, values: &[(Item, i64)]) -> u8 {
        for (item, value) in values {
            let (min, max) = item.range.unwrap_or_default();
            if self.table.is_kept(item.address) && self.has_torque() {
                return error::ACCESS;
            }
            if !(min..=max).contains(value) {
                return error::DATA_RANGE;
            }
            let is_goal = matches!(
                item.address,
                at::GOAL_PWM | at::GOAL_CURRENT | at::GOAL_VELOCITY | at::GOAL
            );
            if is_goal && self.is_timed_out() {
                return error::DATA_RANGE;
            }
            let limit = match item.address {
                at::GOAL if self.is_in_position_mode() => (
                    self.table.get(at::MIN_POSITION),
                    self.table.get(at::MAX_POSITION),
                ),
                at::GOAL_PWM => {
                    let limit = self.table.get(at::PWM_LIMIT);
                    (-limit, limit)
                }
                _ => (min, max),
            };
            if !(limit.0..=limit.1).contains(value) {
                return error::DATA_LIMIT;
            }
            if item.address == at::TORQUE_ENABLE && *value == 1 && self.is_shut_down {
                return error::RESULT_FAIL;
            }
        }
        0
    }
}

impl Firmware for X {
    fn wire(&self) -> Wire {
        Wire::Dynamixel2
    }

    fn id(&self) -> u8 {
        self.table.get(at::ID) as u8
    }

    fn counts(&self, angle: f64) -> f64 {
        let actual = angle * TURN / 360.0;
        let directed = if self.is_reverse() { -actual } else { actual };
        directed + TURN / 2.0 + self.offset()
    }

    fn angle(&self, counts: f64) -> f64 {
        let directed = (counts - self.offset() - TURN / 2.0) * 360.0 / TURN;
        if self.is_reverse() {
            -directed
        } else {
            directed
        }
    }

    fn power_on(&mut self, shaft: &Shaft) {
        self.table.power_on();
        let pwm = self.table.get(at::PWM_LIMIT);
        self.table.set(at::GOAL_PWM, pwm);
        self.angle = shaft.angle;
        self.is_shut_down = false;
        let here = self.here();
        self.table.set(at::GOAL, here);
    }

    fn sense(&mut self, shaft: &Shaft, now: u64) {
        self.angle = shaft.angle;
        let units = self.table.get(at::BUS_WATCHDOG);
        let silence = now.saturating_sub(self.heard);
        if self.has_torque() && units > 0 && silence > units as u64 * WATCHDOG_UNIT {
            self.table.set(at::BUS_WATCHDOG, WATCHDOG_ERROR);
            self.table.set(at::GOAL_VELOCITY, 0);
            let here = self.here();
            self.table.set(at::GOAL, here);
        }
        let sign = if self.is_reverse() { -1.0 } else { 1.0 };
        let load = match self.sheet.current {
            Some((_, stall)) => sign * shaft.load * stall,
            None => sign * shaft.load * 1000.0,
        };
        let velocity = sign * shaft.velocity / 6.0 / VELOCITY_UNIT;
        let position = self.here();
        for (address, value) in [
            (at::POSITION, position),
            (at::PRESENT_VELOCITY, libm::round(velocity) as i64),
            (at::LOAD, load as i64),
            (at::PRESENT_PWM, (sign * shaft.load * 885.0) as i64),
            (at::VOLTAGE, (shaft.voltage * 10.0) as i64),
            (at::TEMPERATURE, shaft.temperature as i64),
            (at::MOVING, i64::from(velocity.abs() > 10.0)),
        ] {
            self.table.set(address, value);
        }
        let volts = self.table.get(at::MIN_VOLTAGE)..=self.table.get(at::MAX_VOLTAGE);
        let mut errors = self.table.get(at::HARDWARE_ERROR);
        if self.table.get(at::TEMPERATURE) > self.table.get(at::TEMPERATURE_LIMIT) {
            errors |= hardware::OVERHEATING;
        }
        if !volts.contains(&self.table.get(at::VOLTAGE)) {
            errors |= hardware::VOLTAGE;
        }
        self.table.set(at::HARDWARE_ERROR, errors);
        if errors & self.table.get(at::SHUTDOWN) != 0 {
            self.is_shut_down = true;
            self.table.set(at::TORQUE_ENABLE, 0);
        }
    }

    fn hear(&mut self, now: u64) {
        self.heard = now;
    }

    fn drive(&self) -> Drive {
        if !self.has_torque() {
            return Drive::Free;
        }
        let sign = if self.is_reverse() { -1.0 } else { 1.0 };
        match self.table.get(at::OPERATING_MODE) {
            // Position, extended position, and current-based position.
            3..=5 => {
                let profile = self.table.get(at::PROFILE_VELOCITY) as f64;
                let is_timed = self.table.get(at::DRIVE_MODE) & 4 != 0;
                let speed = match is_timed {
                    _ if profile == 0.0 => f64::INFINITY,
                    // The profile takes this many ms.
                    true => self.distance / (profile / 1000.0),
                    false => profile * VELOCITY_UNIT * 6.0,
                };
                Drive::To {
                    goal: self.angle(self.goal()),
                    speed,
                    torque: self.torque_limit(),
                }
            }
            1 => {
                let units = self.table.get(at::GOAL_VELOCITY) as f64;
                Drive::Spin(sign * units * VELOCITY_UNIT * 6.0)
            }
            // Currents and voltages are not simulated.
            _ => Drive::Damped,
        }
    }

    fn has_torque(&self) -> bool {
        self.table.get(at::TORQUE_ENABLE) == 1
    }

    fn goal(&self) -> f64 {
        self.table.get(at::GOAL) as f64
    }

    fn torque_limit(&self) -> f64 {
        self.table.get(at::GOAL_PWM) as f64 / 885.0
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

impl Registers for X {
    fn read(&self, start: u16, length: u16) -> Reply {
        match self.table.bytes(start, length) {
            Some(bytes) => Reply {
                error: 0,
                parameters: bytes.to_vec(),
            },
            None => Reply::error(error::ACCESS),
        }
    }

    fn write(&mut self, start: u16, bytes: &[u8]) -> Reply {
        let values = match self.table.parse(start, bytes) {
            Ok(values) => values,
            Err(Refusal::Access) => return Reply::error(error::ACCESS),
            Err(Refusal::Length) => return Reply::error(error::DATA_LENGTH),
        };
        let refused = self.refuses(&values);
        if refused == 0 {
            for (item, value) in values {
                self.table.set(item.address, value);
                if item.address == at::GOAL {
                    self.distance = (self.angle(value as f64) - self.angle).abs();
                    // "Torque On by Goal Update".
                    if self.table.get(at::DRIVE_MODE) & 8 != 0 && !self.is_shut_down {
                        self.table.set(at::TORQUE_ENABLE, 1);
                    }
                }
            }
            self.table.save();
        }
        Reply::error(refused)
    }

    fn ping(&self) -> Vec<u8> {
        let model = self.table.bytes(at::MODEL, 2).unwrap_or_default();
        let firmware = self.table.bytes(at::FIRMWARE, 1).unwrap_or_default();
        [model, firmware].concat()
    }

    fn alarm(&self) -> u8 {
        match self.table.get(at::HARDWARE_ERROR) {
            0 => 0,
            _ => error::ALERT,
        }
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
