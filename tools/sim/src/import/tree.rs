//! The tree of links and joints.

use super::ImportError;
use super::transform::{Forward, Transform};
use crate::message::Importing;
use crate::urdf::frame::WORLD;
use std::collections::{BTreeMap, BTreeSet};

/// A robot, its links and joints in the order of the file.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct RobotFile {
    /// Name of the robot; empty if the file has none.
    pub(super) name: String,
    pub(super) links: Vec<Link>,
    pub(super) joints: Vec<Joint>,
    /// True if the file says that the base moves freely.
    pub(super) is_free: bool,
    /// The initial posture, if the file has one.
    pub(super) posture: Option<Posture>,
    /// Axis that is forward, if the file says so.
    pub(super) forward: Option<Forward>,
    /// The standard OMEGA_MAX, if the file has it, deg/s.
    pub(super) omega_max: Option<f64>,
    /// Remarks on the file for the report.
    pub(super) notes: Vec<Importing>,
}

/// A posture that a file names, as values of joints by their names.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Posture {
    pub(super) name: String,
    /// Values, rad; 0 for a joint that is not there.
    pub(super) joints: BTreeMap<String, f64>,
}

/// A rigid body.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Link {
    pub(super) name: String,
    /// Mass, kg; 0 without `<inertial>`.
    pub(super) mass: f64,
    /// Transform of the centre of mass, whose axes are those of the inertia.
    pub(super) centre: Transform,
    /// Tensor of inertia: xx, yy, zz, xy, xz and yz, kg·m²; 0 without `<inertial>`.
    pub(super) inertia: [f64; 6],
    /// Visual geometry of the link `body`, which may give its extents; empty for other links.
    pub(super) visuals: Vec<Piece>,
    /// Collision geometry.
    pub(super) collisions: Vec<Piece>,
    /// Points that may be a foot, in the order of the file; none in URDF.
    pub(super) tips: Vec<Tip>,
}

/// A point of a link that may be a foot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Tip {
    pub(super) kind: TipKind,
    /// Position in the frame of the link, m.
    pub(super) at: [f64; 3],
}

/// The reason to take a point for a foot, the weakest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum TipKind {
    /// The far end of a capsule.
    Capsule,
    /// The centre of a sphere.
    Sphere,
    /// A site that is called foot, toe or tip.
    Site,
}

/// A geometry of a link at its pose.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Piece {
    pub(super) origin: Transform,
    pub(super) geometry: Geometry,
}

/// A geometry around its origin and, if it is round, about its z axis, m.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Geometry {
    Box([f64; 3]),
    Cylinder {
        radius: f64,
        length: f64,
    },
    /// A cylinder with half a sphere on each end; the length is that of the cylinder.
    Capsule {
        radius: f64,
        length: f64,
    },
    Sphere {
        radius: f64,
    },
    Mesh,
}

impl Geometry {
    /// The elements of all geometries.
    pub(super) const ELEMENTS: [&'static str; 5] = ["box", "cylinder", "capsule", "sphere", "mesh"];
}

/// A joint between two links.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Joint {
    pub(super) name: String,
    pub(super) kind: JointType,
    /// Name of the parent link.
    pub(super) parent: String,
    /// Name of the child link.
    pub(super) child: String,
    /// Pose of the joint in the parent link, at value 0.
    pub(super) origin: Transform,
    /// Position of the joint in the child link, m; 0 in URDF.
    pub(super) anchor: [f64; 3],
    /// Axis in the frame of the joint, of any length; `1 0 0` without `<axis>`.
    pub(super) axis: [f64; 3],
    pub(super) limit: JointLimit,
    /// The joint that this one mimics.
    pub(super) mimic: Option<String>,
}

/// The type of a joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum JointType {
    Revolute,
    Continuous,
    Prismatic,
    Fixed,
    Floating,
    Planar,
    Spherical,
}

impl JointType {
    /// All types with their words.
    pub(super) const WORDS: [(&'static str, JointType); 7] = [
        ("revolute", JointType::Revolute),
        ("continuous", JointType::Continuous),
        ("prismatic", JointType::Prismatic),
        ("fixed", JointType::Fixed),
        ("floating", JointType::Floating),
        ("planar", JointType::Planar),
        ("spherical", JointType::Spherical),
    ];

    pub(super) fn from_word(word: &str) -> Option<Self> {
        let row = JointType::WORDS.iter().find(|(known, _)| *known == word)?;
        Some(row.1)
    }
}

/// Limits of a joint: rad, N·m, rad/s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct JointLimit {
    pub(super) lower: Option<f64>,
    pub(super) upper: Option<f64>,
    /// Distance from 0 of an end that is not stated: 0, or infinite since 1.2.
    pub(super) unstated: f64,
    pub(super) effort: f64,
    /// `None` in formats without speeds.
    pub(super) velocity: Option<f64>,
}

/// The robot's links, and the joints on each.
pub(super) struct LinkTree<'a> {
    links: BTreeMap<&'a str, &'a Link>,
    joints: BTreeMap<&'a str, Vec<&'a Joint>>,
    root: &'a str,
}

impl<'a> LinkTree<'a> {
    /// Builds the tree; names are unique. Refuses everything that is not a tree.
    pub(super) fn new(robot: &'a RobotFile) -> Result<Self, ImportError> {
        let mut links = BTreeMap::new();
        for link in &robot.links {
            links.insert(link.name.as_str(), link);
        }
        let mut joints: BTreeMap<&str, Vec<&Joint>> = BTreeMap::new();
        let mut held = BTreeSet::new();
        for joint in &robot.joints {
            for link in [&joint.parent, &joint.child] {
                if !links.contains_key(link.as_str()) {
                    let (joint, link) = (joint.name.clone(), link.clone());
                    return Err(ImportError::new(Importing::NoSuchLink { joint, link }));
                }
            }
            if !held.insert(joint.child.as_str()) {
                let link = joint.child.clone();
                return Err(ImportError::new(Importing::OnTwoJoints { link }));
            }
            joints.entry(&joint.parent).or_default().push(joint);
        }
        let roots: Vec<&str> = links
            .keys()
            .copied()
            .filter(|link| !held.contains(link))
            .collect();
        let mut root = match roots.as_slice() {
            [root] => *root,
            [] if links.is_empty() => {
                return Err(ImportError::new(Importing::NoLink));
            }
            [] => {
                return Err(ImportError::new(Importing::NoBase));
            }
            [one, other, ..] => {
                let (one, other) = ((*one).to_owned(), (*other).to_owned());
                return Err(ImportError::new(Importing::TwoBases { one, other }));
            }
        };
        // A floating joint at the root says that the robot is free; its parent stands for the world.
        if let Some([only]) = joints.get(root).map(Vec::as_slice)
            && only.kind == JointType::Floating
        {
            links.remove(root);
            root = &only.child;
        }
        let tree = LinkTree {
            root,
            links,
            joints,
        };
        tree.check_reach()?;
        Ok(tree)
    }

    /// Refuses loops of links.
    fn check_reach(&self) -> Result<(), ImportError> {
        let mut reached = BTreeSet::from([self.root]);
        let mut open = vec![self.root];
        while let Some(link) = open.pop() {
            let children = self.joints(link).iter().map(|joint| joint.child.as_str());
            for child in children {
                reached.insert(child);
                open.push(child);
            }
        }
        match self.links.keys().find(|link| !reached.contains(*link)) {
            None => Ok(()),
            Some(link) => Err(ImportError::new(Importing::Circle {
                link: (*link).to_owned(),
                base: self.root.to_owned(),
            })),
        }
    }

    /// Returns the link that carries all others; for a robot that is bolted down to a link `world`,
    /// the link that is fixed there.
    pub(super) fn base(&self) -> &'a str {
        match self.joints(self.root) {
            [only] if self.is_bolted_down() && is_fixed(only) => &only.child,
            _ => self.root,
        }
    }

    /// Returns true if the root is a link `world`, which by convention does not move.
    pub(super) fn is_bolted_down(&self) -> bool {
        self.root == WORLD
    }

    fn joints(&self, link: &str) -> &[&'a Joint] {
        self.joints.get(link).map_or(&[], Vec::as_slice)
    }

    /// Returns a link at `pose`, and all links that fixed joints hold to it, each with its own
    /// pose.
    pub(super) fn rigid(&self, link: &'a str, pose: Transform) -> Vec<(&'a Link, Transform)> {
        let mut open = vec![(link, pose)];
        let mut found = Vec::new();
        while let Some((name, pose)) = open.pop() {
            found.extend(self.links.get(name).map(|link| (*link, pose)));
            let fixed = self.joints(name).iter().filter(|joint| is_fixed(joint));
            open.extend(fixed.map(|joint| (joint.child.as_str(), pose.then(&joint.origin))));
        }
        found
    }

    /// Returns the links that move with a joint whose frame is at `pose`, as [`rigid`](Self::rigid) does.
    pub(super) fn carried(&self, joint: &'a Joint, pose: Transform) -> Vec<(&'a Link, Transform)> {
        let back = Transform::shifted(joint.anchor.map(|part| -part));
        self.rigid(&joint.child, pose.then(&back))
    }

    /// Returns the movable joints on these links, in the order of the file, each with the pose of
    /// its frame.
    pub(super) fn movable(&self, links: &[(&'a Link, Transform)]) -> Vec<(&'a Joint, Transform)> {
        let mut found = Vec::new();
        for (link, pose) in links {
            let moving = self
                .joints(&link.name)
                .iter()
                .filter(|joint| !is_fixed(joint));
            found.extend(moving.map(|joint| (*joint, pose.then(&joint.origin))));
        }
        found
    }

    /// Returns the names of a joint, of its link, and of all links and joints after it.
    pub(super) fn names_after(&self, joint: &'a Joint) -> Vec<&'a str> {
        let joints = self.joints_from(joint).into_iter();
        joints
            .flat_map(|joint| [joint.name.as_str(), joint.child.as_str()])
            .collect()
    }

    /// Returns a joint and all joints after it.
    fn joints_from(&self, joint: &'a Joint) -> Vec<&'a Joint> {
        let mut found = vec![joint];
        let mut next = 0;
        while let Some(joint) = found.get(next) {
            found.extend(self.joints(&joint.child));
            next += 1;
        }
        found
    }

    /// Returns the mass of all links after a joint, kg.
    pub(super) fn mass_after(&self, joint: &'a Joint) -> f64 {
        let joints = self.joints_from(joint).into_iter();
        joints
            .filter_map(|joint| self.links.get(joint.child.as_str()))
            .map(|link| link.mass)
            .sum()
    }

    /// Returns true if no joint is on the link.
    pub(super) fn is_leaf(&self, link: &Link) -> bool {
        self.joints(&link.name).is_empty()
    }
}

fn is_fixed(joint: &Joint) -> bool {
    joint.kind == JointType::Fixed
}
