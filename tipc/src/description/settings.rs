//! Settings of a description besides its legs: its name, and settings that have a default.

use super::Leg;
use super::keys;
use super::legs::{Shape, read_inertial, read_shapes};
use super::section::{Found, Section, Sign};
use crate::message::{Describing, Letter};
use crate::robot::Robot;
use tip_runtime::model::{
    Body, Forces, InertialProperties, Inverse, Part, Range, Slider, Standards, TOUCHING,
    TorqueUnit, generic,
};

/// Reads speeds, tolerances and sampling time. The defaults are those of the generic robot.
pub(super) fn standards(robot: Section<'_>, periods: Range, found: &mut Found) -> Standards {
    let standard = Standards {
        period: generic::MODEL
            .standards
            .period
            .clamp(periods.min, periods.max),
        ..generic::MODEL.standards
    };
    let Some(section) = robot.table("standards", keys::Part::Standards, found) else {
        return standard;
    };
    let mut number = |key, standard| {
        let given = section.number(key, Sign::Positive, found);
        given.unwrap_or(standard)
    };
    let standards = Standards {
        v_max: number("v_max", standard.v_max),
        a_max: number("a_max", standard.a_max),
        omega_max: number("omega_max", standard.omega_max),
        omega_dot_max: number("omega_dot_max", standard.omega_dot_max),
        just_position: number("just_position", standard.just_position),
        just_angle: number("just_angle", standard.just_angle),
        near_position: number("near_position", standard.near_position),
        near_angle: number("near_angle", standard.near_angle),
        period: number("period", standard.period),
    };
    if !periods.contains(standards.period) {
        let Range { min, max } = periods;
        let reason = Describing::SamplingTimes { min, max };
        section.refuse::<()>("period", section.location_of("period"), reason, found);
    }
    standards
}

/// Reads the sampling times that the robot accepts.
pub(super) fn periods(robot: Section<'_>, found: &mut Found) -> Range {
    let periods = robot.range("periods", Sign::Positive, found);
    periods.unwrap_or(generic::MODEL.periods)
}

/// Reads the voltage of a sole that stands on something.
pub(super) fn contact(robot: Section<'_>, found: &mut Found) -> f64 {
    let contact = robot.number("contact", Sign::Positive, found);
    contact.unwrap_or(generic::MODEL.contact)
}

/// Returns the number of lamps.
pub(super) fn lamps(robot: Section<'_>, found: &mut Found) -> u8 {
    let standard = generic::MODEL.lamps;
    let Some(number) = robot.number("lamps", Sign::NotNegative, found) else {
        return standard;
    };
    if number > f64::from(u8::MAX) || number.fract() != 0.0 {
        let reason = Describing::NoNumberOfLamps;
        robot.refuse::<()>("lamps", robot.location_of("lamps"), reason, found);
        return standard;
    }
    number as u8
}

/// Reads the pairs of parts that may touch.
pub(super) fn may_touch(
    robot: Section<'_>,
    legs: &[Leg],
    has_body: bool,
    found: &mut Found,
) -> [Option<[Part; 2]>; TOUCHING] {
    const KEY: &str = "may_touch";
    let mut may_touch = [None; TOUCHING];
    let pairs = robot.pairs(KEY, found).unwrap_or_default();
    if pairs.len() > TOUCHING {
        let reason = Describing::TooManyPairs { most: TOUCHING };
        robot.refuse::<()>(KEY, robot.location_of(KEY), reason, found);
        return may_touch;
    }
    let links = (1..).zip(legs).flat_map(|(leg, of)| {
        let joints = (1..).zip(&of.joints);
        joints.map(move |(joint, _)| Part::Link(leg, joint))
    });
    let parts: Vec<Part> = has_body
        .then_some(Part::Body)
        .into_iter()
        .chain(links)
        .collect();
    let names: Vec<String> = parts.iter().map(Part::to_string).collect();
    let known: Vec<(&str, Part)> = names.iter().map(String::as_str).zip(parts).collect();
    for (place, (location, words)) in may_touch.iter_mut().zip(pairs) {
        let part =
            |word: &str, found: &mut Found| match known.iter().find(|(name, _)| *name == word) {
                Some((_, part)) => Some(*part),
                None => {
                    let names = known.iter().map(|(name, _)| *name);
                    robot.refuse_word(KEY, (location, word), names, found)
                }
            };
        let [one, other] = words.map(|word| part(word, found));
        let pair = one.zip(other).map(|(one, other)| [one, other]);
        *place = match pair {
            Some([one, other]) if one == other => {
                let part = one.to_string();
                robot.refuse(KEY, location, Describing::TouchesItself { part }, found)
            }
            pair => pair,
        };
    }
    may_touch
}

/// Reads the body and its shapes, if the robot walks.
pub(super) fn body(robot: Section<'_>, found: &mut Found) -> Option<(Body, Vec<Shape>)> {
    let section = robot.table("body", keys::Part::Body, found)?;
    let [x, y, z] = ["x", "y", "z"].map(|key| section.extent(key, found));
    let mass = section.number("mass", Sign::Positive, found);
    let mass = mass.unwrap_or(1.0);
    let point = Range::new(0.0, 0.0);
    let even = InertialProperties::block([x, y, z].map(|range| range.unwrap_or(point)), mass);
    let inertial = read_inertial(section, even, found);
    let shapes = read_shapes(section, found);
    let body = Body {
        x: x?,
        y: y?,
        z: z?,
        mass,
        inertial,
    };
    Some((body, shapes))
}

/// Reads the torques that the robot senses and gives, if it does. Such a robot lacks the search commands of the hand.
pub(super) fn forces(robot: Section<'_>, legs: &[Leg], found: &mut Found) -> Option<Forces> {
    let section = robot.table("forces", keys::Part::Forces, found)?;
    let units = TorqueUnit::ALL.map(|unit| (unit.symbol(), unit));
    let unit = section.choice("unit", &units, found);
    let unit = unit.unwrap_or(TorqueUnit::NewtonMetre);
    let scale = unit.per_newton_metre();
    let standard = generic::MODEL.forces?;
    let joints = legs.iter().flat_map(|leg| &leg.joints);
    let strongest = joints.map(|joint| joint.torque).fold(0.0, f64::max);
    let mut number = |key, standard| {
        let given = section.number(key, Sign::Positive, found);
        given.unwrap_or(standard)
    };
    Some(Forces {
        unit,
        torque_max: number("torque_max", strongest * scale),
        angle_stiffness: number("angle_stiffness", standard.angle_stiffness * scale),
        position_stiffness: number("position_stiffness", standard.position_stiffness),
        search_torque: standard.search_torque * scale,
        contact_torque: standard.contact_torque * scale,
        ..standard
    })
}

/// Reads the slider that carries the floor, if there is one.
pub(super) fn slider(robot: Section<'_>, found: &mut Found) -> Option<Slider> {
    let section = robot.table("slider", keys::Part::Slider, found)?;
    let initial: [f64; 3] = section.numbers("initial", Sign::Any, found)?;
    let mut travel = initial.map(|at| Range::new(at, at));
    for ((key, at), travel) in ["x", "y", "z"].into_iter().zip(initial).zip(&mut travel) {
        let Some(given) = section.range(key, Sign::Any, found) else {
            continue;
        };
        *travel = given;
        if !given.contains(at) {
            let reason = Describing::SliderOutside { at };
            section.refuse::<()>(key, section.location_of(key), reason, found);
        }
    }
    Some(Slider { initial, travel })
}

/// Reads the inverse kinematics that the file asks for.
pub(super) fn inverse(robot: Section<'_>, found: &mut Found) -> Option<Inverse> {
    let words = Inverse::ALL.map(|inverse| (inverse.name(), inverse));
    robot.choice("inverse", &words, found)
}

/// The longest name, in characters.
const MAX_NAME_CHARS: usize = 40;

/// Reads the robot's name, if it is one.
pub(super) fn name<'a>(robot: Section<'a>, found: &mut Found) -> Option<&'a str> {
    let (location, name) = robot.text("name", found)?;
    let allowed = |c: char| c.is_alphanumeric() || " -_.".contains(c);
    let reason = if name.trim().is_empty() {
        Describing::NeedsName
    } else if name.trim() != name {
        Describing::BlankAtEnd
    } else if name.chars().count() > MAX_NAME_CHARS {
        Describing::NameTooLong {
            most: MAX_NAME_CHARS,
        }
    } else if let Some(character) = name.chars().find(|c| !allowed(*c)) {
        Describing::NotInName {
            character: Letter(character),
        }
    } else if Robot::from_name(name).is_some() {
        Describing::KnownRobot
    } else {
        return Some(name);
    };
    robot.refuse("name", location, reason, found)
}
