//! Links and joints as the tree that they must be.

use super::ImportError;
use super::frame::WORLD;
use super::pose::Pose;
use super::robot::{Joint, Kind, Link, Robot};
use crate::message::Importing;
use std::collections::{BTreeMap, BTreeSet};

/// The robot's links, and the joints that hang on each.
pub(super) struct Tree<'a> {
    links: BTreeMap<&'a str, &'a Link>,
    joints: BTreeMap<&'a str, Vec<&'a Joint>>,
    root: &'a str,
}

impl<'a> Tree<'a> {
    /// Refuses what is not a tree; names have been seen to be there once.
    pub(super) fn new(robot: &'a Robot) -> Result<Self, ImportError> {
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
        let root = match roots.as_slice() {
            [root] => root,
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
        let tree = Tree {
            root,
            links,
            joints,
        };
        tree.check_reach()?;
        Ok(tree)
    }

    /// Refuses links that hang on each other in a circle.
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

    /// The link that carries all others; of a robot that is bolted down to a link `world`, the one that is fixed there.
    pub(super) fn base(&self) -> &'a str {
        match self.joints(self.root) {
            [only] if self.is_bolted_down() && is_fixed(only) => &only.child,
            _ => self.root,
        }
    }

    /// Whether the robot hangs on a link `world`, which by convention does not move.
    pub(super) fn is_bolted_down(&self) -> bool {
        self.root == WORLD
    }

    fn joints(&self, link: &str) -> &[&'a Joint] {
        self.joints.get(link).map_or(&[], Vec::as_slice)
    }

    /// A link at `pose`, and all that fixed joints hold to it, each with its own pose.
    pub(super) fn rigid(&self, link: &'a str, pose: Pose) -> Vec<(&'a Link, Pose)> {
        let mut open = vec![(link, pose)];
        let mut found = Vec::new();
        while let Some((name, pose)) = open.pop() {
            found.extend(self.links.get(name).map(|link| (*link, pose)));
            let fixed = self.joints(name).iter().filter(|joint| is_fixed(joint));
            open.extend(fixed.map(|joint| (joint.child.as_str(), pose.then(&joint.origin))));
        }
        found
    }

    /// The joints that move on these links, in the order of the file, each with the pose of its frame.
    pub(super) fn movable(&self, links: &[(&'a Link, Pose)]) -> Vec<(&'a Joint, Pose)> {
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

    /// The names of a joint, of its link, and of all that hangs there.
    pub(super) fn names_after(&self, joint: &'a Joint) -> Vec<&'a str> {
        let mut open = vec![joint];
        let mut names = Vec::new();
        while let Some(joint) = open.pop() {
            names.extend([joint.name.as_str(), joint.child.as_str()]);
            open.extend(self.joints(&joint.child));
        }
        names
    }

    /// Whether nothing hangs on the link.
    pub(super) fn is_leaf(&self, link: &Link) -> bool {
        self.joints(&link.name).is_empty()
    }
}

fn is_fixed(joint: &Joint) -> bool {
    joint.kind == Kind::Fixed
}
