//! A URDF file as values: the elements that become part of a description, checked as they are read.
//! All other elements and attributes are ignored: simulators and ROS add their own.

use super::ImportError;
use super::transform::Transform;
use super::tree::{Geometry, Joint, JointLimit, JointType, Link, Piece, RobotFile};
use super::xml::{place, printed, start};
use crate::message::Importing;
use crate::message::Place;
use crate::urdf::frame::BODY;
use roxmltree::{Document, Node};
use std::collections::BTreeMap;
use tipc::message::list::List;

/// A version of URDF.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Version {
    major: u32,
    minor: u32,
}

impl Version {
    const V1_0: Self = Version { major: 1, minor: 0 };
    /// Adds `quat_xyzw` of `<origin>`.
    const V1_1: Self = Version { major: 1, minor: 1 };
    /// Makes missing values of `<limit>` infinite, and refuses impossible numbers.
    const V1_2: Self = Version { major: 1, minor: 2 };

    fn parse(text: &str) -> Option<Self> {
        let (major, minor) = text.trim().split_once('.')?;
        Some(Version {
            major: major.parse().ok()?,
            minor: minor.parse().ok()?,
        })
    }

    /// Returns the known version whose rules are applied.
    fn read_as(self) -> &'static str {
        match self {
            later if later >= Version::V1_2 => "1.2",
            Version::V1_1 => "1.1",
            _ => "1.0",
        }
    }
}

/// Reads a robot from a URDF file.
pub(super) fn robot(document: &Document<'_>) -> Result<RobotFile, ImportError> {
    let node = document.root_element();
    // A missing or malformed version is 1.0, as in urdfdom.
    let version = node.attribute("version").and_then(Version::parse);
    let version = version.unwrap_or(Version::V1_0);
    let links = elements(node, "link").map(|node| link(node, version));
    let links = links.collect::<Result<_, _>>()?;
    let joints = elements(node, "joint").map(|node| joint(node, version));
    let joints = joints.collect::<Result<_, _>>()?;
    check_unique_names(node)?;
    Ok(RobotFile {
        notes: notes(node, version),
        name: node.attribute("name").unwrap_or_default().to_owned(),
        links,
        joints,
        is_free: false,
        posture: None,
        forward: None,
        omega_max: None,
    })
}

/// Refuses two links or two joints of one name.
fn check_unique_names(robot: Node<'_, '_>) -> Result<(), ImportError> {
    for element in ["link", "joint"] {
        let mut known = BTreeMap::new();
        for node in elements(robot, element) {
            let name = node.attribute("name");
            let Some(first) = known.insert(name, node) else {
                continue;
            };
            let (name, first, second) = (
                name.unwrap_or_default().to_owned(),
                start(first),
                start(node),
            );
            return Err(ImportError::new(match element {
                "link" => Importing::LinkTwice {
                    link: name,
                    first,
                    second,
                },
                _ => Importing::JointTwice {
                    joint: name,
                    first,
                    second,
                },
            }));
        }
    }
    Ok(())
}

/// Returns remarks on an unknown version, and on quaternions that the version does not have.
fn notes(robot: Node<'_, '_>, version: Version) -> Vec<Importing> {
    let mut notes = Vec::new();
    let known = [Version::V1_0, Version::V1_1, Version::V1_2];
    let is_known =
        |text: &str| Version::parse(text).is_some_and(|version| known.contains(&version));
    if let Some(text) = robot.attribute("version").filter(|text| !is_known(text)) {
        notes.push(Importing::UnknownVersion {
            version: printed(text),
            read_as: version.read_as(),
        });
    }
    if version < Version::V1_1 {
        let own = ["link", "joint"]
            .into_iter()
            .flat_map(|name| elements(robot, name));
        let origins = own
            .flat_map(|node| node.descendants())
            .filter(|node| node.has_tag_name("origin"));
        let mut turned = origins.filter_map(|node| Some((node, node.attribute_node("quat_xyzw")?)));
        if let Some((node, first)) = turned.next() {
            notes.push(Importing::OldQuaternion {
                at: place(node, first.range().start),
                elements: 1 + turned.count(),
            });
        }
    }
    notes
}

fn link(node: Node<'_, '_>, version: Version) -> Result<Link, ImportError> {
    let name = Attribute::of(node, "name", "foot").required()?.to_owned();
    let mut link = Link {
        visuals: match name == BODY {
            true => pieces(node, "visual", version)?,
            false => Vec::new(),
        },
        collisions: pieces(node, "collision", version)?,
        name,
        tips: Vec::new(),
        mass: 0.0,
        centre: Transform::default(),
        inertia: [0.0; 6],
    };
    if let Some(inertial) = optional(node, "inertial")? {
        const INERTIA: &str =
            "<inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"1\"/>";
        link.centre = origin(inertial, version)?;
        let mass = required(inertial, "mass", "<mass value=\"1\"/>")?;
        link.mass = Attribute::of(mass, "value", "1").finite()?;
        let inertia = required(inertial, "inertia", INERTIA)?;
        let element = |name, example| Attribute::of(inertia, name, example).finite();
        link.inertia = [
            element("ixx", "1")?,
            element("iyy", "1")?,
            element("izz", "1")?,
            element("ixy", "0")?,
            element("ixz", "0")?,
            element("iyz", "0")?,
        ];
    }
    Ok(link)
}

/// Reads the geometries of a link in elements of a name.
fn pieces(
    link: Node<'_, '_>,
    name: &'static str,
    version: Version,
) -> Result<Vec<Piece>, ImportError> {
    let pieces = elements(link, name).map(|piece| {
        Ok(Piece {
            origin: origin(piece, version)?,
            geometry: geometry(piece, version)?,
        })
    });
    pieces.collect()
}

fn geometry(piece: Node<'_, '_>, version: Version) -> Result<Geometry, ImportError> {
    const EXAMPLE: &str = "<geometry><sphere radius=\"1\"/></geometry>";
    let shape = only_shape(required(piece, "geometry", EXAMPLE)?)?;
    let length = |name| {
        let attribute = Attribute::of(shape, name, "1");
        let length = number(attribute.required()?).ok_or_else(|| attribute.not_a_number())?;
        attribute.check_lengths(&[length], version)?;
        Ok(length)
    };
    Ok(match shape.tag_name().name() {
        "box" => {
            let attribute = Attribute::of(shape, "size", "1 1 1");
            let sides = vector(attribute.required()?).ok_or_else(|| attribute.not_numbers(3))?;
            attribute.check_lengths(&sides, version)?;
            Geometry::Box(sides)
        }
        "cylinder" => Geometry::Cylinder {
            radius: length("radius")?,
            length: length("length")?,
        },
        "capsule" => Geometry::Capsule {
            radius: length("radius")?,
            length: length("length")?,
        },
        "sphere" => Geometry::Sphere {
            radius: length("radius")?,
        },
        _ => Geometry::Mesh,
    })
}

/// Returns the single shape in a geometry.
fn only_shape<'a, 'i>(geometry: Node<'a, 'i>) -> Result<Node<'a, 'i>, ImportError> {
    let is_blank = |text: &str| text.trim().is_empty();
    let is_content = |one: &Node<'_, '_>| match one.is_text() {
        true => !one.text().is_none_or(is_blank),
        false => one.is_element(),
    };
    let mut inner = geometry.children().filter(is_content);
    let (first, second) = (inner.next(), inner.next());
    let is_known = |one: &Node<'_, '_>| {
        let mut known = Geometry::ELEMENTS.into_iter();
        known.any(|name| one.has_tag_name(name))
    };
    match (first, second) {
        (Some(first), None) if is_known(&first) => Ok(first),
        (first, second) => Err(ImportError::new(Importing::NotOneShape {
            at: start(second.or(first).unwrap_or(geometry)),
            element: geometry.tag_name().name().to_owned(),
            known: List(Geometry::ELEMENTS.map(str::to_owned).to_vec()),
        })),
    }
}

fn joint(node: Node<'_, '_>, version: Version) -> Result<Joint, ImportError> {
    let name = Attribute::of(node, "name", "knee").required()?.to_owned();
    let kind = Attribute::of(node, "type", "revolute");
    let word = kind.required()?;
    let kind = JointType::from_word(word).ok_or_else(|| {
        ImportError::new(Importing::NotAKindOfJoint {
            at: kind.at(),
            element: kind.element(),
            attribute: kind.name,
            value: word.to_owned(),
            known: List(JointType::WORDS.map(|(word, _)| word.to_owned()).to_vec()),
        })
    })?;
    let link = |element, example, link| {
        let node = required(node, element, example)?;
        Ok(Attribute::of(node, "link", link).required()?.to_owned())
    };
    let axis = optional(node, "axis")?.map(|axis| {
        let attribute = Attribute::of(axis, "xyz", "1 0 0");
        attribute.required()?;
        attribute.vector()
    });
    let mimic = optional(node, "mimic")?.map(|mimic| {
        let name = Attribute::of(mimic, "joint", "knee").required()?;
        Ok(name.to_owned())
    });
    Ok(Joint {
        name,
        kind,
        origin: origin(node, version)?,
        anchor: [0.0; 3],
        parent: link("parent", "<parent link=\"thigh\"/>", "thigh")?,
        child: link("child", "<child link=\"shank\"/>", "shank")?,
        axis: axis.transpose()?.flatten().unwrap_or([1.0, 0.0, 0.0]),
        limit: optional(node, "limit")?.map_or(Ok(NO_LIMIT), |node| limit(node, version))?,
        mimic: mimic.transpose()?,
    })
}

/// Reads the `<origin>` of an element, if it has one.
fn origin(node: Node<'_, '_>, version: Version) -> Result<Transform, ImportError> {
    let Some(node) = optional(node, "origin")? else {
        return Ok(Transform::default());
    };
    let xyz = Attribute::of(node, "xyz", "0 0 0").vector()?;
    let rpy = Attribute::of(node, "rpy", "0 0 0").vector()?;
    let mut origin = Transform::of_rpy(rpy.unwrap_or_default());
    let turn = Attribute::of(node, "quat_xyzw", "0 0 0 1");
    if let Some(text) = turn.text().filter(|_| version >= Version::V1_1) {
        let [x, y, z, w] = quaternion(text).ok_or_else(|| turn.not_numbers(4))?;
        if rpy.is_some() {
            return Err(ImportError::new(Importing::TwoTurns { at: start(node) }));
        }
        origin = Transform::of_quaternion([w, x, y, z]);
    }
    Ok(origin.moved(xyz.unwrap_or_default()))
}

/// The values of a joint without `<limit>`.
const NO_LIMIT: JointLimit = JointLimit {
    lower: None,
    upper: None,
    unstated: 0.0,
    effort: 0.0,
    velocity: Some(0.0),
};

/// Reads a `<limit>`. Missing values are 0 before 1.2 and infinite since.
fn limit(node: Node<'_, '_>, version: Version) -> Result<JointLimit, ImportError> {
    let is_1_2 = version >= Version::V1_2;
    let missing = if is_1_2 { f64::INFINITY } else { 0.0 };
    let most = |name, example| {
        let attribute = Attribute::of(node, name, example);
        let value = attribute.number()?;
        match value {
            Some(value) if is_1_2 && value < 0.0 => Err(attribute.negative()),
            value => Ok(value.unwrap_or(missing)),
        }
    };
    let velocity = Attribute::of(node, "velocity", "2");
    if !is_1_2 {
        velocity.required()?;
    }
    let limit = JointLimit {
        lower: Attribute::of(node, "lower", "-1").number()?,
        upper: Attribute::of(node, "upper", "1").number()?,
        unstated: missing,
        effort: most("effort", "5")?,
        velocity: Some(most("velocity", "2")?),
    };
    match (limit.lower, limit.upper) {
        (Some(lower), Some(upper)) if is_1_2 && upper < lower => {
            Err(ImportError::new(Importing::BoundsSwapped {
                at: start(node),
                lower,
                upper,
            }))
        }
        _ => Ok(limit),
    }
}

/// Iterates over the child elements of a name.
fn elements<'a, 'i>(node: Node<'a, 'i>, name: &'static str) -> impl Iterator<Item = Node<'a, 'i>> {
    node.children()
        .filter(move |child| child.has_tag_name(name))
}

/// Returns the only child element of a name, if there is one.
fn optional<'a, 'i>(
    node: Node<'a, 'i>,
    name: &'static str,
) -> Result<Option<Node<'a, 'i>>, ImportError> {
    let mut found = elements(node, name);
    match (found.next(), found.next()) {
        (first, None) => Ok(first),
        (_, Some(second)) => Err(ImportError::new(Importing::ElementTwice {
            at: start(second),
            element: node.tag_name().name().to_owned(),
            child: name,
        })),
    }
}

/// Returns the only child element of a name.
fn required<'a, 'i>(
    node: Node<'a, 'i>,
    name: &'static str,
    example: &'static str,
) -> Result<Node<'a, 'i>, ImportError> {
    optional(node, name)?.ok_or_else(|| {
        ImportError::new(Importing::NoElement {
            at: start(node),
            element: node.tag_name().name().to_owned(),
            child: name,
            example,
        })
    })
}

/// An attribute that an element may have, with an example of its value.
#[derive(Clone, Copy)]
struct Attribute<'a, 'i> {
    node: Node<'a, 'i>,
    name: &'static str,
    example: &'static str,
}

impl<'a, 'i> Attribute<'a, 'i> {
    fn of(node: Node<'a, 'i>, name: &'static str, example: &'static str) -> Self {
        Attribute {
            node,
            name,
            example,
        }
    }

    fn text(self) -> Option<&'a str> {
        self.node.attribute(self.name)
    }

    fn required(self) -> Result<&'a str, ImportError> {
        self.text().ok_or_else(|| {
            ImportError::new(Importing::NoAttribute {
                at: start(self.node),
                element: self.element(),
                attribute: self.name,
                example: self.example,
            })
        })
    }

    /// Returns a number that may be infinite, if the attribute is there.
    fn number(self) -> Result<Option<f64>, ImportError> {
        let Some(text) = self.text() else {
            return Ok(None);
        };
        match number(text) {
            Some(number) if !number.is_nan() => Ok(Some(number)),
            _ => Err(self.not_a_number()),
        }
    }

    /// Returns a required finite number.
    fn finite(self) -> Result<f64, ImportError> {
        let number = number(self.required()?).filter(|number| number.is_finite());
        number.ok_or_else(|| self.not_a_number())
    }

    /// Returns three finite numbers, if the attribute is there.
    fn vector(self) -> Result<Option<[f64; 3]>, ImportError> {
        let Some(text) = self.text() else {
            return Ok(None);
        };
        let vector = vector(text).filter(|vector| vector.iter().all(|part| part.is_finite()));
        vector.map(Some).ok_or_else(|| self.not_numbers(3))
    }

    /// Refuses lengths that are not above 0, since 1.2.
    fn check_lengths(self, lengths: &[f64], version: Version) -> Result<(), ImportError> {
        let is_length = |length: &f64| length.is_finite() && *length > 0.0;
        if version < Version::V1_2 || lengths.iter().all(is_length) {
            return Ok(());
        }
        Err(ImportError::new(Importing::NotALength {
            at: self.at(),
            element: self.element(),
            attribute: self.name,
            value: self.value(),
            example: self.example,
        }))
    }

    fn at(self) -> Place {
        let found = self.node.attribute_node(self.name);
        found.map_or(start(self.node), |found| {
            place(self.node, found.range().start)
        })
    }

    fn element(self) -> String {
        self.node.tag_name().name().to_owned()
    }

    fn value(self) -> String {
        self.text().unwrap_or_default().to_owned()
    }

    fn not_a_number(self) -> ImportError {
        ImportError::new(Importing::NotANumber {
            at: self.at(),
            element: self.element(),
            attribute: self.name,
            value: self.value(),
            example: self.example,
        })
    }

    fn not_numbers(self, wanted: usize) -> ImportError {
        ImportError::new(Importing::NotSoManyNumbers {
            at: self.at(),
            element: self.element(),
            attribute: self.name,
            value: self.value(),
            wanted,
            example: self.example,
        })
    }

    fn negative(self) -> ImportError {
        ImportError::new(Importing::Negative {
            at: self.at(),
            element: self.element(),
            attribute: self.name,
            value: self.value(),
            example: self.example,
        })
    }
}

/// Parses a text of one number.
fn number(text: &str) -> Option<f64> {
    text.trim().parse().ok()
}

/// Parses a text with three numbers among its words, like urdfdom.
fn vector(text: &str) -> Option<[f64; 3]> {
    let numbers = text.split_whitespace().filter_map(|word| word.parse().ok());
    numbers.collect::<Vec<_>>().try_into().ok()
}

/// Parses a text of four numbers.
fn quaternion(text: &str) -> Option<[f64; 4]> {
    let words: Option<Vec<f64>> = text.split_whitespace().map(number).collect();
    words?.try_into().ok()
}
