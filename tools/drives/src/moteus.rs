//! mjbots moteus controllers on CAN-FD behind an fdcanusb adapter, which takes and gives lines of text. The maker's crate writes
//! requests and reads lines.
//!
//! A controller forgets the limits of a command with the next one, so that each command has all of them.
//!
//! The adapter's lines have no checksum, because USB and CAN have theirs. An answer must nevertheless prove itself: each request
//! has another sender, to which the controller answers, and asks for its identity and twice for its position.

use crate::bus::{BusError, Timing, Wait, Wire};
use crate::family::Model;
use crate::family::{Family, Mismatch, Query, Reading, Setpoint};
use crate::frame::{Bytes, Frame, MAX_FRAME_BYTES, Parsed};
use heapless::Vec;
use moteus_protocol::command::{PositionCommand, PositionFormat, StopCommand};
use moteus_protocol::fdcanusb::{
    EncodeOptions, MAX_LINE_LENGTH, encode_can_send, parse_rcv, strip_checksum,
};
use moteus_protocol::query::QueryFormat;
use moteus_protocol::{
    CanFdFrame, Mode, NOP, READ_INT8, READ_INT16, READ_INT32, REPLY_INT8, Register, Resolution,
    WriteCanData, calculate_arbitration_id, parse_arbitration_id,
};

/// Counts of a turn: those of 32-bit positions of the protocol.
pub const TURN: f64 = 100_000.0;
/// Counts at the controller's position 0, in the middle of ten turns.
pub const MIDDLE: i32 = 500_000;
/// The largest identity. Those above are senders of requests.
pub const LAST_ID: u8 = 0x6F;
/// Bytes of a request, of the adapter's consent and of the answer.
pub const EXCHANGE: usize = 130;
/// Bytes of a command.
const REQUEST: usize = 90;
/// Longest time-out of a command, ms: an hour.
const MAX_TIMEOUT: f64 = 3_600_000.0;
/// Number of senders.
const SENDERS: u8 = 15;
/// Difference of the two positions of an answer, counts: the controller measures between them. 0.07 deg.
pub const BETWEEN: u32 = 20;

/// A line of text.
pub type Line = Vec<u8, MAX_LINE_LENGTH>;

/// The registers of an answer, in their order.
const ASKED: [(Register, Resolution); 8] = [
    (Register::Mode, Resolution::Int8),
    (Register::Position, Resolution::Int32),
    (Register::Torque, Resolution::Int16),
    (Register::Voltage, Resolution::Int16),
    (Register::Temperature, Resolution::Int8),
    (Register::Fault, Resolution::Int8),
    (Register::MultiplexId, Resolution::Int16),
    (Register::Position, Resolution::Int32),
];

/// Values of the register Home State: the position is that since the start, or known within a turn of the rotor; else it is known at
/// the output.
const RELATIVE: i32 = 0;
const ROTOR: i32 = 1;
const OUTPUT: i32 = 2;

/// An answer to a request.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Answer {
    /// Identity of the controller.
    pub id: u8,
    /// True if it follows positions.
    pub is_on: bool,
    /// True if no command came in the time-out of the last one: it follows positions after a stop only.
    pub is_timed_out: bool,
    /// Position, counts.
    pub position: i32,
    /// Torque, 0.01 Nm.
    pub torque: i16,
    /// Supply voltage, 0.1 V.
    pub voltage: i16,
    /// Temperature, °C.
    pub temperature: i8,
    /// Number of the fault for which it has stopped, or 0.
    pub fault: u8,
}

/// Returns the sender of a request.
pub const fn sender(number: u8) -> u8 {
    LAST_ID + 1 + number % SENDERS
}

/// Reads a line without its end as an answer to [`query`] or [`command`]; returns the sender of the request as well.
pub fn answer(line: &[u8]) -> Option<(Answer, u8)> {
    let frame = received(line)?;
    let (id, to) = addresses(&frame)?;
    Some((contents(id, frame.payload())?, to))
}

/// Returns the controller that a frame comes from, and the sender that it is for.
fn addresses(frame: &CanFdFrame) -> Option<(u8, u8)> {
    let (id, to, _) = parse_arbitration_id(frame.arbitration_id);
    let id = u8::try_from(id).ok().filter(|id| *id <= LAST_ID)?;
    Some((id, to as u8))
}

/// Returns the contents of an answer of a controller.
fn contents(id: u8, payload: &[u8]) -> Option<Answer> {
    let [
        mode,
        position,
        torque,
        voltage,
        temperature,
        fault,
        own,
        again,
    ] = values(payload, &ASKED)?;
    if own != i32::from(id) || position.abs_diff(again) > BETWEEN {
        return None;
    }
    let is_faulty = mode == i32::from(i8::from(Mode::Fault));
    Some(Answer {
        id,
        is_on: mode == i32::from(i8::from(Mode::Position)),
        is_timed_out: mode == i32::from(i8::from(Mode::Timeout)),
        position: position.saturating_add(MIDDLE),
        torque: torque as i16,
        voltage: voltage as i16,
        temperature: temperature as i8,
        fault: if is_faulty { (fault as u8).max(1) } else { 0 },
    })
}

/// Returns a register of a byte of a controller, which also tells its identity.
fn byte_of(register: Register, id: u8, payload: &[u8]) -> Option<i32> {
    let asked = [
        (register, Resolution::Int8),
        (Register::MultiplexId, Resolution::Int16),
    ];
    let [value, own] = values(payload, &asked)?;
    (own == i32::from(id)).then_some(value)
}

fn home_state(id: u8, payload: &[u8]) -> Option<i32> {
    byte_of(Register::HomeState, id, payload)
}

fn mode(id: u8, payload: &[u8]) -> Option<i32> {
    byte_of(Register::Mode, id, payload)
}

/// Tries to read a line at the beginning of `bytes` with an answer to a sender, whose contents `read` accepts.
fn parse<T>(bytes: &[u8], sender: u8, read: fn(u8, &[u8]) -> Option<T>) -> Parsed {
    let Some(end) = bytes.iter().position(|byte| *byte == b'\n') else {
        return match bytes.len() < MAX_FRAME_BYTES / 2 {
            true => Parsed::Unfinished,
            false => Parsed::Nothing,
        };
    };
    let line = &bytes[..end];
    if line.trim_ascii() == b"OK" {
        return Parsed::Remark(end + 1);
    }
    let valid = received(line)
        .and_then(|frame| Some((addresses(&frame)?, frame)))
        .filter(|((id, to), frame)| *to == sender && read(*id, frame.payload()).is_some());
    let frame = valid.and_then(|((id, code), frame)| {
        let parameters = Bytes::from_slice(frame.payload()).ok()?;
        Some(Frame {
            id,
            code,
            parameters,
        })
    });
    frame.map_or(Parsed::Nothing, |frame| Parsed::Frame(frame, end + 1))
}

/// Reads the frame of a received line, whose checksum must be right where it has one.
fn received(line: &[u8]) -> Option<CanFdFrame> {
    let (content, has_checksum, is_valid) = strip_checksum(line);
    parse_rcv(content).filter(|_| is_valid || !has_checksum)
}

/// Returns the values of exactly those registers that were asked for. The maker's parser is not used: it overflows at some damaged
/// register numbers.
fn values<const N: usize>(payload: &[u8], asked: &[(Register, Resolution); N]) -> Option<[i32; N]> {
    let mut found = Vec::<i32, N>::new();
    let mut bytes = payload.iter().copied();
    while let Some(head) = bytes.next() {
        if head == NOP {
            continue;
        }
        if head & 0xF0 != REPLY_INT8 {
            return None;
        }
        let count = match head & 3 {
            0 => bytes.next()?,
            count => count,
        };
        let mut register = u16::from(bytes.next()?);
        if register >= 0x80 {
            register = register - 0x80 + u16::from(bytes.next()?) * 0x80;
        }
        let resolution = Resolution::from_type_code(head)?;
        for next in 0..u16::from(count) {
            let (wanted, as_wanted) = *asked.get(found.len())?;
            if register + next != wanted.address() || resolution != as_wanted {
                return None;
            }
            let mut byte = || bytes.next();
            let value = match resolution {
                Resolution::Int8 => i32::from(byte()? as i8),
                Resolution::Int16 => i32::from(i16::from_le_bytes([byte()?, byte()?])),
                _ => i32::from_le_bytes([byte()?, byte()?, byte()?, byte()?]),
            };
            found.push(value).ok()?;
        }
    }
    found.into_array().ok()
}

/// Returns a request for the registers of a controller.
pub fn query(id: u8, from: u8) -> Line {
    let mut frame = frame(id, from, true);
    ask(&mut frame);
    line(&frame)
}

/// Returns a request for a register of a byte of a controller, and for its identity.
fn byte_query(register: Register, id: u8, from: u8) -> Line {
    let mut frame = frame(id, from, true);
    let mut bytes = WriteCanData::new(&mut frame);
    bytes.write_u8(READ_INT8 | 1);
    bytes.write_u8(register.address() as u8);
    bytes.write_u8(READ_INT16 | 1);
    bytes.write_varuint(Register::MultiplexId.address().into());
    line(&frame)
}

fn frame(id: u8, from: u8, is_answered: bool) -> CanFdFrame {
    let mut frame = CanFdFrame::new();
    frame.arbitration_id = calculate_arbitration_id(from as i8, id as i8, 0, is_answered);
    frame
}

fn ask(frame: &mut CanFdFrame) {
    let mut format = QueryFormat::minimal();
    format.velocity = Resolution::Ignore;
    format.position = Resolution::Int32;
    format.torque = Resolution::Int16;
    format.voltage = Resolution::Int16;
    format.temperature = Resolution::Int8;
    format.fault = Resolution::Int8;
    format.add_extra(Register::MultiplexId.address(), Resolution::Int16);
    format.serialize(frame);
    let mut again = WriteCanData::new(frame);
    again.write_u8(READ_INT32 | 1);
    again.write_u8(Register::Position.address() as u8);
}

fn line(frame: &CanFdFrame) -> Line {
    let mut bytes = [0; MAX_LINE_LENGTH];
    // The longest line fits.
    let length = encode_can_send(frame, &EncodeOptions::default(), &mut bytes).unwrap_or(0);
    Line::from_slice(&bytes[..length]).unwrap_or_default()
}

/// Returns a command, which asks for the registers as well if it is to be answered.
pub fn command(servo: &Setpoint, from: u8, is_answered: bool) -> Line {
    let mut frame = frame(servo.id, from, is_answered);
    let torque = servo.model.torque_limit(servo.torque);
    let timeout = servo.timeout.map_or(f32::NAN, |time| time as f32 / 1000.0);
    PositionCommand::new()
        .position(((f64::from(servo.position) - f64::from(MIDDLE)) / TURN) as f32)
        .velocity_limit((servo.speed / 360.0) as f32)
        .maximum_torque(torque.unwrap_or_default() as f32 / 100.0)
        .watchdog_timeout(timeout)
        .serialize(&mut frame, &PositionFormat::default());
    if is_answered {
        ask(&mut frame);
    }
    line(&frame)
}

/// Returns a request to stop: without torque, and without the state in which a time-out or a fault leaves the controller.
pub fn stop(id: u8, from: u8, is_answered: bool) -> Line {
    let mut frame = frame(id, from, is_answered);
    StopCommand::serialize(&mut frame);
    if is_answered {
        ask(&mut frame);
    }
    line(&frame)
}

/// mjbots moteus controllers.
pub static MOTEUS: Moteus = Moteus;

/// The family of moteus controllers.
#[derive(Debug)]
pub struct Moteus;

impl Moteus {
    /// Sends a request to a controller once, and returns what `read` finds in its answer.
    fn exchange<T>(
        wire: &mut dyn Wire,
        id: u8,
        request: impl FnOnce(u8) -> Line,
        limit: u64,
        read: fn(u8, &[u8]) -> Option<T>,
    ) -> Result<T, BusError> {
        if id > LAST_ID {
            return Err(BusError::NoAnswer);
        }
        let sender = sender(wire.next_number());
        let wait = Wait {
            answers: 1,
            time: wire.timing().answer(EXCHANGE),
            limit,
        };
        let parse = |bytes: &[u8]| parse(bytes, sender, read);
        wire.ask(&request(sender), wait, &parse, |frame| {
            let is_its = frame.id == id;
            read(id, &frame.parameters).filter(|_| is_its)
        })
    }

    fn query(wire: &mut dyn Wire, id: u8, limit: u64) -> Result<Answer, BusError> {
        Self::exchange(wire, id, |sender| query(id, sender), limit, contents)
    }

    fn stop(wire: &mut dyn Wire, id: u8) -> Result<(), BusError> {
        let request = |sender| stop(id, sender, true);
        wire.repeat(|wire| Self::exchange(wire, id, request, u64::MAX, contents))
            .map(drop)
    }

    fn command(wire: &mut dyn Wire, servo: &Setpoint) -> Result<(), BusError> {
        let request = |sender| command(servo, sender, true);
        wire.repeat(|wire| Self::exchange(wire, servo.id, request, u64::MAX, contents))
            .map(drop)
    }
}

impl Family for Moteus {
    fn key(&self) -> &'static str {
        "moteus"
    }

    fn name(&self) -> &'static str {
        "mjbots moteus"
    }

    fn last_id(&self) -> u8 {
        LAST_ID
    }

    fn timeouts(&self) -> Option<(f64, f64)> {
        Some((1.0, MAX_TIMEOUT))
    }

    fn times(&self, timing: Timing, servos: usize) -> (u64, u64) {
        let request = timing.bytes(REQUEST);
        (timing.answer(EXCHANGE), request * servos as u64)
    }

    fn identify(&self, wire: &mut dyn Wire, id: u8) -> Result<Option<u16>, BusError> {
        Self::query(wire, id, u64::MAX).map(|_| None)
    }

    fn set_id(&self, _: &mut dyn Wire, _: u8, _: u8) -> Result<(), BusError> {
        Err(BusError::Unsupported)
    }

    fn return_delay(&self, _: &mut dyn Wire, _: u8) -> Result<u32, BusError> {
        Ok(0)
    }

    fn check(
        &self,
        wire: &mut dyn Wire,
        (id, model): (u8, &'static Model),
        (min, max): (i32, i32),
    ) -> Result<Option<Mismatch>, BusError> {
        let request = |sender| byte_query(Register::HomeState, id, sender);
        let state = wire.repeat(|wire| Self::exchange(wire, id, request, u64::MAX, home_state))?;
        // A qdd100 has a reducer of 6 between its rotor and its output.
        let turn = match model.name {
            "moteus-qdd100" => TURN / 6.0,
            _ => TURN,
        };
        let half = (turn / 2.0) as i32;
        let is_known = match state {
            RELATIVE => false,
            // After a start the position is within half a turn of the rotor, and not always where the joint is.
            ROTOR => min >= MIDDLE - half && max <= MIDDLE + half,
            _ => true,
        };
        Ok((!is_known).then_some(Mismatch {
            register: Register::HomeState.address(),
            name: "Home State",
            value: state,
            wanted: OUTPUT,
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
        let time = wire.timing().answer(EXCHANGE);
        for (place, servo) in servos.iter().enumerate() {
            if place > 0 && wire.now() + time > limit {
                return Ok(place);
            }
            match Self::query(wire, servo.id, limit) {
                Ok(answer) => take(
                    place,
                    Reading {
                        error: answer.fault,
                        position: answer.position,
                        load: Some(answer.torque.into()),
                        voltage: Some(f64::from(answer.voltage) / 10.0),
                        temperature: Some(answer.temperature.into()),
                        is_on: Some(answer.is_on),
                        torque_limit: None,
                        speed_limit: None,
                        is_plausible: true,
                    },
                ),
                Err(BusError::NoAnswer) => {}
                Err(error) => return Err(error),
            }
        }
        Ok(servos.len())
    }

    fn hold(&self, wire: &mut dyn Wire, servo: &Setpoint) -> Result<(), BusError> {
        Self::stop(wire, servo.id)?;
        Self::command(wire, servo)
    }

    fn write_goals(&self, wire: &mut dyn Wire, servos: &[Setpoint]) -> Result<(), BusError> {
        for servo in servos {
            wire.send(&command(servo, sender(0), false))?;
        }
        Ok(())
    }

    fn write_torque_limits(
        &self,
        wire: &mut dyn Wire,
        servos: &[Setpoint],
    ) -> Result<(), BusError> {
        self.write_goals(wire, servos)
    }

    fn has_timed_out(&self, wire: &mut dyn Wire, id: u8) -> Result<bool, BusError> {
        // Not the position: the one that was measured stands.
        let request = |sender| byte_query(Register::Mode, id, sender);
        let mode = Self::exchange(wire, id, request, u64::MAX, mode)?;
        Ok(mode == i32::from(i8::from(Mode::Timeout)))
    }

    fn release(&self, wire: &mut dyn Wire, ids: &[u8]) -> Result<(), BusError> {
        for id in ids {
            wire.send(&stop(*id, sender(0), false))?;
        }
        Ok(())
    }

    fn leave(
        &self,
        wire: &mut dyn Wire,
        id: u8,
        hold: Option<&Setpoint>,
    ) -> Result<bool, BusError> {
        match hold {
            Some(servo) => Self::command(wire, servo)?,
            None => Self::stop(wire, id)?,
        }
        let mut answer = wire.repeat(|wire| Self::query(wire, id, u64::MAX))?;
        if let Some(servo) = hold.filter(|_| answer.is_timed_out) {
            self.hold(wire, servo)?;
            answer = wire.repeat(|wire| Self::query(wire, id, u64::MAX))?;
        }
        Ok(answer.is_on == hold.is_some())
    }

    fn is_stiff(&self, wire: &mut dyn Wire, id: u8) -> Result<bool, BusError> {
        let answer = wire.repeat(|wire| Self::query(wire, id, u64::MAX))?;
        Ok(answer.is_on)
    }

    fn cause(&self, alarm: u8) -> &'static str {
        match alarm {
            34 | 40 => "voltage",
            38 => "temperature",
            _ => "sensor or current",
        }
    }
}
