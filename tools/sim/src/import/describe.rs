//! The description of an imported robot as text, and the report of what was assumed, dropped or looks
//! like a placeholder.

use super::chains::{self, Chain, ChainJoint};
use super::names::listed;
use super::rigid_links::{self, Weight};
use super::stand::Postures;
use super::transform::Transform;
use super::tree::{Joint, JointType, Link};
use super::xml::printed;
use crate::message::Importing;
use crate::urdf::frame::rpy_of_axes;
use std::f64::consts::{PI, TAU};
use std::fmt::Write as _;
use tip_runtime::model::{Range, Slider};
use tipc::Robot;
use tipc::description::{Form, Shape};
use tipc::message::list::List;

/// Maximum length of a robot's name, characters.
const MAX_NAME_CHARS: usize = 40;
/// Extent of the assumed body above and below the first joints, mm.
const HALF_HEIGHT: f64 = 50.0;

/// The parts of an imported robot.
pub(super) struct RobotParts<'a> {
    pub(super) name: &'a str,
    /// True for a robot that can stand on its legs.
    pub(super) walks: bool,
    /// The links that are fixed to the base.
    pub(super) base: &'a [(&'a Link, Transform)],
    /// Extents of the body, if the file gives them, mm.
    pub(super) extents: Option<[Range; 3]>,
    pub(super) slider: Option<Slider>,
    pub(super) legs: &'a [Chain<'a>],
    pub(super) stands: InitialPosture,
    /// The standard OMEGA_MAX, if the file has it, deg/s.
    pub(super) omega_max: Option<f64>,
}

/// The initial posture.
pub(super) enum InitialPosture {
    /// The middle of the limits.
    Middle,
    /// A posture with its feet `height` mm below the robot frame, as requested.
    AsAsked { height: f64, postures: Postures },
    /// A posture that the file names.
    OfFile { name: String, postures: Postures },
    /// A posture with its feet `height` mm below the robot frame, assumed because the robot would
    /// fall in the middle of its limits.
    Assumed { height: f64, postures: Postures },
}

impl RobotParts<'_> {
    /// Returns the greatest distance of any part from the robot frame, mm.
    fn reach(&self) -> f64 {
        self.legs.iter().map(Chain::reach).fold(0.0, f64::max)
    }
}

/// Returns the text, and the report of what was assumed or dropped.
pub(super) fn description(source_name: &str, found: &RobotParts<'_>) -> (String, Vec<Importing>) {
    let legs = found.legs;
    let mut report = vec![
        Importing::Frames,
        Importing::Dropped,
        Importing::NoSensors,
        match &found.stands {
            InitialPosture::AsAsked { height, .. } => Importing::Stands { height: *height },
            InitialPosture::Assumed { height, .. } => Importing::StandsByItself { height: *height },
            InitialPosture::OfFile { name, .. } => Importing::PostureOfFile {
                name: printed(name),
            },
            InitialPosture::Middle => Importing::InitialPosture,
        },
    ];
    let mut postures = match &found.stands {
        InitialPosture::AsAsked { postures, .. }
        | InitialPosture::OfFile { postures, .. }
        | InitialPosture::Assumed { postures, .. } => postures.as_slice(),
        InitialPosture::Middle => [].as_slice(),
    }
    .iter()
    .map(Vec::as_slice);
    let mut text = format!(
        "# From {} by `tip robot import`.\n# mm, deg, kg, N·m; x to the right, y forward, z up.\n\nname = \"{}\"\n",
        printed(source_name),
        robot_name(found.name)
    );
    let outside = postures.clone().zip(legs).flat_map(|(angles, leg)| {
        let joints = leg.joints.iter().map(|turning| turning.joint).zip(angles);
        joints.filter(|(joint, angle)| {
            let [min, max] = ends(joint);
            !(min..=max).contains(&measure(**angle))
        })
    });
    let outside: Vec<String> = outside.map(|(joint, _)| limited(joint)).collect();
    if !outside.is_empty() {
        report.push(Importing::PostureOutside {
            joints: List(outside),
        });
    }
    for (number, leg) in (1..).zip(legs) {
        let what = Importing::Leg {
            number,
            joint: printed(leg.name()),
            link: printed(&leg.end.to_string()),
        };
        report.push(what.clone());
        report.extend(leg.remark.clone());
        let initial = postures.next();
        let table = leg_table(leg, initial, found.reach(), &mut report);
        let _ = write!(text, "\n[[leg]] # {what}\n{table}");
    }
    body(&mut text, found, &mut report);
    slider(&mut text, found.slider.as_ref(), &mut report);
    report.extend(rigid_links::dropped(legs, found.base, found.walks));
    report.extend(placeholders(legs, found.base, found.reach()));
    let joints = legs.iter().flat_map(|leg| &leg.joints);
    let velocities: Vec<f64> = joints
        .filter_map(|turning| turning.joint.limit.velocity)
        .collect();
    let sound = velocities.iter().copied();
    let slowest = sound
        .filter(|velocity| !is_placeholder_velocity(*velocity))
        .fold(f64::INFINITY, f64::min);
    let omega_max = match found.omega_max {
        Some(stated) => Some(stated),
        None if slowest.is_finite() => {
            report.push(Importing::OmegaMax);
            Some(slowest.to_degrees())
        }
        None => None,
    };
    if let Some(omega_max) = omega_max {
        let _ = write!(text, "\n[standards]\nomega_max = {}\n", measure(omega_max));
    } else if velocities.is_empty() {
        report.push(Importing::NoVelocity);
    }
    (text, report)
}

fn leg_table(
    leg: &Chain<'_>,
    initial: Option<&[f64]>,
    reach: f64,
    report: &mut Vec<Importing>,
) -> String {
    let base = leg.joints.first().map_or([0.0; 3], |first| first.at);
    let mut text = format!("base = {}\n", vector(base.map(place)));
    if let Some(angles) = initial {
        let joints = leg.joints.iter().map(|turning| turning.joint);
        let angles = joints.zip(angles).map(|(joint, angle)| {
            let [min, max] = ends(joint);
            measure(*angle).clamp(min, max)
        });
        let angles: Vec<f64> = angles.collect();
        let _ = writeln!(text, "initial = {angles:?}");
    }
    text.push_str("joint = [\n");
    let behind = leg.joints.iter().skip(1).map(|next| next.at);
    for (turning, next) in leg.joints.iter().zip(behind.chain([leg.foot])) {
        let link = [0, 1, 2].map(|i| place(next[i] - turning.at[i]));
        let _ = writeln!(
            text,
            "    {{ axis = {}, link = {}{} }}, # {}",
            vector(direction(turning.axis)),
            vector(link),
            settings(turning, reach, report),
            printed(&turning.joint.name)
        );
    }
    text + "]\n"
}

/// Formats limits, mass, torque and shapes of a joint, as far as the file has them.
fn settings(turning: &ChainJoint<'_>, reach: f64, report: &mut Vec<Importing>) -> String {
    let joint = turning.joint;
    let mut text = String::new();
    if let Some(ends) = stated_limits(joint) {
        let ends = ends.map(|end| measure(end.to_degrees()));
        let _ = write!(text, ", limits = [{}, {}]", ends[0], ends[1]);
    }
    let _ = write!(
        text,
        ", mass = {}",
        to(1e12, rigid_links::mass(&turning.links))
    );
    if let Some(weight) = rigid_links::weight(&turning.links, turning.at, reach) {
        for (key, value) in weight_of(&weight) {
            let _ = write!(text, ", {key} = {value}");
        }
    }
    if let Some(effort) = stated_effort(joint) {
        let _ = write!(text, ", torque = {}", measure(effort));
    }
    let shapes = rigid_links::shapes(&turning.links, turning.at);
    if !shapes.is_empty() {
        let _ = write!(text, ", shape = {}", shapes_of(&shapes));
    }
    if !turning.merged.is_empty() {
        let merged: Vec<String> = turning.merged.iter().map(|link| printed(link)).collect();
        report.push(Importing::TookIn {
            link: printed(&joint.child),
            merged: List(merged),
        });
    }
    text
}

/// Writes the body of a robot that can stand on its legs.
fn body(text: &mut String, found: &RobotParts<'_>, report: &mut Vec<Importing>) {
    if !found.walks {
        report.push(Importing::BoltedDown);
        return;
    }
    let shapes = rigid_links::shapes(found.base, [0.0; 3]);
    let (extents, said, flat) = match (found.extents, rigid_links::shape_extents(&shapes)) {
        (Some(extents), _) => (extents, Importing::BodyOfBox, vec![]),
        (None, Some(extents)) => (extents, Importing::BodyOfShapes, vec![]),
        (None, None) => {
            let (extents, flat) = around(found.legs);
            (extents, Importing::Walks, flat)
        }
    };
    report.push(said);
    if !flat.is_empty() {
        report.push(Importing::ThickBody { axes: List(flat) });
    }
    text.push_str("\n[body]\n");
    for (axis, range) in ["x", "y", "z"].into_iter().zip(extents) {
        let _ = writeln!(text, "{axis} = {}", interval(range));
    }
    let mass = rigid_links::mass(found.base);
    if mass > 0.0 {
        let _ = writeln!(text, "mass = {}", to(1e12, mass));
    } else {
        report.push(Importing::BodyMass);
    }
    if let Some(weight) = rigid_links::weight(found.base, [0.0; 3], found.reach()) {
        for (key, value) in weight_of(&weight) {
            let _ = writeln!(text, "{key} = {value}");
        }
    }
    if !shapes.is_empty() {
        let _ = writeln!(text, "shape = {}", shapes_of(&shapes));
    }
}

/// Formats shapes as a list of tables.
fn shapes_of(shapes: &[Shape]) -> String {
    let tables: Vec<String> = shapes.iter().map(shape_of).collect();
    format!("[{}]", tables.join(", "))
}

fn shape_of(shape: &Shape) -> String {
    let mut text = match shape.form {
        Form::Block(sides) => format!("block = {}", vector(sides.map(place))),
        Form::Cylinder { radius, length } => {
            format!("cylinder = [{}, {}]", place(radius), place(length))
        }
        Form::Sphere { radius } => format!("sphere = {}", place(radius)),
    };
    let at = shape.at.map(place);
    // Rounding errors are removed from rotations as well.
    let turned = rpy_of_axes(shape.axes).map(|turn| place(turn.to_degrees()));
    for (key, value) in [("at", at), ("turned", turned)] {
        if value != [0.0; 3] {
            let _ = write!(text, ", {key} = {}", vector(value));
        }
    }
    format!("{{ {text} }}")
}

/// Returns the keys of a centre of mass and of a tensor, if it is known, with their values.
fn weight_of(weight: &Weight) -> impl Iterator<Item = (&'static str, String)> {
    let inertia = weight.inertia.map(|elements| {
        let elements = elements.map(|element| element.to_string());
        ("inertia", format!("[{}]", elements.join(", ")))
    });
    [("centre", vector(weight.centre.map(place)))]
        .into_iter()
        .chain(inertia)
}

/// Returns a box around the first joints, and those of the axes x and y along which these have no
/// extent.
fn around(legs: &[Chain<'_>]) -> ([Range; 3], Vec<String>) {
    let hips = chains::hips(legs);
    let mut flat = Vec::new();
    let [x, y, z] = ["x", "y", "z"];
    let extents = [(0, x), (1, y), (2, z)].map(|(axis, name)| {
        let range = hips[axis];
        let is_flat = chains::is_flat(&hips, axis);
        if is_flat && name != z {
            flat.push(name.to_owned());
        }
        let more = if is_flat || name == z {
            HALF_HEIGHT
        } else {
            0.0
        };
        Range::new(range.min - more, range.max + more)
    });
    (extents, flat)
}

fn slider(text: &mut String, slider: Option<&Slider>, report: &mut Vec<Importing>) {
    let Some(slider) = slider else {
        return;
    };
    report.push(Importing::Slider);
    let initial = vector(slider.initial.map(measure));
    let _ = write!(text, "\n[slider]\ninitial = {initial}\n");
    for (axis, range) in ["x", "y", "z"].into_iter().zip(slider.travel) {
        if range.min < range.max {
            let _ = writeln!(text, "{axis} = {}", interval(range));
        }
    }
}

fn interval(range: Range) -> String {
    format!("[{}, {}]", measure(range.min), measure(range.max))
}

/// Rounds a length (mm) so that noise goes but collinear points stay collinear, as closed forms
/// require.
fn place(value: f64) -> f64 {
    to(1e9, value)
}

/// Normalises a vector and rounds it to the twelfth digit.
fn direction(axis: [f64; 3]) -> [f64; 3] {
    let length = axis.iter().map(|part| part * part).sum::<f64>().sqrt();
    axis.map(|part| to(1e12, part / length))
}

fn vector([x, y, z]: [f64; 3]) -> String {
    format!("[{x}, {y}, {z}]")
}

/// Returns the robot's name with blanks for characters that are not allowed.
fn robot_name(name: &str) -> String {
    let allowed = |c: char| c.is_alphanumeric() || " -_.".contains(c);
    let name: String = name
        .chars()
        .map(|c| if allowed(c) { c } else { ' ' })
        .collect();
    let name: String = name.trim().chars().take(MAX_NAME_CHARS).collect();
    match name.trim() {
        "" => "robot".to_owned(),
        known if Robot::from_name(known).is_some() => format!("{known} robot"),
        name => name.to_owned(),
    }
}

/// Torque above which an effort means a motor without limit, N·m.
const STRONGEST: f64 = 1e5;
/// Torque that is more than any leg's motor has, N·m.
const STRONG: f64 = 1e3;
/// Speed that is more than any joint has, rad/s.
const FAST: f64 = 1e3;
/// Half a turn in files, such as 3.14, rad.
const HALF_TURN: f64 = PI - 2e-3;

/// The form in which a file states the limits of a joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stated {
    Nothing,
    /// Limits of a continuous joint, which have no meaning.
    Unheeded,
    Infinite,
    /// One end; the other one is infinite or missing.
    OneEnd,
    Swapped,
    Locked,
    BothEnds,
}

/// Returns the limits of a joint (rad), unless it turns all round, and their form in the file.
fn limits(joint: &Joint) -> (Option<[f64; 2]>, Stated) {
    let limit = &joint.limit;
    // An end that is not stated is at 0 before 1.2, if that leaves the joint some room.
    let other = |leaves_room: bool| match leaves_room {
        true => limit.unstated,
        false => f64::INFINITY,
    };
    let [lower, upper] = match (limit.lower, limit.upper) {
        (None, None) => return (None, Stated::Nothing),
        _ if joint.kind == JointType::Continuous => return (None, Stated::Unheeded),
        (Some(lower), Some(upper)) => [lower, upper],
        (Some(lower), None) => [lower, other(lower < 0.0)],
        (None, Some(upper)) => [-other(upper > 0.0), upper],
    };
    let [from, to] = [lower.min(upper), lower.max(upper)];
    let turn = |ends, stated| {
        let stated = match lower > upper {
            true => Stated::Swapped,
            false => stated,
        };
        (Some(ends), stated)
    };
    let both_stated = limit.lower.is_some() && limit.upper.is_some();
    match [from, to].map(f64::is_finite) {
        [false, false] => (None, Stated::Infinite),
        // The other end is half a turn off 0, or a whole turn off this one.
        [true, false] if from < PI => turn([from, PI], Stated::OneEnd),
        [true, false] => turn([from, from + TAU], Stated::OneEnd),
        [false, true] if to > -PI => turn([-PI, to], Stated::OneEnd),
        [false, true] => turn([to - TAU, to], Stated::OneEnd),
        [true, true] if from == to => turn([from, to], Stated::Locked),
        [true, true] if both_stated => turn([from, to], Stated::BothEnds),
        [true, true] => turn([from, to], Stated::OneEnd),
    }
}

/// Returns the limits of a joint that has some, rad.
fn stated_limits(joint: &Joint) -> Option<[f64; 2]> {
    limits(joint).0
}

/// Returns the ends between which a joint turns, deg, in order.
fn ends(joint: &Joint) -> [f64; 2] {
    let ends = stated_limits(joint).map(|ends| ends.map(|end| measure(end.to_degrees())));
    ends.filter(|[min, max]| min <= max)
        .unwrap_or([-180.0, 180.0])
}

/// Formats a joint and its resulting limits, deg.
fn limited(joint: &Joint) -> String {
    let name = printed(&joint.name);
    match stated_limits(joint) {
        Some(ends) => {
            let [from, to] = ends.map(|end| measure(end.to_degrees()));
            format!("{name} [{from}, {to}]")
        }
        None => name,
    }
}

/// Returns the torque of a joint that has one, N·m.
fn stated_effort(joint: &Joint) -> Option<f64> {
    let effort = joint.limit.effort;
    (effort > 0.0 && effort <= STRONGEST).then_some(effort)
}

/// Returns true if a velocity is a placeholder: 0, or more than any joint has.
fn is_placeholder_velocity(velocity: f64) -> bool {
    !(velocity > 0.0 && velocity < FAST)
}

/// Reports placeholders and assumptions, a line for each kind. No link is larger than `reach` (mm).
fn placeholders(legs: &[Chain<'_>], base: &[(&Link, Transform)], reach: f64) -> Vec<Importing> {
    let joints = |is: fn(&ChainJoint<'_>) -> bool| {
        let all = legs.iter().flat_map(|leg| &leg.joints);
        listed(all.filter(|turning| is(turning)).map(|it| &it.joint.name))
    };
    let links = |is: &dyn Fn(&Link) -> bool| {
        let all = legs.iter().flat_map(|leg| &leg.joints);
        let all = base.iter().chain(all.flat_map(|turning| &turning.links));
        listed(all.filter(|(link, _)| is(link)).map(|(link, _)| &link.name))
    };
    let stating = |stated: Stated| {
        let all = legs.iter().flat_map(|leg| &leg.joints);
        let those = all.filter(|it| limits(it.joint).1 == stated);
        let names: Vec<String> = those.map(|it| limited(it.joint)).collect();
        (!names.is_empty()).then_some(List(names))
    };
    [
        stating(Stated::Nothing).map(|joints| Importing::TurnsAllRound { joints }),
        stating(Stated::Unheeded).map(|joints| Importing::LimitsOfContinuous { joints }),
        stating(Stated::Infinite).map(|joints| Importing::InfiniteLimits { joints }),
        stating(Stated::OneEnd).map(|joints| Importing::OpenLimits { joints }),
        stating(Stated::Swapped).map(|joints| Importing::SwappedLimits { joints }),
        stating(Stated::Locked).map(|joints| Importing::LockedJoints { joints }),
        joints(|it| stated_effort(it.joint).is_none()).map(|joints| Importing::Motor { joints }),
        joints(|it| stated_limits(it.joint).is_some_and(is_turn))
            .map(|joints| Importing::DoubtfulLimits { joints }),
        joints(|it| stated_effort(it.joint).is_some_and(|effort| effort >= STRONG))
            .map(|joints| Importing::DoubtfulEffort { joints }),
        joints(|it| it.joint.limit.velocity.is_some_and(is_placeholder_velocity))
            .map(|joints| Importing::DoubtfulVelocity { joints }),
        joints(|it| rigid_links::mass(&it.links) <= 0.0).map(|joints| Importing::NoMass { joints }),
        links(&rigid_links::is_flat).map(|links| Importing::NoInertia { links }),
        links(&|link| rigid_links::is_doubtful(link, reach))
            .map(|links| Importing::DoubtfulInertia { links }),
    ]
    .into_iter()
    .flatten()
    .collect()
}

fn is_turn([lower, upper]: [f64; 2]) -> bool {
    lower <= -HALF_TURN && upper >= HALF_TURN
}

/// Rounds a measure to a millionth: conversions of units and frames leave noise beyond that.
fn measure(value: f64) -> f64 {
    to(1e6, value)
}

/// Rounds a value to `parts` of its unit.
fn to(parts: f64, value: f64) -> f64 {
    // Adding 0 makes of −0 a plain 0.
    (value * parts).round() / parts + 0.0
}
