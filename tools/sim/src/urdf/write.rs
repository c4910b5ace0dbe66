//! The description as text, and the report.

use super::chain::{self, Chain, Turning};
use super::collision;
use super::doubt;
use super::pose::{self, Pose};
use super::robot::Link;
use super::stand::Postures;
use super::values::{measure, printed, to};
use super::weight;
use crate::message::Importing;
use std::fmt::Write as _;
use tip_runtime::model::{Range, Slider, Spread};
use tipc::Robot;
use tipc::description::{Form, Shape};
use tipc::message::list::List;

/// The longest name of a robot, in characters.
const LONGEST: usize = 40;
/// How far the assumed body reaches above and below the first joints: mm.
const HALF_HEIGHT: f64 = 50.0;

/// What a file holds.
pub(super) struct Found<'a> {
    pub(super) name: &'a str,
    /// Whether it is a robot that can stand on its legs.
    pub(super) walks: bool,
    /// All that stays with the base.
    pub(super) base: &'a [(&'a Link, Pose)],
    /// Of the body, if it says: mm.
    pub(super) extents: Option<[Range; 3]>,
    pub(super) slider: Option<Slider>,
    pub(super) legs: &'a [Chain<'a>],
    pub(super) stands: Stands,
}

/// The initial posture.
pub(super) enum Stands {
    /// In the middle of the limits.
    Middle,
    /// With its feet so many mm below the robot frame, as it is asked to.
    AsAsked { height: f64, postures: Postures },
    /// Likewise, as it would not stay up in the middle of the limits.
    Assumed { height: f64, postures: Postures },
}

impl Found<'_> {
    /// How far any part of it is from the robot frame, at most: mm.
    fn reach(&self) -> f64 {
        self.legs.iter().map(Chain::reach).fold(0.0, f64::max)
    }
}

/// The text, and what was assumed or dropped.
pub(super) fn description(source_name: &str, found: &Found<'_>) -> (String, Vec<Importing>) {
    let legs = found.legs;
    let mut report = vec![
        Importing::Frames,
        Importing::Dropped,
        Importing::NoSensors,
        match &found.stands {
            Stands::AsAsked { height, .. } => Importing::Stands { height: *height },
            Stands::Assumed { height, .. } => Importing::StandsByItself { height: *height },
            Stands::Middle => Importing::InitialPosture,
        },
    ];
    let mut postures = match &found.stands {
        Stands::AsAsked { postures, .. } | Stands::Assumed { postures, .. } => postures.as_slice(),
        Stands::Middle => [].as_slice(),
    }
    .iter()
    .map(Vec::as_slice);
    let mut text = format!(
        "# From {} by `tip robot import`.\n# mm, deg, kg, N·m; x to the right, y forward, z up.\n\nname = \"{}\"\n",
        printed(source_name),
        robot_name(found.name)
    );
    for (number, leg) in (1..).zip(legs) {
        let what = Importing::Leg {
            number,
            joint: printed(leg.name()),
            link: printed(&leg.end.to_string()),
        };
        report.push(what.clone());
        let initial = postures.next();
        let table = leg_table(leg, initial, found.reach(), &mut report);
        let _ = write!(text, "\n[[leg]] # {what}\n{table}");
    }
    body(&mut text, found, &mut report);
    slider(&mut text, found.slider.as_ref(), &mut report);
    report.extend(collision::dropped(legs, found.base, found.walks));
    report.extend(doubt::of(legs, found.base, found.reach()));
    let joints = legs.iter().flat_map(|leg| &leg.joints);
    let velocities = joints.map(|turning| turning.joint.limit.velocity);
    let slowest = velocities
        .filter(|velocity| !doubt::is_no_velocity(*velocity))
        .fold(f64::INFINITY, f64::min);
    if slowest.is_finite() {
        report.push(Importing::OmegaMax);
        let _ = write!(
            text,
            "\n[standards]\nomega_max = {}\n",
            measure(slowest.to_degrees())
        );
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
        let angles: Vec<f64> = angles.iter().copied().map(measure).collect();
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

/// Limits, mass, torque and shapes of a joint, as far as the file knows them.
fn settings(turning: &Turning<'_>, reach: f64, report: &mut Vec<Importing>) -> String {
    let joint = turning.joint;
    let mut text = String::new();
    if let Some(ends) = doubt::ends(joint) {
        let ends = ends.map(|end| measure(end.to_degrees()));
        let _ = write!(text, ", limits = [{}, {}]", ends[0], ends[1]);
    }
    let _ = write!(text, ", mass = {}", to(1e12, weight::mass(&turning.links)));
    if let Some(spread) = weight::spread(&turning.links, turning.at, reach) {
        let [centre, inertia] = spread_of(&spread);
        let _ = write!(text, ", centre = {centre}, inertia = {inertia}");
    }
    if let Some(effort) = doubt::effort(joint) {
        let _ = write!(text, ", torque = {}", measure(effort));
    }
    let shapes = collision::shapes(&turning.links, turning.at);
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

/// The body of a robot that can stand on its legs.
fn body(text: &mut String, found: &Found<'_>, report: &mut Vec<Importing>) {
    if !found.walks {
        report.push(Importing::BoltedDown);
        return;
    }
    let shapes = collision::shapes(found.base, [0.0; 3]);
    let (extents, said, flat) = match (found.extents, collision::extents(&shapes)) {
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
    let mass = weight::mass(found.base);
    if mass > 0.0 {
        let _ = writeln!(text, "mass = {}", to(1e12, mass));
    } else {
        report.push(Importing::BodyMass);
    }
    if let Some(spread) = weight::spread(found.base, [0.0; 3], found.reach()) {
        let [centre, inertia] = spread_of(&spread);
        let _ = writeln!(text, "centre = {centre}\ninertia = {inertia}");
    }
    if !shapes.is_empty() {
        let _ = writeln!(text, "shape = {}", shapes_of(&shapes));
    }
}

/// Shapes as a list of tables.
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
    // Turns have no dust either.
    let turned = pose::roll_pitch_yaw(shape.axes).map(|turn| place(turn.to_degrees()));
    for (key, value) in [("at", at), ("turned", turned)] {
        if value != [0.0; 3] {
            let _ = write!(text, ", {key} = {}", vector(value));
        }
    }
    format!("{{ {text} }}")
}

/// A centre of mass, and a tensor.
fn spread_of(spread: &Spread) -> [String; 2] {
    let inertia = spread.inertia.map(|element| element.to_string());
    [
        vector(spread.centre.map(place)),
        format!("[{}]", inertia.join(", ")),
    ]
}

/// A box around the first joints, and along which of x and y these leave it no size of its own.
fn around(legs: &[Chain<'_>]) -> ([Range; 3], Vec<String>) {
    let hips = chain::hips(legs);
    let mut flat = Vec::new();
    let [x, y, z] = ["x", "y", "z"];
    let extents = [(0, x), (1, y), (2, z)].map(|(axis, name)| {
        let range = hips[axis];
        let is_flat = chain::is_flat(&hips, axis);
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

/// A length (mm) without that dust, and fine enough for what lies in one line to stay there: closed forms ask for that.
fn place(value: f64) -> f64 {
    to(1e9, value)
}

/// A unit vector, to the twelfth digit.
fn direction(axis: [f64; 3]) -> [f64; 3] {
    let length = axis.iter().map(|part| part * part).sum::<f64>().sqrt();
    axis.map(|part| to(1e12, part / length))
}

fn vector([x, y, z]: [f64; 3]) -> String {
    format!("[{x}, {y}, {z}]")
}

/// The robot's name with blanks for characters that are not allowed.
fn robot_name(name: &str) -> String {
    let allowed = |c: char| c.is_alphanumeric() || " -_.".contains(c);
    let name: String = name
        .chars()
        .map(|c| if allowed(c) { c } else { ' ' })
        .collect();
    let name: String = name.trim().chars().take(LONGEST).collect();
    match name.trim() {
        "" => "robot".to_owned(),
        known if Robot::from_name(known).is_some() => format!("{known} robot"),
        name => name.to_owned(),
    }
}
