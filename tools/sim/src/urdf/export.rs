//! Export of robots as URDF text.

use super::frame::{self, BASE, BODY, FLOOR, WORLD, length, rpy_of_axes};
use super::xml;
use crate::model::{Limb, RobotDescription};
use crate::robot::Robot;
use std::fmt::Write as _;
use tip_runtime::model::{Body, InertialProperties, Inverse, Joint, Point, Range, Slider};
use tipc::description::{Form, Shape, Shapes};

/// Radius of a drawn joint, relative to its link.
const KNUCKLE: f64 = 1.3;
/// Speed of the slider of a simulated hand, m/s.
const SLIDER_SPEED: f64 = 1.0;
/// Effort of the slider, which the model does not give, N.
const SLIDER_EFFORT: f64 = 100.0;
/// Thickness of the drawn slider's plate, mm.
const PLATE: f64 = 5.0;

const HEAD: &str = r#"<?xml version="1.0" encoding="utf-8"?>
<!-- Made by `tip robot export`. m, rad, kg, N·m; x forward, y left, z up (REP 103).
     J11 to Jnm are the joints of the language, with its signs and zeros; link11 to linknm what they carry; F1 to Fn the feet
     or fingertips. While all joints are at 0 all frames are parallel to base_link, the robot frame.
     Thickness of links and looks are assumed where no shapes are given; a mass of which no more is said is spread evenly along
     its link. -->
"#;

/// Returns a robot as URDF: its frames, limits, masses, inertias and shapes; links without shapes
/// are drawn by cylinders and spheres. A robot that walks has `base_link` as its root; one that is
/// bolted down hangs on the link `world`.
///
/// ```
/// use tip_sim::{Robot, urdf};
///
/// let text = urdf::export(&Robot::named("hand")?);
/// assert!(text.contains("<joint name=\"J11\" type=\"revolute\">"));
/// assert!(text.contains("<joint name=\"floor_y\" type=\"prismatic\">"), "its slider");
/// # Ok::<(), tip_sim::UnknownRobot>(())
/// ```
#[must_use]
pub fn export(robot: &Robot) -> String {
    let (description, shapes) = (robot.description(), robot.shapes());
    let mut writer = Writer {
        text: HEAD.to_owned(),
        thickness: frame::thickness(&description.legs),
        speed: description.standards.omega_max.to_radians(),
    };
    writer.line(&format!("<robot name=\"{}\">", xml::escaped(robot.name())));
    writer.line("<material name=\"body\"><color rgba=\"0.35 0.4 0.45 1\"/></material>");
    writer.line("<material name=\"limb\"><color rgba=\"0.9 0.55 0.15 1\"/></material>");
    match &description.body {
        Some(body) => writer.walking(body, &shapes.body),
        None => writer.bolted_down(&description),
    }
    for (number, leg) in (1..).zip(&description.legs) {
        writer.leg(number, leg, shapes);
    }
    if let Some(slider) = &description.slider {
        writer.slider(slider, &description);
    }
    writer.line("</robot>");
    writer.text
}

struct Writer {
    text: String,
    /// Radius of drawn links, mm.
    thickness: f64,
    /// Speed limit of every joint, rad/s.
    speed: f64,
}

/// A joint of the file.
struct JointElement<'a> {
    name: &'a str,
    parent: &'a str,
    child: &'a str,
    /// Position in the frame of its parent, mm.
    at: Point,
}

impl Writer {
    fn line(&mut self, line: &str) {
        self.text.push_str(line);
        self.text.push('\n');
    }

    fn link(&mut self, name: &str, element: &LinkElement) {
        self.text.push_str(&element.link(name));
    }

    fn joint(&mut self, element: &JointElement<'_>, kind: &str, turned: [f64; 3], rest: &str) {
        let JointElement {
            name,
            parent,
            child,
            at,
        } = element;
        let (at, rpy) = (xml::vector(frame::metres(*at)), xml::vector(turned));
        self.line(&format!(
            "<joint name=\"{name}\" type=\"{kind}\">\n  \
             <parent link=\"{parent}\"/><child link=\"{child}\"/>\n  \
             <origin xyz=\"{at}\" rpy=\"{rpy}\"/>{rest}\n</joint>"
        ));
    }

    fn fixed(&mut self, element: &JointElement<'_>) {
        self.joint(element, "fixed", [0.0; 3], "");
    }

    /// Writes a base with a body that the legs carry. The visual is its box, which is the geometry
    /// of the plants and gives `import` its extents; the collision elements are its shapes.
    fn walking(&mut self, body: &Body, shapes: &[Shape]) {
        self.link(BASE, &LinkElement::default());
        let ranges = [body.x, body.y, body.z];
        let whole = block(ranges);
        let element = LinkElement {
            mass: body.mass,
            inertial: Some(
                body.inertial
                    .unwrap_or(InertialProperties::block(ranges, body.mass)),
            ),
            even: None,
            visual: vec![(whole, "body")],
            collision: match shapes {
                [] => vec![whole],
                shapes => shapes.to_vec(),
            },
        };
        self.link(BODY, &element);
        self.fixed(&JointElement {
            name: "body_fixed",
            parent: BASE,
            child: BODY,
            at: [0.0; 3],
        });
    }

    /// Writes a base that is bolted down, drawn as a plate through the first joints.
    fn bolted_down(&mut self, description: &RobotDescription) {
        self.link(WORLD, &LinkElement::default());
        let around = frame::around(&description.legs, self.thickness);
        self.link(BASE, &plate(around));
        let turned = frame::standing(description.inverse == Inverse::Planar);
        let element = JointElement {
            name: "base_fixed",
            parent: WORLD,
            child: BASE,
            at: [0.0; 3],
        };
        self.joint(&element, "fixed", turned, "");
    }

    fn leg(&mut self, number: u8, leg: &Limb, shapes: &Shapes) {
        let (mut parent, mut at) = (BASE.to_owned(), leg.base);
        for (joint, of) in (1..).zip(&leg.joints) {
            let child = frame::link(number, joint);
            self.link(&child, &self.limb(of, shapes.of(number, joint)));
            let element = JointElement {
                name: &frame::joint(number, joint),
                parent: &parent,
                child: &child,
                at,
            };
            let rest = format!(
                "\n  <axis xyz=\"{}\"/>\n  <limit lower=\"{}\" upper=\"{}\" effort=\"{}\" velocity=\"{}\"/>",
                xml::vector(frame::direction(of.axis)),
                of.limits.min.to_radians(),
                of.limits.max.to_radians(),
                of.torque,
                self.speed
            );
            self.joint(&element, "revolute", [0.0; 3], &rest);
            (parent, at) = (child, of.link);
        }
        let foot = frame::foot(number);
        self.link(&foot, &LinkElement::default());
        self.fixed(&JointElement {
            name: &format!("{foot}_fixed"),
            parent: &parent,
            child: &foot,
            at,
        });
    }

    /// Returns the link after a joint: its shapes, or a rod to the next joint.
    fn limb(&self, joint: &Joint, shapes: &[Shape]) -> LinkElement {
        let ball = ball(KNUCKLE * self.thickness);
        let rod = (length(joint.link) >= frame::MIN_SIZE).then(|| rod(joint.link, self.thickness));
        let visual: Vec<_> = match shapes {
            [] => {
                let rod = rod.map(|rod| (rod, "limb"));
                rod.into_iter().chain([(ball, "body")]).collect()
            }
            shapes => shapes.iter().map(|shape| (*shape, "limb")).collect(),
        };
        LinkElement {
            mass: joint.mass,
            inertial: joint.inertial,
            even: Some(rod.unwrap_or(ball)),
            collision: visual.iter().map(|(shape, _)| *shape).collect(),
            visual,
        }
    }

    /// Writes a joint for each axis along which the slider moves, and the plate that carries the
    /// floor. All joints are at 0 in the slider's initial position.
    fn slider(&mut self, slider: &Slider, description: &RobotDescription) {
        let (mut parent, mut at) = (BASE.to_owned(), slider.initial);
        for axis in frame::ways(slider) {
            let name = frame::carriage(axis);
            let child = format!("{name}_carriage");
            self.link(&child, &LinkElement::default());
            let mut along = [0.0; 3];
            along[axis] = 1.0;
            let rest = format!(
                "\n  <axis xyz=\"{}\"/>\n  <limit lower=\"{}\" upper=\"{}\" effort=\"{SLIDER_EFFORT}\" velocity=\"{SLIDER_SPEED}\"/>",
                xml::vector(frame::direction(along)),
                (slider.travel[axis].min - slider.initial[axis]) / 1000.0,
                (slider.travel[axis].max - slider.initial[axis]) / 1000.0,
            );
            let element = JointElement {
                name,
                parent: &parent,
                child: &child,
                at,
            };
            self.joint(&element, "prismatic", [0.0; 3], &rest);
            (parent, at) = (child, [0.0; 3]);
        }
        let up = if description.inverse == Inverse::Planar {
            1
        } else {
            2
        };
        let mut around = frame::around(&description.legs, 10.0 * self.thickness);
        // Its upper side is where the floor is, in its own frame.
        around[up].min = -PLATE;
        around[up].max = 0.0;
        self.link(FLOOR, &plate(around));
        self.fixed(&JointElement {
            name: "floor_fixed",
            parent: &parent,
            child: FLOOR,
            at,
        });
    }
}

/// Returns a plate with these extents (mm), without mass.
fn plate(ranges: [Range; 3]) -> LinkElement {
    let block = block(ranges);
    LinkElement {
        visual: vec![(block, "body")],
        collision: vec![block],
        ..LinkElement::default()
    }
}

/// A link of the file: mass, visuals and collision shapes.
#[derive(Default)]
pub(super) struct LinkElement {
    /// Mass, kg.
    pub(super) mass: f64,
    /// The inertia, unless the mass is uniform in `even`.
    pub(super) inertial: Option<InertialProperties>,
    pub(super) even: Option<Shape>,
    /// Visual shapes with their materials.
    pub(super) visual: Vec<(Shape, &'static str)>,
    pub(super) collision: Vec<Shape>,
}

impl LinkElement {
    /// Returns the element.
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

    /// Returns the content of `<inertial>`, if the link has mass.
    fn inertial(&self) -> Option<String> {
        let mass = Some(self.mass).filter(|mass| *mass > 0.0)?;
        let mass = mass.max(LEAST_MASS);
        let (origin, inertia) = match (&self.inertial, &self.even) {
            (Some(inertial), _) => (
                origin(inertial.centre, [0.0; 3]),
                frame::tensor(inertial.inertia),
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

/// Returns the origin and geometry of a shape.
fn placed(shape: &Shape) -> String {
    let origin = origin(shape.at, turned(shape));
    format!("{origin}<geometry>{}</geometry>", geometry(&shape.form))
}

/// Returns roll, pitch and yaw of a shape, rad. Its own x is to the right, that of URDF forward.
fn turned(shape: &Shape) -> [f64; 3] {
    let [right, forward, up] = shape.axes;
    let left = right.map(|part| -part);
    rpy_of_axes([forward, left, up].map(frame::direction))
}

/// Returns a block with these extents along x, y and z, mm.
pub(super) fn block(ranges: [Range; 3]) -> Shape {
    Shape {
        form: Form::Block(ranges.map(|range| range.max - range.min)),
        at: ranges.map(|range| (range.min + range.max) / 2.0),
        axes: UPRIGHT,
    }
}

/// Returns a ball around the origin, mm.
pub(super) fn ball(radius: f64) -> Shape {
    Shape {
        form: Form::Sphere { radius },
        at: [0.0; 3],
        axes: UPRIGHT,
    }
}

/// Returns a rod from the origin to the end of a vector, mm.
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
            let size = frame::metres(*sides).map(|side| side.abs().max(frame::MIN_SIZE / 1000.0));
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

/// Returns the moments of inertia of a mass (kg) about the form's axes in URDF, kg·m².
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

/// Least mass that is written for a link with mass, kg. Simulators refuse less.
const LEAST_MASS: f64 = 1e-9;
/// Least second moment of mass that is written for it, kg·m².
const LEAST_MOMENT: f64 = 1e-12;
/// Share of a tensor within which rounding may make it invalid.
const ROUNDING: f64 = 1e-9;

/// Returns xx, yy, zz, xy, xz and yz of a tensor of inertia that simulators load. The tensor of a body without thickness, or
/// with hardly any mass, grows by the same amount about every axis; any other one is unchanged.
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

/// Returns the moments of inertia of a rod (kg, m) across its axis and about it, kg·m².
pub(crate) fn rod_moments(mass: f64, length: f64, radius: f64) -> [f64; 2] {
    let across = mass * (3.0 * radius * radius + length * length) / 12.0;
    [across, mass * radius * radius / 2.0]
}
