//! The register tables of servo families, and the servo models. A model is a row; nothing else differs between servos.

use crate::frame::Protocol;
use crate::moteus::{self, address};

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

const fn register(address: u16, width: u8) -> Register {
    Register {
        address,
        width,
        sign: Sign::None,
    }
}

const fn signed(address: u16, width: u8, sign: Sign) -> Register {
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

/// A part of the register table that is read in a cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Window {
    /// First address.
    pub start: u16,
    /// Length, bytes.
    pub length: u8,
}

const fn window(start: u16, length: u8) -> Window {
    Window { start, length }
}

/// The register table of a family of servos.
#[derive(Debug, PartialEq, Eq)]
pub struct Family {
    /// Name in messages.
    pub name: &'static str,
    /// Frames that it understands.
    pub protocol: Protocol,
    /// True if one request reads many servos.
    pub reads_many: bool,
    /// Windows with position, load, voltage and temperature. Successive cycles read different ones, so that the length of
    /// an answer tells an old answer from a new one. With a checksum of 8 bits, two neighbouring bytes can be damaged unnoticed:
    /// the byte before the position must be one whose value is known.
    pub windows: [Window; 3],
    /// Number of the model; an answer of 3 bytes or more differs from the echo of its request.
    pub model: Register,
    /// Identity on the bus.
    pub id: Register,
    /// Delay of an answer, in units of 2 µs; `None` if there is none.
    pub return_delay: Option<Register>,
    /// Register with the way in which it turns, and the values with which it goes to positions; `None` if it always does.
    pub mode: Option<(Register, i32, i32)>,
    /// Register that protects the identity until it is 0; `None` if torque off is enough.
    pub lock: Option<Register>,
    /// Torque on or off.
    pub torque_enable: Register,
    /// Commanded position, counts.
    pub goal_position: Register,
    /// The fastest that it turns by itself.
    pub goal_speed: Register,
    /// The most torque that it gives.
    pub torque_limit: Register,
    /// Measured position, counts.
    pub position: Register,
    /// Measured load.
    pub load: Register,
    /// Supply voltage, 0.1 V.
    pub voltage: Register,
    /// Temperature, °C.
    pub temperature: Register,
    /// Stops the servo when no instruction comes for this many units of 20 ms; `None` if it holds its last command forever.
    pub watchdog: Option<Register>,
    /// Bits of the error byte of an answer that are alarms of the servo, not remarks on a request.
    pub alarms: u8,
    /// Register with the alarms, where the error byte only says that there are some.
    pub alarm_status: Option<Register>,
    /// Bits of an alarm that are voltage, temperature and overload; of a moteus, the numbers of the faults.
    pub alarm_bits: [u8; 3],
}

/// AX, RX, EX and MX servos with Dynamixel protocol 1. None of them answers a sync read.
pub static AX: Family = Family {
    name: "Dynamixel AX/MX",
    protocol: Protocol::Dynamixel1,
    reads_many: false,
    windows: [window(36, 8), window(36, 11), window(24, 20)],
    model: register(0, 2),
    id: register(3, 1),
    return_delay: Some(register(5, 1)),
    // The largest position; 0 makes it a wheel.
    mode: Some((register(8, 2), 1, 4095)),
    lock: None,
    torque_enable: register(24, 1),
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

/// X servos with Dynamixel protocol 2.
pub static X: Family = Family {
    name: "Dynamixel X",
    protocol: Protocol::Dynamixel2,
    reads_many: true,
    windows: [window(126, 21), window(124, 23), window(122, 25)],
    model: register(0, 2),
    id: register(7, 1),
    return_delay: Some(register(9, 1)),
    mode: Some((register(11, 1), 3, 3)),
    lock: None,
    torque_enable: register(64, 1),
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

/// STS servos of Feetech.
pub static STS: Family = Family {
    name: "Feetech STS",
    protocol: Protocol::Feetech,
    reads_many: true,
    windows: [window(56, 8), window(56, 11), window(40, 24)],
    model: register(3, 2),
    id: register(5, 1),
    return_delay: Some(register(7, 1)),
    mode: Some((register(33, 1), 0, 0)),
    lock: Some(register(55, 1)),
    torque_enable: register(40, 1),
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

/// moteus controllers of mjbots, with the register table of [`crate::moteus`].
pub static MOTEUS: Family = Family {
    name: "mjbots moteus",
    protocol: Protocol::Moteus,
    reads_many: false,
    windows: [window(0, moteus::MEASURED as u8); 3],
    model: register(address::MODEL, 2),
    id: register(address::ID, 1),
    return_delay: None,
    mode: None,
    lock: None,
    torque_enable: register(address::TORQUE_ENABLE, 1),
    goal_position: signed(address::GOAL_POSITION, 4, Sign::Twos),
    goal_speed: register(address::GOAL_SPEED, 4),
    torque_limit: register(address::TORQUE_LIMIT, 2),
    position: signed(address::POSITION, 4, Sign::Twos),
    load: signed(address::LOAD, 2, Sign::Twos),
    voltage: register(address::VOLTAGE, 2),
    temperature: register(address::TEMPERATURE, 1),
    watchdog: Some(register(address::WATCHDOG, 1)),
    alarms: 0x80,
    alarm_status: Some(register(address::FAULT, 1)),
    alarm_bits: [40, 38, 0],
};

impl Family {
    /// Returns the cause of an alarm.
    pub fn cause(&self, alarm: u8) -> &'static str {
        let mut causes = self
            .alarm_bits
            .into_iter()
            .zip(["voltage", "temperature", "overload"]);
        let is_meant = |bits: u8| match self.protocol {
            Protocol::Moteus => bits == alarm,
            _ => bits & alarm != 0,
        };
        let found = causes.find(|(bits, _)| is_meant(*bits));
        found.map_or("sensor or current", |(_, cause)| cause)
    }
}

/// A servo model.
#[derive(Debug, PartialEq)]
pub struct Model {
    /// Name in a robot file.
    pub name: &'static str,
    /// Number that the servo reports; 0 if the maker states none.
    pub number: u16,
    /// Its registers.
    pub family: &'static Family,
    /// Counts of a full turn.
    pub turn: f64,
    /// The largest position, counts; the smallest is 0.
    pub largest: i32,
    /// Position at a motor angle of 0, counts.
    pub middle: f64,
    /// Speed of one unit of the speed register, deg/s.
    pub speed_unit: f64,
    /// Speed without load at the rated voltage, deg/s.
    pub speed: f64,
    /// Load register at the stall torque.
    pub full_load: f64,
    /// Value of the torque limit at full torque.
    pub full_torque: u16,
}

const fn ax(name: &'static str, number: u16, speed: f64) -> Model {
    Model {
        name,
        number,
        family: &AX,
        turn: 1228.8,
        largest: 1023,
        middle: 512.0,
        speed_unit: 0.666,
        speed,
        full_load: 1023.0,
        full_torque: 1023,
    }
}

const fn mx(name: &'static str, number: u16, speed: f64) -> Model {
    Model {
        turn: 4096.0,
        largest: 4095,
        middle: 2048.0,
        speed_unit: 0.684,
        ..ax(name, number, speed)
    }
}

const fn x(name: &'static str, number: u16, speed: f64, full_load: f64) -> Model {
    Model {
        name,
        number,
        family: &X,
        turn: 4096.0,
        largest: 4095,
        middle: 2048.0,
        speed_unit: 1.374,
        speed,
        full_load,
        full_torque: 885,
    }
}

const fn sts(name: &'static str, number: u16, speed: f64) -> Model {
    Model {
        name,
        number,
        family: &STS,
        turn: 4096.0,
        largest: 4095,
        middle: 2048.0,
        speed_unit: 360.0 / 4096.0,
        speed,
        full_load: 1000.0,
        full_torque: 1000,
    }
}

/// A moteus with a motor of this torque, 0.01 Nm.
const fn moteus(name: &'static str, speed: f64, torque: u16) -> Model {
    Model {
        name,
        number: 0,
        family: &MOTEUS,
        turn: moteus::TURN,
        largest: 2 * moteus::MIDDLE,
        middle: moteus::MIDDLE as f64,
        speed_unit: 1.0,
        speed,
        full_load: torque as f64,
        full_torque: torque,
    }
}

/// The models that a robot file can name.
pub static MODELS: &[Model] = &[
    ax("AX-12", 12, 354.0),
    ax("AX-18", 18, 582.0),
    mx("MX-28", 29, 330.0),
    mx("MX-64", 310, 378.0),
    mx("MX-106", 320, 270.0),
    x("XL430-W250", 1060, 366.0, 1000.0),
    x("2XL430-W250", 1090, 366.0, 1000.0),
    x("XL330-M288", 1200, 618.0, 1750.0),
    x("XM430-W210", 1030, 462.0, 1193.0),
    x("XM430-W350", 1020, 276.0, 1193.0),
    x("XM540-W270", 1120, 180.0, 2047.0),
    sts("STS3215", 777, 270.0),
    sts("STS3032", 0, 660.0),
    moteus("moteus-mj5208", 3600.0, 170),
    moteus("moteus-qdd100", 1200.0, 1600),
];

impl Model {
    /// Returns the model of that name, in any case.
    pub fn named(name: &str) -> Option<&'static Self> {
        MODELS
            .iter()
            .find(|model| model.name.eq_ignore_ascii_case(name))
    }

    /// Returns the model that reports a number, in a family.
    pub fn numbered(family: &Family, number: u16) -> Option<&'static Self> {
        let mut of_family = MODELS.iter().filter(|model| model.family == family);
        of_family.find(|model| number != 0 && model.number == number)
    }

    /// Returns the motor angle at a position, deg.
    pub fn angle(&self, counts: f64) -> f64 {
        (counts - self.middle) * 360.0 / self.turn
    }

    /// Returns the position at a motor angle, deg: counts, not rounded.
    pub fn counts(&self, angle: f64) -> f64 {
        self.middle + angle * self.turn / 360.0
    }
}
