//! Frames of the protocols: bytes to be sent, and answers in a stream of bytes that may be damaged.

use crate::moteus;
use heapless::Vec;

/// The frames that a servo understands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Protocol {
    /// Dynamixel protocol 1: a checksum of 8 bits.
    Dynamixel1,
    /// Dynamixel protocol 2: a CRC of 16 bits.
    Dynamixel2,
    /// Feetech STS: frames of Dynamixel protocol 1, with a sync read.
    Feetech,
    /// Lines of an fdcanusb adapter, which `moteus` writes.
    Moteus,
}

/// The identity that every servo listens to.
pub const BROADCAST: u8 = 0xFE;
/// The largest identity of a servo.
pub const LAST_ID: u8 = 252;
/// The longest frame, bytes.
pub const LONGEST: usize = 512;

/// A frame to be sent.
pub type Bytes = Vec<u8, LONGEST>;

/// The frame does not fit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooLong;

/// Instructions of a frame. The numbers are the same in all protocols.
pub mod instruction {
    /// Asks for an answer.
    pub const PING: u8 = 0x01;
    /// Reads registers.
    pub const READ: u8 = 0x02;
    /// Writes registers.
    pub const WRITE: u8 = 0x03;
    /// An answer, in protocol 2.
    pub const STATUS: u8 = 0x55;
    /// Reads registers of many servos.
    pub const SYNC_READ: u8 = 0x82;
    /// Writes registers of many servos.
    pub const SYNC_WRITE: u8 = 0x83;
    /// Reads registers of many servos, which answer in one frame.
    pub const FAST_SYNC_READ: u8 = 0x8A;
}

/// A frame without its framing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Frame {
    /// Receiver of a request, sender of an answer.
    pub id: u8,
    /// Instruction of a request, error byte of an answer.
    pub code: u8,
    /// Everything else.
    pub parameters: Vec<u8, LONGEST>,
}

const HEADER_1: [u8; 2] = [0xFF, 0xFF];
const HEADER_2: [u8; 4] = [0xFF, 0xFF, 0xFD, 0x00];
/// Bytes that may not appear in the body of a frame of protocol 2, and the one that is put after them.
const STUFFED: [u8; 3] = [0xFF, 0xFF, 0xFD];

impl Protocol {
    /// Returns the number of bytes of an answer with this many parameters, without stuffing.
    pub const fn answer_length(self, parameters: usize) -> usize {
        match self {
            Protocol::Dynamixel2 => parameters + 11,
            Protocol::Moteus => moteus::EXCHANGE,
            _ => parameters + 6,
        }
    }

    /// Returns the bytes of a request.
    ///
    /// # Errors
    /// It has too many parameters.
    pub fn request(self, id: u8, instruction: u8, parameters: &[u8]) -> Result<Bytes, TooLong> {
        self.encode(id, &[instruction], parameters)
    }

    /// Returns the bytes of an answer, as a servo sends them.
    ///
    /// # Errors
    /// It has too many parameters.
    pub fn answer(self, id: u8, error: u8, parameters: &[u8]) -> Result<Bytes, TooLong> {
        match self {
            Protocol::Dynamixel2 => self.encode(id, &[instruction::STATUS, error], parameters),
            _ => self.encode(id, &[error], parameters),
        }
    }

    fn encode(self, id: u8, codes: &[u8], parameters: &[u8]) -> Result<Bytes, TooLong> {
        debug_assert!(
            self != Protocol::Moteus,
            "its requests are made by `moteus`"
        );
        let mut frame = Bytes::new();
        let add =
            |frame: &mut Bytes, bytes: &[u8]| frame.extend_from_slice(bytes).map_err(|_| TooLong);
        if self == Protocol::Dynamixel2 {
            add(&mut frame, &HEADER_2)?;
            add(&mut frame, &[id, 0, 0])?;
            for byte in codes.iter().chain(parameters) {
                add(&mut frame, &[*byte])?;
                if frame[7..].ends_with(&STUFFED) {
                    add(&mut frame, &STUFFED[2..])?;
                }
            }
            let length = u16::try_from(frame.len() - 7 + 2).map_err(|_| TooLong)?;
            frame[5..7].copy_from_slice(&length.to_le_bytes());
            let crc = crc16(&frame).to_le_bytes();
            add(&mut frame, &crc)?;
        } else {
            let length = u8::try_from(codes.len() + parameters.len() + 1).map_err(|_| TooLong)?;
            add(&mut frame, &HEADER_1)?;
            add(&mut frame, &[id, length])?;
            add(&mut frame, codes)?;
            add(&mut frame, parameters)?;
            let sum = checksum(&frame[2..]);
            add(&mut frame, &[sum])?;
        }
        Ok(frame)
    }

    /// Tries to read a frame at the beginning of `bytes`. An answer of another length is refused as soon as its length is there.
    fn parse(self, bytes: &[u8], reads: Reads) -> Parsed {
        match self {
            Protocol::Dynamixel2 => parse_2(bytes, reads),
            Protocol::Moteus => parse_line(bytes, reads),
            _ => parse_1(bytes, reads),
        }
    }
}

/// The frames that a decoder reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reads {
    /// Requests, of any length.
    Requests,
    /// Answers with this many parameters.
    Answers(usize),
    /// Answers of a moteus to this sender.
    AnswersTo(u8),
}

#[allow(clippy::large_enum_variant, reason = "there is no allocator")]
enum Parsed {
    /// A frame, and the number of its bytes.
    Frame(Frame, usize),
    /// The beginning of a frame, perhaps; more bytes decide.
    Unfinished,
    /// A line that is no frame, and the number of its bytes.
    Line(usize),
    /// No frame begins here.
    Nothing,
}

fn begins(bytes: &[u8], header: &[u8]) -> bool {
    bytes
        .iter()
        .zip(header)
        .all(|(byte, wanted)| byte == wanted)
}

fn parse_1(bytes: &[u8], reads: Reads) -> Parsed {
    let (Some(&id), Some(&length)) = (bytes.get(2), bytes.get(3)) else {
        return match begins(bytes, &HEADER_1) && bytes.get(2) != Some(&0xFF) {
            true => Parsed::Unfinished,
            false => Parsed::Nothing,
        };
    };
    let length = usize::from(length);
    let fits = match reads {
        Reads::Requests => length >= 2,
        Reads::Answers(wanted) => length == wanted + 2,
        Reads::AnswersTo(_) => false,
    };
    if !begins(bytes, &HEADER_1) || id == 0xFF || !fits {
        return Parsed::Nothing;
    }
    let Some(body) = bytes.get(2..length + 4) else {
        return Parsed::Unfinished;
    };
    let [body @ .., sum] = body else {
        return Parsed::Nothing;
    };
    let (Some(code), Ok(parameters)) = (body.get(2), Vec::from_slice(&body[3..])) else {
        return Parsed::Nothing;
    };
    if checksum(body) != *sum {
        return Parsed::Nothing;
    }
    let code = *code;
    let frame = Frame {
        id,
        code,
        parameters,
    };
    Parsed::Frame(frame, length + 4)
}

fn parse_2(bytes: &[u8], reads: Reads) -> Parsed {
    if !begins(bytes, &HEADER_2) {
        return Parsed::Nothing;
    }
    let Some(&[_, _, _, _, id, low, high]) = bytes.first_chunk::<7>() else {
        return Parsed::Unfinished;
    };
    let length = usize::from(u16::from_le_bytes([low, high]));
    let fits = match reads {
        Reads::Requests => (3..=LONGEST - 7).contains(&length),
        // One byte is stuffed after three at the most.
        Reads::Answers(wanted) => (wanted + 4..=wanted + 5 + wanted / 3).contains(&length),
        Reads::AnswersTo(_) => false,
    };
    if !fits {
        return Parsed::Nothing;
    }
    let Some(whole) = bytes.get(..length + 7) else {
        return Parsed::Unfinished;
    };
    let (body, crc) = whole.split_at(whole.len() - 2);
    if crc16(body).to_le_bytes() != crc {
        return Parsed::Nothing;
    }
    let mut plain = Vec::<u8, LONGEST>::new();
    let mut stuffed = false;
    for byte in &body[7..] {
        // The byte after the three is not part of the message.
        if !stuffed && plain.push(*byte).is_err() {
            return Parsed::Nothing;
        }
        stuffed = !stuffed && plain.ends_with(&STUFFED);
    }
    let (code, parameters) = match (reads, &plain[..]) {
        (Reads::Requests, [code, parameters @ ..]) => (*code, parameters),
        (Reads::Answers(wanted), [instruction::STATUS, error, parameters @ ..])
            if parameters.len() == wanted =>
        {
            (*error, parameters)
        }
        _ => return Parsed::Nothing,
    };
    let Ok(parameters) = Vec::from_slice(parameters) else {
        return Parsed::Nothing;
    };
    let frame = Frame {
        id,
        code,
        parameters,
    };
    Parsed::Frame(frame, length + 7)
}

/// Reads a line of an fdcanusb adapter, or one to it.
fn parse_line(bytes: &[u8], reads: Reads) -> Parsed {
    let Some(end) = bytes.iter().position(|byte| *byte == b'\n') else {
        return match bytes.len() < LONGEST / 2 {
            true => Parsed::Unfinished,
            false => Parsed::Nothing,
        };
    };
    let line = &bytes[..end];
    if moteus::is_consent(line) {
        return Parsed::Line(end + 1);
    }
    let frame = match reads {
        Reads::Requests => moteus::request(line).map(|request| Frame {
            id: request.id,
            code: request.from | u8::from(request.is_answered) << 7,
            // A CAN-FD frame is shorter than the longest one.
            parameters: Vec::from_slice(&request.payload).unwrap_or_default(),
        }),
        Reads::AnswersTo(sender) => moteus::answer(line)
            .filter(|answer| answer.to == sender)
            .map(|answer| Frame {
                id: answer.id,
                code: u8::from(answer.is_faulty) << 7,
                parameters: Vec::from_slice(&answer.table).unwrap_or_default(),
            }),
        Reads::Answers(_) => None,
    };
    frame.map_or(Parsed::Nothing, |frame| Parsed::Frame(frame, end + 1))
}

/// Returns the checksum of protocol 1 over identity, length, code and parameters.
fn checksum(body: &[u8]) -> u8 {
    !body.iter().fold(0_u8, |sum, byte| sum.wrapping_add(*byte))
}

/// Returns the CRC of protocol 2: polynomial 0x8005, most significant bit first, from 0.
fn crc16(bytes: &[u8]) -> u16 {
    bytes.iter().fold(0_u16, |crc, byte| {
        (0..8).fold(crc ^ u16::from(*byte) << 8, |crc, _| match crc >> 15 {
            0 => crc << 1,
            _ => crc << 1 ^ 0x8005,
        })
    })
}

/// Finds frames in a stream of bytes. After damaged bytes it looks for a frame at each of the following ones, so that an intact
/// frame is found whatever came before it.
#[derive(Clone, Debug)]
pub struct Decoder {
    protocol: Protocol,
    buffer: Vec<u8, LONGEST>,
    discarded: u64,
}

impl Decoder {
    /// Creates a decoder with nothing in it.
    pub const fn new(protocol: Protocol) -> Self {
        Decoder {
            protocol,
            buffer: Vec::new(),
            discarded: 0,
        }
    }

    /// Adds a byte.
    pub fn push(&mut self, byte: u8) {
        if self.buffer.is_full() {
            self.drop_front(1);
        }
        // There is room now.
        let _ = self.buffer.push(byte);
    }

    /// Returns the next frame; bytes that cannot become one are discarded.
    pub fn next(&mut self, reads: Reads) -> Option<Frame> {
        loop {
            if self.buffer.is_empty() {
                return None;
            }
            match self.protocol.parse(&self.buffer, reads) {
                Parsed::Frame(frame, length) => {
                    self.buffer.drain(..length);
                    return Some(frame);
                }
                Parsed::Unfinished => return None,
                Parsed::Line(length) => self.drop_front(length),
                Parsed::Nothing => self.discard(1),
            }
        }
    }

    /// Returns the next frame after one that is not finished and never will be.
    pub fn next_after_silence(&mut self, reads: Reads) -> Option<Frame> {
        while !self.buffer.is_empty() {
            self.discard(1);
            if let Some(frame) = self.next(reads) {
                return Some(frame);
            }
        }
        None
    }

    /// Forgets everything.
    pub fn clear(&mut self) {
        self.discard(self.buffer.len());
    }

    /// Returns the number of bytes that were in no frame.
    pub const fn discarded(&self) -> u64 {
        self.discarded
    }

    fn discard(&mut self, count: usize) {
        self.discarded += count as u64;
        self.drop_front(count);
    }

    fn drop_front(&mut self, count: usize) {
        self.buffer.drain(..count.min(self.buffer.len()));
    }
}
