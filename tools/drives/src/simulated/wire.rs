//! Frames on the servos' side: requests in a stream of bytes, and answers.
//!
//! Sources: ROBOTIS e-Manual, "DYNAMIXEL Protocol 1.0" and "DYNAMIXEL Protocol 2.0" (with its "CRC Calculation"); LewanSoul, "Bus
//! Servo Communication Protocol", "Table 1"; mjbots, "fdcanusb", commands `can send` and `rcv`.

use std::format;
use std::vec;
use std::vec::Vec;

/// The frames of a bus.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Wire {
    /// FF FF, and a checksum of 8 bits.
    Dynamixel1,
    /// FF FF FD 00, and a CRC of 16 bits.
    Dynamixel2,
    /// 55 55, and a checksum of 8 bits.
    Lx,
    /// Lines of text.
    Fdcanusb,
}

/// A request.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Request {
    pub(super) id: u8,
    /// Instruction or command; of a CAN frame its sender, with the highest bit if an answer is wanted.
    pub(super) code: u8,
    pub(super) parameters: Vec<u8>,
}

/// The line with which an fdcanusb takes a request.
pub(super) const CONSENT: &[u8] = b"OK\n";

/// The longest request, bytes.
const MAX_REQUEST: usize = 1024;

fn checksum(bytes: &[u8]) -> u8 {
    !bytes
        .iter()
        .fold(0, |sum: u8, byte| sum.wrapping_add(*byte))
}

fn crc(bytes: &[u8]) -> [u8; 2] {
    let mut crc = 0_u16;
    for byte in bytes {
        crc ^= u16::from(*byte) << 8;
        for _ in 0..8 {
            let carry = crc & 0x8000 != 0;
            crc <<= 1;
            if carry {
                crc ^= 0x8005;
            }
        }
    }
    crc.to_le_bytes()
}

/// A request at the front of bytes.
enum Front {
    /// It takes this many bytes; `None` if they are no valid request.
    Whole(usize, Option<Request>),
    /// More bytes are needed.
    Part,
}

impl Wire {
    fn front(self, bytes: &[u8]) -> Front {
        match self {
            Wire::Dynamixel1 => short(bytes, 0xFF),
            Wire::Lx => short(bytes, 0x55),
            Wire::Dynamixel2 => long(bytes),
            Wire::Fdcanusb => match bytes.iter().position(|byte| *byte == b'\n') {
                Some(end) => Front::Whole(end + 1, can_send(&bytes[..end])),
                None => Front::Part,
            },
        }
    }

    /// Returns the bytes of an answer. `code` is the error byte, or the command of an LX; `to` is the sender of the request.
    pub(super) fn answer(self, id: u8, code: u8, to: u8, parameters: &[u8]) -> Vec<u8> {
        match self {
            Wire::Dynamixel1 => {
                let mut frame = vec![0xFF, 0xFF, id, parameters.len() as u8 + 2, code];
                frame.extend(parameters);
                frame.push(checksum(&frame[2..]));
                frame
            }
            Wire::Lx => {
                let mut frame = vec![0x55, 0x55, id, parameters.len() as u8 + 3, code];
                frame.extend(parameters);
                frame.push(checksum(&frame[2..]));
                frame
            }
            Wire::Dynamixel2 => {
                let mut body = vec![0x55];
                for byte in [code].iter().chain(parameters) {
                    body.push(*byte);
                    if body.ends_with(&[0xFF, 0xFF, 0xFD]) {
                        body.push(0xFD);
                    }
                }
                let [low, high] = (body.len() as u16 + 2).to_le_bytes();
                let mut frame = vec![0xFF, 0xFF, 0xFD, 0, id, low, high];
                frame.extend(body);
                let crc = crc(&frame);
                frame.extend(crc);
                frame
            }
            Wire::Fdcanusb => {
                let mut payload = parameters.to_vec();
                // CAN-FD has frames of some lengths only; NOPs fill them up.
                let sizes = [0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 16, 20, 24, 32, 48, 64];
                if let Some(size) = sizes.into_iter().find(|size| *size >= payload.len()) {
                    payload.resize(size, 0x50);
                }
                let mut line = format!("rcv {id:02x}{to:02x} ");
                payload
                    .iter()
                    .for_each(|byte| line.push_str(&format!("{byte:02X}")));
                line.push_str(" B F\n");
                line.into_bytes()
            }
        }
    }

    /// Returns the answer of several servos in one frame: error, identity, data and CRC of each ("Fast Sync Read").
    pub(super) fn fast_answer(parts: &[(u8, u8, Vec<u8>)]) -> Vec<u8> {
        let Some((_, error, _)) = parts.first() else {
            return Vec::new();
        };
        let mut parameters = Vec::new();
        for (place, (id, own, data)) in parts.iter().enumerate() {
            if place > 0 {
                // The CRC up to here, which masters need not look at.
                parameters.extend([0, 0, *own]);
            }
            parameters.push(*id);
            parameters.extend(data);
        }
        Wire::Dynamixel2.answer(super::BROADCAST, *error, 0, &parameters)
    }
}

/// A frame with a header of two equal bytes, identity, length, code and checksum.
fn short(bytes: &[u8], header: u8) -> Front {
    match *bytes {
        [first, ..] if first != header => Front::Whole(1, None),
        [_, second, ..] if second != header => Front::Whole(1, None),
        // A third header byte: the frame begins later.
        [_, _, id, ..] if id == header && header == 0xFF => Front::Whole(1, None),
        [_, _, id, length, ..] => {
            let length = usize::from(length);
            // An LX counts itself: its shortest frame has length 3 and no parameters.
            let (total, least) = match header {
                0xFF => (length + 4, 2),
                _ => (length + 3, 3),
            };
            if length < least {
                return Front::Whole(1, None);
            }
            let Some(frame) = bytes.get(..total) else {
                return Front::Part;
            };
            let [body @ .., sum] = &frame[2..] else {
                return Front::Whole(1, None);
            };
            if checksum(body) != *sum {
                return Front::Whole(1, None);
            }
            let request = Request {
                id,
                code: body[2],
                parameters: body[3..].to_vec(),
            };
            Front::Whole(total, Some(request))
        }
        _ => Front::Part,
    }
}

/// A frame of protocol 2.
fn long(bytes: &[u8]) -> Front {
    let header = [0xFF, 0xFF, 0xFD, 0x00];
    if bytes
        .iter()
        .zip(&header)
        .any(|(byte, wanted)| byte != wanted)
    {
        return Front::Whole(1, None);
    }
    let [_, _, _, _, id, low, high, ..] = *bytes else {
        return Front::Part;
    };
    let length = usize::from(u16::from_le_bytes([low, high]));
    if !(3..=MAX_REQUEST - 7).contains(&length) {
        return Front::Whole(1, None);
    }
    let Some(frame) = bytes.get(..length + 7) else {
        return Front::Part;
    };
    let (body, sum) = frame.split_at(frame.len() - 2);
    if crc(body) != sum {
        return Front::Whole(1, None);
    }
    let mut plain: Vec<u8> = Vec::new();
    let mut is_stuffed = false;
    for byte in &body[7..] {
        if is_stuffed {
            is_stuffed = false;
            continue;
        }
        plain.push(*byte);
        is_stuffed = plain.ends_with(&[0xFF, 0xFF, 0xFD]);
    }
    let request = plain.split_first().map(|(code, parameters)| Request {
        id,
        code: *code,
        parameters: parameters.to_vec(),
    });
    Front::Whole(frame.len(), request)
}

/// A line `can send ID DATA FLAGS`, where the ID is source and destination.
fn can_send(line: &[u8]) -> Option<Request> {
    let line = str::from_utf8(line).ok()?;
    let mut words = line.split_whitespace();
    if (words.next()?, words.next()?) != ("can", "send") {
        return None;
    }
    let id = u16::from_str_radix(words.next()?, 16).ok()?;
    let data = words.next()?;
    let byte = |place: usize| {
        let digits = data.get(place..place + 2)?;
        u8::from_str_radix(digits, 16).ok()
    };
    let parameters: Option<Vec<u8>> = (0..data.len()).step_by(2).map(byte).collect();
    let [source, destination] = id.to_be_bytes();
    Some(Request {
        id: destination,
        code: source,
        parameters: parameters?,
    })
}

/// A reader of requests. After damaged bytes it looks for a request at each of the following ones.
#[derive(Clone, Debug)]
pub(super) struct Reader {
    wire: Wire,
    bytes: Vec<u8>,
}

impl Reader {
    pub(super) const fn new(wire: Wire) -> Self {
        Reader {
            wire,
            bytes: Vec::new(),
        }
    }

    /// Takes a byte, and returns the request that it completes.
    pub(super) fn push(&mut self, byte: u8) -> Option<Request> {
        self.bytes.push(byte);
        while !self.bytes.is_empty() {
            match self.wire.front(&self.bytes) {
                Front::Part if self.bytes.len() > MAX_REQUEST => self.bytes.clear(),
                Front::Part => return None,
                Front::Whole(length, request) => {
                    self.bytes.drain(..length);
                    if request.is_some() {
                        return request;
                    }
                }
            }
        }
        None
    }
}
