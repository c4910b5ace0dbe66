//! What a link looks like, collides with and weighs.

use super::frame::{self, length};
use super::pose;
use super::xml;
use std::fmt::Write as _;
use tip_runtime::model::{Point, Range, Spread};
use tipc::description::{Form, Shape};

/// A link of the file.
#[derive(Default)]
pub(super) struct Solid {
    /// kg.
    pub(super) mass: f64,
    /// How the mass is spread, if not evenly in `even`.
    pub(super) spread: Option<Spread>,
    pub(super) even: Option<Shape>,
    /// What it looks like, and of which material.
    pub(super) visual: Vec<(Shape, &'static str)>,
    pub(super) collision: Vec<Shape>,
}

impl Solid {
    /// The element.
    pub(super) fn link(&self, name: &str) -> String {
        let inertial = self.inertial();
        if inertial.is_none() && self.visual.is_empty() && self.collision.is_empty() {
            return format!("<link name=\"{name}\"/>\n");
        }
        let mut text = format!("<link name=\"{name}\">\n");
        // Writing to a String cannot fail.
        if let Some(inside) = inertial {
            let _ = writeln!(text, "  <inertial>{inside}</inertial>");
        }
        for (shape, material) in &self.visual {
            let inside = placed(shape);
            let _ = writeln!(
                text,
                "  <visual>{inside}<material name=\"{material}\"/></visual>"
            );
        }
        for shape in &self.collision {
            let _ = writeln!(text, "  <collision>{}</collision>", placed(shape));
        }
        text + "</link>\n"
    }

    /// What is in the element of that name, if it weighs something.
    fn inertial(&self) -> Option<String> {
        let mass = Some(self.mass).filter(|mass| *mass > 0.0)?;
        let mass = mass.max(LEAST_MASS);
        let (origin, inertia) = match (&self.spread, &self.even) {
            (Some(spread), _) => (
                origin(spread.centre, [0.0; 3]),
                frame::tensor(spread.inertia),
            ),
            (None, Some(even)) => {
                let [x, y, z] = moments(&even.form, mass);
                let origin = origin(even.at, turned(even));
                (origin, [x, y, z, 0.0, 0.0, 0.0])
            }
            (None, None) => return None,
        };
        let [xx, yy, zz, xy, xz, yz] = loadable(inertia);
        Some(format!(
            "{origin}<mass value=\"{mass}\"/><inertia ixx=\"{xx}\" iyy=\"{yy}\" izz=\"{zz}\" ixy=\"{xy}\" ixz=\"{xz}\" iyz=\"{yz}\"/>"
        ))
    }
}

fn origin(at: Point, turned: [f64; 3]) -> String {
    let (at, turned) = (xml::vector(frame::metres(at)), xml::vector(turned));
    format!("<origin xyz=\"{at}\" rpy=\"{turned}\"/>")
}

/// Where a shape is, and what it is.
fn placed(shape: &Shape) -> String {
    let origin = origin(shape.at, turned(shape));
    format!("{origin}<geometry>{}</geometry>", geometry(&shape.form))
}

/// Its roll, pitch and yaw: rad. Its own x is to the right, that of URDF forward.
fn turned(shape: &Shape) -> [f64; 3] {
    let [right, forward, up] = shape.axes;
    let left = right.map(|part| -part);
    pose::roll_pitch_yaw([forward, left, up].map(frame::direction))
}

/// A block with these extents along x, y and z: mm.
pub(super) fn block(ranges: [Range; 3]) -> Shape {
    Shape {
        form: Form::Block(ranges.map(|range| range.max - range.min)),
        at: ranges.map(|range| (range.min + range.max) / 2.0),
        axes: UPRIGHT,
    }
}

/// A ball around the origin: mm.
pub(super) fn ball(radius: f64) -> Shape {
    Shape {
        form: Form::Sphere { radius },
        at: [0.0; 3],
        axes: UPRIGHT,
    }
}

/// A rod from the origin to the end of a vector: mm.
pub(super) fn rod(along: [f64; 3], radius: f64) -> Shape {
    let length = length(along);
    let [x, y, z] = along;
    let level = (x * x + y * y).sqrt();
    let forward = match level > 0.0 {
        true => [x / level, y / level],
        false => [0.0, 1.0],
    };
    // Its own x stays level.
    let [sin, cos] = [level / length, z / length];
    Shape {
        form: Form::Cylinder { radius, length },
        at: along.map(|part| part / 2.0),
        axes: [
            [forward[1], -forward[0], 0.0],
            [forward[0] * cos, forward[1] * cos, -sin],
            [forward[0] * sin, forward[1] * sin, cos],
        ],
    }
}

const UPRIGHT: [Point; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

fn geometry(form: &Form) -> String {
    match form {
        Form::Block(sides) => {
            // Sizes have no sign.
            let size = frame::metres(*sides).map(|side| side.abs().max(frame::LEAST / 1000.0));
            format!("<box size=\"{}\"/>", xml::vector(size))
        }
        Form::Sphere { radius } => format!("<sphere radius=\"{}\"/>", radius / 1000.0),
        Form::Cylinder { radius, length } => format!(
            "<cylinder radius=\"{}\" length=\"{}\"/>",
            radius / 1000.0,
            length / 1000.0
        ),
    }
}

/// The moments of inertia of a mass (kg) about the form's axes in URDF: kg·m².
fn moments(form: &Form, mass: f64) -> [f64; 3] {
    match form {
        Form::Block(sides) => {
            let [xx, yy, zz] = frame::metres(*sides).map(|side| side * side);
            [yy + zz, xx + zz, xx + yy].map(|squares| mass * squares / 12.0)
        }
        Form::Sphere { radius } => [0.4 * mass * (radius / 1000.0) * (radius / 1000.0); 3],
        Form::Cylinder { radius, length } => {
            let [across, along] = rod_moments(mass, length / 1000.0, radius / 1000.0);
            [across, across, along]
        }
    }
}

/// The least mass that is written of what weighs something: kg. Simulators refuse less.
const LEAST_MASS: f64 = 1e-9;
/// The least second moment of mass that is written of it: kg·m².
const LEAST_MOMENT: f64 = 1e-12;
/// The share of a tensor within which rounding may make it that of no body.
const ROUNDING: f64 = 1e-9;

/// Returns xx, yy, zz, xy, xz and yz of a tensor of inertia that simulators load. That of a body without thickness, or with hardly
/// any mass, grows by the same amount about every axis; any other one stays as it is.
pub(crate) fn loadable(tensor: [f64; 6]) -> [f64; 6] {
    let [xx, yy, zz, xy, xz, yz] = tensor;
    let half = (xx + yy + zz) / 2.0;
    let least = LEAST_MOMENT + ROUNDING * half;
    // Second moments of mass above `least` in every direction: the leading minors are positive.
    let [x, y, z] = [xx, yy, zz].map(|moment| half - moment - least);
    let (a, b, c) = (-xy, -xz, -yz);
    let minors = [
        x,
        x * y - a * a,
        x * (y * z - c * c) - a * (a * z - b * c) + b * (a * c - b * y),
    ];
    if minors.into_iter().all(|minor| minor > 0.0) {
        return tensor;
    }
    let more = 2.0 * LEAST_MOMENT + 20.0 * ROUNDING * half;
    [xx + more, yy + more, zz + more, xy, xz, yz]
}

/// The moments of inertia of a rod (kg, m) across it and about itself: kg·m².
pub(crate) fn rod_moments(mass: f64, length: f64, radius: f64) -> [f64; 2] {
    let across = mass * (3.0 * radius * radius + length * length) / 12.0;
    [across, mass * radius * radius / 2.0]
}
