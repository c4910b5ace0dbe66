//! The legs of a robot: chains of joints from the body to the feet, and the options that select them.

use super::ImportError;
use super::names;
use super::transform::{Forward, Transform, Up};
use super::tree::LinkTree;
use super::tree::{Joint, JointType, Link, Posture};
use super::xml::printed;
use crate::message::Importing;
use crate::message::JointKind;
use crate::urdf::frame::{self, length};
use std::fmt;
use std::path::PathBuf;
use tip_runtime::model::Range;
use tipc::message::list::List;

/// Options of an import, for what a file leaves open. A chain is named by one of its joints or
/// links, or by words that only the name of its first joint has: `FL` is the chain of
/// `FL_hip_joint`.
///
/// ```
/// use tip_sim::import::{ImportOptions, import_with};
///
/// let text = tip_sim::urdf::export(&tip_sim::Robot::named("titan8")?);
/// let order = ["F2", "F1", "F4", "F3"].map(String::from).to_vec();
/// let import = import_with("titan8.urdf", &text, &ImportOptions { order, ..ImportOptions::default() })?;
/// assert!(import.toml.contains("F1: joint J21 to link F2"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ImportOptions {
    /// Feet that are not the last links of their chains, or not where those have their frames.
    pub feet: Vec<Foot>,
    /// Chains that are not legs.
    pub skip: Vec<String>,
    /// The chains that become F1, F2, …; empty for an order by place, from front to rear and left before right.
    pub order: Vec<String>,
    /// The axis of the file that is up. By default it is z, and a robot that lies on its side is
    /// refused.
    pub up: Option<Up>,
    /// The axis of the file that is forward. By default it is x, or −z where x is up.
    pub forward: Option<Forward>,
    /// The folder of the file, below which it may include others. Without one they are refused.
    pub folder: Option<PathBuf>,
    /// Height of the robot frame above the feet in the initial posture of a robot that walks, mm.
    pub stand: Option<f64>,
}

/// The first joint of a chain, and the pose of its frame.
type First<'a> = (&'a Joint, Transform);

impl ImportOptions {
    /// Returns the first joints of the legs in their order, and a remark on the others.
    pub(super) fn legs<'a>(
        &self,
        tree: &LinkTree<'a>,
        firsts: Vec<First<'a>>,
    ) -> Result<(Vec<First<'a>>, Option<Importing>), ImportError> {
        let skipped = find_chains(tree, &firsts, &self.skip)?;
        let names = |indices: &[usize]| {
            let joints = indices.iter().filter_map(|index| firsts.get(*index));
            List(joints.map(|(joint, _)| printed(&joint.name)).collect())
        };
        let kept: Vec<usize> = (0..firsts.len())
            .filter(|index| !skipped.contains(index))
            .collect();
        if kept.is_empty() {
            let chains = names(&skipped);
            return Err(ImportError::new(Importing::AllLeftOut { chains }));
        }
        let ordered = match self.order.is_empty() {
            true => kept,
            false => self.ordered(tree, &firsts, &kept, names)?,
        };
        let left_out = (!skipped.is_empty()).then(|| {
            let joints = skipped.iter().filter_map(|index| firsts.get(*index));
            let mass: f64 = joints.map(|(joint, _)| tree.mass_after(joint)).sum();
            Importing::LeftOut {
                chains: names(&skipped),
                mass: rounded(mass),
            }
        });
        let legs = ordered.iter().filter_map(|index| firsts.get(*index));
        Ok((legs.copied().collect(), left_out))
    }

    /// Returns the legs that are kept, each named once.
    fn ordered(
        &self,
        tree: &LinkTree<'_>,
        firsts: &[First<'_>],
        kept: &[usize],
        names: impl Fn(&[usize]) -> List,
    ) -> Result<Vec<usize>, ImportError> {
        let mut ordered = find_chains(tree, firsts, &self.order)?;
        ordered.retain(|index| kept.contains(index));
        let lacking: Vec<usize> = kept
            .iter()
            .copied()
            .filter(|index| !ordered.contains(index))
            .collect();
        match lacking.as_slice() {
            [] => Ok(ordered),
            lacking => Err(ImportError::new(Importing::NotInOrder {
                chains: names(lacking),
            })),
        }
    }
}

/// Returns the chains that words name, each once.
fn find_chains(
    tree: &LinkTree<'_>,
    firsts: &[First<'_>],
    words: &[String],
) -> Result<Vec<usize>, ImportError> {
    let mut found = Vec::new();
    for word in words {
        let index = find_chain(tree, firsts, word)?;
        if found.contains(&index) {
            return Err(ImportError::new(Importing::ChainTwice {
                word: printed(word),
                chain: printed(&firsts[index].0.name),
            }));
        }
        found.push(index);
    }
    Ok(found)
}

/// Returns the chain that a word names.
fn find_chain(tree: &LinkTree<'_>, firsts: &[First<'_>], word: &str) -> Result<usize, ImportError> {
    let those = |is: &dyn Fn(&Joint) -> bool| -> Vec<usize> {
        let indices = 0..firsts.len();
        indices.filter(|index| is(firsts[*index].0)).collect()
    };
    let names = |indices: &[usize]| {
        let names = indices.iter().map(|index| printed(&firsts[*index].0.name));
        List(names.collect())
    };
    let whole = those(&|joint| tree.names_after(joint).contains(&word));
    let found = match whole.is_empty() {
        true => those(&|joint| has_words(&joint.name, word)),
        false => whole,
    };
    let word = printed(word);
    match found.as_slice() {
        [index] => Ok(*index),
        [] => Err(ImportError::new(Importing::NoChain {
            word,
            chains: names(&those(&|_| true)),
        })),
        several => Err(ImportError::new(Importing::SeveralChains {
            word,
            chains: names(several),
        })),
    }
}

/// Returns true if a name has these words in a row, whatever separates them: `front_left` is in
/// `front_left_hip`.
fn has_words(name: &str, words: &str) -> bool {
    let parts = |text: &str| -> Vec<String> {
        let parts = text.split(|c: char| !c.is_alphanumeric());
        parts
            .filter(|part| !part.is_empty())
            .map(str::to_lowercase)
            .collect()
    };
    let (name, words) = (parts(name), parts(words));
    !words.is_empty() && name.windows(words.len()).any(|some| some == words)
}

/// A point on a link that is a foot.
///
/// ```
/// use tip_sim::import::Foot;
///
/// assert_eq!(Foot::from("toe").to_string(), "toe");
/// let tip = Foot { link: "shank".to_owned(), at: [0.0, 0.0, -0.13] };
/// assert_eq!(tip.to_string(), "shank=0,0,-0.13");
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Foot {
    /// The link.
    pub link: String,
    /// Position in the frame of the link, m.
    pub at: [f64; 3],
}

/// The origin of a link's frame.
impl From<&str> for Foot {
    fn from(link: &str) -> Self {
        Foot {
            link: link.to_owned(),
            at: [0.0; 3],
        }
    }
}

impl fmt::Display for Foot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Foot { link, at } = self;
        match at {
            [0.0, 0.0, 0.0] => f.write_str(link),
            [x, y, z] => write!(f, "{link}={x},{y},{z}"),
        }
    }
}

/// A leg, seen from the robot frame while every joint is at 0: there the axes of all joints are
/// those of a description, whose frames are parallel at 0, however URDF has turned its own frames.
#[derive(Clone, Debug)]
pub(super) struct Chain<'a> {
    pub(super) joints: Vec<ChainJoint<'a>>,
    /// The end of the leg, by the name of a link.
    pub(super) end: Foot,
    /// Position of the foot, mm.
    pub(super) foot: [f64; 3],
    /// The remark on the end in the report of the import.
    pub(super) remark: Option<Importing>,
}

/// A revolute joint, and the links that it carries up to the next one.
#[derive(Clone, Debug)]
pub(super) struct ChainJoint<'a> {
    pub(super) joint: &'a Joint,
    pub(super) axis: [f64; 3],
    /// Position, mm.
    pub(super) at: [f64; 3],
    /// The links that it carries up to the next joint.
    pub(super) links: Vec<(&'a Link, Transform)>,
    /// Links that fixed joints hold to the one after this joint, without those of the foot.
    pub(super) merged: Vec<&'a str>,
}

impl<'a> Chain<'a> {
    /// Follows the chain from a joint on the body to the foot: one of `feet`, or the last link.
    pub(super) fn follow(
        tree: &LinkTree<'a>,
        first: &'a Joint,
        pose: Transform,
        feet: &[Foot],
    ) -> Result<Self, ImportError> {
        let mut joints = Vec::new();
        let mut next = (first, pose);
        loop {
            let (joint, pose) = next;
            check_kind(joint)?;
            let links = tree.carried(joint, pose);
            let movable = tree.movable(&links);
            let chosen = feet.iter().find_map(|foot| foot_on(foot, &links));
            let is_last = movable.is_empty() || chosen.is_some();
            joints.push(ChainJoint {
                joint,
                axis: pose.direction(joint.axis),
                at: pose.origin(),
                merged: merged(&links).filter(|_| !is_last).collect(),
                links: links.clone(),
            });
            if let Some((end, foot)) = chosen {
                let remark = match movable.is_empty() {
                    true => is_wheel(joint).then(|| Importing::WheelIsFoot {
                        joint: printed(&joint.name),
                    }),
                    false => Some(Importing::CutOff {
                        foot: printed(&end.to_string()),
                        joints: List(
                            movable
                                .iter()
                                .map(|(next, _)| printed(&next.name))
                                .collect(),
                        ),
                        mass: rounded(movable.iter().map(|(next, _)| tree.mass_after(next)).sum()),
                    }),
                };
                return Ok(Chain {
                    joints,
                    end,
                    foot,
                    remark,
                });
            }
            match movable.as_slice() {
                [] if is_wheel(joint) => {
                    return Err(ImportError::new(Importing::Wheel {
                        joint: joint.name.clone(),
                        link: joint.child.clone(),
                        before: joint.parent.clone(),
                    }));
                }
                [] => {
                    let (end, foot) = foot(tree, joint, &links)?;
                    return Ok(Chain {
                        joints,
                        end,
                        foot,
                        remark: None,
                    });
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

    /// Returns the values of the joints in a posture, deg.
    pub(super) fn posture(&self, posture: &Posture) -> Vec<f64> {
        let value = |turning: &ChainJoint<'_>| posture.joints.get(&turning.joint.name).copied();
        let joints = self.joints.iter();
        joints
            .map(|turning| value(turning).unwrap_or_default().to_degrees())
            .collect()
    }

    /// Returns the length from the robot frame to the foot, along the links, mm.
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

    /// Returns the name of the leg in errors and comments: that of its first joint.
    pub(super) fn name(&self) -> &'a str {
        self.joints.first().map_or("", |first| &first.joint.name)
    }
}

/// The share of the largest extent below which positions count as equal.
const NEAR: f64 = 0.01;
/// The share of the length of all first joints that separates rows of legs.
const ROW: f64 = 0.1;

/// Returns the box around the first joints of all legs, mm.
pub(super) fn hips(legs: &[Chain<'_>]) -> [Range; 3] {
    around(&places(legs, |leg| {
        leg.joints.first().map(|first| first.at)
    }))
}

/// Returns true if a box has no size along an axis.
pub(super) fn is_flat(extents: &[Range; 3], axis: usize) -> bool {
    size(&extents[axis]) <= NEAR * extents.iter().map(size).fold(0.0, f64::max)
}

/// Returns the axis of the file that may point up, if the first joints of all legs are in one
/// upright plane.
pub(super) fn on_its_side(legs: &[Chain<'_>]) -> Option<&'static str> {
    let hips = hips(legs);
    match [0, 1, 2].map(|axis| is_flat(&hips, axis)) {
        // To the right is what is not to the left, forward is x.
        [true, _, false] => Some("y"),
        [false, true, false] => Some("x"),
        _ => None,
    }
}

/// Orders the legs as programs expect them, from front to rear and left before right, unless they
/// are fingers or have numbers of their own; returns a remark for the report.
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

/// Returns the order of positions, from front to rear and left before right; `None` if two of them
/// count as equal.
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
    // One leg on each side makes a pair, even if one is far ahead of the other.
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

/// Returns the box around all positions, mm.
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

/// Returns the foot if it is on one of these links, and its position, mm.
fn foot_on(foot: &Foot, links: &[(&Link, Transform)]) -> Option<(Foot, [f64; 3])> {
    let (_, pose) = links.iter().find(|(link, _)| link.name == foot.link)?;
    Some((foot.clone(), point(pose, foot.at)))
}

/// Returns true if a joint is called a wheel.
fn is_wheel(joint: &Joint) -> bool {
    let words = [&joint.name, &joint.child].map(|name| names::words(name));
    words.iter().flatten().any(|word| word == "wheel")
}

/// Rounds a mass to a mg, for reports.
fn rounded(mass: f64) -> f64 {
    (mass * 1e6).round() / 1e6
}

/// Returns a point of a frame (m) in the robot frame, mm.
fn point(pose: &Transform, at: [f64; 3]) -> [f64; 3] {
    pose.then(&Transform::shifted(at)).origin()
}

fn merged<'a>(links: &[(&'a Link, Transform)]) -> impl Iterator<Item = &'a str> {
    links.iter().skip(1).map(|(link, _)| link.name.as_str())
}

fn check_kind(joint: &Joint) -> Result<(), ImportError> {
    let kind = match joint.kind {
        JointType::Revolute | JointType::Continuous => None,
        JointType::Fixed => Some(JointKind::Fixed),
        JointType::Prismatic => Some(JointKind::Prismatic),
        JointType::Floating => Some(JointKind::Floating),
        JointType::Planar => Some(JointKind::Planar),
        JointType::Spherical => Some(JointKind::Spherical),
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

/// Returns the foot: the frame that fixed joints put at the end of the last link.
fn foot<'a>(
    tree: &LinkTree<'a>,
    last: &Joint,
    links: &[(&'a Link, Transform)],
) -> Result<(Foot, [f64; 3]), ImportError> {
    let tips = links
        .iter()
        .flat_map(|(link, pose)| link.tips.iter().map(move |tip| (*link, pose, tip)));
    // If several tips are of the same kind, the last one counts.
    if let Some((link, pose, tip)) = tips.max_by_key(|(_, _, tip)| tip.kind) {
        let foot = Foot {
            link: link.name.clone(),
            at: tip.at,
        };
        return Ok((foot, point(pose, tip.at)));
    }
    let behind = links.iter().skip(1);
    let ends: Vec<&(&Link, Transform)> = behind.filter(|(link, _)| tree.is_leaf(link)).collect();
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
