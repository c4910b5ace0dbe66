//! Feetech STS servos: frames of Dynamixel protocol 1, with a sync read.
//!
//! Source: the memory table of STS3215 and the protocol manual of the maker.

use crate::dynamixel1::Protocol1;
use crate::registers::{Check, Rule, Sign, Table, block, register, signed};

/// STS servos.
pub static STS: Table = Table {
    key: "sts",
    name: "Feetech STS",
    framing: &Protocol1,
    reads_together: true,
    blocks: [block(56, 8), block(56, 11), block(40, 24)],
    model: register(3, 2),
    id: register(5, 1),
    return_delay: register(7, 1),
    checks: &[
        Check {
            name: "Response Status Level",
            register: register(8, 1),
            rule: Rule::Bits(0xFF, 1),
        },
        Check {
            name: "Operation Mode",
            register: register(33, 1),
            rule: Rule::Bits(0xFF, 0),
        },
        Check {
            name: "Angular Resolution",
            register: register(30, 1),
            rule: Rule::Bits(0xFF, 1),
        },
        Check {
            name: "Position Correction",
            register: signed(31, 2, Sign::Bit(11)),
            rule: Rule::Bits(-1, 0),
        },
        Check {
            name: "Maximum Angle Limitation",
            register: register(11, 2),
            rule: Rule::Highest,
        },
        Check {
            name: "Minimum Angle Limitation",
            register: register(9, 2),
            rule: Rule::Lowest,
        },
    ],
    lock: Some(register(55, 1)),
    torque_enable: register(40, 1),
    acceleration: Some(register(41, 1)),
    goal_position: signed(42, 2, Sign::Bit(15)),
    goal_speed: signed(46, 2, Sign::Bit(15)),
    torque_limit: register(48, 2),
    position: signed(56, 2, Sign::Bit(15)),
    load: signed(60, 2, Sign::Bit(10)),
    voltage: register(62, 1),
    temperature: register(63, 1),
    watchdog: None,
    alarms: 0b0010_1111,
    alarm_status: None,
    alarm_bits: [1, 1 << 2, 1 << 5 | 1 << 3],
};
