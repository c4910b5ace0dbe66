//! Checks of the consistency of a model.

use super::{
    Body, Forces, InertialProperties, Inverse, Joint, Leg, Model, Part, Range, Slider, Standards,
    VibrationGain,
};
use crate::command::{MAX, Target};
use core::fmt;

/// A place in a model; legs and joints count from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Place {
    /// The robot as a whole.
    Robot,
    /// A leg.
    Leg(u8),
    /// A joint, by leg and joint.
    Joint(u8, u8),
    /// The body.
    Body,
    /// The standard parameters.
    Standards,
    /// The parameters of torques.
    Forces,
    /// The slider.
    Slider,
    /// The response to a volt of vibration.
    Vibration,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Place::Robot => f.write_str("robot"),
            Place::Leg(leg) => Target::Foot(*leg).fmt(f),
            Place::Joint(leg, joint) => Target::Joint(*leg, *joint).fmt(f),
            Place::Body => f.write_str("body"),
            Place::Standards => f.write_str("standards"),
            Place::Forces => f.write_str("forces"),
            Place::Slider => f.write_str("slider"),
            Place::Vibration => f.write_str("vibration"),
        }
    }
}

/// The error of an inconsistent model: its first fault.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ModelError {
    /// Place of the error.
    pub place: Place,
    /// The field's name in the model.
    pub field: &'static str,
    /// The requirement that does not hold.
    pub wanted: &'static str,
}

impl fmt::Display for ModelError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {} {}", self.place, self.field, self.wanted)
    }
}

impl core::error::Error for ModelError {}

/// Tolerance of the length of an axis, which is 1, and of a direction.
const SLIGHT: f64 = 1e-9;

const NOT_NEGATIVE: &str = "must be a finite number, not below 0";
const POSITIVE: &str = "must be a finite number above 0";
const A_BODY: &str = "must be finite, with the inertia of some rigid body";
const FINITE: &str = "must be finite numbers";
const ORDERED: &str = "must be finite, the lower end not above the upper one";

impl<const L: usize, const J: usize> Model<L, J> {
    /// Checks that the model describes a robot.
    ///
    /// # Errors
    /// The first fault, such as a number that is not finite, an axis whose length is not 1, limits that are
    /// reversed or do not contain the initial posture, a leg without length, or a chain that its inverse kinematics
    /// does not fit.
    pub fn check(&self) -> Result<(), ModelError> {
        let robot = |good, field, wanted| require(good, Place::Robot, field, wanted);
        robot(!self.name.is_empty(), "name", "must not be empty")?;
        robot((1..=MAX).contains(&L), "legs", "must be 1 to 9")?;
        robot((1..=MAX).contains(&J), "joints", "must be 1 to 9")?;
        for (n, leg) in (1..).zip(&self.legs) {
            check_leg(n, leg, self.inverse)?;
        }
        if let Some(body) = &self.body {
            check_body(body)?;
            let links = self.legs.iter().flat_map(|leg| &leg.joints);
            let mass = links.fold(body.mass, |mass, joint| mass + joint.mass);
            require(
                mass > 0.0,
                Place::Body,
                "mass",
                "or that of a link must be above 0",
            )?;
        }
        robot(is_ordered(self.periods), "periods", ORDERED)?;
        robot(self.periods.min > 0.0, "periods", "must be above 0")?;
        robot(self.contact.is_finite(), "contact", FINITE)?;
        let has = |part: &Part| match part {
            Part::Body => self.body.is_some(),
            Part::Link(leg, joint) => {
                (1..=L).contains(&usize::from(*leg)) && (1..=J).contains(&usize::from(*joint))
            }
        };
        let mut pairs = self.may_touch.iter().flatten();
        robot(
            pairs.all(|[one, other]| has(one) && has(other) && one != other),
            "may_touch",
            "must be pairs of different parts of the robot",
        )?;
        check_standards(&self.standards, self.periods)?;
        self.forces.as_ref().map_or(Ok(()), check_forces)?;
        self.slider.as_ref().map_or(Ok(()), check_slider)?;
        self.vibration.as_ref().map_or(Ok(()), check_vibration)
    }
}

impl Inverse {
    /// Returns true if this inverse kinematics fits a leg with these joints.
    #[must_use]
    pub fn fits(self, joints: &[Joint]) -> bool {
        match self {
            Inverse::YawPitchPitch => is_yaw_pitch_pitch(joints),
            Inverse::RollPitchPitch => is_roll_pitch_pitch(joints),
            Inverse::Planar => joints.iter().all(|joint| is_along(joint.axis, Z)),
            Inverse::LeastSquares => true,
        }
    }

    /// Returns the requirements on the joints of a leg, as a text.
    #[must_use]
    pub const fn wanted(self) -> &'static str {
        match self {
            Inverse::YawPitchPitch => {
                "must be a vertical and two level axes, with links straight outward at 0 and a knee that flexes downwards"
            }
            Inverse::RollPitchPitch => {
                "must be an axis and two parallel ones at right angles to it, with links that these two swing"
            }
            Inverse::Planar => "must have vertical axes only",
            Inverse::LeastSquares => "may be anything",
        }
    }
}

fn require(
    good: bool,
    place: Place,
    field: &'static str,
    wanted: &'static str,
) -> Result<(), ModelError> {
    if good {
        Ok(())
    } else {
        Err(ModelError {
            place,
            field,
            wanted,
        })
    }
}

fn check_leg<const J: usize>(n: u8, leg: &Leg<J>, inverse: Inverse) -> Result<(), ModelError> {
    let of_leg = |good, field, wanted| require(good, Place::Leg(n), field, wanted);
    of_leg(are_finite(&leg.base), "base", FINITE)?;
    for (m, (joint, initial)) in (1..).zip(leg.joints.iter().zip(&leg.initial)) {
        check_joint(Place::Joint(n, m), joint, *initial)?;
    }
    let moves = leg.joints.iter().any(|joint| square(joint.link) > 0.0);
    of_leg(moves, "links", "must have a length, at least one of them")?;
    of_leg(inverse.fits(&leg.joints), "joints", inverse.wanted())
}

fn check_joint(place: Place, joint: &Joint, initial: f64) -> Result<(), ModelError> {
    let check = |good, field, wanted| require(good, place, field, wanted);
    check(are_finite(&joint.axis), "axis", FINITE)?;
    let off = square(joint.axis) - 1.0;
    check(
        (-SLIGHT..=SLIGHT).contains(&off),
        "axis",
        "must have length 1",
    )?;
    check(are_finite(&joint.link), "link", FINITE)?;
    check(is_ordered(joint.limits), "limits", ORDERED)?;
    check(is_ordered(joint.outer), "outer", ORDERED)?;
    let inside = joint.outer.contains(joint.limits.min) && joint.outer.contains(joint.limits.max);
    check(inside, "outer", "must contain the limits")?;
    check(is_at_least_0(joint.mass), "mass", NOT_NEGATIVE)?;
    check(is_sound(joint.inertial), "inertial", A_BODY)?;
    check(is_positive(joint.torque), "torque", POSITIVE)?;
    check(joint.radius.is_none_or(is_positive), "radius", POSITIVE)?;
    check(
        joint.limits.contains(initial),
        "initial",
        "must lie within the limits",
    )
}

fn check_body(body: &Body) -> Result<(), ModelError> {
    for (field, range) in [("x", body.x), ("y", body.y), ("z", body.z)] {
        require(is_ordered(range), Place::Body, field, ORDERED)?;
    }
    require(is_at_least_0(body.mass), Place::Body, "mass", NOT_NEGATIVE)?;
    require(is_sound(body.inertial), Place::Body, "inertial", A_BODY)
}

fn is_sound(inertial: Option<InertialProperties>) -> bool {
    inertial.is_none_or(|inertial| inertial.is_sound())
}

fn check_standards(standards: &Standards, periods: Range) -> Result<(), ModelError> {
    let Standards {
        v_max,
        a_max,
        omega_max,
        omega_dot_max,
        just_position,
        just_angle,
        near_position,
        near_angle,
        period,
    } = *standards;
    for (field, value) in [
        ("v_max", v_max),
        ("a_max", a_max),
        ("omega_max", omega_max),
        ("omega_dot_max", omega_dot_max),
        ("just_position", just_position),
        ("just_angle", just_angle),
        ("near_position", near_position),
        ("near_angle", near_angle),
    ] {
        require(is_positive(value), Place::Standards, field, POSITIVE)?;
    }
    let accepted = periods.contains(period);
    require(
        accepted,
        Place::Standards,
        "period",
        "must lie within the robot's periods",
    )
}

fn check_forces(forces: &Forces) -> Result<(), ModelError> {
    let Forces {
        unit: _,
        torque_max,
        angle_stiffness,
        position_stiffness,
        search_torque,
        search_force,
        contact_torque,
    } = *forces;
    for (field, value) in [
        ("torque_max", torque_max),
        ("angle_stiffness", angle_stiffness),
        ("position_stiffness", position_stiffness),
        ("search_torque", search_torque),
        ("search_force", search_force),
        ("contact_torque", contact_torque),
    ] {
        require(is_at_least_0(value), Place::Forces, field, NOT_NEGATIVE)?;
    }
    Ok(())
}

fn check_slider(slider: &Slider) -> Result<(), ModelError> {
    let check = |good, field, wanted| require(good, Place::Slider, field, wanted);
    check(slider.travel.into_iter().all(is_ordered), "travel", ORDERED)?;
    check(
        slider.reaches(slider.initial),
        "initial",
        "must lie within the travel",
    )
}

fn check_vibration(per_volt: &VibrationGain) -> Result<(), ModelError> {
    let VibrationGain { angle, torque } = *per_volt;
    for (field, value) in [("angle", angle), ("torque", torque)] {
        require(is_at_least_0(value), Place::Vibration, field, NOT_NEGATIVE)?;
    }
    Ok(())
}

fn is_at_least_0(value: f64) -> bool {
    value >= 0.0 && value.is_finite()
}

fn is_positive(value: f64) -> bool {
    value > 0.0 && value.is_finite()
}

fn are_finite(values: &[f64]) -> bool {
    values.iter().all(|value| value.is_finite())
}

fn is_ordered(range: Range) -> bool {
    range.min <= range.max && are_finite(&[range.min, range.max])
}

const Z: [f64; 3] = [0.0, 0.0, 1.0];

/// Returns true for a yaw, a thigh and a knee that point straight outward at 0, with room for the
/// knee to flex downwards.
fn is_yaw_pitch_pitch(joints: &[Joint]) -> bool {
    let [yaw, thigh, knee] = joints else {
        return false;
    };
    let outward = yaw.link;
    let across = cross(outward, Z);
    let goes_on = |joint: &Joint| {
        is_along(joint.axis, across)
            && is_along(joint.link, outward)
            && dot(joint.link, outward) > 0.0
    };
    let flexed = -dot(across, knee.axis) * (knee.limits.min + knee.limits.max);
    let is_level = is_along(cross(across, Z), outward);
    is_along(yaw.axis, Z) && is_level && goes_on(thigh) && goes_on(knee) && flexed > 0.0
}

/// Returns true for three joints, the last two of which turn their links in a plane through the
/// first one's axis, or beside it.
fn is_roll_pitch_pitch(joints: &[Joint]) -> bool {
    let [roll, thigh, knee] = joints else {
        return false;
    };
    let off = dot(roll.axis, thigh.axis);
    let swings =
        |joint: &Joint| square(cross(thigh.axis, joint.link)) > SLIGHT * square(joint.link);
    (-SLIGHT..=SLIGHT).contains(&off)
        && is_along(thigh.axis, knee.axis)
        && swings(thigh)
        && swings(knee)
}

/// Returns true if two vectors lie on one line; one without length does not.
fn is_along(a: [f64; 3], b: [f64; 3]) -> bool {
    let size = square(a) * square(b);
    size > 0.0 && square(cross(a, b)) <= SLIGHT * SLIGHT * size
}

fn square(vector: [f64; 3]) -> f64 {
    dot(vector, vector)
}

fn dot([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> f64 {
    a * x + b * y + c * z
}

fn cross([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}
