//! What a link looks like and weighs.

use super::frame::{self, length};
use super::xml;
use std::fmt::Write as _;
use tip_runtime::model::{Point, Range, Spread};

/// A link of the file.
#[derive(Default)]
pub(super) struct Solid {
    /// kg.
    pub(super) mass: f64,
    /// The first one has the mass.
    pub(super) shapes: Vec<Shape>,
    /// How the mass is spread, if not evenly in that shape.
    pub(super) spread: Option<Spread>,
}

/// A body of even density.
pub(super) struct Shape {
    kind: Kind,
    /// Its middle: mm.
    at: Point,
    material: &'static str,
}

/// Lengths in mm.
enum Kind {
    /// Along each axis of the robot frame.
    Block([f64; 3]),
    Ball {
        radius: f64,
    },
    Rod {
        along: [f64; 3],
        radius: f64,
    },
}

impl Solid {
    /// The element.
    pub(super) fn link(&self, name: &str) -> String {
        if self.shapes.is_empty() {
            return format!("<link name=\"{name}\"/>\n");
        }
        let mut text = format!("<link name=\"{name}\">\n");
        // Writing to a String cannot fail.
        if let (Some(first), true) = (self.shapes.first(), self.mass > 0.0) {
            let (origin, inertia) = match &self.spread {
                Some(spread) => (
                    origin(spread.centre, [0.0; 3]),
                    tensor(frame::tensor(spread.inertia)),
                ),
                None => {
                    let [x, y, z] = first.moments(self.mass);
                    let even = tensor([x, y, z, 0.0, 0.0, 0.0]);
                    (origin(first.at, first.turned()), even)
                }
            };
            let mass = self.mass;
            let _ = writeln!(
                text,
                "  <inertial>{origin}<mass value=\"{mass}\"/>{inertia}</inertial>"
            );
        }
        for shape in &self.shapes {
            let inside = format!(
                "{}<geometry>{}</geometry>",
                origin(shape.at, shape.turned()),
                shape.geometry()
            );
            let material = shape.material;
            let _ = write!(
                text,
                "  <visual>{inside}<material name=\"{material}\"/></visual>\n  <collision>{inside}</collision>\n"
            );
        }
        text + "</link>\n"
    }
}

fn origin(at: Point, turned: [f64; 3]) -> String {
    let (at, turned) = (xml::vector(frame::metres(at)), xml::vector(turned));
    format!("<origin xyz=\"{at}\" rpy=\"{turned}\"/>")
}

/// A tensor of inertia along the axes of the element's origin.
fn tensor([xx, yy, zz, xy, xz, yz]: [f64; 6]) -> String {
    format!(
        "<inertia ixx=\"{xx}\" ixy=\"{xy}\" ixz=\"{xz}\" iyy=\"{yy}\" iyz=\"{yz}\" izz=\"{zz}\"/>"
    )
}

impl Shape {
    /// A block with these extents along x, y and z: mm.
    pub(super) fn block(ranges: [Range; 3], material: &'static str) -> Self {
        Shape {
            kind: Kind::Block(ranges.map(|range| range.max - range.min)),
            at: ranges.map(|range| (range.min + range.max) / 2.0),
            material,
        }
    }

    /// A ball around the origin: mm.
    pub(super) fn ball(radius: f64, material: &'static str) -> Self {
        Shape {
            kind: Kind::Ball { radius },
            at: [0.0; 3],
            material,
        }
    }

    /// A rod from the origin to the end of a vector: mm.
    pub(super) fn rod(along: [f64; 3], radius: f64, material: &'static str) -> Self {
        Shape {
            kind: Kind::Rod { along, radius },
            at: along.map(|part| part / 2.0),
            material,
        }
    }

    /// Its roll, pitch and yaw: rad. A cylinder of URDF stands along z.
    fn turned(&self) -> [f64; 3] {
        match self.kind {
            Kind::Block(_) | Kind::Ball { .. } => [0.0; 3],
            Kind::Rod { along, .. } => {
                let [x, y, z] = frame::direction(along);
                let level = (x * x + y * y).sqrt();
                [0.0, libm::atan2(level, z), libm::atan2(y, x)]
            }
        }
    }

    fn geometry(&self) -> String {
        match self.kind {
            Kind::Block(size) => {
                // Sizes have no sign.
                let size = frame::metres(size).map(f64::abs);
                format!("<box size=\"{}\"/>", xml::vector(size))
            }
            Kind::Ball { radius } => format!("<sphere radius=\"{}\"/>", radius / 1000.0),
            Kind::Rod { along, radius } => format!(
                "<cylinder radius=\"{}\" length=\"{}\"/>",
                radius / 1000.0,
                length(frame::metres(along))
            ),
        }
    }

    /// The moments of inertia of a mass (kg) about its own axes: kg·m².
    fn moments(&self, mass: f64) -> [f64; 3] {
        match self.kind {
            Kind::Block(size) => {
                let [xx, yy, zz] = frame::metres(size).map(|side| side * side);
                [yy + zz, xx + zz, xx + yy].map(|squares| mass * squares / 12.0)
            }
            Kind::Ball { radius } => [0.4 * mass * (radius / 1000.0) * (radius / 1000.0); 3],
            Kind::Rod { along, radius } => {
                let [across, along] =
                    rod_moments(mass, length(frame::metres(along)), radius / 1000.0);
                [across, across, along]
            }
        }
    }
}

/// The moments of inertia of a rod (kg, m) across it and about itself: kg·m².
pub(crate) fn rod_moments(mass: f64, length: f64, radius: f64) -> [f64; 2] {
    let across = mass * (3.0 * radius * radius + length * length) / 12.0;
    [across, mass * radius * radius / 2.0]
}
