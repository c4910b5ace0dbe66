//! mjbots moteus controllers on CAN-FD behind an fdcanusb adapter, which takes and gives lines of text. The maker's crate writes
//! requests and reads lines.
//!
//! A controller forgets the limits of a command with the next one. Here it has a register table as other servos have: a request is
//! completed from what was written before, and an answer is the beginning of the table.
//!
//! The adapter's lines have no checksum, because USB and CAN have theirs. An answer must nevertheless prove itself: each request
//! has another sender, to which the controller answers, and asks for its identity and twice for its position.

use heapless::Vec;
use moteus_protocol::command::{PositionCommand, PositionFormat, StopCommand};
use moteus_protocol::fdcanusb::{
    EncodeOptions, MAX_LINE_LENGTH, encode_can_send, parse_rcv, strip_checksum,
};
use moteus_protocol::query::QueryFormat;
use moteus_protocol::{
    CanFdFrame, Mode, NOP, READ_INT32, REPLY_INT8, Register, Resolution, WriteCanData,
    calculate_arbitration_id, parse_arbitration_id,
};

/// Addresses of the table: width in bytes after the name.
pub mod address {
    /// 2: always 0.
    pub const MODEL: u16 = 0;
    /// 1: identity.
    pub const ID: u16 = 2;
    /// 1: 1 if it follows positions.
    pub const TORQUE_ENABLE: u16 = 3;
    /// 4: measured position.
    pub const POSITION: u16 = 4;
    /// 2: torque, 0.01 Nm.
    pub const LOAD: u16 = 8;
    /// 2: 0.1 V.
    pub const VOLTAGE: u16 = 10;
    /// 1: °C.
    pub const TEMPERATURE: u16 = 12;
    /// 1: number of the fault.
    pub const FAULT: u16 = 13;
    /// 4: commanded position.
    pub const GOAL_POSITION: u16 = 16;
    /// 4: velocity limit, deg/s.
    pub const GOAL_SPEED: u16 = 20;
    /// 2: maximum torque, 0.01 Nm.
    pub const TORQUE_LIMIT: u16 = 24;
    /// 1: time-out of a command, 20 ms; 0 for none.
    pub const WATCHDOG: u16 = 26;
}

/// Number of bytes of the table that an answer holds.
pub const MEASURED: usize = 14;
/// Counts of a turn: those of 32-bit positions of the protocol.
pub const TURN: f64 = 100_000.0;
/// Counts at the controller's position 0, in the middle of ten turns.
pub const MIDDLE: i32 = 500_000;
/// The largest identity. Those above are senders of requests.
pub const LAST_ID: u8 = 0x6F;
/// Bytes of a request, of the adapter's consent and of the answer.
pub const EXCHANGE: usize = 130;
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

/// An answer to a request.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Answer {
    /// Identity of the controller.
    pub id: u8,
    /// The sender of the request.
    pub to: u8,
    /// True if the controller has stopped for a fault.
    pub is_faulty: bool,
    /// Its registers.
    pub table: [u8; MEASURED],
}

/// Returns the sender of a request.
pub const fn sender(number: u8) -> u8 {
    LAST_ID + 1 + number % SENDERS
}

/// Reads a line without its end as an answer to [`query`] or to [`Command::line`].
pub fn answer(line: &[u8]) -> Option<Answer> {
    let frame = received(line)?;
    let (id, to, _) = parse_arbitration_id(frame.arbitration_id);
    let [
        mode,
        position,
        torque,
        voltage,
        temperature,
        fault,
        own,
        again,
    ] = values(frame.payload())?;
    let id = u8::try_from(id).ok().filter(|id| *id <= LAST_ID)?;
    if own != i32::from(id) || position.abs_diff(again) > BETWEEN {
        return None;
    }
    let is_on = mode == i32::from(i8::from(Mode::Position));
    let mut table = [0; MEASURED];
    table[usize::from(address::ID)] = id;
    table[usize::from(address::TORQUE_ENABLE)] = is_on.into();
    table[4..8].copy_from_slice(&position.saturating_add(MIDDLE).to_le_bytes());
    table[8..10].copy_from_slice(&(torque as i16).to_le_bytes());
    table[10..12].copy_from_slice(&(voltage as i16).to_le_bytes());
    table[usize::from(address::TEMPERATURE)] = temperature.max(0) as u8;
    table[usize::from(address::FAULT)] = fault as u8;
    Some(Answer {
        id,
        to: to as u8,
        is_faulty: mode == i32::from(i8::from(Mode::Fault)),
        table,
    })
}

/// Reads the frame of a received line, whose checksum must be right where it has one.
fn received(line: &[u8]) -> Option<CanFdFrame> {
    let (content, has_checksum, is_valid) = strip_checksum(line);
    parse_rcv(content).filter(|_| is_valid || !has_checksum)
}

/// Returns the values of exactly those registers that were asked for. The maker's parser is not used: it overflows at some damaged
/// register numbers.
fn values(payload: &[u8]) -> Option<[i32; ASKED.len()]> {
    let mut found = Vec::<i32, { ASKED.len() }>::new();
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
            let (wanted, as_wanted) = *ASKED.get(found.len())?;
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

/// The part of the table that commands are made of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Command {
    goal: i32,
    speed: i32,
    torque: i32,
    watchdog: i32,
    is_on: bool,
}

impl Command {
    /// Writes a register; returns true if the controller must hear of it.
    pub fn set(&mut self, register: u16, value: i32) -> bool {
        match register {
            address::GOAL_POSITION => self.goal = value,
            address::GOAL_SPEED => self.speed = value,
            address::TORQUE_LIMIT => self.torque = value,
            address::WATCHDOG => {
                self.watchdog = value;
                // Only a stop ends the state in which a time-out leaves the controller.
                return self.is_on || value == 0;
            }
            address::TORQUE_ENABLE => {
                self.is_on = value != 0;
                return true;
            }
            _ => {}
        }
        self.is_on
    }

    /// Returns the request, which asks for the registers as well if it is to be answered.
    pub fn line(&self, id: u8, from: u8, is_answered: bool) -> Line {
        let mut frame = frame(id, from, is_answered);
        if self.is_on {
            let timeout = match self.watchdog {
                0 => f32::NAN,
                units => units as f32 / 50.0,
            };
            PositionCommand::new()
                .position(((f64::from(self.goal) - f64::from(MIDDLE)) / TURN) as f32)
                .velocity_limit(self.speed as f32 / 360.0)
                .maximum_torque(self.torque as f32 / 100.0)
                .watchdog_timeout(timeout)
                .serialize(&mut frame, &PositionFormat::default());
        } else {
            StopCommand::serialize(&mut frame);
        }
        if is_answered {
            ask(&mut frame);
        }
        line(&frame)
    }
}

/// A request as a controller receives it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Request {
    /// The receiver.
    pub id: u8,
    /// The sender.
    pub from: u8,
    /// True if the controller answers.
    pub is_answered: bool,
    /// Registers to read and to write, as the frame encodes them.
    pub payload: Vec<u8, 64>,
}

/// Reads a line without its end as a request.
pub fn request(line: &[u8]) -> Option<Request> {
    let mut received = Line::from_slice(b"rcv ").ok()?;
    let rest = line.strip_prefix(b"can send ")?;
    received.extend_from_slice(rest).ok()?;
    let frame = self::received(&received)?;
    let (from, id, _) = parse_arbitration_id(frame.arbitration_id);
    Some(Request {
        id: id as u8,
        from: from as u8,
        is_answered: frame.arbitration_id & 0x8000 != 0,
        payload: Vec::from_slice(frame.payload()).ok()?,
    })
}

/// Returns true if the adapter sends this line without an answer in it.
pub fn is_consent(line: &[u8]) -> bool {
    line.trim_ascii() == b"OK"
}
