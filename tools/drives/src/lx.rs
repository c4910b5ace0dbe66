//! LewanSoul / Hiwonder LX and HTS servos: a bus of 115200 bit/s with one request per servo, and moves that carry a time.
//!
//! A servo reports its position, supply voltage, temperature and torque switch by a request each. It has no load, no torque limit,
//! no model number, no watchdog and no alarm in its answers. Writes are not confirmed; they are read back here.
//!
//! Source: "LewanSoul Bus Servo Communication Protocol" of the maker.

use crate::bus::{BusError, Timing, Wait, Wire};
use crate::family::Model;
use crate::family::{Family, Mismatch, Query, Reading, Setpoint};
use crate::frame::{Bytes, Frame, Parsed, checksum};

/// LX and HTS servos.
pub static LX: Lx = Lx;

/// The family of LX and HTS servos.
#[derive(Debug)]
pub struct Lx;

/// Numbers of commands. A request to read has no parameters, its answer has the same number.
pub mod command {
    /// Position and time: the servo moves.
    pub const MOVE_TIME_WRITE: u8 = 1;
    /// Position and time of the last move command.
    pub const MOVE_TIME_READ: u8 = 2;
    /// Identity.
    pub const ID_WRITE: u8 = 13;
    /// Identity.
    pub const ID_READ: u8 = 14;
    /// Deviation that is added to positions, signed, counts; command 18 keeps it without power.
    pub const ANGLE_OFFSET_ADJUST: u8 = 17;
    /// The same.
    pub const ANGLE_OFFSET_READ: u8 = 19;
    /// Smallest and largest position.
    pub const ANGLE_LIMIT_WRITE: u8 = 20;
    /// The same.
    pub const ANGLE_LIMIT_READ: u8 = 21;
    /// °C.
    pub const TEMP_READ: u8 = 26;
    /// mV.
    pub const VIN_READ: u8 = 27;
    /// Position, signed.
    pub const POS_READ: u8 = 28;
    /// 0 for positions, 1 for a motor; then its speed.
    pub const OR_MOTOR_MODE_WRITE: u8 = 29;
    /// The same.
    pub const OR_MOTOR_MODE_READ: u8 = 30;
    /// 1 for torque on.
    pub const LOAD_OR_UNLOAD_WRITE: u8 = 31;
    /// The same.
    pub const LOAD_OR_UNLOAD_READ: u8 = 32;
}

use command::*;

const HEADER: [u8; 2] = [0x55, 0x55];
/// Header, identity, length, command and checksum.
const FRAMING: usize = 6;
/// Delay of an answer that is allowed for, µs. No register states it.
const ANSWER_DELAY: u32 = 500;
/// Longest time of a move, ms.
const MAX_MOVE_TIME: f64 = 30_000.0;
/// Voltage, temperature and torque switch are asked for in turn, one with each of this many readings of the position.
const SLOW: u32 = 8;
const SLOW_VALUES: [u8; 3] = [VIN_READ, TEMP_READ, LOAD_OR_UNLOAD_READ];

/// Returns the bytes of a request.
pub fn request(id: u8, command: u8, parameters: &[u8]) -> Bytes {
    let mut frame = Bytes::new();
    let head = [
        HEADER[0],
        HEADER[1],
        id,
        parameters.len() as u8 + 3,
        command,
    ];
    // No command has more than four parameters.
    let _ = frame.extend_from_slice(&head);
    let _ = frame.extend_from_slice(parameters);
    let sum = checksum(&frame[HEADER.len()..]);
    let _ = frame.push(sum);
    frame
}

/// Tries to read the answer to a command, with this many parameters, at the beginning of `bytes`.
pub fn parse(bytes: &[u8], command: u8, parameters: usize) -> Parsed {
    let head = [
        Some(HEADER[0]),
        Some(HEADER[1]),
        None,
        u8::try_from(parameters + 3).ok(),
        Some(command),
    ];
    let mut pairs = bytes.iter().zip(head);
    if !pairs.all(|(byte, wanted)| wanted.is_none_or(|wanted| *byte == wanted)) {
        return Parsed::Nothing;
    }
    let length = parameters + FRAMING;
    let Some([_, _, body @ .., sum]) = bytes.get(..length) else {
        return Parsed::Unfinished;
    };
    let [id, _, code, parameters @ ..] = body else {
        return Parsed::Nothing;
    };
    match Bytes::from_slice(parameters) {
        Ok(parameters) if checksum(body) == *sum => {
            let (id, code) = (*id, *code);
            let frame = Frame {
                id,
                code,
                parameters,
            };
            Parsed::Frame(frame, length)
        }
        _ => Parsed::Nothing,
    }
}

/// Returns the position and the time of a move.
fn move_to(servo: &Setpoint) -> [u8; 4] {
    let [low, high] = (servo.position.clamp(0, i32::from(u16::MAX)) as u16).to_le_bytes();
    let time = libm::round(servo.period).clamp(0.0, MAX_MOVE_TIME) as u16;
    let [time_low, time_high] = time.to_le_bytes();
    [low, high, time_low, time_high]
}

impl Lx {
    /// Asks a servo once for the `N` bytes that a command reads.
    fn read_once<const N: usize>(
        wire: &mut dyn Wire,
        id: u8,
        command: u8,
        limit: u64,
    ) -> Result<[u8; N], BusError> {
        let wait = Wait {
            answers: 1,
            time: wire.timing().answer(N + FRAMING),
            limit,
        };
        let parse = |bytes: &[u8]| parse(bytes, command, N);
        wire.ask(&request(id, command, &[]), wait, &parse, |frame| {
            let its = frame.parameters.first_chunk::<N>();
            its.filter(|_| frame.id == id).copied()
        })
    }

    fn get<const N: usize>(wire: &mut dyn Wire, id: u8, command: u8) -> Result<[u8; N], BusError> {
        wire.repeat(|wire| Self::read_once(wire, id, command, u64::MAX))
    }

    /// Sends a command until what another one reads agrees.
    fn set<const N: usize>(
        wire: &mut dyn Wire,
        id: u8,
        (write, parameters): (u8, [u8; N]),
        read: u8,
    ) -> Result<(), BusError> {
        wire.repeat(|wire| {
            wire.send(&request(id, write, &parameters))?;
            let own = Self::read_once::<N>(wire, id, read, u64::MAX)?;
            if own == parameters {
                Ok(())
            } else {
                Err(BusError::NoAnswer)
            }
        })
    }

    fn set_goal(wire: &mut dyn Wire, servo: &Setpoint) -> Result<(), BusError> {
        let goal = (MOVE_TIME_WRITE, move_to(servo));
        Self::set(wire, servo.id, goal, MOVE_TIME_READ)
    }

    fn switch_torque(wire: &mut dyn Wire, id: u8, is_on: bool) -> Result<(), BusError> {
        let write = (LOAD_OR_UNLOAD_WRITE, [is_on.into()]);
        Self::set(wire, id, write, LOAD_OR_UNLOAD_READ)
    }

    /// Reads the position of a servo, and one of the other values in some turns.
    fn reading(wire: &mut dyn Wire, servo: &Query, limit: u64) -> Result<Reading, BusError> {
        let Query { id, turn, is_late } = *servo;
        let read = |wire: &mut dyn Wire| {
            let position = Self::read_once(wire, id, POS_READ, limit)?;
            Ok::<i16, BusError>(i16::from_le_bytes(position))
        };
        let mut position = read(wire)?;
        if is_late {
            // All answers look the same, and this may be the one that was missing before: the next one must agree.
            let again = read(wire)?;
            if again.abs_diff(position) > 1 {
                return Err(BusError::NoAnswer);
            }
            position = again;
        }
        let mut reading = Reading {
            error: 0,
            position: position.into(),
            load: None,
            voltage: None,
            temperature: None,
            is_on: None,
            torque_limit: None,
            speed_limit: None,
            is_plausible: true,
        };
        let slow = SLOW_VALUES.len() as u32;
        let which = match turn < slow {
            true => turn,
            false if !is_late && (turn + u32::from(id)).is_multiple_of(SLOW) => turn / SLOW % slow,
            false => return Ok(reading),
        };
        let command = SLOW_VALUES[which as usize];
        let value = match command {
            VIN_READ => Self::read_once(wire, id, command, limit).map(u16::from_le_bytes),
            _ => Self::read_once::<1>(wire, id, command, limit).map(|[it]| it.into()),
        };
        let value = match value {
            Ok(value) => value,
            // The position counts without it.
            Err(BusError::NoAnswer) => return Ok(reading),
            Err(error) => return Err(error),
        };
        match command {
            VIN_READ => reading.voltage = Some(f64::from(value) / 1000.0),
            TEMP_READ => reading.temperature = Some(value.into()),
            _ => reading.is_on = Some(value != 0),
        }
        Ok(reading)
    }
}

impl Family for Lx {
    fn key(&self) -> &'static str {
        "lx"
    }

    fn name(&self) -> &'static str {
        "Hiwonder LX"
    }

    fn last_id(&self) -> u8 {
        253
    }

    fn limits_torque(&self) -> bool {
        false
    }

    fn times(&self, timing: Timing, servos: usize) -> (u64, u64) {
        let read = timing.bytes(FRAMING) + timing.answer(FRAMING + 2);
        let goals = servos as u64 * timing.bytes(FRAMING + 4);
        (read + read / u64::from(SLOW), goals)
    }

    fn identify(&self, wire: &mut dyn Wire, id: u8) -> Result<Option<u16>, BusError> {
        let [own] = Self::read_once(wire, id, ID_READ, u64::MAX)?;
        if own == id {
            Ok(None)
        } else {
            Err(BusError::NoAnswer)
        }
    }

    fn set_id(&self, wire: &mut dyn Wire, id: u8, to: u8) -> Result<(), BusError> {
        Self::switch_torque(wire, id, false)?;
        wire.repeat(|wire| {
            wire.send(&request(id, ID_WRITE, &[to]))?;
            self.identify(wire, to)
        })
        .map(drop)
    }

    fn return_delay(&self, _: &mut dyn Wire, _: u8) -> Result<u32, BusError> {
        Ok(ANSWER_DELAY)
    }

    fn check(
        &self,
        wire: &mut dyn Wire,
        (id, model): (u8, &'static Model),
        (min, max): (i32, i32),
    ) -> Result<Option<Mismatch>, BusError> {
        let [mode, ..] = Self::get::<4>(wire, id, OR_MOTOR_MODE_READ)?;
        let [offset] = Self::get(wire, id, ANGLE_OFFSET_READ)?;
        let [low, high, low_2, high_2] = Self::get(wire, id, ANGLE_LIMIT_READ)?;
        let lowest = i32::from(u16::from_le_bytes([low, high]));
        let highest = i32::from(u16::from_le_bytes([low_2, high_2]));
        let offset = i32::from(offset as i8);
        let checks = [
            (
                OR_MOTOR_MODE_WRITE,
                "OR_MOTOR_MODE_WRITE",
                mode.into(),
                0,
                mode == 0,
            ),
            (
                ANGLE_OFFSET_ADJUST,
                "ANGLE_OFFSET_ADJUST",
                offset,
                0,
                offset == 0,
            ),
            (
                ANGLE_LIMIT_WRITE,
                "ANGLE_LIMIT_WRITE, minimum",
                lowest,
                0,
                lowest <= min,
            ),
            (
                ANGLE_LIMIT_WRITE,
                "ANGLE_LIMIT_WRITE, maximum",
                highest,
                model.largest,
                highest >= max,
            ),
        ];
        let mut wrong = checks.into_iter().filter(|(.., is_right)| !is_right);
        Ok(wrong.next().map(|(number, name, value, wanted, _)| {
            let register = number.into();
            Mismatch {
                register,
                name,
                value,
                wanted,
            }
        }))
    }

    fn read(
        &self,
        wire: &mut dyn Wire,
        servos: &[Query],
        limit: u64,
        _: bool,
        take: &mut dyn FnMut(usize, Reading),
    ) -> Result<usize, BusError> {
        let timing = wire.timing();
        let time = timing.bytes(FRAMING) + timing.answer(FRAMING + 2);
        for (place, servo) in servos.iter().enumerate() {
            if place > 0 && wire.now() + time > limit {
                return Ok(place);
            }
            match Self::reading(wire, servo, limit) {
                Ok(reading) => take(place, reading),
                Err(BusError::NoAnswer) => {}
                Err(error) => return Err(error),
            }
        }
        Ok(servos.len())
    }

    fn hold(&self, wire: &mut dyn Wire, servo: &Setpoint) -> Result<(), BusError> {
        // Before the torque, so that it does not go where an older command sent it.
        Self::set_goal(wire, servo)?;
        Self::switch_torque(wire, servo.id, true)
    }

    fn write_goals(&self, wire: &mut dyn Wire, servos: &[Setpoint]) -> Result<(), BusError> {
        for servo in servos {
            wire.send(&request(servo.id, MOVE_TIME_WRITE, &move_to(servo)))?;
        }
        Ok(())
    }

    fn write_torque_limits(&self, _: &mut dyn Wire, _: &[Setpoint]) -> Result<(), BusError> {
        Err(BusError::Unsupported)
    }

    fn release(&self, wire: &mut dyn Wire, ids: &[u8]) -> Result<(), BusError> {
        for id in ids {
            wire.send(&request(*id, LOAD_OR_UNLOAD_WRITE, &[0]))?;
        }
        Ok(())
    }

    fn leave(
        &self,
        wire: &mut dyn Wire,
        id: u8,
        hold: Option<&Setpoint>,
    ) -> Result<bool, BusError> {
        let Some(servo) = hold else {
            return Self::switch_torque(wire, id, false).map(|()| true);
        };
        Self::set_goal(wire, servo)?;
        let [is_on] = Self::get(wire, id, LOAD_OR_UNLOAD_READ)?;
        Ok(is_on != 0)
    }

    fn cause(&self, _: u8) -> &'static str {
        "unknown"
    }
}
