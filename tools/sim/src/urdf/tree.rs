//! The tree of links and joints.

use super::ImportError;
use super::frame::WORLD;
use super::parse::{JointType, UrdfJoint, UrdfLink, UrdfRobot};
use super::transform::Transform;
use crate::message::Importing;
use std::collections::{BTreeMap, BTreeSet};

/// The robot's links, and the joints on each.
pub(super) struct LinkTree<'a> {
    links: BTreeMap<&'a str, &'a UrdfLink>,
    joints: BTreeMap<&'a str, Vec<&'a UrdfJoint>>,
    root: &'a str,
}

impl<'a> LinkTree<'a> {
    /// Builds the tree; names are unique. Refuses everything that is not a tree.
    pub(super) fn new(robot: &'a UrdfRobot) -> Result<Self, ImportError> {
        let mut links = BTreeMap::new();
        for link in &robot.links {
            links.insert(link.name.as_str(), link);
        }
        let mut joints: BTreeMap<&str, Vec<&UrdfJoint>> = BTreeMap::new();
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

    fn joints(&self, link: &str) -> &[&'a UrdfJoint] {
        self.joints.get(link).map_or(&[], Vec::as_slice)
    }

    /// Returns a link at `pose`, and all links that fixed joints hold to it, each with its own
    /// pose.
    pub(super) fn rigid(&self, link: &'a str, pose: Transform) -> Vec<(&'a UrdfLink, Transform)> {
        let mut open = vec![(link, pose)];
        let mut found = Vec::new();
        while let Some((name, pose)) = open.pop() {
            found.extend(self.links.get(name).map(|link| (*link, pose)));
            let fixed = self.joints(name).iter().filter(|joint| is_fixed(joint));
            open.extend(fixed.map(|joint| (joint.child.as_str(), pose.then(&joint.origin))));
        }
        found
    }

    /// Returns the movable joints on these links, in the order of the file, each with the pose of
    /// its frame.
    pub(super) fn movable(
        &self,
        links: &[(&'a UrdfLink, Transform)],
    ) -> Vec<(&'a UrdfJoint, Transform)> {
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
    pub(super) fn names_after(&self, joint: &'a UrdfJoint) -> Vec<&'a str> {
        let mut open = vec![joint];
        let mut names = Vec::new();
        while let Some(joint) = open.pop() {
            names.extend([joint.name.as_str(), joint.child.as_str()]);
            open.extend(self.joints(&joint.child));
        }
        names
    }

    /// Returns true if no joint is on the link.
    pub(super) fn is_leaf(&self, link: &UrdfLink) -> bool {
        self.joints(&link.name).is_empty()
    }
}

fn is_fixed(joint: &UrdfJoint) -> bool {
    joint.kind == JointType::Fixed
}
