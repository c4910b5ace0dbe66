//! A robot as URDF text.

use super::frame::{self, BASE, BODY, FLOOR, WORLD, length};
use super::shape::{self, Solid};
use super::xml;
use crate::model::{Anatomy, Limb};
use crate::robot::Robot;
use tip_runtime::model::{Body, Inverse, Joint, Point, Range, Slider, Spread};
use tipc::description::{Shape, Shapes};

/// How much thicker a joint is drawn than its link.
const KNUCKLE: f64 = 1.3;
/// How fast the slider of a simulated hand goes: m/s.
const SLIDER_SPEED: f64 = 1.0;
/// The slider's effort, of which the model says nothing: N.
const SLIDER_EFFORT: f64 = 100.0;
/// How thick the slider's plate is drawn: mm.
const PLATE: f64 = 5.0;

const HEAD: &str = r#"<?xml version="1.0" encoding="utf-8"?>
<!-- Made by `tip robot export`. m, rad, kg, N·m; x forward, y left, z up (REP 103).
     J11 to Jnm are the joints of the language, with its signs and zeros; link11 to linknm what they carry; F1 to Fn the feet
     or fingertips. While all joints are at 0 all frames are parallel to base_link, the robot frame.
     Thickness of links and looks are assumed where no shapes are given; a mass of which no more is said is spread evenly along
     its link. -->
"#;

/// A robot as URDF: its frames, limits, masses, inertias and shapes; links without shapes are drawn by cylinders and spheres. A robot that walks has
/// `base_link` as its root; one that is bolted down hangs on the link `world`.
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
    let (anatomy, shapes) = (robot.anatomy(), robot.shapes());
    let mut writer = Writer {
        text: HEAD.to_owned(),
        thickness: frame::thickness(&anatomy.legs),
        speed: anatomy.standards.omega_max.to_radians(),
    };
    writer.line(&format!("<robot name=\"{}\">", xml::escaped(robot.name())));
    writer.line("<material name=\"body\"><color rgba=\"0.35 0.4 0.45 1\"/></material>");
    writer.line("<material name=\"limb\"><color rgba=\"0.9 0.55 0.15 1\"/></material>");
    match &anatomy.body {
        Some(body) => writer.walking(body, &shapes.body),
        None => writer.bolted_down(&anatomy),
    }
    for (number, leg) in (1..).zip(&anatomy.legs) {
        writer.leg(number, leg, shapes);
    }
    if let Some(slider) = &anatomy.slider {
        writer.slider(slider, &anatomy);
    }
    writer.line("</robot>");
    writer.text
}

struct Writer {
    text: String,
    /// mm.
    thickness: f64,
    /// Of every joint: rad/s.
    speed: f64,
}

/// A joint of the file.
struct Hinge<'a> {
    name: &'a str,
    parent: &'a str,
    child: &'a str,
    /// Where it is in the frame of its parent: mm.
    at: Point,
}

impl Writer {
    fn line(&mut self, line: &str) {
        self.text.push_str(line);
        self.text.push('\n');
    }

    fn link(&mut self, name: &str, solid: &Solid) {
        self.text.push_str(&solid.link(name));
    }

    fn joint(&mut self, hinge: &Hinge<'_>, kind: &str, turned: [f64; 3], rest: &str) {
        let Hinge {
            name,
            parent,
            child,
            at,
        } = hinge;
        let (at, rpy) = (xml::vector(frame::metres(*at)), xml::vector(turned));
        self.line(&format!(
            "<joint name=\"{name}\" type=\"{kind}\">\n  \
             <parent link=\"{parent}\"/><child link=\"{child}\"/>\n  \
             <origin xyz=\"{at}\" rpy=\"{rpy}\"/>{rest}\n</joint>"
        ));
    }

    fn fixed(&mut self, hinge: &Hinge<'_>) {
        self.joint(hinge, "fixed", [0.0; 3], "");
    }

    /// A base with a body that the legs carry. It looks like its box, which is all that plants know of it and where `import` finds
    /// its extents, and collides with its shapes.
    fn walking(&mut self, body: &Body, shapes: &[Shape]) {
        self.link(BASE, &Solid::default());
        let ranges = [body.x, body.y, body.z];
        let whole = shape::block(ranges);
        let solid = Solid {
            mass: body.mass,
            spread: Some(body.spread.unwrap_or(Spread::block(ranges, body.mass))),
            even: None,
            visual: vec![(whole, "body")],
            collision: match shapes {
                [] => vec![whole],
                shapes => shapes.to_vec(),
            },
        };
        self.link(BODY, &solid);
        self.fixed(&Hinge {
            name: "body_fixed",
            parent: BASE,
            child: BODY,
            at: [0.0; 3],
        });
    }

    /// A base that stays where it is, drawn as a plate through the first joints.
    fn bolted_down(&mut self, anatomy: &Anatomy) {
        self.link(WORLD, &Solid::default());
        let around = frame::around(&anatomy.legs, self.thickness);
        self.link(BASE, &plate(around));
        let turned = frame::standing(anatomy.inverse == Inverse::Planar);
        let hinge = Hinge {
            name: "base_fixed",
            parent: WORLD,
            child: BASE,
            at: [0.0; 3],
        };
        self.joint(&hinge, "fixed", turned, "");
    }

    fn leg(&mut self, number: u8, leg: &Limb, shapes: &Shapes) {
        let (mut parent, mut at) = (BASE.to_owned(), leg.base);
        for (joint, of) in (1..).zip(&leg.joints) {
            let child = frame::link(number, joint);
            self.link(&child, &self.limb(of, shapes.of(number, joint)));
            let hinge = Hinge {
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
            self.joint(&hinge, "revolute", [0.0; 3], &rest);
            (parent, at) = (child, of.link);
        }
        let foot = frame::foot(number);
        self.link(&foot, &Solid::default());
        self.fixed(&Hinge {
            name: &format!("{foot}_fixed"),
            parent: &parent,
            child: &foot,
            at,
        });
    }

    /// What a joint carries: these shapes, or a rod to the next joint.
    fn limb(&self, joint: &Joint, shapes: &[Shape]) -> Solid {
        let ball = shape::ball(KNUCKLE * self.thickness);
        let rod =
            (length(joint.link) >= frame::LEAST).then(|| shape::rod(joint.link, self.thickness));
        let visual: Vec<_> = match shapes {
            [] => {
                let rod = rod.map(|rod| (rod, "limb"));
                rod.into_iter().chain([(ball, "body")]).collect()
            }
            shapes => shapes.iter().map(|shape| (*shape, "limb")).collect(),
        };
        Solid {
            mass: joint.mass,
            spread: joint.spread,
            even: Some(rod.unwrap_or(ball)),
            collision: visual.iter().map(|(shape, _)| *shape).collect(),
            visual,
        }
    }

    /// A joint for each axis along which the slider goes, and the plate that carries the floor. All of them are at 0 where the
    /// slider is at first.
    fn slider(&mut self, slider: &Slider, anatomy: &Anatomy) {
        let (mut parent, mut at) = (BASE.to_owned(), slider.initial);
        for axis in frame::ways(slider) {
            let name = frame::carriage(axis);
            let child = format!("{name}_carriage");
            self.link(&child, &Solid::default());
            let mut along = [0.0; 3];
            along[axis] = 1.0;
            let rest = format!(
                "\n  <axis xyz=\"{}\"/>\n  <limit lower=\"{}\" upper=\"{}\" effort=\"{SLIDER_EFFORT}\" velocity=\"{SLIDER_SPEED}\"/>",
                xml::vector(frame::direction(along)),
                (slider.travel[axis].min - slider.initial[axis]) / 1000.0,
                (slider.travel[axis].max - slider.initial[axis]) / 1000.0,
            );
            let hinge = Hinge {
                name,
                parent: &parent,
                child: &child,
                at,
            };
            self.joint(&hinge, "prismatic", [0.0; 3], &rest);
            (parent, at) = (child, [0.0; 3]);
        }
        let up = if anatomy.inverse == Inverse::Planar {
            1
        } else {
            2
        };
        let mut around = frame::around(&anatomy.legs, 10.0 * self.thickness);
        // Its upper side is where the floor is, in its own frame.
        around[up].min = -PLATE;
        around[up].max = 0.0;
        self.link(FLOOR, &plate(around));
        self.fixed(&Hinge {
            name: "floor_fixed",
            parent: &parent,
            child: FLOOR,
            at,
        });
    }
}

/// What has these extents (mm), and no mass.
fn plate(ranges: [Range; 3]) -> Solid {
    let block = shape::block(ranges);
    Solid {
        visual: vec![(block, "body")],
        collision: vec![block],
        ..Solid::default()
    }
}
