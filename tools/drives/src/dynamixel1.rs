//! Dynamixel AX, RX, EX and MX servos with protocol 1: frames with a checksum of 8 bits, and no sync read.
//!
//! Source: the control tables of AX-12A and MX-28(1.0) and "Protocol 1.0" in the maker's e-manual.

use crate::frame::{Bytes, Frame, Parsed, TooLong, add, begins, checksum};
use crate::registers::{Check, Framing, Rule, Sign, Table, block, register, signed};

/// AX, RX, EX and MX servos.
pub static AX: Table = Table {
    key: "ax",
    name: "Dynamixel AX/MX",
    framing: &Protocol1,
    reads_together: false,
    blocks: [block(36, 8), block(36, 11), block(24, 20)],
    model: register(0, 2),
    id: register(3, 1),
    return_delay: register(5, 1),
    checks: &[
        Check {
            name: "Status Return Level",
            register: register(16, 1),
            rule: Rule::Bits(0xFF, 2),
        },
        // 0 makes it a wheel.
        Check {
            name: "CCW Angle Limit",
            register: register(8, 2),
            rule: Rule::Highest,
        },
        // The largest position makes it count turns.
        Check {
            name: "CW Angle Limit",
            register: register(6, 2),
            rule: Rule::Lowest,
        },
    ],
    lock: None,
    torque_enable: register(24, 1),
    acceleration: None,
    goal_position: register(30, 2),
    goal_speed: register(32, 2),
    torque_limit: register(34, 2),
    position: register(36, 2),
    load: signed(40, 2, Sign::Bit(10)),
    voltage: register(42, 1),
    temperature: register(43, 1),
    watchdog: None,
    alarms: 0b0010_0101,
    alarm_status: None,
    alarm_bits: [1, 1 << 2, 1 << 5],
};

/// Frames of protocol 1, which Feetech uses as well.
#[derive(Debug)]
pub struct Protocol1;

const HEADER: [u8; 2] = [0xFF, 0xFF];

impl Framing for Protocol1 {
    fn request(&self, id: u8, instruction: u8, parameters: &[u8]) -> Result<Bytes, TooLong> {
        let length = u8::try_from(parameters.len() + 2).map_err(|_| TooLong)?;
        let mut frame = Bytes::new();
        add(&mut frame, &HEADER)?;
        add(&mut frame, &[id, length, instruction])?;
        add(&mut frame, parameters)?;
        let sum = checksum(&frame[HEADER.len()..]);
        add(&mut frame, &[sum])?;
        Ok(frame)
    }

    fn parse(&self, bytes: &[u8], parameters: usize) -> Parsed {
        let (Some(&id), Some(&length)) = (bytes.get(2), bytes.get(3)) else {
            return match begins(bytes, &HEADER) && bytes.get(2) != Some(&0xFF) {
                true => Parsed::Unfinished,
                false => Parsed::Nothing,
            };
        };
        let length = usize::from(length);
        if !begins(bytes, &HEADER) || id == 0xFF || length != parameters + 2 {
            return Parsed::Nothing;
        }
        let Some(whole) = bytes.get(..length + 4) else {
            return Parsed::Unfinished;
        };
        let [_, _, body @ .., sum] = whole else {
            return Parsed::Nothing;
        };
        let [_, _, code, parameters @ ..] = body else {
            return Parsed::Nothing;
        };
        match Bytes::from_slice(parameters) {
            Ok(parameters) if checksum(body) == *sum => {
                let code = *code;
                let frame = Frame {
                    id,
                    code,
                    parameters,
                };
                Parsed::Frame(frame, whole.len())
            }
            _ => Parsed::Nothing,
        }
    }

    fn frame_length(&self, parameters: usize) -> usize {
        parameters + 6
    }

    fn word(&self) -> usize {
        1
    }
}
