//! mjbots moteus.
//!
//! Sources: mjbots, moteus documentation: "CAN Protocol" (CAN ID, subframes, the example); "Register Reference" (mappings, 0x000
//! Mode, 0x001 to 0x00f, 0x020 to 0x028, 0x110 Multiplex ID); "Configurable values" (`servo.default_timeout_s`,
//! `servo.timeout_mode`); "moteus reports mode 11 - Timeout". Lines of an fdcanusb are those of `wire`.

use super::firmware::{Drive, Firmware, Shaft};
use super::wire::Wire;
use std::boxed::Box;
use std::vec::Vec;

/// Registers.
mod at {
    pub(super) const MODE: u32 = 0x000;
    pub(super) const POSITION: u32 = 0x001;
    pub(super) const VELOCITY: u32 = 0x002;
    pub(super) const TORQUE: u32 = 0x003;
    pub(super) const HOME_STATE: u32 = 0x00C;
    pub(super) const VOLTAGE: u32 = 0x00D;
    pub(super) const TEMPERATURE: u32 = 0x00E;
    pub(super) const FAULT: u32 = 0x00F;
    pub(super) const COMMAND_POSITION: u32 = 0x020;
    pub(super) const COMMAND_VELOCITY: u32 = 0x021;
    pub(super) const FEEDFORWARD: u32 = 0x022;
    pub(super) const MAX_TORQUE: u32 = 0x025;
    pub(super) const TIMEOUT: u32 = 0x027;
    pub(super) const VELOCITY_LIMIT: u32 = 0x028;
    pub(super) const MODEL: u32 = 0x100;
    pub(super) const REGISTER_MAP: u32 = 0x102;
    pub(super) const MULTIPLEX_ID: u32 = 0x110;
}

/// Values of register 0x000.
mod mode {
    pub(super) const STOPPED: u8 = 0;
    pub(super) const FAULT: u8 = 1;
    pub(super) const POSITION: u8 = 10;
    pub(super) const TIMEOUT: u8 = 11;
    pub(super) const BRAKE: u8 = 15;
}

/// Fault code 38: over temperature.
const OVER_TEMPERATURE: f64 = 38.0;
/// The default of `servo.fault_temperature`, °C.
const FAULT_TEMPERATURE: f64 = 75.0;
/// The default of `servo.default_timeout_s`.
const DEFAULT_TIMEOUT: f64 = 0.1;
/// Counts of a turn, and those at the middle of ten turns.
const TURN: f64 = 100_000.0;
const MIDDLE: f64 = 500_000.0;

/// Returns the units of a register's numbers of 8, 16 and 32 bits ("Mappings").
const fn units(register: u32) -> [f64; 3] {
    match register {
        at::POSITION | at::COMMAND_POSITION => [0.01, 0.0001, 0.000_01],
        at::VELOCITY | at::COMMAND_VELOCITY | at::VELOCITY_LIMIT => [0.1, 0.000_25, 0.000_01],
        at::TORQUE | at::FEEDFORWARD | at::MAX_TORQUE => [0.5, 0.01, 0.001],
        at::VOLTAGE => [0.5, 0.1, 0.001],
        at::TEMPERATURE => [1.0, 0.1, 0.001],
        at::TIMEOUT => [0.01, 0.001, 0.000_001],
        _ => [1.0; 3],
    }
}

/// A command in position mode. What a frame does not state has its default.
#[derive(Clone, Copy, Debug)]
struct Command {
    /// Turns; NaN for the present position.
    position: f64,
    /// Nm; NaN for no limit but that of the controller.
    max_torque: f64,
    /// s; NaN for none, 0 for the default.
    timeout: f64,
    /// Turns/s; negative or NaN for none.
    velocity_limit: f64,
}

impl Command {
    const UNSPECIFIED: Command = Command {
        position: 0.0,
        max_torque: f64::NAN,
        timeout: 0.0,
        velocity_limit: f64::NAN,
    };
}

/// The firmware of a moteus.
#[derive(Clone, Debug)]
pub(super) struct Moteus {
    id: u8,
    /// Register 0x00c: 0 relative, 1 rotor, 2 output.
    home: u8,
    /// Torque that the motor can have, Nm.
    stall: f64,
    mode: u8,
    fault: f64,
    command: Command,
    /// Time of the last command, µs.
    commanded: u64,
    /// True if the last answer holds the position.
    tells_position: bool,
}

/// Bytes of a payload, from the front.
struct Bytes<'a>(&'a [u8]);

impl Bytes<'_> {
    fn byte(&mut self) -> Option<u8> {
        let (first, rest) = self.0.split_first()?;
        self.0 = rest;
        Some(*first)
    }

    fn varuint(&mut self) -> Option<u32> {
        let mut value = 0;
        for shift in [0, 7, 14, 21, 28] {
            let byte = self.byte()?;
            value |= u32::from(byte & 0x7F) << shift;
            if byte & 0x80 == 0 {
                return Some(value);
            }
        }
        None
    }

    /// Reads a number: 0 to 2 are integers of 1, 2 and 4 bytes, 3 is a float. The most negative integer is NaN.
    fn number(&mut self, kind: u8, units: [f64; 3]) -> Option<f64> {
        let width = [1, 2, 4, 4][usize::from(kind)];
        let mut bytes = [0; 4];
        for byte in bytes.iter_mut().take(width) {
            *byte = self.byte()?;
        }
        if kind == 3 {
            return Some(f32::from_le_bytes(bytes).into());
        }
        let shift = 32 - 8 * width as u32;
        let raw = i32::from_le_bytes(bytes) << shift >> shift;
        let lowest = i32::MIN >> shift;
        match raw == lowest {
            true => Some(f64::NAN),
            false => Some(f64::from(raw) * units[usize::from(kind)]),
        }
    }
}

fn put_varuint(to: &mut Vec<u8>, mut value: u32) {
    while value > 0x7F {
        to.push(value as u8 | 0x80);
        value >>= 7;
    }
    to.push(value as u8);
}

impl Moteus {
    /// Creates the firmware of a model, and returns its top speed, deg/s, and the voltage of its supply.
    pub(super) fn of(model: &str, id: u8) -> Option<(Box<dyn Firmware + Send + Sync>, f64, f64)> {
        // Peak torque, Nm, and speed, deg/s, of the motor: mj5208 (1.7 Nm), qdd100 (16 Nm, 3600 deg/s).
        let (stall, top_speed) = match model {
            "moteus-mj5208" => (1.7, 36_000.0),
            "moteus-qdd100" => (16.0, 3600.0),
            _ => return None,
        };
        let moteus = Moteus {
            id,
            // Its position is that of an encoder at the output.
            home: 2,
            stall,
            mode: mode::STOPPED,
            fault: 0.0,
            command: Command::UNSPECIFIED,
            commanded: 0,
            tells_position: false,
        };
        Some((Box::new(moteus), top_speed, 12.0))
    }

    fn read(&self, register: u32, shaft: &Shaft) -> f64 {
        match register {
            at::MODE => self.mode.into(),
            at::POSITION => shaft.angle / 360.0,
            at::VELOCITY => shaft.velocity / 360.0,
            at::TORQUE => shaft.load * self.stall,
            at::HOME_STATE => self.home.into(),
            at::VOLTAGE => shaft.voltage,
            at::TEMPERATURE => shaft.temperature,
            at::FAULT => self.fault,
            at::COMMAND_POSITION => self.command.position,
            at::MAX_TORQUE => self.command.max_torque,
            at::TIMEOUT => self.command.timeout,
            at::VELOCITY_LIMIT => self.command.velocity_limit,
            at::MODEL => 0.0,
            at::REGISTER_MAP => 5.0,
            at::MULTIPLEX_ID => self.id.into(),
            _ => 0.0,
        }
    }

    /// Reads the subframe that follows its first byte.
    fn subframe(
        &mut self,
        first: u8,
        bytes: &mut Bytes<'_>,
        shaft: &Shaft,
        new: &mut Option<(u8, Command)>,
        answer: &mut Vec<u8>,
    ) -> Option<()> {
        let kind = first >> 2 & 3;
        let count = match first & 3 {
            0 => bytes.varuint()?,
            count => count.into(),
        };
        let start = bytes.varuint()?;
        if first & 0xF0 == 0x10 {
            answer.push(0x20 | kind << 2 | if count < 4 { count as u8 } else { 0 });
            if count >= 4 {
                put_varuint(answer, count);
            }
            put_varuint(answer, start);
        }
        for register in start..start.checked_add(count)? {
            let units = units(register);
            if first & 0xF0 == 0x10 {
                let value = self.read(register, shaft);
                self.tells_position |= register == at::POSITION;
                if kind == 3 {
                    answer.extend((value as f32).to_le_bytes());
                    continue;
                }
                let width = [1, 2, 4][usize::from(kind)];
                let most = (1_i64 << (8 * width - 1)) - 1;
                let raw = libm::round(value / units[usize::from(kind)]) as i64;
                let raw = if value.is_nan() {
                    -most - 1
                } else {
                    raw.clamp(-most, most)
                };
                answer.extend(&raw.to_le_bytes()[..width]);
                continue;
            }
            let value = bytes.number(kind, units)?;
            // "This register must be written before any other registers."
            match (register, new.as_mut()) {
                (at::MODE, _) => *new = Some((value as u8, Command::UNSPECIFIED)),
                (at::COMMAND_POSITION, Some((_, command))) => command.position = value,
                (at::MAX_TORQUE, Some((_, command))) => command.max_torque = value,
                (at::TIMEOUT, Some((_, command))) => command.timeout = value,
                (at::VELOCITY_LIMIT, Some((_, command))) => command.velocity_limit = value,
                _ => {}
            }
        }
        Some(())
    }
}

impl Firmware for Moteus {
    fn wire(&self) -> Wire {
        Wire::Fdcanusb
    }

    fn id(&self) -> u8 {
        self.id
    }

    fn counts(&self, angle: f64) -> f64 {
        angle / 360.0 * TURN + MIDDLE
    }

    fn angle(&self, counts: f64) -> f64 {
        (counts - MIDDLE) / TURN * 360.0
    }

    fn power_on(&mut self, _shaft: &Shaft) {
        (self.mode, self.fault) = (mode::STOPPED, 0.0);
        self.command = Command::UNSPECIFIED;
    }

    fn sense(&mut self, shaft: &Shaft, now: u64) {
        let timeout = match self.command.timeout {
            0.0 => DEFAULT_TIMEOUT,
            timeout => timeout,
        };
        let silence = now.saturating_sub(self.commanded) as f64 / 1e6;
        if self.mode == mode::POSITION && silence > timeout {
            self.mode = mode::TIMEOUT;
        }
        if shaft.temperature > FAULT_TEMPERATURE && self.mode != mode::STOPPED {
            (self.mode, self.fault) = (mode::FAULT, OVER_TEMPERATURE);
        }
    }

    fn drive(&self) -> Drive {
        match self.mode {
            mode::POSITION => Drive::To {
                goal: match self.command.position.is_nan() {
                    true => return Drive::Damped,
                    false => self.command.position * 360.0,
                },
                speed: match self.command.velocity_limit {
                    limit if limit >= 0.0 => limit * 360.0,
                    _ => f64::INFINITY,
                },
                torque: self.torque_limit(),
            },
            // `servo.timeout_mode` 12, its default: no velocity, and no angle.
            mode::TIMEOUT | mode::BRAKE => Drive::Damped,
            _ => Drive::Free,
        }
    }

    fn has_torque(&self) -> bool {
        self.mode == mode::POSITION
    }

    fn goal(&self) -> f64 {
        self.counts(self.command.position * 360.0)
    }

    fn torque_limit(&self) -> f64 {
        match self.command.max_torque.is_nan() {
            true => 1.0,
            false => (self.command.max_torque / self.stall).min(1.0),
        }
    }

    fn copy(&self) -> Box<dyn Firmware + Send + Sync> {
        Box::new(self.clone())
    }

    fn mode(&self) -> Option<u8> {
        Some(self.mode)
    }

    fn preset(&mut self, address: u16, value: i64) {
        assert_eq!(u32::from(address), at::HOME_STATE, "a setting");
        self.home = value as u8;
    }

    fn tells_position(&self, _code: u8, _answer: &[u8]) -> bool {
        self.tells_position
    }

    fn serve(&mut self, _code: u8, payload: &[u8], shaft: &Shaft, now: u64) -> Option<Vec<u8>> {
        self.tells_position = false;
        let (mut new, mut answer) = (None, Vec::new());
        let mut bytes = Bytes(payload);
        while let Some(first) = bytes.byte() {
            let is_known = matches!(first & 0xF0, 0x00 | 0x10);
            // 0x50 fills frames up.
            if first != 0x50
                && (!is_known
                    || self
                        .subframe(first, &mut bytes, shaft, &mut new, &mut answer)
                        .is_none())
            {
                break;
            }
        }
        let is_latched = matches!(self.mode, mode::TIMEOUT | mode::FAULT);
        match new {
            Some((mode::STOPPED, _)) => (self.mode, self.fault) = (mode::STOPPED, 0.0),
            // Only a stop ends a time-out or a fault.
            Some((mode, command)) if !is_latched => {
                let position = match command.position.is_nan() {
                    true => shaft.angle / 360.0,
                    false => command.position,
                };
                (self.mode, self.command) = (
                    mode,
                    Command {
                        position,
                        ..command
                    },
                );
                self.commanded = now;
            }
            _ => {}
        }
        Some(answer)
    }
}
