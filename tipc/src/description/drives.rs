//! The drives of a real robot in its description: `[bus]` and `[[drive]]`, checked against the joints.
//!
//! The caller passes in the names and travels of the servos that exist.

use super::Leg;
use super::keys::Part;
use super::section::{Found, Section, Sign, fault};
use crate::message::list::List;
use crate::message::{Describing, Message, Suggestion};
use crate::source::Span;
use crate::suggest::nearest;
use std::ops::RangeInclusive;
use tip_runtime::command::Target;
use tip_runtime::model::Range;

/// A servo model that a description can name.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Servo {
    /// Its name.
    pub name: &'static str,
    /// Its family. All servos of a bus are of one family.
    pub family: &'static str,
    /// Angles that its shaft can have, deg.
    pub travel: Range,
}

/// `[bus]`, with the drives.
#[derive(Clone, Debug, PartialEq)]
pub struct Bus {
    /// Name of the port, if it is stated.
    pub port: Option<String>,
    /// Bits per second.
    pub baud: u32,
    /// Maximum delay of an answer by the adapter and its driver, ms.
    pub latency: f64,
    /// True if all servos answer in one frame.
    pub together: bool,
    /// Number of cycles for which a servo may fail to answer.
    pub silence: u32,
    /// Maximum temperature of a servo, °C.
    pub temperature: f64,
    /// Allowed supply voltage, V.
    pub voltage: Range,
    /// Load limit, as part of the stall torque, and the time for which a joint may exceed it, s.
    pub overload: [f64; 2],
    /// Limit of the position error, deg, and the time for which a joint may exceed it, s.
    pub lag: [f64; 2],
    /// Speed of the motion to the initial posture, deg/s.
    pub start: f64,
    /// True if the torque is switched off at the end of a program, and in an emergency.
    pub relaxes: [bool; 2],
    /// True if a command to a posture in which two parts of the robot overlap stops it.
    pub stops_collisions: bool,
    /// True if a page drives the robot only while its operator holds a button.
    pub hold_to_drive: bool,
    /// Times of silence of the page that drives, s: until the robot pauses, until the program is asked to halt, and until the
    /// emergency stop.
    pub driver_silence: [f64; 3],
    /// The drive of each joint, leg by leg.
    pub drives: Vec<Drive>,
}

/// `[[drive]]`: the servo of a joint.
#[derive(Clone, Debug, PartialEq)]
pub struct Drive {
    /// Identity on the bus.
    pub id: u8,
    /// Name of its model.
    pub model: String,
    /// +1 or -1.
    pub sign: f64,
    /// Motor angle at a joint angle of 0, deg.
    pub offset: f64,
    /// Turns of the motor for each turn of the joint.
    pub gear: f64,
    /// Limits of commanded angles, deg.
    pub limits: Range,
    /// Speed limit, deg/s.
    pub speed: f64,
    /// Torque limit, as part of the full torque.
    pub torque: f64,
}

/// Reads the bus, if there is one.
pub(super) fn read(
    robot: Section<'_>,
    legs: &[Leg],
    servos: &[Servo],
    found: &mut Found,
) -> Option<Bus> {
    let Some(bus) = robot.table("bus", Part::Bus, found) else {
        if robot.has("drive") && !robot.has("bus") {
            let location = robot.location_of("drive");
            robot.refuse::<()>("drive", location, Describing::DrivesNeedBus, found);
        }
        return None;
    };
    let family = bus.text("servo", found);
    let family = family.and_then(|named| servo(bus, "servo", named, servos, found));
    let drives = robot.tables("drive", Part::Drive, found);
    let mut places: Vec<Option<Drive>> = legs
        .iter()
        .flat_map(|leg| &leg.joints)
        .map(|_| None)
        .collect();
    let joints = legs.first().map_or(1, |leg| leg.joints.len());
    let mut first = family;
    for section in drives.unwrap_or_default() {
        let Some((location, name)) = section.text("joint", found) else {
            continue;
        };
        let Some((place, joint, initial)) = joint_of(legs, name) else {
            section.refuse::<()>("joint", location, Describing::NoSuchJoint, found);
            continue;
        };
        if places[place].is_some() {
            let help = Describing::TakeOneAway;
            section.refuse_beside("joint", Describing::TwoDrives, help, found);
            continue;
        }
        let Some((drive, model)) = drive(section, bus, (joint, initial), servos, found) else {
            continue;
        };
        let has_it = |other: &Option<Drive>| other.as_ref().is_some_and(|it| it.id == drive.id);
        if let Some(other) = places.iter().position(has_it) {
            let reason = Describing::SameIdentity {
                id: drive.id.into(),
                joint: joint_at(other, joints),
            };
            section.refuse_beside("id", reason, Describing::OneIdentityEach, found);
        }
        if let (Some(first), Some(model)) = (first, model)
            && first.family != model.family
        {
            let reason = Describing::OtherFamily {
                family: model.family,
                first: first.family,
            };
            section.refuse_beside("model", reason, Describing::OneFamilyEach, found);
        }
        first = first.or(model);
        places[place] = Some(drive);
    }
    let complete = found.is_empty();
    for (place, _) in places.iter().enumerate().filter(|(_, it)| it.is_none()) {
        if complete {
            let joint = joint_at(place, joints);
            let reason = Describing::NoDrive { joint };
            bus.refuse::<()>("servo", bus.location, reason, found);
        }
    }
    settings(bus, places.into_iter().flatten().collect(), found)
}

fn settings(bus: Section<'_>, drives: Vec<Drive>, found: &mut Found) -> Option<Bus> {
    let port = bus.text("port", found).map(|(_, text)| text.to_owned());
    let baud = whole(bus, "baud", 9_600.0..=4_500_000.0, 1_000_000, found);
    let latency = within(bus, "latency", 0.0..=1000.0, 4.0, found);
    let answers = [("each", false), ("together", true)];
    let together = bus.has("answers") && bus.choice("answers", &answers, found)?;
    let policies = [("hold", false), ("relax", true)];
    let mut relaxes = [false; 2];
    for (relaxes, key) in relaxes.iter_mut().zip(["at_end", "in_emergency"]) {
        *relaxes = bus.has(key) && bus.choice(key, &policies, found)?;
    }
    let reactions = [("stop", true), ("warn", false)];
    let stops_collisions = !bus.has("collisions") || bus.choice("collisions", &reactions, found)?;
    let silence = whole(bus, "silence", 0.0..=1000.0, 5, found);
    let temperature = bus.number("temperature", Sign::Positive, found);
    let voltage = bus.range("voltage", Sign::Positive, found);
    let overload = bus.numbers("overload", Sign::Positive, found);
    let lag = bus.numbers("lag", Sign::Positive, found);
    let start = within(bus, "start", SPEEDS, 30.0, found);
    let hold_to_drive = bus.boolean("hold_to_drive", found);
    let driver_silence = driver_silence(bus, found);
    Some(Bus {
        port,
        baud: baud?,
        latency,
        together,
        silence: silence?,
        temperature: temperature.unwrap_or(65.0),
        voltage: voltage.unwrap_or(Range::new(6.0, 15.0)),
        overload: overload.unwrap_or([0.9, 0.5]),
        lag: lag.unwrap_or([25.0, 0.5]),
        start,
        relaxes,
        stops_collisions,
        hold_to_drive: hold_to_drive.unwrap_or(true),
        driver_silence: driver_silence.unwrap_or([0.3, 3.0, 10.0]),
        drives,
    })
}

/// Longest silence of a page that drives, s: a robot that nobody drives is stopped in the end.
const MAX_SILENCE: f64 = 3600.0;

/// Reads the times of silence, each at least the one before.
fn driver_silence(bus: Section<'_>, found: &mut Found) -> Option<[f64; 3]> {
    let key = "driver_silence";
    let times: [f64; 3] = bus.numbers(key, Sign::Positive, found)?;
    let reason = match times.windows(2).find(|pair| pair[0] > pair[1]) {
        Some(pair) => Describing::Above {
            min: pair[0],
            max: pair[1],
        },
        None if times[2] > MAX_SILENCE => Describing::NotBetween {
            least: times[1],
            most: MAX_SILENCE,
        },
        None => return Some(times),
    };
    bus.refuse(key, bus.location_of(key), reason, found)
}

/// Speeds that a joint may have, deg/s. A slower motion would take hours.
const SPEEDS: RangeInclusive<f64> = 0.1..=100_000.0;

/// Reads a number of a range.
fn within(
    section: Section<'_>,
    key: &str,
    range: RangeInclusive<f64>,
    standard: f64,
    found: &mut Found,
) -> f64 {
    let Some(number) = section.number(key, Sign::Any, found) else {
        return standard;
    };
    if !range.contains(&number) {
        let (least, most) = range.into_inner();
        let reason = Describing::NotBetween { least, most };
        section.refuse::<()>(key, section.location_of(key), reason, found);
    }
    number
}

/// Reads a whole number.
fn whole(
    section: Section<'_>,
    key: &str,
    range: RangeInclusive<f64>,
    standard: u32,
    found: &mut Found,
) -> Option<u32> {
    if !section.has(key) {
        return Some(standard);
    }
    let number = section.number(key, Sign::Count, found)?;
    if number.fract() == 0.0 && range.contains(&number) {
        return Some(number as u32);
    }
    let (least, most) = (*range.start(), *range.end());
    let reason = Describing::NotWhole { least, most };
    section.refuse(key, section.location_of(key), reason, found)
}

/// Returns the joint at a place, where each leg has this many.
fn joint_at(place: usize, joints: usize) -> Target {
    let [leg, joint] = [place / joints, place % joints].map(|it| it as u8 + 1);
    Target::Joint(leg, joint)
}

/// Returns the place of a joint by its name, its working limits and its initial angle.
fn joint_of(legs: &[Leg], name: &str) -> Option<(usize, Range, f64)> {
    let Ok(Target::Joint(leg, joint)) = name.parse() else {
        return None;
    };
    let [leg, joint] = [leg, joint].map(|number| usize::from(number) - 1);
    let found = legs.get(leg)?;
    let limits = found.joints.get(joint)?.limits;
    Some((
        leg * found.joints.len() + joint,
        limits,
        found.initial[joint],
    ))
}

/// Returns the servo that a key names; `None` if no servos are known here.
fn servo(
    section: Section<'_>,
    key: &str,
    (location, name): (Span, &str),
    servos: &[Servo],
    found: &mut Found,
) -> Option<Servo> {
    let meant = servos
        .iter()
        .find(|servo| servo.name.eq_ignore_ascii_case(name));
    if meant.is_none() && !servos.is_empty() {
        let names: Vec<&str> = servos.iter().map(|servo| servo.name).collect();
        let known = List(names.iter().map(ToString::to_string).collect());
        let reason = Describing::NoSuchServo { known };
        match nearest_servo(name, &names) {
            Some(near) => {
                let help = Suggestion::DidYouMean { near: near.into() };
                found.push(fault(section.part, location, reason, help));
            }
            None => {
                section.refuse::<()>(key, location, reason, found);
            }
        }
    }
    meant.copied()
}

/// Returns the model whose name is nearest, or begins so, in any case.
fn nearest_servo<'a>(name: &str, names: &[&'a str]) -> Option<&'a str> {
    let name = name.to_lowercase();
    let lower: Vec<String> = names.iter().map(|name| name.to_lowercase()).collect();
    let near = nearest(&name, lower.iter().map(String::as_str));
    let begins = || {
        let mut names = lower.iter().map(String::as_str);
        names.find(|known| name.len() > 1 && known.starts_with(&name))
    };
    let near = near.or_else(begins)?;
    let place = lower.iter().position(|known| known == near)?;
    names.get(place).copied()
}

/// Reads a drive of a joint with these limits and this initial angle.
fn drive(
    section: Section<'_>,
    bus: Section<'_>,
    (joint, initial): (Range, f64),
    servos: &[Servo],
    found: &mut Found,
) -> Option<(Drive, Option<Servo>)> {
    let refuse = |key: &str, reason: Message, found: &mut Found| {
        section.refuse::<()>(key, section.location_of(key), reason, found);
    };
    let id = section
        .has("id")
        .then(|| whole(section, "id", 0.0..=252.0, 0, found));
    let named = section.text("model", found);
    let model = match named {
        Some(named) => servo(section, "model", named, servos, found),
        None => bus
            .text("servo", &mut Found::new())
            .and_then(|named| servo(bus, "servo", named, servos, &mut Found::new())),
    };
    let name = named.or_else(|| bus.text("servo", &mut Found::new()));
    if name.is_none() && !bus.has("servo") {
        refuse("model", Describing::NoModel.into(), found);
    }
    let sign = section.number("sign", Sign::Any, found).unwrap_or(1.0);
    if sign.abs() != 1.0 {
        refuse("sign", Describing::NoSign.into(), found);
    }
    let offset = section.number("offset", Sign::Any, found).unwrap_or(0.0);
    let gear = section.number("gear", Sign::Positive, found).unwrap_or(1.0);
    let limits = section.range("limits", Sign::Any, found).unwrap_or(joint);
    let is_inside = joint.contains(limits.min) && joint.contains(limits.max);
    if !is_inside {
        let Range { min, max } = joint;
        refuse("limits", Describing::BeyondJoint { min, max }.into(), found);
    } else if !limits.contains(initial) {
        refuse(
            "limits",
            Describing::StartsOutside { angle: initial }.into(),
            found,
        );
    }
    let speed = within(section, "speed", SPEEDS, 180.0, found);
    // Less than a hundredth rounds to 0 counts in some servos, which would then be switched on without any force.
    let torque = within(section, "torque", 0.01..=1.0, 1.0, found);
    if let Some(servo) = model.filter(|_| is_inside) {
        let Range { min, max } = servo.travel;
        let ends = [limits.min, limits.max].map(|angle| sign * gear * angle + offset);
        if let Some(angle) = ends.into_iter().find(|end| !servo.travel.contains(*end)) {
            let key = if section.has("limits") {
                "limits"
            } else {
                "joint"
            };
            let [angle, min, max] = [angle, min, max].map(|angle| (angle * 10.0).round() / 10.0);
            let reason = Describing::BeyondTravel { angle, min, max };
            let (location, help) = (section.location_of(key), Suggestion::FitsTravel);
            found.push(fault(section.part, location, reason, help));
        }
    }
    let drive = Drive {
        id: id?? as u8,
        model: name?.1.to_owned(),
        sign,
        offset,
        gear,
        limits,
        speed,
        torque,
    };
    Some((drive, model))
}
