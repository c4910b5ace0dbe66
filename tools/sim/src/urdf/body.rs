//! What stays with the base: the body of a robot that walks, and the slider that carries a floor.

use super::frame::{BODY, FLOOR};
use super::pose::Pose;
use super::robot::{Geometry, Joint, Kind, Link};
use super::tree::Tree;
use tip_runtime::model::{Point, Range, Slider};

/// An axis that is off by less than this is along x, y or z.
const SLIGHT: f64 = 1e-9;

/// The extents of the body along x, y and z (mm): those of the only box of a link `body`.
pub(super) fn extents(rigid: &[(&Link, Pose)]) -> Option<[Range; 3]> {
    let (link, pose) = rigid.iter().find(|(link, _)| link.name == BODY)?;
    let mut boxes = link
        .visuals
        .iter()
        .filter_map(|piece| match piece.geometry {
            Geometry::Box(size) if size.iter().all(|side| *side > 0.0) => {
                Some((&piece.origin, size))
            }
            _ => None,
        });
    let (Some((origin, size)), None) = (boxes.next(), boxes.next()) else {
        return None;
    };
    let pose = pose.then(origin);
    let centre = pose.origin();
    let mut half = [0.0; 3];
    for (side, length) in size.iter().enumerate() {
        let mut along = [0.0; 3];
        along[side] = 1.0;
        half[axis(pose.direction(along))?.0] = length * 500.0;
    }
    Some([0, 1, 2].map(|i| Range::new(centre[i] - half[i], centre[i] + half[i])))
}

/// The slider: a chain of prismatic joints along x, y and z of the robot frame to a link `floor`. All its joints are at 0
/// where it is at first.
pub(super) fn slider(tree: &Tree<'_>, rigid: &[(&Link, Pose)]) -> Option<Slider> {
    if let Some(initial) = floor(rigid) {
        return Some(still(initial));
    }
    let firsts = tree.movable(rigid);
    firsts
        .into_iter()
        .find_map(|(joint, pose)| follow(tree, joint, pose))
}

/// Whether a joint begins the chain of the slider.
pub(super) fn is_slider(tree: &Tree<'_>, joint: &Joint, pose: Pose) -> bool {
    follow(tree, joint, pose).is_some()
}

fn follow<'a>(tree: &Tree<'a>, first: &'a Joint, pose: Pose) -> Option<Slider> {
    let mut travel: [Option<Range>; 3] = [None; 3];
    let mut next = (first, pose);
    loop {
        let (joint, pose) = next;
        let (axis, sign) = axis(pose.direction(joint.axis))?;
        if joint.kind != Kind::Prismatic || travel[axis].is_some() {
            return None;
        }
        let limit = joint.limit;
        let ends = [
            limit.lower.unwrap_or(-limit.unstated),
            limit.upper.unwrap_or(limit.unstated),
        ]
        .map(|end| end * sign * 1000.0);
        travel[axis] = Some(Range::new(ends[0].min(ends[1]), ends[0].max(ends[1])));
        let links = tree.rigid(&joint.child, pose);
        match tree.movable(&links).as_slice() {
            [] => {
                let mut slider = still(floor(&links)?);
                for (range, goes) in slider.travel.iter_mut().zip(travel) {
                    let goes = goes.unwrap_or(Range::new(0.0, 0.0));
                    *range = Range::new(range.min + goes.min, range.max + goes.max);
                }
                return Some(slider);
            }
            [only] => next = *only,
            _ => return None,
        }
    }
}

/// A slider that goes nowhere: mm.
fn still(initial: Point) -> Slider {
    Slider {
        initial,
        travel: initial.map(|at| Range::new(at, at)),
    }
}

fn floor(links: &[(&Link, Pose)]) -> Option<Point> {
    let (_, pose) = links.iter().find(|(link, _)| link.name == FLOOR)?;
    Some(pose.origin())
}

/// Which axis a direction is along, and whether forwards (1) or backwards (−1).
fn axis(direction: [f64; 3]) -> Option<(usize, f64)> {
    let size = direction.iter().map(|part| part * part).sum::<f64>().sqrt();
    let is_along = |axis: &usize| (direction[*axis].abs() - size).abs() <= SLIGHT * size;
    let axis = (0..3).find(|axis| size > 0.0 && is_along(axis))?;
    Some((axis, direction[axis].signum()))
}
