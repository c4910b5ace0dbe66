//! A URDF file as values: what becomes part of a description, and nothing else.

use crate::message::Importing;

/// The robot, its links and joints in the order of the file.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Robot {
    /// Empty where the file gives none.
    pub(super) name: String,
    pub(super) links: Vec<Link>,
    pub(super) joints: Vec<Joint>,
    /// What is to be said of the file.
    pub(super) notes: Vec<Importing>,
}

/// A rigid body.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Link {
    pub(super) name: String,
    /// kg; 0 without `<inertial>`.
    pub(super) mass: f64,
    /// Where its centre of mass is, and how the axes of its inertia are turned.
    pub(super) centre: Origin,
    /// The elements xx, yy, zz, xy, xz and yz of its tensor of inertia: kg·m²; 0 without `<inertial>`.
    pub(super) inertia: [f64; 6],
    /// What it looks like.
    pub(super) visuals: Vec<Piece>,
    /// What it collides with.
    pub(super) collisions: Vec<Piece>,
}

/// A part of a link.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Piece {
    pub(super) origin: Origin,
    pub(super) geometry: Geometry,
}

/// What a part is, around its origin and, where it is round, about its z: m.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Geometry {
    Box([f64; 3]),
    Cylinder {
        radius: f64,
        length: f64,
    },
    /// A cylinder with half a sphere on each end; its length is that of the cylinder.
    Capsule {
        radius: f64,
        length: f64,
    },
    Sphere {
        radius: f64,
    },
    Mesh,
}

/// What holds a link to another one.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Joint {
    pub(super) name: String,
    pub(super) kind: Kind,
    pub(super) parent: String,
    pub(super) child: String,
    pub(super) origin: Origin,
    /// In the frame of the joint, of any length; `1 0 0` without `<axis>`.
    pub(super) axis: [f64; 3],
    pub(super) limit: Limit,
    /// The joint that this one mimics.
    pub(super) mimic: Option<String>,
}

/// How a joint moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Revolute,
    Continuous,
    Prismatic,
    Fixed,
    Floating,
    Planar,
    Spherical,
}

impl Kind {
    /// Each kind and its word.
    const WORDS: [(&'static str, Kind); 7] = [
        ("revolute", Kind::Revolute),
        ("continuous", Kind::Continuous),
        ("prismatic", Kind::Prismatic),
        ("fixed", Kind::Fixed),
        ("floating", Kind::Floating),
        ("planar", Kind::Planar),
        ("spherical", Kind::Spherical),
    ];

    /// The kind of this name.
    pub(super) fn from_word(word: &str) -> Option<Self> {
        let row = Kind::WORDS.iter().find(|(known, _)| *known == word)?;
        Some(row.1)
    }

    /// The names of all kinds.
    pub(super) fn words() -> Vec<String> {
        Kind::WORDS.map(|(word, _)| word.to_owned()).to_vec()
    }
}

/// The pose of a joint's frame in its parent's.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Origin {
    /// m.
    pub(super) xyz: [f64; 3],
    /// Turns about the fixed axes x, y and z, one after the other: rad.
    pub(super) rpy: [f64; 3],
}

/// How far, strong and fast a joint moves: rad, N·m, rad/s. Without `<limit>` no end is stated, and the rest is 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Limit {
    pub(super) lower: Option<f64>,
    pub(super) upper: Option<f64>,
    /// How far from 0 an end is that is not stated: not at all, or without limit since 1.2.
    pub(super) unstated: f64,
    pub(super) effort: f64,
    pub(super) velocity: f64,
}
