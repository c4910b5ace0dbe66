//! A serial bus as its master sees it: requests, and answers within a bounded time. The bytes of requests and answers belong to the
//! [families](crate::family), the meaning of their values to [`drives`](crate::drives).

use crate::frame::{Decoder, Frame, MAX_FRAME_BYTES, Parsed, TooLong};
use core::fmt;

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
    /// Maximum time that adapter and driver add to a request and its answer, µs.
    pub latency: u32,
}

impl Timing {
    /// Returns the time that bytes take on the wire, µs.
    pub const fn bytes(&self, count: usize) -> u64 {
        (count as u64 * 10_000_000).div_ceil(self.baud as u64)
    }

    /// Returns the time of an answer of this many bytes, without adapter and driver, µs.
    pub const fn answer(&self, bytes: usize) -> u64 {
        self.bytes(bytes) + self.return_delay as u64
    }
}

/// A reason for which a bus did not do what it was asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BusError {
    /// The port cannot be read or written: unplugged, perhaps.
    Port,
    /// No valid answer came in time.
    NoAnswer,
    /// The request is longer than a frame can be, or has more servos than a bus.
    TooLong,
    /// Servos of this family have no such request.
    Unsupported,
}

impl fmt::Display for BusError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            BusError::Port => "the port is gone",
            BusError::NoAnswer => "no answer",
            BusError::TooLong => "the request is too long",
            BusError::Unsupported => "these servos have no such request",
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

/// Maximum number of servos on a bus.
pub const MAX_SERVOS: usize = 81;

/// Number of bytes that are read after the time of the answers: those of all servos.
const MAX_LATE_BYTES: usize = 4 * MAX_FRAME_BYTES;

/// The answers that a request waits for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Wait {
    /// Number of answers.
    pub answers: usize,
    /// Maximum time after the request, without adapter and driver, µs.
    pub time: u64,
    /// Time of the port's clock at which waiting ends in any case, µs.
    pub limit: u64,
}

/// The bus as a family sees it, whatever its port.
pub trait Wire {
    /// Returns the time of the port's clock, µs.
    fn now(&mut self) -> u64;

    /// Returns the timing.
    fn timing(&self) -> Timing;

    /// Returns how often a request to one servo is sent until it is answered.
    fn tries(&self) -> u32;

    /// Returns a number that differs from that of the last 255 requests.
    fn next_number(&mut self) -> u8;

    /// Sends a request that has no answer.
    ///
    /// # Errors
    /// The port is gone.
    fn send(&mut self, request: &[u8]) -> Result<(), BusError>;

    /// Forgets what has come so far, so that nothing old is taken for an answer, sends a request, and gives the frames that `parse`
    /// finds to `take` until it returns true or the time is over.
    ///
    /// # Errors
    /// The port is gone.
    fn exchange(
        &mut self,
        request: &[u8],
        wait: Wait,
        parse: &dyn Fn(&[u8]) -> Parsed,
        take: &mut dyn FnMut(Frame) -> bool,
    ) -> Result<(), BusError>;

    /// Counts answers that came intact.
    fn count_answers(&mut self, count: u64);
}

impl dyn Wire + '_ {
    /// Sends a request to one servo until it answers: `parse` accepts the bytes of its answers, `read` returns the value of one.
    ///
    /// # Errors
    /// The port is gone, or no valid answer came.
    pub fn ask<T>(
        &mut self,
        request: &[u8],
        wait: Wait,
        parse: &dyn Fn(&[u8]) -> Parsed,
        mut read: impl FnMut(&Frame) -> Option<T>,
    ) -> Result<T, BusError> {
        let mut found = None;
        self.exchange(request, wait, parse, &mut |frame| {
            found = read(&frame);
            found.is_some()
        })?;
        self.count_answers(found.is_some().into());
        found.ok_or(BusError::NoAnswer)
    }

    /// Repeats a request that has no answer.
    ///
    /// # Errors
    /// The last error.
    pub fn repeat<T>(
        &mut self,
        mut request: impl FnMut(&mut Self) -> Result<T, BusError>,
    ) -> Result<T, BusError> {
        for _ in 1..self.tries() {
            match request(self) {
                Err(BusError::NoAnswer) => {}
                done => return done,
            }
        }
        request(self)
    }
}

/// A bus with servos of one family.
#[derive(Debug)]
pub struct Bus<P> {
    port: P,
    timing: Timing,
    tries: u32,
    decoder: Decoder,
    counters: Counters,
    /// Number of the last request.
    number: u8,
}

impl<P: Port> Bus<P> {
    /// Creates the master of a bus.
    pub const fn new(port: P, timing: Timing) -> Self {
        Bus {
            port,
            timing,
            tries: 3,
            decoder: Decoder::new(),
            counters: Counters {
                asked: 0,
                answered: 0,
                discarded: 0,
                bytes: 0,
            },
            number: 0,
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

    /// Sets how often a request to one servo is sent until it is answered; 3 at first.
    pub const fn set_tries(&mut self, tries: u32) {
        self.tries = tries;
    }

    /// Returns what was counted.
    pub const fn counters(&self) -> Counters {
        Counters {
            discarded: self.decoder.discarded(),
            ..self.counters
        }
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
}

impl<P: Port> Wire for Bus<P> {
    fn now(&mut self) -> u64 {
        self.port.now()
    }

    fn timing(&self) -> Timing {
        self.timing
    }

    fn tries(&self) -> u32 {
        self.tries
    }

    fn next_number(&mut self) -> u8 {
        self.number = self.number.wrapping_add(1);
        self.number
    }

    fn send(&mut self, request: &[u8]) -> Result<(), BusError> {
        self.counters.bytes += request.len() as u64;
        self.port.write_all(request).map_err(|_| BusError::Port)?;
        self.port.flush().map_err(|_| BusError::Port)
    }

    fn exchange(
        &mut self,
        request: &[u8],
        wait: Wait,
        parse: &dyn Fn(&[u8]) -> Parsed,
        take: &mut dyn FnMut(Frame) -> bool,
    ) -> Result<(), BusError> {
        self.counters.asked += wait.answers as u64;
        self.decoder.clear();
        let now = self.port.now();
        let mut old = 0;
        // A port that never falls silent must not hold the cycle.
        while old < MAX_FRAME_BYTES && self.port.wait(now).map_err(|_| BusError::Port)? {
            old += self.receive()?;
            self.decoder.clear();
        }
        self.send(request)?;
        // A port may take the request before it is on the wire.
        let time = self.timing.bytes(request.len()) + wait.time + u64::from(self.timing.latency);
        let limit = wait.limit.min(self.port.now().saturating_add(time));
        let mut late = 0;
        while self.port.wait(limit).map_err(|_| BusError::Port)? {
            let count = self.receive()?;
            while let Some(frame) = self.decoder.next(parse) {
                if take(frame) {
                    return Ok(());
                }
            }
            // A host that woke up late finds answers that came in time.
            if self.port.now() >= limit {
                late += count;
            }
            if late > MAX_LATE_BYTES {
                break;
            }
        }
        while let Some(frame) = self.decoder.next_after_silence(parse) {
            if take(frame) {
                return Ok(());
            }
        }
        Ok(())
    }

    fn count_answers(&mut self, count: u64) {
        self.counters.answered += count;
    }
}
