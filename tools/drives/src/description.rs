//! The description of drives: the servo of each joint, and the limits beyond which the robot is stopped. [`check`] refuses what no
//! robot can have, so that the drives need not ask again.

use crate::bus::MAX_SERVOS;
use crate::family::Model;
use core::fmt;
use tip_runtime::model::Range;

/// A joint and the servo that moves it. Motor angle = `sign` · `gear` · joint angle + `offset`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint {
    /// Identity of the servo.
    pub id: u8,
    /// Model of the servo.
    pub model: &'static Model,
    /// +1, or -1 if the motor turns against the joint.
    pub sign: f64,
    /// Motor angle at a joint angle of 0, deg.
    pub offset: f64,
    /// Turns of the motor for each turn of the joint.
    pub gear: f64,
    /// Angles that are commanded, deg.
    pub limits: Range,
    /// The fastest that is commanded, deg/s.
    pub speed: f64,
    /// Torque limit, as a part of the full torque.
    pub torque: f64,
}

impl Joint {
    /// Returns the position of the servo at a joint angle, counts.
    pub fn counts(&self, angle: f64) -> i32 {
        let motor = self.sign * self.gear * angle + self.offset;
        let counts = libm::round(self.model.counts(motor));
        (counts as i32).clamp(0, self.model.largest)
    }

    /// Returns the joint angle at a position of the servo, deg.
    pub fn angle(&self, counts: i32) -> f64 {
        (self.model.angle(counts.into()) - self.offset) * self.sign / self.gear
    }

    /// Returns the positions at its limits, counts, the smaller one first.
    pub fn goals(&self) -> (i32, i32) {
        let (one, other) = (self.counts(self.limits.min), self.counts(self.limits.max));
        (one.min(other), one.max(other))
    }
}

/// Treatment of the robot when its program does not move it any more.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Policy {
    /// The servos hold their position.
    #[default]
    Hold,
    /// The torque falls to nothing, slowly.
    Relax,
}

/// Limits beyond which the robot is stopped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Number of cycles in a row for which a servo may be silent; its last angle stands for the missing ones.
    pub silence: u32,
    /// The hottest that a servo may be, °C.
    pub temperature: f64,
    /// Supply voltage, V.
    pub voltage: Range,
    /// Load, as a part of the stall torque, and the time for which a joint may have more, s.
    pub overload: (f64, f64),
    /// Distance from the command, deg, and the time for which a joint may be farther away, s.
    pub lag: (f64, f64),
    /// Maximum part of a cycle in which servos are read one by one, where one request cannot read all.
    pub reading: f64,
    /// Time in which the torque falls to nothing, s.
    pub relaxing: f64,
    /// True if a command to a posture in which two parts of the robot would overlap stops it.
    pub stops_collisions: bool,
    /// Treatment at END, at EXIT and when the run is interrupted.
    pub at_end: Policy,
    /// Treatment in an emergency.
    pub in_emergency: Policy,
    /// Servos of protocol 2 answer in one frame.
    pub fast: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Settings {
            silence: 5,
            temperature: 65.0,
            voltage: Range::new(6.0, 15.0),
            overload: (0.9, 0.5),
            lag: (25.0, 0.5),
            reading: 0.6,
            relaxing: 2.0,
            stops_collisions: true,
            at_end: Policy::Hold,
            in_emergency: Policy::Hold,
            fast: false,
        }
    }
}

/// A reason why joints or settings cannot be those of a bus. Joints count from 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Invalid {
    /// There are more joints than servos on a bus.
    TooManyJoints,
    /// A setting has a value that it cannot have.
    Setting {
        /// Its name.
        name: &'static str,
    },
    /// A joint has a value that it cannot have.
    Value {
        /// The joint.
        joint: usize,
        /// Name of the value.
        name: &'static str,
    },
    /// The motor would turn beyond its travel.
    Travel {
        /// The joint.
        joint: usize,
        /// Motor angle at a limit of the joint, deg.
        angle: f64,
    },
    /// The torque of the servo cannot be limited.
    NoTorqueLimit {
        /// The joint.
        joint: usize,
    },
    /// Two servos have the same identity.
    SameIdentity {
        /// The joint.
        joint: usize,
        /// The joint before it.
        other: usize,
    },
    /// The servos of two joints are of two families.
    OtherFamily {
        /// The joint.
        joint: usize,
        /// The joint before it.
        other: usize,
    },
}

impl fmt::Display for Invalid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Invalid::TooManyJoints => write!(f, "a bus has {MAX_SERVOS} servos at most"),
            Invalid::Setting { name } => write!(f, "no bus can have this `{name}`"),
            Invalid::Value { joint, name } => {
                write!(
                    f,
                    "the servo of joint {} cannot have this `{name}`",
                    joint + 1
                )
            }
            Invalid::Travel { joint, angle } => {
                let joint = joint + 1;
                write!(
                    f,
                    "the motor of joint {joint} cannot turn to {angle:.1} deg"
                )
            }
            Invalid::NoTorqueLimit { joint } => {
                let joint = joint + 1;
                write!(
                    f,
                    "the torque of the servo of joint {joint} cannot be limited: `torque` is 1"
                )
            }
            Invalid::SameIdentity { joint, other } => {
                let [joint, other] = [joint, other].map(|it| it + 1);
                write!(
                    f,
                    "the servos of joints {other} and {joint} have the same identity"
                )
            }
            Invalid::OtherFamily { joint, other } => {
                let [joint, other] = [joint, other].map(|it| it + 1);
                write!(
                    f,
                    "the servos of joints {other} and {joint} cannot share a bus"
                )
            }
        }
    }
}

impl core::error::Error for Invalid {}

/// A motor angle this far beyond the travel is its end, rounded: deg.
const ROUNDING: f64 = 1e-6;

/// Checks joints and settings.
///
/// # Errors
/// The first thing that is wrong.
pub fn check(joints: &[Joint], settings: &Settings) -> Result<(), Invalid> {
    let is_range =
        |range: Range| range.min.is_finite() && range.max.is_finite() && range.min <= range.max;
    let is_positive = |value: f64| value.is_finite() && value > 0.0;
    let checks = [
        ("temperature", settings.temperature.is_finite()),
        ("voltage", is_range(settings.voltage)),
        (
            "overload",
            is_positive(settings.overload.0) && settings.overload.1 >= 0.0,
        ),
        ("lag", is_positive(settings.lag.0) && settings.lag.1 >= 0.0),
        ("reading", (0.0..=1.0).contains(&settings.reading)),
        (
            "relaxing",
            settings.relaxing.is_finite() && settings.relaxing >= 0.0,
        ),
    ];
    if let Some((name, _)) = checks.into_iter().find(|(_, is_right)| !is_right) {
        return Err(Invalid::Setting { name });
    }
    if joints.len() > MAX_SERVOS {
        return Err(Invalid::TooManyJoints);
    }
    for (number, joint) in joints.iter().enumerate() {
        check_joint(number, joint)?;
        let before = joints.iter().take(number);
        if let Some(other) = before.clone().position(|other| other.id == joint.id) {
            return Err(Invalid::SameIdentity {
                joint: number,
                other,
            });
        }
        let mut before = before.enumerate();
        if let Some((other, _)) = before.find(|(_, it)| it.model.family != joint.model.family) {
            return Err(Invalid::OtherFamily {
                joint: number,
                other,
            });
        }
    }
    Ok(())
}

fn check_joint(number: usize, joint: &Joint) -> Result<(), Invalid> {
    let Joint {
        id,
        model,
        sign,
        offset,
        gear,
        limits,
        speed,
        torque,
    } = *joint;
    let is_range = limits.min.is_finite() && limits.max.is_finite() && limits.min <= limits.max;
    let checks = [
        ("id", id <= model.family.last_id()),
        ("sign", sign.abs() == 1.0),
        ("offset", offset.is_finite()),
        ("gear", gear.is_finite() && gear > 0.0),
        ("limits", is_range),
        ("speed", speed.is_finite() && speed > 0.0),
        ("torque", torque > 0.0 && torque <= 1.0),
    ];
    if let Some((name, _)) = checks.into_iter().find(|(_, is_right)| !is_right) {
        return Err(Invalid::Value {
            joint: number,
            name,
        });
    }
    if torque < 1.0 && !model.family.limits_torque() {
        return Err(Invalid::NoTorqueLimit { joint: number });
    }
    let (low, high) = (model.angle(0.0), model.angle(model.largest.into()));
    let ends = [limits.min, limits.max].map(|angle| sign * gear * angle + offset);
    let is_outside = |end: &f64| *end < low - ROUNDING || *end > high + ROUNDING;
    match ends.into_iter().find(is_outside) {
        Some(angle) => Err(Invalid::Travel {
            joint: number,
            angle,
        }),
        None => Ok(()),
    }
}
