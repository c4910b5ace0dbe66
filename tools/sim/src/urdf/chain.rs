//! One leg: a chain of joints from the body to the foot.

use super::ImportError;
use super::foot::Foot;
use super::frame::{self, length};
use super::pose::Pose;
use super::robot::{Joint, Kind, Link, Origin};
use super::tree::Tree;
use super::values::printed;
use crate::message::Importing;
use crate::message::JointKind;
use tip_runtime::model::Range;
use tipc::message::list::List;

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

/// The share of the largest extent below which places are not told apart.
const NEAR: f64 = 0.01;
/// The share of the length of all first joints by which rows of legs are apart.
const ROW: f64 = 0.1;

/// What holds the first joints of all legs: mm.
pub(super) fn hips(legs: &[Chain<'_>]) -> [Range; 3] {
    around(&places(legs, |leg| {
        leg.joints.first().map(|first| first.at)
    }))
}

/// Whether what is there has no size along an axis.
pub(super) fn is_flat(extents: &[Range; 3], axis: usize) -> bool {
    size(&extents[axis]) <= NEAR * extents.iter().map(size).fold(0.0, f64::max)
}

/// The axis of the file that may point up, if the first joints of all legs are in one upright plane.
pub(super) fn on_its_side(legs: &[Chain<'_>]) -> Option<&'static str> {
    let hips = hips(legs);
    match [0, 1, 2].map(|axis| is_flat(&hips, axis)) {
        // To the right is what is not to the left, forward is x.
        [true, _, false] => Some("y"),
        [false, true, false] => Some("x"),
        _ => None,
    }
}

/// Puts the legs in the order in which programs expect them, from front to rear and left before right, unless they are fingers or have
/// numbers of their own; returns what is to be said of that.
pub(super) fn order(legs: &mut Vec<Chain<'_>>, walks: bool) -> Importing {
    let names = |legs: &[Chain<'_>]| List(legs.iter().map(|leg| printed(leg.name())).collect());
    let mut numbered = (1..).zip(legs.iter());
    if !walks || numbered.all(|(number, leg)| leg.name() == frame::joint(number, 1)) {
        return Importing::LegsOfFile {
            joints: names(legs),
        };
    }
    let hips = places(legs, |leg| leg.joints.first().map(|first| first.at));
    let feet = places(legs, |leg| Some(leg.foot));
    match by_place(&hips).or_else(|| by_place(&feet)) {
        None => Importing::LegsWithoutPlace {
            joints: names(legs),
        },
        Some(order) => {
            *legs = order
                .iter()
                .filter_map(|leg| legs.get(*leg).cloned())
                .collect();
            Importing::LegsByPlace {
                joints: names(legs),
            }
        }
    }
}

/// The order of places, from front to rear and left before right; `None` if two of them are not told apart.
fn by_place(places: &[[f64; 3]]) -> Option<Vec<usize>> {
    let extents = around(places);
    let [across, along] = [0, 1].map(|axis| size(&extents[axis]));
    let middle = (extents[0].min + extents[0].max) / 2.0;
    let beside = NEAR * across.max(along);
    let x = |leg: usize| places[leg][0];
    let y = |leg: usize| places[leg][1];
    let left_first = |a: &usize, b: &usize| x(*a).total_cmp(&x(*b));
    let mut order: Vec<usize> = (0..places.len()).collect();
    order.sort_by(|a, b| y(*b).total_cmp(&y(*a)).then(left_first(a, b)));
    // One leg on each side makes a pair, however much one is ahead of the other.
    let is_pair = |pair: &[usize]| match pair {
        [one, other] => {
            let [left, right] = [x(*one).min(x(*other)), x(*one).max(x(*other))];
            left < middle - beside && right > middle + beside
        }
        _ => false,
    };
    if order.chunks(2).all(is_pair) {
        order
            .chunks_mut(2)
            .for_each(|pair| pair.sort_by(left_first));
        return Some(order);
    }
    let in_row = |a: &usize, b: &usize| y(*a) - y(*b) <= ROW * along;
    for row in order.chunk_by_mut(in_row) {
        row.sort_by(left_first);
        if row.windows(2).any(|pair| x(pair[1]) - x(pair[0]) <= beside) {
            return None;
        }
    }
    Some(order)
}

fn places<'a>(legs: &[Chain<'a>], place: impl Fn(&Chain<'a>) -> Option<[f64; 3]>) -> Vec<[f64; 3]> {
    legs.iter().filter_map(place).collect()
}

/// What holds all places: mm.
fn around(places: &[[f64; 3]]) -> [Range; 3] {
    [0, 1, 2].map(|axis| {
        let at = || places.iter().map(|place| place[axis]);
        Range::new(
            at().fold(f64::INFINITY, f64::min),
            at().fold(f64::NEG_INFINITY, f64::max),
        )
    })
}

fn size(range: &Range) -> f64 {
    range.max - range.min
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
