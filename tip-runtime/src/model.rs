//! Robots as data: legs, joints, axes, limits, standard parameters, what they sense and can do.
//!
//! Lengths are in mm, angles in degrees, masses in kg, torques in N·m, times in ms. The robot
//! frame has x to the right, y forward, z up, its origin at the body's centre.

pub mod generic;
pub mod titan8;

use crate::program::Signature;

/// Whose commands a robot understands (the letters T, H, G of the language reference).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Family {
    /// TITAN VIII.
    Titan,
    /// Hiroshima Hand.
    Hand,
    /// A generic robot of n joints by m legs.
    Generic,
}

/// An interval that contains both ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// The lower end.
    pub min: f64,
    /// The upper end.
    pub max: f64,
}

impl Range {
    /// From `min` to `max`.
    pub const fn new(min: f64, max: f64) -> Self {
        Range { min, max }
    }

    /// Whether `value` lies inside; NaN never does.
    pub const fn contains(&self, value: f64) -> bool {
        value >= self.min && value <= self.max
    }

    /// The interval with both ends moved outwards by `margin`.
    #[must_use]
    pub const fn widened(&self, margin: f64) -> Self {
        Range::new(self.min - margin, self.max + margin)
    }
}

/// A revolute joint and the link behind it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint {
    /// Unit vector of the axis in the frame of the link before; right-handed.
    pub axis: [f64; 3],
    /// From this joint to the next one, or to the foot, at angle 0: mm.
    pub link: [f64; 3],
    /// The working limits: deg.
    pub limits: Range,
    /// The limits of the potentiometer, beyond which nothing may move: deg.
    pub outer: Range,
    /// The link's mass: kg.
    pub mass: f64,
    /// The most torque that its motor gives: N·m.
    pub torque: f64,
}

/// A leg or finger: a serial chain of joints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Leg<const J: usize> {
    /// The first joint in the robot frame: mm.
    pub base: [f64; 3],
    /// The joints from base to foot.
    pub joints: [Joint; J],
    /// The initial posture: deg.
    pub initial: [f64; J],
}

/// The body of a walking robot: a box around the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body {
    /// Extent along x: mm.
    pub x: Range,
    /// Extent along y: mm.
    pub y: Range,
    /// Extent along z; the lower end is the belly: mm.
    pub z: Range,
    /// Mass without legs: kg.
    pub mass: f64,
}

/// What parameter commands set, at its standard value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Standards {
    /// `V_MAX`: mm/s.
    pub v_max: f64,
    /// `A_MAX`: mm/s².
    pub a_max: f64,
    /// `OMEGA_MAX`: deg/s.
    pub omega_max: f64,
    /// `OMEGA_DOT_MAX`: deg/s².
    pub omega_dot_max: f64,
    /// `JUST_POSITION`: mm.
    pub just_position: f64,
    /// `JUST_ANGLE`: deg.
    pub just_angle: f64,
    /// `NEAR_POSITION`: mm.
    pub near_position: f64,
    /// `NEAR_ANGLE`: deg.
    pub near_angle: f64,
    /// Sampling time: ms.
    pub period: f64,
}

/// How joint angles follow from a foot's position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Inverse {
    /// Closed form of a yaw joint followed by two parallel pitch joints; the knee bends downwards.
    YawPitchPitch,
}

/// A robot of `L` legs with `J` joints each.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Model<const L: usize, const J: usize> {
    /// The name that programs and messages use.
    pub name: &'static str,
    /// Whose commands it understands.
    pub family: Family,
    /// Its legs, F1 first.
    pub legs: [Leg<J>; L],
    /// Its inverse kinematics.
    pub inverse: Inverse,
    /// Its body, if it walks.
    pub body: Body,
    /// Its parameters at program start.
    pub standards: Standards,
    /// The sampling times that it accepts: ms.
    pub periods: Range,
    /// The reading of a sole's pressure sensor from which its foot stands on something: V.
    pub contact: f64,
    /// Lamps and relays: devices 0 up to, but not including, this number.
    pub lamps: u8,
}

impl<const L: usize, const J: usize> Model<L, J> {
    /// What a program must have been checked for to run on this robot.
    pub const fn signature(&self) -> Signature {
        Signature {
            robot: self.name,
            family: self.family,
            legs: L as u8,
            joints: J as u8,
        }
    }
}
