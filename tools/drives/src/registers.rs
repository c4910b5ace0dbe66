//! Servos with a register table: Dynamixel and Feetech. A family is a [`Table`], and the [`Framing`] of its requests.

use crate::bus::{BusError, MAX_SERVOS, Timing, Wait, Wire};
use crate::family::Model;
use crate::family::{Family, Mismatch, Query, Reading, Setpoint};
use crate::frame::{BROADCAST, Bytes, Frame, Parsed, TooLong, add};
use core::fmt;
use heapless::Vec;

/// Instructions of a frame. The numbers are the same in all protocols.
pub mod instruction {
    /// Reads registers.
    pub const READ: u8 = 0x02;
    /// Writes registers.
    pub const WRITE: u8 = 0x03;
    /// Reads registers of many servos.
    pub const SYNC_READ: u8 = 0x82;
    /// Writes registers of many servos.
    pub const SYNC_WRITE: u8 = 0x83;
    /// Reads registers of many servos, which answer in one frame.
    pub const FAST_SYNC_READ: u8 = 0x8A;
}

/// Requests and answers of a protocol.
pub trait Framing: fmt::Debug + Sync {
    /// Returns the bytes of a request.
    ///
    /// # Errors
    /// It has too many parameters.
    fn request(&self, id: u8, instruction: u8, parameters: &[u8]) -> Result<Bytes, TooLong>;

    /// Tries to read an answer with this many parameters at the beginning of `bytes`. One of another length is refused as soon as its
    /// length is there.
    fn parse(&self, bytes: &[u8], parameters: usize) -> Parsed;

    /// Returns the number of bytes of a frame with this many parameters, without stuffing.
    fn frame_length(&self, parameters: usize) -> usize;

    /// Width of an address and of a length, bytes.
    fn word(&self) -> usize;
}

/// Encoding of negative values in a register.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// There are none.
    None,
    /// Two's complement over the register's width.
    Twos,
    /// This bit is set, and the bits below are the amount.
    Bit(u8),
}

/// A register: its address, its width in bytes and its sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Register {
    /// Address of its lowest byte.
    pub address: u16,
    /// Width, bytes: 1, 2 or 4.
    pub width: u8,
    /// Encoding of negative values.
    pub sign: Sign,
}

pub(crate) const fn register(address: u16, width: u8) -> Register {
    signed(address, width, Sign::None)
}

pub(crate) const fn signed(address: u16, width: u8, sign: Sign) -> Register {
    Register {
        address,
        width,
        sign,
    }
}

impl Register {
    /// Returns the value in `bytes`, which begin at address `start`; `None` if they do not hold it.
    pub fn decode(self, start: u16, bytes: &[u8]) -> Option<i32> {
        let first = usize::from(self.address.checked_sub(start)?);
        let bytes = bytes.get(first..first + usize::from(self.width))?;
        let raw = bytes
            .iter()
            .rev()
            .fold(0_u32, |value, byte| value << 8 | u32::from(*byte));
        Some(match self.sign {
            Sign::None => raw as i32,
            Sign::Twos if self.width == 2 => i32::from(raw as u16 as i16),
            Sign::Twos => raw as i32,
            Sign::Bit(bit) => {
                let amount = (raw & ((1 << bit) - 1)) as i32;
                if raw >> bit & 1 == 1 { -amount } else { amount }
            }
        })
    }

    /// Returns the bytes of a value, lowest first; those beyond the width are 0.
    pub fn encode(self, value: i32) -> [u8; 4] {
        let raw = match self.sign {
            Sign::Bit(bit) if value < 0 => value.unsigned_abs() | 1 << bit,
            _ => value as u32,
        };
        let mut bytes = raw.to_le_bytes();
        bytes[usize::from(self.width).min(4)..].fill(0);
        bytes
    }
}

/// A part of the register table that is read by one request.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Block {
    /// First address.
    pub start: u16,
    /// Length, bytes.
    pub length: u8,
}

pub(crate) const fn block(start: u16, length: u8) -> Block {
    Block { start, length }
}

/// The values of a register with which goals mean positions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// The bits of the first number are those of the second.
    Bits(i32, i32),
    /// It is below all goals.
    Lowest,
    /// It is above all goals.
    Highest,
}

/// A register that changes the meaning of a goal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Check {
    /// Its name in the maker's manual.
    pub name: &'static str,
    /// The register.
    pub register: Register,
    /// Its right values.
    pub rule: Rule,
}

impl Check {
    /// Returns the value to be written if the present one is wrong.
    fn correct(&self, value: i32, model: &Model, (min, max): (i32, i32)) -> Option<i32> {
        let (is_right, wanted) = match self.rule {
            Rule::Bits(mask, right) => (value & mask == right, value & !mask | right),
            Rule::Lowest => (value <= min, 0),
            Rule::Highest => (value >= max, model.largest),
        };
        (!is_right).then_some(wanted)
    }
}

/// The register table of a family.
#[derive(Debug)]
pub struct Table {
    /// Name in commands.
    pub key: &'static str,
    /// Name in messages.
    pub name: &'static str,
    /// Its frames.
    pub framing: &'static dyn Framing,
    /// True if one request reads many servos.
    pub reads_together: bool,
    /// Blocks with position, load, voltage and temperature. Successive readings are of different ones, so that the length of
    /// an answer tells an old answer from a new one. With a checksum of 8 bits, two neighbouring bytes can be damaged unnoticed:
    /// the byte before the position must be one whose value is known.
    pub blocks: [Block; 3],
    /// Number of the model.
    pub model: Register,
    /// Identity on the bus.
    pub id: Register,
    /// Delay of an answer, in units of 2 µs.
    pub return_delay: Register,
    /// Registers that change the meaning of a goal.
    pub checks: &'static [Check],
    /// Register that protects the identity until it is 0; `None` if torque off is enough.
    pub lock: Option<Register>,
    /// Torque on or off.
    pub torque_enable: Register,
    /// Acceleration by itself, where 0 is none; it forgets that without power.
    pub acceleration: Option<Register>,
    /// Commanded position, counts.
    pub goal_position: Register,
    /// Speed limit.
    pub goal_speed: Register,
    /// Torque limit.
    pub torque_limit: Register,
    /// Measured position, counts.
    pub position: Register,
    /// Measured load.
    pub load: Register,
    /// Supply voltage, 0.1 V.
    pub voltage: Register,
    /// Temperature, °C.
    pub temperature: Register,
    /// Stops the servo when no instruction comes for this many units of 20 ms, 127 at most; 0 for never.
    pub watchdog: Option<Register>,
    /// Bits of the error byte of an answer that are alarms of the servo, not remarks on a request.
    pub alarms: u8,
    /// Register with the alarms, where the error byte only says that there are some.
    pub alarm_status: Option<Register>,
    /// Bits of an alarm that are voltage, temperature and overload.
    pub alarm_bits: [u8; 3],
}

/// Unit of a watchdog, ms.
const WATCHDOG_UNIT: f64 = 20.0;
/// Largest value of a watchdog.
const WATCHDOG_MAX: f64 = 127.0;
/// Servos in one frame of a sync write: a frame of protocol 1 has 255 bytes at most.
const IN_A_FRAME: usize = 40;

impl Table {
    fn word(&self, value: u16) -> Bytes {
        let bytes = value.to_le_bytes();
        Bytes::from_slice(&bytes[..self.framing.word().min(2)]).unwrap_or_default()
    }

    fn address_of(&self, block: Block) -> Result<Bytes, TooLong> {
        let mut parameters = self.word(block.start);
        add(&mut parameters, &self.word(block.length.into()))?;
        Ok(parameters)
    }

    /// Returns the longest time in which answers of this many servos with this many parameters come, µs.
    fn longest(&self, timing: Timing, servos: usize, parameters: usize) -> u64 {
        // A frame of protocol 2 has stuffed bytes sometimes.
        let bytes = self.framing.frame_length(parameters + parameters / 3);
        servos as u64 * timing.answer(bytes)
    }

    fn wait(&self, wire: &mut dyn Wire, servos: usize, parameters: usize, limit: u64) -> Wait {
        Wait {
            answers: servos,
            time: self.longest(wire.timing(), servos, parameters),
            limit,
        }
    }

    /// Reads registers of one servo, once.
    fn read_block(
        &self,
        wire: &mut dyn Wire,
        id: u8,
        block: Block,
        limit: u64,
    ) -> Result<Frame, BusError> {
        let parameters = self.address_of(block)?;
        let request = self.framing.request(id, instruction::READ, &parameters)?;
        let length = usize::from(block.length);
        let wait = self.wait(wire, 1, length, limit);
        wire.ask(
            &request,
            wait,
            &|bytes| self.framing.parse(bytes, length),
            |frame| (frame.id == id).then(|| frame.clone()),
        )
    }

    /// Reads one register of a servo, once.
    fn read_register(
        &self,
        wire: &mut dyn Wire,
        id: u8,
        register: Register,
    ) -> Result<i32, BusError> {
        // Shorter answers look like the echo of their request, which some adapters return.
        let length = register.width.max(3);
        let start = register
            .address
            .saturating_sub(u16::from(length - register.width));
        let frame = self.read_block(wire, id, block(start, length), u64::MAX)?;
        let value = register.decode(start, &frame.parameters);
        value.ok_or(BusError::NoAnswer)
    }

    /// Writes a register of one servo until it confirms it.
    fn write(
        &self,
        wire: &mut dyn Wire,
        id: u8,
        register: Register,
        value: i32,
    ) -> Result<(), BusError> {
        wire.repeat(|wire| self.write_once(wire, id, register, value))
    }

    fn write_once(
        &self,
        wire: &mut dyn Wire,
        id: u8,
        register: Register,
        value: i32,
    ) -> Result<(), BusError> {
        let mut parameters = self.word(register.address);
        let bytes = register.encode(value);
        add(&mut parameters, &bytes[..register.width.into()])?;
        let request = self.framing.request(id, instruction::WRITE, &parameters)?;
        let wait = self.wait(wire, 1, 0, u64::MAX);
        wire.ask(
            &request,
            wait,
            &|bytes| self.framing.parse(bytes, 0),
            |frame| (frame.id == id).then_some(()),
        )
    }

    /// Writes the same register of many servos. There are no answers.
    fn sync_write(
        &self,
        wire: &mut dyn Wire,
        register: Register,
        mut values: impl Iterator<Item = (u8, i32)>,
    ) -> Result<(), BusError> {
        loop {
            let mut parameters = self.word(register.address);
            add(&mut parameters, &self.word(register.width.into()))?;
            let empty = parameters.len();
            for (id, value) in values.by_ref().take(IN_A_FRAME) {
                add(&mut parameters, &[id])?;
                let bytes = register.encode(value);
                add(&mut parameters, &bytes[..register.width.into()])?;
            }
            if parameters.len() == empty {
                return Ok(());
            }
            let code = instruction::SYNC_WRITE;
            let request = self.framing.request(BROADCAST, code, &parameters)?;
            wire.send(&request)?;
        }
    }

    fn limit_torque(&self, wire: &mut dyn Wire, servo: &Setpoint) -> Result<(), BusError> {
        match servo.model.torque_limit(servo.torque) {
            Some(limit) => self.write(wire, servo.id, self.torque_limit, limit),
            None => Ok(()),
        }
    }

    fn reading(&self, block: Block, error: u8, bytes: &[u8]) -> Option<Reading> {
        let get = |register: Register| register.decode(block.start, bytes);
        Some(Reading {
            error,
            position: get(self.position)?,
            load: get(self.load),
            voltage: get(self.voltage).map(|it| f64::from(it) / 10.0),
            temperature: get(self.temperature).map(f64::from),
            is_on: get(self.torque_enable).map(|it| it != 0),
            torque_limit: get(self.torque_limit),
            speed_limit: get(self.goal_speed),
            // Nothing here leaves the lock open.
            is_plausible: self.lock.and_then(get).is_none_or(|it| it == 1),
        })
    }

    /// Reads many servos that answer one after the other to one request.
    fn read_together(
        &self,
        wire: &mut dyn Wire,
        block: Block,
        servos: &[Query],
        limit: u64,
        take: &mut dyn FnMut(usize, Reading),
    ) -> Result<(), BusError> {
        let parameters = self.address_of_many(block, servos)?;
        let code = instruction::SYNC_READ;
        let request = self.framing.request(BROADCAST, code, &parameters)?;
        let length = usize::from(block.length);
        let wait = self.wait(wire, servos.len(), length, limit);
        let mut found: Vec<Option<Answer>, MAX_SERVOS> = Vec::new();
        found.resize(servos.len(), None).map_err(|_| TooLong)?;
        let mut missing = found.len();
        let parse = |bytes: &[u8]| self.framing.parse(bytes, length);
        wire.exchange(&request, wait, &parse, &mut |frame| {
            let place = servos.iter().position(|servo| servo.id == frame.id);
            let Some(slot) = place.and_then(|place| found.get_mut(place)) else {
                return false;
            };
            let new = Answer::of(&frame);
            match slot {
                None => {
                    missing -= 1;
                    *slot = Some(new);
                }
                Some(old) if *old != new => old.is_doubtful = true,
                Some(_) => {}
            }
            missing == 0
        })?;
        for (place, answer) in found.iter().enumerate() {
            let Some(answer) = answer.as_ref().filter(|answer| !answer.is_doubtful) else {
                continue;
            };
            wire.count_answers(1);
            if let Some(reading) = self.reading(block, answer.error, &answer.bytes) {
                take(place, reading);
            }
        }
        Ok(())
    }

    /// Reads many servos that answer in one frame: it is valid as a whole or not at all.
    fn read_fast(
        &self,
        wire: &mut dyn Wire,
        block: Block,
        servos: &[Query],
        limit: u64,
        take: &mut dyn FnMut(usize, Reading),
    ) -> Result<(), BusError> {
        let parameters = self.address_of_many(block, servos)?;
        let length = usize::from(block.length);
        // Between two servos there are two bytes of a checksum, and the next one's error and identity.
        let each = length + 4;
        // The error of the first is where that of any answer is.
        let wanted = (each * servos.len()).saturating_sub(3);
        let code = instruction::FAST_SYNC_READ;
        let request = self.framing.request(BROADCAST, code, &parameters)?;
        let wait = self.wait(wire, servos.len(), length, limit);
        let mut whole = None;
        let parse = |bytes: &[u8]| self.framing.parse(bytes, wanted);
        wire.exchange(&request, wait, &parse, &mut |frame| {
            whole = (frame.id == BROADCAST).then_some(frame);
            whole.is_some()
        })?;
        let Some(frame) = whole else {
            return Ok(());
        };
        let mut error = frame.code;
        let parts = frame.parameters.chunks(each);
        for (place, (servo, part)) in servos.iter().zip(parts).enumerate() {
            let (Some(own), Some(bytes)) = (part.first(), part.get(1..=length)) else {
                break;
            };
            if *own == servo.id {
                wire.count_answers(1);
                if let Some(reading) = self.reading(block, error, bytes) {
                    take(place, reading);
                }
            }
            error = part.last().copied().unwrap_or_default();
        }
        Ok(())
    }

    fn address_of_many(&self, block: Block, servos: &[Query]) -> Result<Bytes, TooLong> {
        let mut parameters = self.address_of(block)?;
        for servo in servos {
            add(&mut parameters, &[servo.id])?;
        }
        Ok(parameters)
    }
}

/// Returns the units of a watchdog.
fn watchdog_units(timeout: Option<f64>) -> i32 {
    timeout.map_or(0, |time| {
        libm::ceil(time / WATCHDOG_UNIT).clamp(1.0, WATCHDOG_MAX) as i32
    })
}

impl Family for Table {
    fn key(&self) -> &'static str {
        self.key
    }

    fn name(&self) -> &'static str {
        self.name
    }

    fn reads_together(&self) -> bool {
        self.reads_together
    }

    fn timeouts(&self) -> Option<(f64, f64)> {
        self.watchdog
            .map(|_| (WATCHDOG_UNIT, WATCHDOG_UNIT * WATCHDOG_MAX))
    }

    fn times(&self, timing: Timing, servos: usize) -> (u64, u64) {
        let length = self.blocks.iter().map(|it| usize::from(it.length)).max();
        let answer = timing.answer(self.framing.frame_length(length.unwrap_or_default()));
        let word = self.framing.word();
        let request = match self.reads_together {
            // Each servo has its part in the request.
            true => timing.bytes(1),
            false => timing.bytes(self.framing.frame_length(2 * word)),
        };
        let goals = servos * (1 + usize::from(self.goal_position.width));
        let goals = timing.bytes(self.framing.frame_length(2 * word + goals));
        (request + answer, goals)
    }

    fn identify(&self, wire: &mut dyn Wire, id: u8) -> Result<Option<u16>, BusError> {
        let number = self.read_register(wire, id, self.model)?;
        Ok(Some(number as u16))
    }

    fn set_id(&self, wire: &mut dyn Wire, id: u8, to: u8) -> Result<(), BusError> {
        self.write(wire, id, self.torque_enable, 0)?;
        if let Some(lock) = self.lock {
            self.write(wire, id, lock, 0)?;
        }
        // Some servos answer with the old identity, others with the new one.
        match self.write_once(wire, id, self.id, to.into()) {
            Ok(()) | Err(BusError::NoAnswer) => {}
            Err(error) => return Err(error),
        }
        if let Some(lock) = self.lock {
            self.write(wire, to, lock, 1)?;
        }
        wire.repeat(|wire| self.identify(wire, to)).map(drop)
    }

    fn return_delay(&self, wire: &mut dyn Wire, id: u8) -> Result<u32, BusError> {
        let units = wire.repeat(|wire| self.read_register(wire, id, self.return_delay))?;
        Ok(units.unsigned_abs() * 2)
    }

    fn check(
        &self,
        wire: &mut dyn Wire,
        (id, model): (u8, &'static Model),
        goals: (i32, i32),
    ) -> Result<Option<Mismatch>, BusError> {
        for check in self.checks {
            let value = wire.repeat(|wire| self.read_register(wire, id, check.register))?;
            if let Some(wanted) = check.correct(value, model, goals) {
                return Ok(Some(Mismatch {
                    register: check.register.address,
                    name: check.name,
                    value,
                    wanted,
                }));
            }
        }
        Ok(None)
    }

    fn read(
        &self,
        wire: &mut dyn Wire,
        servos: &[Query],
        limit: u64,
        fast: bool,
        take: &mut dyn FnMut(usize, Reading),
    ) -> Result<usize, BusError> {
        let block_of = |servo: &Query| self.blocks[servo.turn as usize % self.blocks.len()];
        let Some(first) = servos.first().filter(|_| self.reads_together) else {
            for (place, servo) in servos.iter().enumerate() {
                let block = block_of(servo);
                let timing = wire.timing();
                let request = timing.bytes(self.framing.frame_length(2 * self.framing.word()));
                let time = request + self.longest(timing, 1, block.length.into());
                if place > 0 && wire.now() + time > limit {
                    return Ok(place);
                }
                match self.read_block(wire, servo.id, block, limit) {
                    Ok(frame) => {
                        if let Some(reading) = self.reading(block, frame.code, &frame.parameters) {
                            take(place, reading);
                        }
                    }
                    Err(BusError::NoAnswer) => {}
                    Err(error) => return Err(error),
                }
            }
            return Ok(servos.len());
        };
        // They are read together each time.
        let block = block_of(first);
        match fast && self.framing.word() == 2 {
            true => self.read_fast(wire, block, servos, limit, take)?,
            false => self.read_together(wire, block, servos, limit, take)?,
        }
        Ok(servos.len())
    }

    fn hold(&self, wire: &mut dyn Wire, servo: &Setpoint) -> Result<(), BusError> {
        let (id, model) = (servo.id, servo.model);
        if let Some(watchdog) = self.watchdog {
            // Writing 0 ends the state that an old one has left.
            self.write(wire, id, watchdog, 0)?;
            self.write(wire, id, watchdog, watchdog_units(servo.timeout))?;
        }
        if let Some(acceleration) = self.acceleration {
            self.write(wire, id, acceleration, 0)?;
        }
        self.limit_torque(wire, servo)?;
        self.write(wire, id, self.goal_speed, model.speed_limit(servo.speed))?;
        self.write(wire, id, self.goal_position, servo.position)?;
        self.write(wire, id, self.torque_enable, 1)
    }

    fn write_goals(&self, wire: &mut dyn Wire, servos: &[Setpoint]) -> Result<(), BusError> {
        let goals = servos.iter().map(|servo| (servo.id, servo.position));
        self.sync_write(wire, self.goal_position, goals)
    }

    fn write_torque_limits(
        &self,
        wire: &mut dyn Wire,
        servos: &[Setpoint],
    ) -> Result<(), BusError> {
        let limits = servos
            .iter()
            .filter_map(|servo| Some((servo.id, servo.model.torque_limit(servo.torque)?)));
        self.sync_write(wire, self.torque_limit, limits)
    }

    fn write_timeouts(&self, wire: &mut dyn Wire, servos: &[Setpoint]) -> Result<(), BusError> {
        let Some(watchdog) = self.watchdog else {
            return Ok(());
        };
        let units = servos.iter();
        let units = units.map(|servo| (servo.id, watchdog_units(servo.timeout)));
        self.sync_write(wire, watchdog, units)
    }

    fn release(&self, wire: &mut dyn Wire, ids: &[u8]) -> Result<(), BusError> {
        self.sync_write(wire, self.torque_enable, ids.iter().map(|id| (*id, 0)))
    }

    fn leave(
        &self,
        wire: &mut dyn Wire,
        id: u8,
        hold: Option<&Setpoint>,
    ) -> Result<bool, BusError> {
        if hold.is_none() {
            self.write(wire, id, self.torque_enable, 0)?;
        }
        if let Some(watchdog) = self.watchdog {
            self.write(wire, id, watchdog, 0)?;
        }
        if let Some(servo) = hold {
            self.limit_torque(wire, servo)?;
            self.write(wire, id, self.goal_position, servo.position)?;
        }
        let torque = wire.repeat(|wire| self.read_register(wire, id, self.torque_enable))?;
        Ok((torque != 0) == hold.is_some())
    }

    fn alarms(&self, error: u8) -> u8 {
        error & self.alarms
    }

    fn alarm(&self, wire: &mut dyn Wire, id: u8, error: u8) -> Result<u8, BusError> {
        match self.alarm_status {
            Some(status) => Ok(self.read_register(wire, id, status)? as u8),
            None => Ok(self.alarms(error)),
        }
    }

    fn cause(&self, alarm: u8) -> &'static str {
        let mut causes = self
            .alarm_bits
            .into_iter()
            .zip(["voltage", "temperature", "overload"]);
        let found = causes.find(|(bits, _)| bits & alarm != 0);
        found.map_or("sensor or current", |(_, cause)| cause)
    }
}

/// An answer of one servo to a sync read.
#[derive(Clone, Debug, PartialEq)]
struct Answer {
    error: u8,
    bytes: Vec<u8, 32>,
    /// Another answer had other contents: neither is used.
    is_doubtful: bool,
}

impl Answer {
    fn of(frame: &Frame) -> Self {
        Answer {
            error: frame.code,
            bytes: Vec::from_slice(&frame.parameters).unwrap_or_default(),
            is_doubtful: false,
        }
    }
}
