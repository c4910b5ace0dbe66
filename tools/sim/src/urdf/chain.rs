//! One leg: a chain of joints from the body to the foot.

use super::ImportError;
use super::foot::Foot;
use super::frame::length;
use super::pose::Pose;
use super::robot::{Joint, Kind, Link, Origin};
use super::tree::Tree;
use crate::message::Importing;
use crate::message::JointKind;

/// A leg. All of it is seen from the robot frame while every joint is at 0: there the axes of all joints
/// are those of a description, whose frames are parallel at 0, however URDF has turned its own frames.
#[derive(Clone, Debug)]
pub(super) struct Chain<'a> {
    pub(super) joints: Vec<Turning<'a>>,
    /// Where it ends, by the name of a link.
    pub(super) end: Foot,
    /// Where that is: mm.
    pub(super) foot: [f64; 3],
}

/// A joint that turns, and the links that it carries up to the next one.
#[derive(Clone, Debug)]
pub(super) struct Turning<'a> {
    pub(super) joint: &'a Joint,
    pub(super) axis: [f64; 3],
    /// Where it is: mm.
    pub(super) at: [f64; 3],
    /// The links that it carries up to the next joint.
    pub(super) links: Vec<(&'a Link, Pose)>,
    /// Links that fixed joints hold to the one after this joint, without those of the foot.
    pub(super) merged: Vec<&'a str>,
}

impl<'a> Chain<'a> {
    /// From a joint on the body to the foot: one of `feet`, or the last link.
    pub(super) fn follow(
        tree: &Tree<'a>,
        first: &'a Joint,
        pose: Pose,
        feet: &[Foot],
    ) -> Result<Self, ImportError> {
        let mut joints = Vec::new();
        let mut next = (first, pose);
        loop {
            let (joint, pose) = next;
            check_kind(joint)?;
            let links = tree.rigid(&joint.child, pose);
            let movable = tree.movable(&links);
            let chosen = feet.iter().find_map(|foot| on(foot, &links));
            let is_last = movable.is_empty() || chosen.is_some();
            joints.push(Turning {
                joint,
                axis: pose.direction(joint.axis),
                at: pose.origin(),
                merged: merged(&links).filter(|_| !is_last).collect(),
                links: links.clone(),
            });
            if let Some((end, foot)) = chosen {
                return Ok(Chain { joints, end, foot });
            }
            match movable.as_slice() {
                [] => {
                    let (end, foot) = foot(tree, joint, &links)?;
                    return Ok(Chain { joints, end, foot });
                }
                [one] => next = *one,
                [(one, _), (other, _), ..] => {
                    return Err(ImportError::new(Importing::Branches {
                        leg: first.name.clone(),
                        link: joint.child.clone(),
                        one: one.name.clone(),
                        other: other.name.clone(),
                    }));
                }
            }
        }
    }

    /// From the robot frame to its foot, along its links: mm.
    pub(super) fn reach(&self) -> f64 {
        let places = self.joints.iter().map(|turning| turning.at);
        let mut from = [0.0; 3];
        let mut reach = 0.0;
        for place in places.chain([self.foot]) {
            reach += length([0, 1, 2].map(|axis| place[axis] - from[axis]));
            from = place;
        }
        reach
    }

    /// What errors and comments call the leg.
    pub(super) fn name(&self) -> &'a str {
        self.joints.first().map_or("", |first| &first.joint.name)
    }
}

/// A foot that is on one of these links, and where: mm.
fn on(foot: &Foot, links: &[(&Link, Pose)]) -> Option<(Foot, [f64; 3])> {
    let (_, pose) = links.iter().find(|(link, _)| link.name == foot.link)?;
    let place = Origin {
        xyz: foot.at,
        ..Origin::default()
    };
    Some((foot.clone(), pose.then(&place).origin()))
}

fn merged<'a>(links: &[(&'a Link, Pose)]) -> impl Iterator<Item = &'a str> {
    links.iter().skip(1).map(|(link, _)| link.name.as_str())
}

fn check_kind(joint: &Joint) -> Result<(), ImportError> {
    let kind = match joint.kind {
        Kind::Revolute | Kind::Continuous => None,
        Kind::Fixed => Some(JointKind::Fixed),
        Kind::Prismatic => Some(JointKind::Prismatic),
        Kind::Floating => Some(JointKind::Floating),
        Kind::Planar => Some(JointKind::Planar),
        Kind::Spherical => Some(JointKind::Spherical),
    };
    let (name, link) = (joint.name.clone(), joint.parent.clone());
    if let Some(kind) = kind {
        return Err(ImportError::new(Importing::DoesNotTurn {
            joint: name,
            link,
            kind,
        }));
    }
    if let Some(mimic) = &joint.mimic {
        return Err(ImportError::new(Importing::Mimics {
            joint: name,
            link,
            other: mimic.clone(),
        }));
    }
    if joint.axis.iter().all(|part| *part == 0.0) {
        return Err(ImportError::new(Importing::NoAxis { joint: name, link }));
    }
    Ok(())
}

/// The foot: the frame that fixed joints put at the end of the last link.
fn foot<'a>(
    tree: &Tree<'a>,
    last: &Joint,
    links: &[(&'a Link, Pose)],
) -> Result<(Foot, [f64; 3]), ImportError> {
    let behind = links.iter().skip(1);
    let ends: Vec<&(&Link, Pose)> = behind.filter(|(link, _)| tree.is_leaf(link)).collect();
    let (link, joint) = (last.child.clone(), last.name.clone());
    match ends.as_slice() {
        [(end, pose)] => Ok((Foot::from(end.name.as_str()), pose.origin())),
        [] => Err(ImportError::new(Importing::NoFoot { link, joint })),
        [(one, _), (other, _), ..] => Err(ImportError::new(Importing::TwoFeet {
            link,
            joint,
            one: one.name.clone(),
            other: other.name.clone(),
        })),
    }
}
