//! The servo families and models that exist. A model is a row; what else differs between servos is in their families.

use crate::dynamixel1::AX;
use crate::dynamixel2::X;
use crate::family::Family;
pub use crate::family::Model;
use crate::feetech::STS;
use crate::lx::LX;
use crate::moteus::{self, MOTEUS};

const fn ax(name: &'static str, number: u16, speed: f64) -> Model {
    Model {
        name,
        number: Some(number),
        family: &AX,
        turn: 1228.8,
        largest: 1023,
        middle: 512.0,
        speed_unit: Some(0.666),
        speed,
        full_load: Some(1023.0),
        full_torque: Some(1023),
    }
}

const fn mx(name: &'static str, number: u16, speed: f64) -> Model {
    Model {
        turn: 4096.0,
        largest: 4095,
        middle: 2048.0,
        speed_unit: Some(0.684),
        ..ax(name, number, speed)
    }
}

const fn x(name: &'static str, number: u16, speed: f64, full_load: f64) -> Model {
    Model {
        name,
        number: Some(number),
        family: &X,
        turn: 4096.0,
        largest: 4095,
        middle: 2048.0,
        speed_unit: Some(1.374),
        speed,
        full_load: Some(full_load),
        full_torque: Some(885),
    }
}

const fn sts(name: &'static str, number: Option<u16>, speed: f64) -> Model {
    Model {
        name,
        number,
        family: &STS,
        turn: 4096.0,
        largest: 4095,
        middle: 2048.0,
        speed_unit: Some(360.0 / 4096.0),
        speed,
        full_load: Some(1000.0),
        full_torque: Some(1000),
    }
}

/// A moteus with a motor of this torque, 0.01 Nm.
const fn moteus(name: &'static str, speed: f64, torque: u16) -> Model {
    Model {
        name,
        number: None,
        family: &MOTEUS,
        turn: moteus::TURN,
        largest: 2 * moteus::MIDDLE,
        middle: moteus::MIDDLE as f64,
        speed_unit: None,
        speed,
        full_load: Some(torque as f64),
        full_torque: Some(torque),
    }
}

/// A servo of 240 deg.
const fn lx(name: &'static str, speed: f64) -> Model {
    Model {
        name,
        number: None,
        family: &LX,
        turn: 1500.0,
        largest: 1000,
        middle: 500.0,
        speed_unit: None,
        speed,
        full_load: None,
        full_torque: None,
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
    x("XL330-M288", 1200, 618.0, 1470.0),
    x("XM430-W210", 1030, 462.0, 855.0),
    x("XM430-W350", 1020, 276.0, 855.0),
    x("XM540-W270", 1120, 180.0, 1636.0),
    sts("STS3215", Some(777), 270.0),
    sts("STS3032", None, 660.0),
    lx("LX-16A", 375.0),
    lx("HTS-35H", 333.0),
    moteus("moteus-mj5208", 3600.0, 170),
    moteus("moteus-qdd100", 1200.0, 1600),
];

/// The families.
pub static FAMILIES: [&dyn Family; 5] = [&AX, &X, &STS, &LX, &MOTEUS];

/// Returns the family with a name in commands.
pub fn family_named(key: &str) -> Option<&'static dyn Family> {
    FAMILIES.into_iter().find(|family| family.key() == key)
}

impl Model {
    /// Returns the model of that name, in any case.
    pub fn named(name: &str) -> Option<&'static Self> {
        MODELS
            .iter()
            .find(|model| model.name.eq_ignore_ascii_case(name))
    }

    /// Returns the model that reports a number, in a family.
    pub fn numbered(family: &dyn Family, number: u16) -> Option<&'static Self> {
        let is_it =
            |model: &&Model| model.family.key() == family.key() && model.number == Some(number);
        MODELS.iter().find(is_it)
    }
}
