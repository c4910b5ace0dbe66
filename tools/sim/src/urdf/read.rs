//! A robot from the text of a URDF file.

use super::ImportError;
use super::check;
use super::node::{elements, place, start};
use super::robot::{Geometry, Joint, Kind, Limit, Link, Origin, Piece, Robot};
use super::schema::ROBOT;
use super::values::{number, printed, quaternion, roll_pitch_yaw, vector};
use super::version::Version;
use super::{xacro, xml};
use crate::message::Importing;
use crate::message::Place;
use roxmltree::{Document, Error, Node};
use std::collections::BTreeMap;

/// Refuses what is not URDF. Once it is checked, only what may be left out is missing.
pub(super) fn robot(text: &str) -> Result<Robot, ImportError> {
    let text = xml::without_late_declaration(text);
    xml::check_size(&text)?;
    let document = Document::parse(&text).map_err(|error| {
        ImportError::new(match error {
            Error::DtdDetected => Importing::Doctype,
            Error::UnknownNamespace(prefix, at) if prefix == xacro::PREFIX => Importing::Xacro {
                // The place is that of the prefix, after the bracket.
                at: Place::At {
                    line: at.row,
                    column: at.col.saturating_sub(1),
                },
            },
            error => Importing::NoUrdf {
                error: error.to_string().into(),
            },
        })
    })?;
    xacro::refuse(&document)?;
    let node = document.root_element();
    if !node.has_tag_name(ROBOT.name) {
        return Err(ImportError::new(Importing::NotARobot {
            element: node.tag_name().name().to_owned(),
        }));
    }
    let version = Version::from_attribute(node.attribute("version"));
    check::element(node, &ROBOT, version)?;
    names_once(node)?;
    Ok(Robot {
        notes: notes(node, version),
        name: string(node, "name"),
        links: elements(node, "link")
            .map(|node| link(node, version))
            .collect(),
        joints: elements(node, "joint")
            .map(|node| joint(node, version))
            .collect(),
    })
}

/// Refuses two links or two joints of one name.
fn names_once(robot: Node<'_, '_>) -> Result<(), ImportError> {
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

/// What the version of a robot lets stand there without a meaning, or what is not known of the version.
fn notes(robot: Node<'_, '_>, version: Version) -> Vec<Importing> {
    let mut notes = Vec::new();
    let said = robot.attribute("version");
    if let Some(text) = said.filter(|text| !Version::is_known(text)) {
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

fn link(node: Node<'_, '_>, version: Version) -> Link {
    let inertial = elements(node, "inertial").next();
    let within = |name| inertial.and_then(|inertial| elements(inertial, name).next());
    let element = |name| within("inertia").and_then(|inertia| value(inertia, name));
    let centre = within("origin").map(|node| origin_of(node, version));
    Link {
        name: string(node, "name"),
        mass: within("mass")
            .and_then(|mass| value(mass, "value"))
            .unwrap_or_default(),
        centre: centre.unwrap_or_default(),
        inertia: ["ixx", "iyy", "izz", "ixy", "ixz", "iyz"]
            .map(|name| element(name).unwrap_or_default()),
        visuals: pieces(node, "visual", version),
        collisions: pieces(node, "collision", version),
    }
}

/// The parts of a link in elements of a name.
fn pieces(link: Node<'_, '_>, name: &'static str, version: Version) -> Vec<Piece> {
    let pieces = elements(link, name).filter_map(|piece| {
        let origin = elements(piece, "origin").next();
        Some(Piece {
            origin: origin.map_or_else(Origin::default, |node| origin_of(node, version)),
            geometry: geometry(piece)?,
        })
    });
    pieces.collect()
}

fn geometry(piece: Node<'_, '_>) -> Option<Geometry> {
    let geometry = elements(piece, "geometry").next()?;
    let form = geometry.children().find(Node::is_element)?;
    let [radius, length] = ["radius", "length"].map(|name| value(form, name));
    Some(match form.tag_name().name() {
        "box" => Geometry::Box(form.attribute("size").and_then(vector)?),
        "cylinder" => Geometry::Cylinder {
            radius: radius?,
            length: length?,
        },
        "capsule" => Geometry::Capsule {
            radius: radius?,
            length: length?,
        },
        "sphere" => Geometry::Sphere { radius: radius? },
        _ => Geometry::Mesh,
    })
}

fn joint(node: Node<'_, '_>, version: Version) -> Joint {
    let child = |name| elements(node, name).next();
    let link = |name| child(name).map_or_else(String::new, |node| string(node, "link"));
    Joint {
        name: string(node, "name"),
        kind: node
            .attribute("type")
            .and_then(Kind::from_word)
            .unwrap_or(Kind::Fixed),
        parent: link("parent"),
        child: link("child"),
        origin: child("origin").map_or_else(Origin::default, |node| origin_of(node, version)),
        axis: child("axis")
            .and_then(|axis| axis.attribute("xyz"))
            .and_then(vector)
            .unwrap_or([1.0, 0.0, 0.0]),
        limit: child("limit").map_or_else(Limit::default, |node| limit(node, version)),
        mimic: child("mimic").map(|mimic| string(mimic, "joint")),
    }
}

fn origin_of(node: Node<'_, '_>, version: Version) -> Origin {
    let turns = node.attribute("quat_xyzw");
    let turns = turns.filter(|_| version >= Version::V1_1);
    let rpy = match turns.and_then(quaternion) {
        Some(quaternion) => Some(roll_pitch_yaw(quaternion)),
        None => node.attribute("rpy").and_then(vector),
    };
    let xyz = node.attribute("xyz").and_then(vector);
    Origin {
        xyz: xyz.unwrap_or_default(),
        rpy: rpy.unwrap_or_default(),
    }
}

/// What a limit leaves out is 0, and without limit since 1.2.
fn limit(node: Node<'_, '_>, version: Version) -> Limit {
    let most = match version >= Version::V1_2 {
        true => f64::INFINITY,
        false => 0.0,
    };
    Limit {
        lower: value(node, "lower"),
        upper: value(node, "upper"),
        unstated: most,
        effort: value(node, "effort").unwrap_or(most),
        velocity: value(node, "velocity").unwrap_or(most),
    }
}

fn string(node: Node<'_, '_>, attribute: &str) -> String {
    node.attribute(attribute).unwrap_or_default().to_owned()
}

fn value(node: Node<'_, '_>, attribute: &str) -> Option<f64> {
    node.attribute(attribute).and_then(number)
}
