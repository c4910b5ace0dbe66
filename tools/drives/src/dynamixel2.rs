//! Dynamixel X servos with protocol 2: frames with a CRC of 16 bits, sync reads, and a watchdog.
//!
//! Source: the control table of XL430-W250 and "Protocol 2.0" in the maker's e-manual.

use crate::frame::{Bytes, Frame, MAX_FRAME_BYTES, Parsed, TooLong, add, begins};
use crate::registers::{Check, Framing, Rule, Sign, Table, block, register, signed};

/// X servos.
pub static X: Table = Table {
    key: "x",
    name: "Dynamixel X",
    framing: &Protocol2,
    reads_together: true,
    blocks: [block(126, 21), block(124, 23), block(122, 25)],
    model: register(0, 2),
    id: register(7, 1),
    return_delay: register(9, 1),
    checks: &[
        Check {
            name: "Status Return Level",
            register: register(68, 1),
            rule: Rule::Bits(0xFF, 2),
        },
        // Position control: 4 counts turns, 1 is a wheel.
        Check {
            name: "Operating Mode",
            register: register(11, 1),
            rule: Rule::Bits(0xFF, 3),
        },
        // Reverse direction, and a profile by times in place of speeds.
        Check {
            name: "Drive Mode",
            register: register(10, 1),
            rule: Rule::Bits(0b101, 0),
        },
        Check {
            name: "Homing Offset",
            register: signed(20, 4, Sign::Twos),
            rule: Rule::Bits(-1, 0),
        },
        Check {
            name: "Max Position Limit",
            register: register(48, 4),
            rule: Rule::Highest,
        },
        Check {
            name: "Min Position Limit",
            register: register(52, 4),
            rule: Rule::Lowest,
        },
    ],
    lock: None,
    torque_enable: register(64, 1),
    acceleration: Some(register(108, 4)),
    goal_position: signed(116, 4, Sign::Twos),
    goal_speed: register(112, 4),
    torque_limit: register(100, 2),
    position: signed(132, 4, Sign::Twos),
    load: signed(126, 2, Sign::Twos),
    voltage: register(144, 2),
    temperature: register(146, 1),
    watchdog: Some(register(98, 1)),
    alarms: 0x80,
    alarm_status: Some(register(70, 1)),
    alarm_bits: [1, 1 << 2, 1 << 5],
};

/// Frames of protocol 2.
#[derive(Debug)]
pub struct Protocol2;

const HEADER: [u8; 4] = [0xFF, 0xFF, 0xFD, 0x00];
/// Header, identity and length.
const HEAD: usize = 7;
/// Instruction of an answer.
const STATUS: u8 = 0x55;
/// Bytes that may not appear in the body of a frame, and the one that is put after them.
const STUFFED: [u8; 3] = [0xFF, 0xFF, 0xFD];

impl Framing for Protocol2 {
    fn request(&self, id: u8, instruction: u8, parameters: &[u8]) -> Result<Bytes, TooLong> {
        let mut frame = Bytes::new();
        add(&mut frame, &HEADER)?;
        add(&mut frame, &[id, 0, 0])?;
        for byte in [instruction].iter().chain(parameters) {
            add(&mut frame, &[*byte])?;
            if frame[HEAD..].ends_with(&STUFFED) {
                add(&mut frame, &STUFFED[2..])?;
            }
        }
        let length = u16::try_from(frame.len() - HEAD + 2).map_err(|_| TooLong)?;
        frame[5..7].copy_from_slice(&length.to_le_bytes());
        let crc = crc16(&frame).to_le_bytes();
        add(&mut frame, &crc)?;
        Ok(frame)
    }

    fn parse(&self, bytes: &[u8], parameters: usize) -> Parsed {
        if !begins(bytes, &HEADER) {
            return Parsed::Nothing;
        }
        let Some(&[_, _, _, _, id, low, high]) = bytes.first_chunk::<HEAD>() else {
            return Parsed::Unfinished;
        };
        let length = usize::from(u16::from_le_bytes([low, high]));
        // One byte is stuffed after three at the most.
        let possible = parameters + 4..=parameters + 5 + parameters / 3;
        if !possible.contains(&length) || length > MAX_FRAME_BYTES - HEAD {
            return Parsed::Nothing;
        }
        let Some(whole) = bytes.get(..length + HEAD) else {
            return Parsed::Unfinished;
        };
        let (body, crc) = whole.split_at(whole.len() - 2);
        if crc16(body).to_le_bytes() != crc {
            return Parsed::Nothing;
        }
        let mut plain = Bytes::new();
        let mut stuffed = false;
        for byte in &body[HEAD..] {
            // The byte after the three is not part of the message.
            if !stuffed && plain.push(*byte).is_err() {
                return Parsed::Nothing;
            }
            stuffed = !stuffed && plain.ends_with(&STUFFED);
        }
        let [STATUS, code, rest @ ..] = &plain[..] else {
            return Parsed::Nothing;
        };
        match Bytes::from_slice(rest) {
            Ok(rest) if rest.len() == parameters => {
                let code = *code;
                let frame = Frame {
                    id,
                    code,
                    parameters: rest,
                };
                Parsed::Frame(frame, whole.len())
            }
            _ => Parsed::Nothing,
        }
    }

    fn frame_length(&self, parameters: usize) -> usize {
        parameters + 11
    }

    fn word(&self) -> usize {
        2
    }
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
