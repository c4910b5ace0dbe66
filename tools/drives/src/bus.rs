//! The master of a bus: requests, and answers within a bounded time. What the values mean belongs to `drives`.

use crate::frame::{
    BROADCAST, Bytes, Decoder, Frame, LONGEST, Protocol, Reads, TooLong, instruction,
};
use crate::model::{Family, Register, Window};
use crate::moteus::{self, Command, Line};
use core::fmt;
use heapless::Vec;

/// A serial port with a clock.
pub trait Port: embedded_io::Read + embedded_io::Write {
    /// Returns the time since any moment, µs.
    fn now(&mut self) -> u64;

    /// Waits until a byte can be read, or until a time of the clock; returns true if one can.
    ///
    /// # Errors
    /// The port is gone.
    fn wait(&mut self, until: u64) -> Result<bool, Self::Error>;
}

/// Timing of a bus.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Timing {
    /// Bits per second; a byte is 10 bits.
    pub baud: u32,
    /// Delay of the servos' answers, µs.
    pub return_delay: u32,
    /// The most that adapter and driver add to a request and its answer, µs.
    pub latency: u32,
}

impl Timing {
    /// Returns the time that bytes take on the wire, µs.
    pub const fn bytes(&self, count: usize) -> u64 {
        (count as u64 * 10_000_000).div_ceil(self.baud as u64)
    }
}

/// A reason why a bus did not do what it was asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BusError {
    /// The port cannot be read or written: unplugged, perhaps.
    Port,
    /// No valid answer came in time.
    NoAnswer,
    /// The request is longer than a frame can be.
    TooLong,
}

impl fmt::Display for BusError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            BusError::Port => "the port is gone",
            BusError::NoAnswer => "no answer",
            BusError::TooLong => "the request is too long",
        })
    }
}

impl core::error::Error for BusError {}

impl From<TooLong> for BusError {
    fn from(_: TooLong) -> Self {
        BusError::TooLong
    }
}

/// Counts of what happened on a bus.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counters {
    /// Answers that were asked for.
    pub asked: u64,
    /// Answers that came intact, complete and in time.
    pub answered: u64,
    /// Bytes that belonged to no valid answer.
    pub discarded: u64,
    /// Bytes sent and received.
    pub bytes: u64,
}

/// The most servos of one sync read or sync write.
pub const SERVOS: usize = 81;
/// Servos in one frame of a sync write: a frame of protocol 1 has 255 bytes at most.
const IN_A_FRAME: usize = 40;

/// A bus with servos of one protocol.
#[derive(Debug)]
pub struct Bus<P> {
    port: P,
    timing: Timing,
    decoder: Decoder,
    protocol: Protocol,
    counters: Counters,
    /// Registers of moteus controllers, of which commands are made.
    commands: Vec<(u8, Command), SERVOS>,
    /// Number of requests to moteus controllers.
    requests: u8,
}

impl<P: Port> Bus<P> {
    /// Creates the master of a bus.
    pub const fn new(port: P, protocol: Protocol, timing: Timing) -> Self {
        Bus {
            port,
            timing,
            decoder: Decoder::new(protocol),
            protocol,
            counters: Counters {
                asked: 0,
                answered: 0,
                discarded: 0,
                bytes: 0,
            },
            commands: Vec::new(),
            requests: 0,
        }
    }

    /// Returns the port.
    pub const fn port(&self) -> &P {
        &self.port
    }

    /// Returns the port.
    pub const fn port_mut(&mut self) -> &mut P {
        &mut self.port
    }

    /// Returns the timing.
    pub const fn timing(&self) -> Timing {
        self.timing
    }

    /// Sets the delay of answers that the servos report, µs.
    pub const fn set_return_delay(&mut self, delay: u32) {
        self.timing.return_delay = delay;
    }

    /// Returns what was counted.
    pub const fn counters(&self) -> Counters {
        Counters {
            discarded: self.decoder.discarded(),
            ..self.counters
        }
    }

    /// Reads three registers or more from one servo.
    ///
    /// # Errors
    /// The port is gone, or no valid answer came.
    pub fn read(&mut self, id: u8, window: Window) -> Result<Frame, BusError> {
        let limit = self.port.now() + self.longest(1, window.length.into());
        self.read_until(id, window, limit)
    }

    /// Reads registers of one servo, but waits no longer than until a time of the port's clock.
    ///
    /// # Errors
    /// The port is gone, or no valid answer came.
    pub fn read_until(&mut self, id: u8, window: Window, limit: u64) -> Result<Frame, BusError> {
        if self.protocol == Protocol::Moteus {
            return self.exchange(id, moteus::query, limit);
        }
        let parameters = self.of_window(window)?;
        let request = self.protocol.request(id, instruction::READ, &parameters)?;
        self.ask_one(id, &request, window.length.into(), limit)
    }

    /// Reads one register of a servo.
    ///
    /// # Errors
    /// The port is gone, or no valid answer came.
    pub fn read_register(&mut self, id: u8, register: Register) -> Result<i32, BusError> {
        // Shorter answers look like the echo of their request, which some adapters return.
        let length = register.width.max(3);
        let start = register
            .address
            .saturating_sub(u16::from(length - register.width));
        let frame = self.read(id, Window { start, length })?;
        let start = match self.protocol {
            // Its answers always are the beginning of the table.
            Protocol::Moteus => 0,
            _ => start,
        };
        let value = register.decode(start, &frame.parameters);
        value.ok_or(BusError::NoAnswer)
    }

    /// Writes a register of one servo, and waits for its confirmation.
    ///
    /// # Errors
    /// The port is gone, or no valid answer came.
    pub fn write(&mut self, id: u8, register: Register, value: i32) -> Result<u8, BusError> {
        if self.protocol == Protocol::Moteus {
            let limit = self.port.now() + self.longest(1, 0);
            return match self.command(id, register, value)? {
                Some(command) => self
                    .exchange(id, |id, sender| command.line(id, sender, true), limit)
                    .map(|answer| answer.code),
                None => Ok(0),
            };
        }
        let mut parameters = self.address(register.address)?;
        let bytes = register.encode(value);
        let bytes = &bytes[..register.width.into()];
        parameters.extend_from_slice(bytes).map_err(|_| TooLong)?;
        let request = self.protocol.request(id, instruction::WRITE, &parameters)?;
        let answer = self.ask_one(id, &request, 0, u64::MAX)?;
        Ok(answer.code)
    }

    /// Writes the same register of many servos. There are no answers.
    ///
    /// # Errors
    /// The port is gone.
    pub fn sync_write(&mut self, register: Register, values: &[(u8, i32)]) -> Result<(), BusError> {
        if self.protocol == Protocol::Moteus {
            for (id, value) in values {
                if let Some(command) = self.command(*id, register, *value)? {
                    self.send(&command.line(*id, moteus::sender(0), false))?;
                }
            }
            return Ok(());
        }
        for values in values.chunks(IN_A_FRAME) {
            let mut parameters = self.address(register.address)?;
            match self.protocol {
                Protocol::Dynamixel2 => add(&mut parameters, &[register.width, 0])?,
                _ => add(&mut parameters, &[register.width])?,
            }
            for (id, value) in values {
                add(&mut parameters, &[*id])?;
                let bytes = register.encode(*value);
                add(&mut parameters, &bytes[..register.width.into()])?;
            }
            let code = instruction::SYNC_WRITE;
            let request = self.protocol.request(BROADCAST, code, &parameters)?;
            self.send(&request)?;
        }
        Ok(())
    }

    /// Reads the same registers of many servos, in one request where the family allows it, else one by one until `limit`, a time of
    /// the port's clock. `answer` gets the place of each servo in `ids` with its error byte and its registers; a servo that does not
    /// answer is left out. Returns the number of servos that were asked.
    ///
    /// # Errors
    /// The port is gone.
    pub fn read_many(
        &mut self,
        family: &Family,
        window: Window,
        ids: &[u8],
        limit: u64,
        fast: bool,
        mut answer: impl FnMut(usize, u8, &[u8]),
    ) -> Result<usize, BusError> {
        if !family.reads_many {
            for (place, id) in ids.iter().enumerate() {
                if place > 0 && self.port.now() + self.shortest(1, window.length.into()) > limit {
                    return Ok(place);
                }
                match self.read_until(*id, window, limit) {
                    Ok(frame) => answer(place, frame.code, &frame.parameters),
                    Err(BusError::NoAnswer) => {}
                    Err(error) => return Err(error),
                }
            }
            return Ok(ids.len());
        }
        let mut parameters = self.of_window(window)?;
        add(&mut parameters, ids)?;
        if fast && self.protocol == Protocol::Dynamixel2 {
            return self.read_fast(window, ids, limit, &parameters, answer);
        }
        let code = instruction::SYNC_READ;
        let request = self.protocol.request(BROADCAST, code, &parameters)?;
        self.ask(&request, ids.len())?;
        let limit = limit.min(self.port.now() + self.longest(ids.len(), window.length.into()));
        let mut found: Vec<Option<Answer>, SERVOS> = Vec::new();
        found
            .resize(ids.len().min(SERVOS), None)
            .map_err(|_| BusError::TooLong)?;
        let mut missing = found.len();
        self.collect(Reads::Answers(window.length.into()), limit, |frame| {
            let place = ids.iter().position(|id| *id == frame.id);
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
        for (place, frame) in found.iter().enumerate() {
            if let Some(frame) = frame.as_ref().filter(|frame| !frame.is_doubtful) {
                self.counters.answered += 1;
                answer(place, frame.error, &frame.bytes);
            }
        }
        Ok(ids.len())
    }

    /// Reads many servos that answer in one frame: it is valid as a whole or not at all.
    fn read_fast(
        &mut self,
        window: Window,
        ids: &[u8],
        limit: u64,
        parameters: &[u8],
        mut answer: impl FnMut(usize, u8, &[u8]),
    ) -> Result<usize, BusError> {
        let length = usize::from(window.length);
        // Between two servos there are two bytes of a checksum, and the next one's error and identity.
        let each = length + 4;
        // The error of the first is where that of any answer is.
        let wanted = (each * ids.len()).saturating_sub(3);
        let code = instruction::FAST_SYNC_READ;
        let request = self.protocol.request(BROADCAST, code, parameters)?;
        self.ask(&request, ids.len())?;
        let limit = limit.min(self.port.now() + self.longest(ids.len(), length));
        let mut whole = None;
        self.collect(Reads::Answers(wanted), limit, |frame| {
            whole = (frame.id == BROADCAST).then_some(frame);
            whole.is_some()
        })?;
        let Some(frame) = whole else {
            return Ok(ids.len());
        };
        let mut error = frame.code;
        for (place, (id, part)) in ids.iter().zip(frame.parameters.chunks(each)).enumerate() {
            let (Some(own), Some(bytes)) = (part.first(), part.get(1..=length)) else {
                break;
            };
            if own == id {
                self.counters.answered += 1;
                answer(place, error, bytes);
            }
            error = part.last().copied().unwrap_or_default();
        }
        Ok(ids.len())
    }

    /// Repeats a request that has no answer.
    fn again<T>(
        &mut self,
        times: u32,
        mut request: impl FnMut(&mut Self) -> Result<T, BusError>,
    ) -> Result<T, BusError> {
        for _ in 1..times {
            match request(self) {
                Err(BusError::NoAnswer) => {}
                done => return done,
            }
        }
        request(self)
    }

    /// Asks every identity for its model, one after the other and twice if it is silent, and calls `found` with those that answer.
    ///
    /// # Errors
    /// The port is gone.
    pub fn scan(
        &mut self,
        family: &Family,
        ids: impl IntoIterator<Item = u8>,
        mut found: impl FnMut(u8, u16),
    ) -> Result<(), BusError> {
        for id in ids {
            match self.again(2, |bus| bus.read_register(id, family.model)) {
                Ok(number) => found(id, number as u16),
                Err(BusError::NoAnswer) => {}
                Err(error) => return Err(error),
            }
        }
        Ok(())
    }

    /// Gives a servo another identity, which it keeps without power. Its torque is switched off.
    ///
    /// # Errors
    /// The port is gone, or the servo does not answer.
    pub fn set_id(&mut self, family: &Family, id: u8, to: u8) -> Result<(), BusError> {
        self.again(3, |bus| bus.write(id, family.torque_enable, 0))?;
        if let Some(lock) = family.lock {
            self.again(3, |bus| bus.write(id, lock, 0))?;
        }
        // Some servos answer with the old identity, others with the new one.
        match self.write(id, family.id, to.into()) {
            Ok(_) | Err(BusError::NoAnswer) => {}
            Err(error) => return Err(error),
        }
        if let Some(lock) = family.lock {
            self.again(3, |bus| bus.write(to, lock, 1))?;
        }
        self.again(3, |bus| bus.read_register(to, family.model))
            .map(drop)
    }

    /// Returns the longest time in which answers of this many servos with this many parameters come, µs.
    pub fn longest(&self, servos: usize, parameters: usize) -> u64 {
        self.shortest(servos, parameters) + u64::from(self.timing.latency)
    }

    /// Returns the time that answers take on the wire, µs.
    fn shortest(&self, servos: usize, parameters: usize) -> u64 {
        // A frame of protocol 2 has stuffed bytes sometimes.
        let bytes = self.protocol.answer_length(parameters + parameters / 3);
        servos as u64 * (self.timing.bytes(bytes) + u64::from(self.timing.return_delay))
    }

    /// Sends a request to a moteus and waits for its answer.
    fn exchange(
        &mut self,
        id: u8,
        request: impl FnOnce(u8, u8) -> Line,
        limit: u64,
    ) -> Result<Frame, BusError> {
        if id > moteus::LAST_ID {
            return Err(BusError::NoAnswer);
        }
        self.requests = self.requests.wrapping_add(1);
        let sender = moteus::sender(self.requests);
        self.ask(&request(id, sender), 1)?;
        let limit = limit.min(self.port.now() + self.longest(1, 0));
        self.answer_of(id, Reads::AnswersTo(sender), limit)
    }

    /// Sends a request to one servo and waits for its answer with this many parameters.
    fn ask_one(
        &mut self,
        id: u8,
        request: &[u8],
        parameters: usize,
        limit: u64,
    ) -> Result<Frame, BusError> {
        self.ask(request, 1)?;
        let limit = limit.min(self.port.now() + self.longest(1, parameters));
        self.answer_of(id, Reads::Answers(parameters), limit)
    }

    /// Waits for the answer of a servo.
    fn answer_of(&mut self, id: u8, reads: Reads, limit: u64) -> Result<Frame, BusError> {
        let mut found = None;
        self.collect(reads, limit, |frame| {
            found = (frame.id == id).then_some(frame);
            found.is_some()
        })?;
        self.counters.answered += u64::from(found.is_some());
        found.ok_or(BusError::NoAnswer)
    }

    /// Writes a register of a moteus; returns the command if the controller must hear of it.
    fn command(
        &mut self,
        id: u8,
        register: Register,
        value: i32,
    ) -> Result<Option<Command>, BusError> {
        if !self.commands.iter().any(|(other, _)| *other == id) {
            let new = (id, Command::default());
            self.commands.push(new).map_err(|_| BusError::TooLong)?;
        }
        let mut own = self.commands.iter_mut().filter(|(other, _)| *other == id);
        let command = own.next().map(|(_, command)| command);
        Ok(command.and_then(|it| it.set(register.address, value).then_some(*it)))
    }

    fn address(&self, address: u16) -> Result<Bytes, TooLong> {
        let mut parameters = Bytes::new();
        let [low, high] = address.to_le_bytes();
        match self.protocol {
            Protocol::Dynamixel2 => add(&mut parameters, &[low, high])?,
            _ => add(&mut parameters, &[low])?,
        }
        Ok(parameters)
    }

    fn of_window(&self, window: Window) -> Result<Bytes, TooLong> {
        let mut parameters = self.address(window.start)?;
        match self.protocol {
            Protocol::Dynamixel2 => add(&mut parameters, &[window.length, 0])?,
            _ => add(&mut parameters, &[window.length])?,
        }
        Ok(parameters)
    }

    /// Forgets what came so far, so that nothing old is taken for an answer, and sends a request for a number of answers.
    fn ask(&mut self, request: &[u8], answers: usize) -> Result<(), BusError> {
        self.counters.asked += answers as u64;
        self.decoder.clear();
        let now = self.port.now();
        let mut old = 0;
        // A port that never falls silent must not hold the cycle.
        while old < LONGEST && self.port.wait(now).map_err(|_| BusError::Port)? {
            old += self.receive()?;
            self.decoder.clear();
        }
        self.send(request)
    }

    fn send(&mut self, bytes: &[u8]) -> Result<(), BusError> {
        self.counters.bytes += bytes.len() as u64;
        self.port.write_all(bytes).map_err(|_| BusError::Port)?;
        self.port.flush().map_err(|_| BusError::Port)
    }

    /// Adds the bytes that have come to the decoder, and returns their number.
    fn receive(&mut self) -> Result<usize, BusError> {
        let mut bytes = [0; 64];
        let count = self.port.read(&mut bytes).map_err(|_| BusError::Port)?;
        if count == 0 {
            return Err(BusError::Port);
        }
        for byte in bytes.iter().take(count) {
            self.decoder.push(*byte);
        }
        self.counters.bytes += count as u64;
        Ok(count)
    }

    /// Gives frames to `take` until it returns true or it is `limit`.
    fn collect(
        &mut self,
        reads: Reads,
        limit: u64,
        mut take: impl FnMut(Frame) -> bool,
    ) -> Result<(), BusError> {
        while self.port.wait(limit).map_err(|_| BusError::Port)? {
            self.receive()?;
            while let Some(frame) = self.decoder.next(reads) {
                if take(frame) {
                    return Ok(());
                }
            }
            if self.port.now() >= limit {
                break;
            }
        }
        while let Some(frame) = self.decoder.next_after_silence(reads) {
            if take(frame) {
                return Ok(());
            }
        }
        Ok(())
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

fn add(to: &mut Bytes, bytes: &[u8]) -> Result<(), TooLong> {
    to.extend_from_slice(bytes).map_err(|_| TooLong)
}
