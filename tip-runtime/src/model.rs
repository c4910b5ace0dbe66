//! Robots as data: legs, joints, axes, limits, standard parameters, what they sense and can do.
//!
//! Lengths are in mm, angles in degrees, masses in kg, motor torques in N·m, times in ms; torques
//! of commands and sensors in the robot's own [`TorqueUnit`]. The robot frame has x to the right, y
//! forward, z up, its origin at the body's centre; of the hand y is the height.
//!
//! A robot is a constant; builders have a default for whatever they leave out. Other values than the defaults are one struct update away; [`Model::check`] reports what is inconsistent.
//!
//! ```
//! use tip_runtime::model::{Body, Joint, Leg, Model, Range};
//!
//! /// Three legs around a small body, each of a yaw, a thigh and a knee.
//! const TRIPOD: Model<3, 3> = Model {
//!     body: Some(Body {
//!         x: Range::new(-60.0, 60.0),
//!         y: Range::new(-60.0, 60.0),
//!         z: Range::new(-30.0, 30.0),
//!         mass: 1.0,
//!         inertial: None,
//!     }),
//!     ..Model::generic("tripod", [leg(0.0, 1.0), leg(0.96, -0.28), leg(-0.96, -0.28)])
//! };
//!
//! /// A leg that points to (x, y) from the middle.
//! const fn leg(x: f64, y: f64) -> Leg<3> {
//!     let across = [y, -x, 0.0];
//!     let joints = [
//!         Joint::revolute([0.0, 0.0, 1.0], [30.0 * x, 30.0 * y, 0.0]).limits(-45.0, 45.0),
//!         Joint::revolute(across, [80.0 * x, 80.0 * y, 0.0]).limits(-60.0, 60.0),
//!         Joint::revolute(across, [0.0, 0.0, -120.0]).limits(-60.0, 60.0),
//!     ];
//!     Leg::at([60.0 * x, 60.0 * y, 0.0], joints).initial([0.0, 20.0, -20.0])
//! }
//!
//! assert_eq!(TRIPOD.check(), Ok(()));
//!
//! let mut bent = TRIPOD;
//! bent.legs[1].joints[2].limits = Range::new(60.0, -60.0);
//! let error = bent.check().unwrap_err();
//! assert!(error.to_string().starts_with("J23: limits must be"));
//! ```

mod check;
#[cfg(feature = "control")]
mod model_facts;
mod robots;

pub use check::{ModelError, Place};
#[cfg(feature = "control")]
pub(crate) use model_facts::ModelFacts;
pub use robots::{generic, hand, titan8};

use core::fmt;
use core::str::FromStr;

/// The set of commands that a robot understands (the letters T, H, G of the language reference).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Family {
    /// TITAN VIII.
    Titan,
    /// Hiroshima Hand.
    Hand,
    /// A generic robot of n joints by m legs.
    Generic,
}

impl fmt::Display for Family {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Family::Titan => "TITAN VIII",
            Family::Hand => "Hiroshima Hand",
            Family::Generic => "generic robots",
        })
    }
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
    /// Creates the interval from `min` to `max`.
    pub const fn new(min: f64, max: f64) -> Self {
        Range { min, max }
    }

    /// Returns true if `value` lies inside; NaN never does.
    pub const fn contains(&self, value: f64) -> bool {
        value >= self.min && value <= self.max
    }

    /// Returns the interval with both ends moved outwards by `margin`.
    #[must_use]
    pub const fn widened(&self, margin: f64) -> Self {
        Range::new(self.min - margin, self.max + margin)
    }
}

/// A point: its x, y and z in mm. Every point of the public API is one, of the robot frame unless it says that it is of
/// the world's. In a plane (`hand`) it keeps its z; what is no place, such as a force, a velocity or a link from one
/// joint to the next, is a plain array.
pub type Point = [f64; 3];

/// A revolute joint and the link after it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint {
    /// Unit vector of the axis in the frame of the link before; right-handed.
    pub axis: [f64; 3],
    /// Vector from this joint to the next one, or to the foot, at angle 0, mm.
    pub link: [f64; 3],
    /// The working limits, deg.
    pub limits: Range,
    /// The limits of the potentiometer, beyond which nothing may move, deg.
    pub outer: Range,
    /// The link's mass, kg.
    pub mass: f64,
    /// Distribution of the mass; `None`: evenly along the link. The simulated hand takes all its
    /// links to be so.
    pub inertial: Option<InertialProperties>,
    /// Maximum torque of its motor, N·m.
    pub torque: f64,
    /// Radius of the link, a capsule, where it may meet other links and the body, mm; `None`: 5 % of its length.
    pub radius: Option<f64>,
}

/// A leg or finger: a serial chain of joints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Leg<const J: usize> {
    /// Place of the first joint in the robot frame, mm.
    pub base: Point,
    /// The joints from base to foot.
    pub joints: [Joint; J],
    /// The initial posture, deg.
    pub initial: [f64; J],
}

/// The body of a walking robot: a box around the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body {
    /// Extent along x, mm.
    pub x: Range,
    /// Extent along y, mm.
    pub y: Range,
    /// Extent along z; the lower end is the belly, mm.
    pub z: Range,
    /// Mass without legs, kg.
    pub mass: f64,
    /// Distribution of the mass; `None`: evenly in the box, its centre in the origin.
    pub inertial: Option<InertialProperties>,
}

/// Standard values of the parameters that commands set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Standards {
    /// `V_MAX`, mm/s.
    pub v_max: f64,
    /// `A_MAX`, mm/s².
    pub a_max: f64,
    /// `OMEGA_MAX`, deg/s.
    pub omega_max: f64,
    /// `OMEGA_DOT_MAX`, deg/s².
    pub omega_dot_max: f64,
    /// `JUST_POSITION`, mm.
    pub just_position: f64,
    /// `JUST_ANGLE`, deg.
    pub just_angle: f64,
    /// `NEAR_POSITION`, mm.
    pub near_position: f64,
    /// `NEAR_ANGLE`, deg.
    pub near_angle: f64,
    /// Sampling time, ms.
    pub period: f64,
}

/// The inverse kinematics of a leg: joint angles from a foot's position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Inverse {
    /// Closed form of a yaw joint followed by two parallel pitch joints; the knee bends downwards.
    YawPitchPitch,
    /// Closed form of a joint followed by two parallel ones at right angles to it, such as a roll and two pitches.
    RollPitchPitch,
    /// All joints turn about z, and only x and y of a position count: damped least squares with
    /// the least-norm inverse of the Jacobian (Whitney, 1969).
    Planar,
    /// Any chain in space: the same, for x, y and z.
    LeastSquares,
}

/// The axes x, y and z that count.
pub type Axes = [bool; 3];

impl Inverse {
    /// All forms, each before those that fit more legs.
    pub const ALL: [Inverse; 4] = [
        Inverse::YawPitchPitch,
        Inverse::RollPitchPitch,
        Inverse::Planar,
        Inverse::LeastSquares,
    ];

    /// Returns its name in descriptions.
    pub const fn name(self) -> &'static str {
        match self {
            Inverse::YawPitchPitch => "yaw-pitch-pitch",
            Inverse::RollPitchPitch => "roll-pitch-pitch",
            Inverse::Planar => "planar",
            Inverse::LeastSquares => "least-squares",
        }
    }

    /// Returns true if a closed form finds the angles of a foot, so that no search is needed.
    pub const fn is_closed(self) -> bool {
        matches!(self, Inverse::YawPitchPitch | Inverse::RollPitchPitch)
    }

    /// Returns the axes of a position, velocity or force that count.
    pub const fn axes(self) -> Axes {
        [true, true, !matches!(self, Inverse::Planar)]
    }

    /// Returns a position, velocity or force as the robot has it: without z, if that does not
    /// count.
    #[must_use]
    pub const fn flat(self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let [_, _, space] = self.axes();
        [x, y, if space { z } else { 0.0 }]
    }
}

/// The unit of torques.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TorqueUnit {
    /// N·m.
    NewtonMetre,
    /// mN·m, which is N·mm.
    MillinewtonMetre,
}

impl TorqueUnit {
    /// Both units.
    pub const ALL: [TorqueUnit; 2] = [TorqueUnit::NewtonMetre, TorqueUnit::MillinewtonMetre];

    /// Returns its symbol.
    pub const fn symbol(self) -> &'static str {
        match self {
            TorqueUnit::NewtonMetre => "N·m",
            TorqueUnit::MillinewtonMetre => "mN·m",
        }
    }

    /// Returns the number of these units in 1 N·m.
    pub const fn per_newton_metre(self) -> f64 {
        match self {
            TorqueUnit::NewtonMetre => 1.0,
            TorqueUnit::MillinewtonMetre => 1000.0,
        }
    }
}

/// Parameters of commands of torque, force and compliance, for a robot that senses and gives
/// torques.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Forces {
    /// The unit of every torque that is commanded or sensed.
    pub unit: TorqueUnit,
    /// `TORQUE_MAX` at its standard value, in that unit.
    pub torque_max: f64,
    /// `ANGLE_STIFFNESS` at its standard value: torque per degree.
    pub angle_stiffness: f64,
    /// `POSITION_STIFFNESS` at its standard value, along each axis, N/mm.
    pub position_stiffness: f64,
    /// The torque with which DETECT_FLOOR closes a joint.
    pub search_torque: f64,
    /// The force with which DETECT_OBJECT closes the fingers of one side, N.
    pub search_force: f64,
    /// The torque from which a joint that stands still presses on something.
    pub contact_torque: f64,
}

/// Response of a joint to one volt of [vibration](crate::vibration).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VibrationGain {
    /// Addition to the angle that is commanded, deg.
    pub angle: f64,
    /// Addition to the torque that is commanded, in the robot's [`TorqueUnit`].
    pub torque: f64,
}

/// A slider that carries the floor under a hand (`FLOOR`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slider {
    /// Initial place, mm.
    pub initial: Point,
    /// Travel along x, y and z, mm.
    pub travel: [Range; 3],
}

impl Slider {
    /// Returns true if the slider can go there.
    pub fn reaches(&self, position: Point) -> bool {
        let axes = self.travel.iter().zip(position);
        axes.into_iter().all(|(travel, at)| travel.contains(at))
    }
}

/// A robot of `L` legs with `J` joints each.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Model<const L: usize, const J: usize> {
    /// The name that programs and messages use.
    pub name: &'static str,
    /// The set of commands that it understands.
    pub family: Family,
    /// Its legs, F1 first.
    pub legs: [Leg<J>; L],
    /// Its inverse kinematics.
    pub inverse: Inverse,
    /// Its body, if it walks; a robot without one is bolted down where its frame is.
    pub body: Option<Body>,
    /// Its parameters at program start.
    pub standards: Standards,
    /// The sampling times that it accepts, ms.
    pub periods: Range,
    /// The reading of a sole's pressure sensor from which its foot stands on something, V.
    pub contact: f64,
    /// Lamps and relays: devices 0 up to, but not including, this number.
    pub lamps: u8,
    /// Parameters of torques and forces, if it has any.
    pub forces: Option<Forces>,
    /// Its slider, if it has one.
    pub slider: Option<Slider>,
    /// Vibration of its joints, if they vibrate.
    pub vibration: Option<VibrationGain>,
    /// Pairs of parts that may touch or overlap: no collisions of them are reported.
    pub may_touch: [Option<[Part; 2]>; TOUCHING],
}

/// Maximum number of pairs that a model allows to touch.
pub const TOUCHING: usize = 32;

/// A rigid part of a robot.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Part {
    /// The body.
    Body,
    /// The link after a joint, by leg and joint.
    Link(u8, u8),
}

impl Part {
    /// Returns a link, by leg and joint from 0.
    #[cfg(feature = "control")]
    pub(crate) fn link(leg: usize, joint: usize) -> Self {
        let number = |from_0: usize| u8::try_from(from_0 + 1).unwrap_or(u8::MAX);
        Part::Link(number(leg), number(joint))
    }
}

impl fmt::Display for Part {
    /// Writes `body`, or the name of a link in exported files, such as `link12`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Part::Body => f.write_str("body"),
            Part::Link(leg, joint) => write!(f, "link{leg}{joint}"),
        }
    }
}

impl FromStr for Part {
    type Err = ();

    /// Parses `body`, or a link such as `link12`: leg 1, joint 2.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let number = |digit: &u8| matches!(digit, b'1'..=b'9').then_some(digit - b'0');
        match (text, text.strip_prefix("link").map(str::as_bytes)) {
            ("body", _) => Ok(Part::Body),
            (_, Some([leg, joint])) => number(leg)
                .zip(number(joint))
                .map_or(Err(()), |(leg, joint)| Ok(Part::Link(leg, joint))),
            _ => Err(()),
        }
    }
}

/// Radius of a link, as a share of its length.
#[cfg(feature = "control")]
const SLENDER: f64 = 0.05;

/// Margin by which the potentiometers measure beyond the working limits, deg.
const OUTER: f64 = 5.0;

impl Joint {
    /// Returns a joint that turns about `axis`, a unit vector in the frame of the link before, and
    /// carries a link that goes from it to the next joint, or to the foot, by `link` (mm) at angle
    /// 0. It turns from −180 to 180 deg; its link has 0.1 kg, its motor 10 N·m.
    #[must_use]
    pub const fn revolute(axis: [f64; 3], link: [f64; 3]) -> Self {
        Joint {
            axis,
            link,
            limits: Range::new(-180.0, 180.0),
            outer: Range::new(-180.0 - OUTER, 180.0 + OUTER),
            mass: 0.1,
            inertial: None,
            torque: 10.0,
            radius: None,
        }
    }

    /// Returns the radius of the link, a capsule, where it may meet other links and the body, mm.
    #[cfg(feature = "control")]
    pub fn thickness(&self) -> f64 {
        let [x, y, z] = self.link;
        self.radius
            .unwrap_or_else(|| SLENDER * libm::sqrt(x * x + y * y + z * z))
    }

    /// Sets the working limits, deg; the potentiometers measure 5 deg beyond.
    #[must_use]
    pub const fn limits(self, min: f64, max: f64) -> Self {
        let limits = Range::new(min, max);
        Joint {
            limits,
            outer: limits.widened(OUTER),
            ..self
        }
    }

    /// Sets the mass of the link, kg.
    #[must_use]
    pub const fn mass(self, mass: f64) -> Self {
        Joint { mass, ..self }
    }

    /// Sets the distribution of the mass.
    #[must_use]
    pub const fn inertial(self, inertial: InertialProperties) -> Self {
        Joint {
            inertial: Some(inertial),
            ..self
        }
    }

    /// Sets the torque of the motor, N·m.
    #[must_use]
    pub const fn torque(self, torque: f64) -> Self {
        Joint { torque, ..self }
    }
}

impl<const J: usize> Leg<J> {
    /// Returns a leg whose first joint is at `base` (mm, in the robot frame); all its angles are 0
    /// at first.
    #[must_use]
    pub const fn at(base: Point, joints: [Joint; J]) -> Self {
        Leg {
            base,
            joints,
            initial: [0.0; J],
        }
    }

    /// Sets the initial posture, deg.
    #[must_use]
    pub const fn initial(self, initial: [f64; J]) -> Self {
        Leg { initial, ..self }
    }
}

impl<const L: usize, const J: usize> Model<L, J> {
    /// Returns a robot with the commands marked G: bolted down, without torques and slider, its
    /// joint angles found by least squares; everything else is as [`generic::MODEL`] has it.
    #[must_use]
    pub const fn generic(name: &'static str, legs: [Leg<J>; L]) -> Self {
        Model {
            name,
            family: generic::MODEL.family,
            legs,
            inverse: Inverse::LeastSquares,
            body: None,
            standards: generic::MODEL.standards,
            periods: generic::MODEL.periods,
            contact: generic::MODEL.contact,
            lamps: generic::MODEL.lamps,
            forces: None,
            slider: None,
            vibration: None,
            may_touch: generic::MODEL.may_touch,
        }
    }

    /// Returns the robot with these legs.
    #[must_use]
    pub const fn with_legs<const N: usize>(self, legs: [Leg<J>; N]) -> Model<N, J> {
        Model {
            legs,
            name: self.name,
            family: self.family,
            inverse: self.inverse,
            body: self.body,
            standards: self.standards,
            periods: self.periods,
            contact: self.contact,
            lamps: self.lamps,
            forces: self.forces,
            slider: self.slider,
            vibration: self.vibration,
            may_touch: self.may_touch,
        }
    }
}

/// Centre of mass and inertia.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InertialProperties {
    /// Centre of mass, mm: of a link from its joint on, of a body in the robot frame.
    pub centre: Point,
    /// The elements xx, yy, zz, xy, xz and yz of the tensor of inertia about that centre: kg·m². Its axes are those of the link's
    /// frame, which is parallel to the robot frame while all joints are at 0.
    pub inertia: [f64; 6],
}

/// Relative rounding error of a tensor.
const SLIGHT: f64 = 1e-9;

impl InertialProperties {
    /// Spreads a mass evenly along a rod from the joint to the end of `link` (mm).
    #[must_use]
    pub const fn rod(link: [f64; 3], mass: f64) -> Self {
        let [x, y, z] = link;
        let share = mass / 12.0 * 1e-6;
        InertialProperties {
            centre: [x / 2.0, y / 2.0, z / 2.0],
            inertia: [
                share * (y * y + z * z),
                share * (x * x + z * z),
                share * (x * x + y * y),
                -share * x * y,
                -share * x * z,
                -share * y * z,
            ],
        }
    }

    /// Spreads a mass evenly in a box with these extents (mm), its centre taken to be in the
    /// origin.
    #[must_use]
    pub const fn block([x, y, z]: [Range; 3], mass: f64) -> Self {
        let (x, y, z) = (x.max - x.min, y.max - y.min, z.max - z.min);
        let share = mass / 12.0 * 1e-6;
        InertialProperties {
            centre: [0.0; 3],
            inertia: [
                share * (y * y + z * z),
                share * (x * x + z * z),
                share * (x * x + y * y),
                0.0,
                0.0,
                0.0,
            ],
        }
    }

    /// Returns true if all its numbers are finite, and some rigid body has such an inertia.
    #[must_use]
    pub fn is_sound(&self) -> bool {
        let numbers = self.centre.iter().chain(&self.inertia);
        numbers.into_iter().all(|number| number.is_finite()) && is_of_a_body(self.inertia)
    }
}

/// Returns true if the second moments of mass that such a tensor comes from are not negative in any
/// direction. Its principal moments are not negative then, and none is greater than the other two
/// together.
fn is_of_a_body([xx, yy, zz, xy, xz, yz]: [f64; 6]) -> bool {
    let half = (xx + yy + zz) / 2.0;
    let (x, y, z) = (half - xx, half - yy, half - zz);
    let (a, b, c) = (-xy, -xz, -yz);
    let pairs = [x * y - a * a, x * z - b * b, y * z - c * c];
    let all = x * y * z + 2.0 * a * b * c - x * c * c - y * b * b - z * a * a;
    let slight = SLIGHT * half;
    [x, y, z].into_iter().all(|moment| moment >= -slight)
        && pairs.into_iter().all(|pair| pair >= -slight * half)
        && all >= -slight * half * half
}
