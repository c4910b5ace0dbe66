//! The robot description file: what differs between the robot at hand and its model.

use serde::Deserialize;
use std::fmt;
use tip_runtime::model::{Leg, Model, Range, titan8};

/// Legs of the robot.
pub const LEGS: usize = 4;
/// Joints of a leg.
pub const JOINTS: usize = 3;

/// A robot as its description file defines it.
#[derive(Clone, Debug, PartialEq)]
pub struct Description {
    /// Name given by the owner.
    pub name: String,
    /// Link lengths: mm.
    pub lengths: Lengths,
    /// Settings that the servos share.
    pub servos: Servos,
    /// Each joint by leg and joint, from 0.
    pub joints: [[JointDescription; JOINTS]; LEGS],
}

/// Link lengths of every leg: mm.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Lengths {
    /// Yaw axis to thigh axis.
    pub hip: f64,
    /// Thigh axis to knee axis.
    pub thigh: f64,
    /// Knee axis to foot.
    pub shank: f64,
}

/// Settings that the servos share.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Servos {
    /// Encoder counts of a full turn.
    pub counts_per_turn: i16,
    /// Encoder count at a motor angle of 0.
    pub middle: i16,
}

/// One joint and the servo that drives it.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct JointDescription {
    /// The joint's name in the language: `J11`…`J43`.
    pub name: String,
    /// The servo's address on the bus.
    pub servo: u8,
    /// +1 or −1: which way the motor turns when the joint's angle grows.
    pub sign: i8,
    /// The motor angle when the joint is at 0: deg.
    pub offset: f64,
    /// Working limits of the joint: deg.
    pub limits: [f64; 2],
    /// Limits of the mechanism: deg.
    pub outer: [f64; 2],
}

/// Reason why a description is refused.
#[derive(Clone, Debug, PartialEq)]
pub enum DescriptionError {
    /// The file is not TOML of the expected shape; the text says where.
    Format(String),
    /// A joint of the robot is missing, or described twice.
    Joints(String),
    /// A servo address serves two joints.
    Address(u8),
    /// A value of the named joint or table makes no sense; the text says which one.
    Value(String, &'static str),
}

impl fmt::Display for DescriptionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            DescriptionError::Format(why) => f.write_str(why),
            DescriptionError::Joints(name) => write!(f, "joint {name} must be described once"),
            DescriptionError::Address(servo) => write!(f, "servo {servo} drives two joints"),
            DescriptionError::Value(whose, why) => write!(f, "{whose}: {why}"),
        }
    }
}

impl std::error::Error for DescriptionError {}

/// The file as it is written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    name: String,
    lengths: Lengths,
    servos: Servos,
    joint: Vec<JointDescription>,
}

impl Description {
    /// Reads a description file's text.
    ///
    /// # Errors
    /// The first thing that is wrong with it.
    pub fn parse(text: &str) -> Result<Self, DescriptionError> {
        let file: File =
            toml::from_str(text).map_err(|error| DescriptionError::Format(error.to_string()))?;
        check_lengths(file.lengths)?;
        check_addresses(&file.joint)?;
        for joint in &file.joint {
            check_joint(joint, file.servos)?;
        }
        Ok(Description {
            joints: arrange(file.joint)?,
            name: file.name,
            lengths: file.lengths,
            servos: file.servos,
        })
    }

    /// The model with this robot's lengths and limits; all else is TITAN VIII's.
    pub fn model(&self) -> Model<LEGS, JOINTS> {
        let mut model = titan8::MODEL;
        for (leg, joints) in model.legs.iter_mut().zip(&self.joints) {
            self.fit(leg, joints);
        }
        model
    }

    fn fit(&self, leg: &mut Leg<JOINTS>, described: &[JointDescription; JOINTS]) {
        let lengths = [self.lengths.hip, self.lengths.thigh, self.lengths.shank];
        for ((joint, length), own) in leg.joints.iter_mut().zip(lengths).zip(described) {
            joint.link[0] = joint.link[0].signum() * length;
            joint.limits = Range::new(own.limits[0], own.limits[1]);
            joint.outer = Range::new(own.outer[0], own.outer[1]);
        }
    }
}

impl Servos {
    /// The encoder count at which a servo holds its joint at `angle` (deg).
    pub fn counts(&self, joint: &JointDescription, angle: f64) -> f64 {
        let motor = f64::from(joint.sign) * angle + joint.offset;
        f64::from(self.middle) + motor * f64::from(self.counts_per_turn) / 360.0
    }

    /// The joint's angle (deg) at an encoder count.
    pub fn angle(&self, joint: &JointDescription, counts: f64) -> f64 {
        let turn = (counts - f64::from(self.middle)) / f64::from(self.counts_per_turn);
        (turn * 360.0 - joint.offset) * f64::from(joint.sign)
    }
}

fn check_lengths(lengths: Lengths) -> Result<(), DescriptionError> {
    let sound = |length: f64| length.is_finite() && length > 0.0;
    if sound(lengths.hip) && sound(lengths.thigh) && sound(lengths.shank) {
        return Ok(());
    }
    Err(value("lengths", "every length must be above 0"))
}

fn check_addresses(joints: &[JointDescription]) -> Result<(), DescriptionError> {
    for (i, joint) in joints.iter().enumerate() {
        if joints[..i].iter().any(|other| other.servo == joint.servo) {
            return Err(DescriptionError::Address(joint.servo));
        }
    }
    Ok(())
}

fn check_joint(joint: &JointDescription, servos: Servos) -> Result<(), DescriptionError> {
    let [low, high] = joint.limits;
    let [outer_low, outer_high] = joint.outer;
    if !matches!(joint.sign, 1 | -1) {
        return Err(value(&joint.name, "sign must be 1 or -1"));
    }
    // A comparison with NaN is false, so that no limit can be NaN.
    if !(outer_low <= low && low < high && high <= outer_high) {
        return Err(value(&joint.name, "limits must lie inside outer"));
    }
    let turn = 0.0..=f64::from(servos.counts_per_turn);
    let reached = |angle| turn.contains(&servos.counts(joint, angle));
    if !(reached(outer_low) && reached(outer_high)) {
        return Err(value(&joint.name, "the servo cannot turn that far"));
    }
    Ok(())
}

/// Joints in the order of legs, each exactly once.
fn arrange(
    mut joints: Vec<JointDescription>,
) -> Result<[[JointDescription; JOINTS]; LEGS], DescriptionError> {
    let mut take = |leg: usize, joint: usize| {
        let name = format!("J{}{}", leg + 1, joint + 1);
        let found = joints.iter().position(|own| own.name == name);
        let own = found.map(|place| joints.swap_remove(place));
        own.ok_or(DescriptionError::Joints(name))
    };
    let mut leg = |n: usize| Ok([take(n, 0)?, take(n, 1)?, take(n, 2)?]);
    let arranged = [leg(0)?, leg(1)?, leg(2)?, leg(3)?];
    match joints.pop() {
        None => Ok(arranged),
        Some(left_over) => Err(DescriptionError::Joints(left_over.name)),
    }
}

fn value(whose: &str, why: &'static str) -> DescriptionError {
    DescriptionError::Value(whose.to_owned(), why)
}
