//! Simulated servos on a bus that can fail. They see bytes and a clock, so that they work in memory and on a pseudo-terminal.
//!
//! A servo turns towards its goal with the lag and the speed of its model, and warms up under load. Nothing loads it but its own
//! motion. Its registers, scales and limits are written from its maker's manual, each family in a module of its own: the master's
//! tables are not used here, so that a wrong address or scale of the master shows.

mod ax_mx;
mod firmware;
mod lx;
mod moteus;
mod servo;
mod sts;
mod table;
mod wire;
mod x;

pub use servo::Servo;

use crate::bus::{Port, Timing};
use core::convert::Infallible;
use firmware::{Registers, Reply};
use std::vec::Vec;
use wire::{Reader, Request, Wire};

/// The identity that every servo listens to; of a moteus it is 0.
const BROADCAST: u8 = 0xFE;

/// Instructions of servos with registers: ROBOTIS e-Manual, "DYNAMIXEL Protocol 2.0", section "Instruction".
mod instruction {
    pub(super) const PING: u8 = 0x01;
    pub(super) const READ: u8 = 0x02;
    pub(super) const WRITE: u8 = 0x03;
    pub(super) const SYNC_READ: u8 = 0x82;
    pub(super) const SYNC_WRITE: u8 = 0x83;
    pub(super) const FAST_SYNC_READ: u8 = 0x8A;
}

/// Probabilities of what can happen to an answer.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Faults {
    /// Bytes are damaged.
    pub corrupt: f64,
    /// It is lost.
    pub drop: f64,
    /// It comes twice.
    pub duplicate: f64,
    /// It comes up to 30 ms later, after the next request perhaps.
    pub delay: f64,
    /// Its end is lost.
    pub truncate: f64,
}

impl Faults {
    /// Returns the same probability for each of them, so that one of them happens to an answer with `probability`.
    pub fn evenly(probability: f64) -> Self {
        let each = probability / 5.0;
        Faults {
            corrupt: each,
            drop: each,
            duplicate: each,
            delay: each,
            truncate: each,
        }
    }
}

/// Counts of the faults that happened.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Happened {
    /// Damaged answers.
    pub corrupt: u64,
    /// Lost answers.
    pub dropped: u64,
    /// Answers that came twice.
    pub duplicated: u64,
    /// Late answers.
    pub delayed: u64,
    /// Answers without their end.
    pub truncated: u64,
}

/// A bus of simulated servos, with everything that can go wrong.
#[derive(Clone, Debug)]
pub struct SimulatedBus {
    servos: Vec<Servo>,
    faults: Faults,
    happened: Happened,
    wire: Wire,
    timing: Timing,
    reader: Reader,
    random: u64,
    /// µs
    time: u64,
    /// Bytes on the wire to the master with their times, in order.
    answers: Vec<(u64, u8)>,
    /// Number of instructions that were understood.
    understood: u64,
}

impl SimulatedBus {
    /// Creates a bus; the frames of its first servo are the frames of all.
    pub fn new(servos: Vec<Servo>, timing: Timing) -> Self {
        let wire = servos
            .first()
            .map_or(Wire::Dynamixel1, |servo| servo.firmware.wire());
        SimulatedBus {
            servos,
            faults: Faults::default(),
            happened: Happened::default(),
            wire,
            timing,
            reader: Reader::new(wire),
            random: 0x9E37_79B9_7F4A_7C15,
            time: 0,
            answers: Vec::new(),
            understood: 0,
        }
    }

    /// Lets faults happen, in an order that `seed` gives.
    #[must_use]
    pub fn with_faults(mut self, faults: Faults, seed: u64) -> Self {
        self.faults = faults;
        self.random ^= seed;
        self
    }

    /// Returns the servos.
    pub fn servos(&self) -> &[Servo] {
        &self.servos
    }

    /// Returns the faults that happened.
    pub fn happened(&self) -> Happened {
        self.happened
    }

    /// Returns the number of instructions that were understood.
    pub fn understood(&self) -> u64 {
        self.understood
    }

    /// Takes a servo away: it answers no more.
    pub fn unplug(&mut self, id: u8) {
        self.change(id, |servo| servo.is_gone = true);
    }

    /// Lets a servo start anew, as after a loose power connector: without torque, at its own speed.
    pub fn reset(&mut self, id: u8) {
        self.change(id, Servo::reset);
    }

    /// Lets a servo get too hot in a few seconds.
    pub fn overheat(&mut self, id: u8) {
        self.change(id, Servo::overheat);
    }

    /// Lets something hold a servo, which needs all its torque then.
    pub fn block(&mut self, id: u8) {
        self.change(id, Servo::block);
    }

    /// Lets the supply of a servo drop to 7 V.
    pub fn sag(&mut self, id: u8) {
        self.change(id, Servo::sag);
    }

    /// Turns the shaft of a servo by hand, deg.
    pub fn turn(&mut self, id: u8, by: f64) {
        self.change(id, |servo| servo.turn(by));
    }

    fn change(&mut self, id: u8, change: impl FnMut(&mut Servo)) {
        let servos = self.servos.iter_mut();
        servos.filter(|servo| servo.id() == id).for_each(change);
    }

    /// Moves the servos until a time, µs.
    pub fn advance(&mut self, now: u64) {
        // Steps that are short against the lag.
        while self.time < now {
            let next = now.min(self.time + 2000);
            let time = (next - self.time) as f64 / 1e6;
            for servo in &mut self.servos {
                servo.advance(time, next);
            }
            self.time = next;
        }
    }

    /// Takes bytes from the master, the last of which arrived `now`, µs.
    pub fn receive(&mut self, bytes: &[u8], now: u64) {
        self.advance(now);
        for byte in bytes {
            if let Some(request) = self.reader.push(*byte) {
                self.understood += 1;
                self.execute(&request);
            }
        }
    }

    /// Returns the time of the next byte to the master, µs.
    pub fn next_byte(&self) -> Option<u64> {
        self.answers.first().map(|(at, _)| *at)
    }

    /// Removes the bytes that have come to the master by now.
    pub fn take_bytes(&mut self, now: u64, most: usize) -> Vec<u8> {
        let due = self.answers.iter().take_while(|(at, _)| *at <= now);
        let count = due.take(most).count();
        self.answers.drain(..count).map(|(_, byte)| byte).collect()
    }

    /// Puts a line after those that are on the way.
    fn append(&mut self, line: &[u8], can_fail: bool) {
        let last = self.answers.last().map_or(0, |(at, _)| *at);
        let after = last.saturating_sub(self.time);
        match can_fail {
            true => self.transmit(line, after),
            false => self.put(line, self.time + after),
        }
    }

    fn execute(&mut self, request: &Request) {
        match self.wire {
            Wire::Fdcanusb => self.forward(request),
            Wire::Lx => self.command(request),
            Wire::Dynamixel1 | Wire::Dynamixel2 => self.instruct(request),
        }
    }

    /// Executes a line of an fdcanusb: identity 0 means all.
    fn forward(&mut self, request: &Request) {
        self.append(wire::CONSENT, false);
        for place in self.addressed(request.id, 0) {
            let now = self.time;
            let servo = &mut self.servos[place];
            let answer = servo.serve(request.code, &request.parameters, now);
            // The highest bit of the sender asks for an answer.
            if let Some(payload) = answer.filter(|_| request.code & 0x80 != 0) {
                let line = self
                    .wire
                    .answer(servo.id(), 0, request.code & 0x7F, &payload);
                self.append(&line, true);
            }
        }
    }

    /// Executes a command of an LX. All servos answer to no other broadcast than a question for their identity.
    fn command(&mut self, request: &Request) {
        const ID_READ: u8 = 14;
        for place in self.addressed(request.id, BROADCAST) {
            let now = self.time;
            let servo = &mut self.servos[place];
            // It answers with the identity that it had.
            let id = servo.id();
            let answer = servo.serve(request.code, &request.parameters, now);
            let is_wanted = request.id != BROADCAST || request.code == ID_READ;
            if let Some(parameters) = answer.filter(|_| is_wanted) {
                let frame = self.wire.answer(id, request.code, 0, &parameters);
                self.transmit(&frame, 0);
            }
        }
    }

    /// Executes an instruction for servos with registers.
    fn instruct(&mut self, request: &Request) {
        let size = if self.wire == Wire::Dynamixel2 { 2 } else { 1 };
        let word = |bytes: &[u8]| {
            bytes
                .iter()
                .rev()
                .fold(0, |word, byte| word << 8 | u16::from(*byte))
        };
        let parameters = &request.parameters[..];
        let (first, rest) = parameters.split_at(size.min(parameters.len()));
        let (second, others) = rest.split_at(size.min(rest.len()));
        let (start, length) = (word(first), word(second));
        let meant = self.addressed(request.id, BROADCAST);
        for place in &meant {
            self.servos[*place].firmware.hear(self.time);
        }
        let is_broadcast = request.id == BROADCAST;
        match request.code {
            instruction::PING => {
                for place in meant {
                    let parameters = self.registers(place).map(|it| it.ping());
                    self.answer(place, parameters.map(Reply::of), 0);
                }
            }
            instruction::READ if second.len() == size && !is_broadcast => {
                for place in meant {
                    self.answer_read(place, start, length, 0);
                }
            }
            instruction::WRITE => {
                for place in meant {
                    // The answer has the identity that it had.
                    let id = self.servos[place].id();
                    let registers = self.servos[place].firmware.registers_mut();
                    let reply = registers.map(|registers| registers.write(start, rest));
                    let answers = self.registers(place).is_some_and(|it| it.answers().1);
                    if answers && !is_broadcast {
                        self.answer_as(place, id, reply, 0);
                    }
                }
            }
            instruction::FAST_SYNC_READ if self.wire == Wire::Dynamixel2 => {
                self.answer_fast(start, length, others);
            }
            instruction::SYNC_READ => {
                let mut after = 0;
                for id in others {
                    for place in self.addressed(*id, BROADCAST) {
                        after += self.answer_read(place, start, length, after);
                    }
                }
            }
            instruction::SYNC_WRITE => {
                for part in others.chunks_exact(usize::from(length) + 1) {
                    for place in self.addressed(part[0], BROADCAST) {
                        if let Some(registers) = self.servos[place].firmware.registers_mut() {
                            registers.write(start, &part[1..]);
                        }
                    }
                }
            }
            _ if !is_broadcast => {
                for place in meant {
                    let error = self.registers(place).map(|it| it.instruction_error());
                    self.answer(place, error.map(Reply::error), 0);
                }
            }
            _ => {}
        }
    }

    /// Returns the places of the servos that an identity means.
    fn addressed(&self, id: u8, all: u8) -> Vec<usize> {
        let servos = self.servos.iter().enumerate();
        let meant = servos.filter(|(_, servo)| !servo.is_gone && (id == all || servo.id() == id));
        meant.map(|(place, _)| place).collect()
    }

    fn registers(&self, place: usize) -> Option<&dyn Registers> {
        self.servos[place].firmware.registers()
    }

    /// Sends registers `after` µs, and returns how long that takes.
    fn answer_read(&mut self, place: usize, start: u16, length: u16, after: u64) -> u64 {
        if !self.registers(place).is_some_and(|it| it.answers().0) {
            return 0;
        }
        let reply = self.servos[place].read(start, length);
        self.answer(place, reply, after)
    }

    fn answer_fast(&mut self, start: u16, length: u16, ids: &[u8]) {
        let mut parts = Vec::new();
        for id in ids {
            for place in self.addressed(*id, BROADCAST) {
                if let Some(reply) = self.servos[place].read(start, length) {
                    let alarm = self.registers(place).map_or(0, |it| it.alarm());
                    let error = alarm | reply.error;
                    parts.push((self.servos[place].id(), error, reply.parameters));
                }
            }
        }
        self.transmit(&Wire::fast_answer(&parts), 0);
    }

    /// Sends an answer `after` µs, and returns how long that takes.
    fn answer(&mut self, place: usize, reply: Option<Reply>, after: u64) -> u64 {
        self.answer_as(place, self.servos[place].id(), reply, after)
    }

    fn answer_as(&mut self, place: usize, id: u8, reply: Option<Reply>, after: u64) -> u64 {
        let (Some(reply), Some(registers)) = (reply, self.registers(place)) else {
            return 0;
        };
        let delay = registers.return_delay();
        let error = registers.alarm() | reply.error;
        let frame = self.wire.answer(id, error, 0, &reply.parameters);
        self.transmit(&frame, after + delay);
        delay + self.timing.bytes(frame.len())
    }

    /// Puts bytes on the wire, with a fault perhaps.
    fn transmit(&mut self, frame: &[u8], after: u64) {
        let Faults {
            corrupt,
            drop,
            duplicate,
            delay,
            truncate,
        } = self.faults;
        let mut bytes = frame.to_vec();
        let mut at = self.time + after;
        let chance = self.chance();
        let kinds = [corrupt, drop, duplicate, delay, truncate];
        let mut below = 0.0;
        let kind = kinds.iter().position(|probability| {
            below += probability;
            chance < below
        });
        match kind {
            Some(0) => {
                self.happened.corrupt += 1;
                self.damage(&mut bytes);
            }
            Some(1) => {
                self.happened.dropped += 1;
                return;
            }
            Some(2) => {
                self.happened.duplicated += 1;
                let later = at + self.timing.bytes(bytes.len());
                self.put(&bytes, later);
            }
            Some(3) => {
                self.happened.delayed += 1;
                at += (self.chance() * 30_000.0) as u64;
            }
            Some(_) => {
                self.happened.truncated += 1;
                let left = self.below(bytes.len());
                bytes.truncate(left);
            }
            None => {}
        }
        self.put(&bytes, at);
    }

    /// Damages a frame as a line does: a bit, a byte, or a burst of bytes.
    fn damage(&mut self, bytes: &mut [u8]) {
        let first = self.below(bytes.len());
        match self.below(3) {
            0 => bytes[first] ^= 1 << self.below(8),
            1 => bytes[first] ^= 1 + self.below(255) as u8,
            _ => {
                let length = 2 + self.below(3);
                for byte in bytes.iter_mut().skip(first).take(length) {
                    *byte ^= 1 + self.below(255) as u8;
                }
            }
        }
    }

    /// Puts bytes on the wire. Where two servos send, zeros win.
    fn put(&mut self, bytes: &[u8], at: u64) {
        // Times are rounded up: two bytes of a frame may be this close.
        let each = 10_000_000 / u64::from(self.timing.baud);
        for (number, byte) in bytes.iter().enumerate() {
            let at = at + self.timing.bytes(number + 1);
            let place = self
                .answers
                .partition_point(|(other, _)| other + each <= at);
            match self.answers.get_mut(place) {
                Some((other, old)) if *other < at + each => *old &= byte,
                _ => self.answers.insert(place, (at, *byte)),
            }
        }
    }

    /// Returns a number from 0 to 1.
    fn chance(&mut self) -> f64 {
        // SplitMix64.
        self.random = self.random.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.random;
        z = (z ^ z >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ z >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ z >> 31) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn below(&mut self, end: usize) -> usize {
        (self.chance() * end as f64) as usize
    }
}

/// A simulated bus as a port, with a clock of its own: bytes take their time on the wire, and waiting takes none of ours.
#[derive(Clone, Debug)]
pub struct MemoryPort {
    /// The servos at its end.
    pub bus: SimulatedBus,
    now: u64,
}

impl MemoryPort {
    /// Creates a port at time 0.
    pub fn new(bus: SimulatedBus) -> Self {
        MemoryPort { bus, now: 0 }
    }

    /// Lets time pass until a time, µs.
    pub fn pass(&mut self, until: u64) {
        self.now = self.now.max(until);
        self.bus.advance(self.now);
    }
}

impl embedded_io::ErrorType for MemoryPort {
    type Error = Infallible;
}

impl embedded_io::Read for MemoryPort {
    fn read(&mut self, into: &mut [u8]) -> Result<usize, Infallible> {
        let bytes = self.bus.take_bytes(self.now, into.len());
        into[..bytes.len()].copy_from_slice(&bytes);
        Ok(bytes.len())
    }
}

impl embedded_io::Write for MemoryPort {
    fn write(&mut self, bytes: &[u8]) -> Result<usize, Infallible> {
        self.now += self.bus.timing.bytes(bytes.len());
        self.bus.receive(bytes, self.now);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> Result<(), Infallible> {
        Ok(())
    }
}

impl Port for MemoryPort {
    fn now(&mut self) -> u64 {
        self.now
    }

    fn wait(&mut self, until: u64) -> Result<bool, Infallible> {
        match self.bus.next_byte() {
            Some(at) if at <= until.max(self.now) => {
                self.pass(at);
                Ok(true)
            }
            _ => {
                self.pass(until);
                Ok(false)
            }
        }
    }
}
