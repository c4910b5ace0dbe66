//! Groups of links that move as one: mass and collision shapes, the body of a walking robot, and the
//! slider that carries a floor.

use super::chains::Chain;
use super::names::listed;
use super::transform::{Transform, point_tensor};
use super::tree::{Geometry, Joint, JointType, Link, LinkTree, Piece};
use crate::message::Importing;
use crate::urdf::frame::{self, FLOOR};
use tip_runtime::model::{InertialProperties, Point, Range, Slider};
use tipc::description::{Form, Shape};

/// Greatest relative deviation of an axis along x, y or z.
const SLIGHT: f64 = 1e-9;

/// Returns the extents of the body along x, y and z (mm): those of the only box in the
/// visual geometry of the body.
pub(super) fn body_extents(rigid: &[(&Link, Transform)]) -> Option<[Range; 3]> {
    let (link, pose) = rigid.iter().find(|(link, _)| !link.visuals.is_empty())?;
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

/// Returns the slider: a chain of prismatic joints along x, y and z of the robot frame to a link
/// `floor`. All its joints are at 0 in its initial position.
pub(super) fn slider(tree: &LinkTree<'_>, rigid: &[(&Link, Transform)]) -> Option<Slider> {
    if let Some(initial) = floor(rigid) {
        return Some(still(initial));
    }
    let firsts = tree.movable(rigid);
    firsts
        .into_iter()
        .find_map(|(joint, pose)| follow(tree, joint, pose))
}

/// Returns true if a joint begins the chain of the slider.
pub(super) fn is_slider(tree: &LinkTree<'_>, joint: &Joint, pose: Transform) -> bool {
    follow(tree, joint, pose).is_some()
}

fn follow<'a>(tree: &LinkTree<'a>, first: &'a Joint, pose: Transform) -> Option<Slider> {
    let mut travel: [Option<Range>; 3] = [None; 3];
    let mut next = (first, pose);
    loop {
        let (joint, pose) = next;
        let (axis, sign) = axis(pose.direction(joint.axis))?;
        if joint.kind != JointType::Prismatic || travel[axis].is_some() {
            return None;
        }
        let limit = joint.limit;
        let ends = [
            limit.lower.unwrap_or(-limit.unstated),
            limit.upper.unwrap_or(limit.unstated),
        ]
        .map(|end| end * sign * 1000.0);
        travel[axis] = Some(Range::new(ends[0].min(ends[1]), ends[0].max(ends[1])));
        let links = tree.carried(joint, pose);
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

/// Returns a slider that cannot move, at `initial`, mm.
fn still(initial: Point) -> Slider {
    Slider {
        initial,
        travel: initial.map(|at| Range::new(at, at)),
    }
}

fn floor(links: &[(&Link, Transform)]) -> Option<Point> {
    let (_, pose) = links.iter().find(|(link, _)| link.name == FLOOR)?;
    Some(pose.origin())
}

/// Returns the axis of a direction, and its sense: 1 or −1.
fn axis(direction: [f64; 3]) -> Option<(usize, f64)> {
    let size = direction.iter().map(|part| part * part).sum::<f64>().sqrt();
    let is_along = |axis: &usize| (direction[*axis].abs() - size).abs() <= SLIGHT * size;
    let axis = (0..3).find(|axis| size > 0.0 && is_along(axis))?;
    Some((axis, direction[axis].signum()))
}

/// Number of digits of a tensor that are written.
const DIGITS: usize = 11;

/// Returns the mass of all links, kg.
pub(super) fn mass(links: &[(&Link, Transform)]) -> f64 {
    links.iter().map(|(link, _)| link.mass).sum()
}

/// The centre of mass of links that move as one, and their tensor about it if it is known.
pub(super) struct Weight {
    /// Centre, mm.
    pub(super) centre: Point,
    /// Tensor in a frame that is parallel to the robot frame, kg·m².
    pub(super) inertia: Option<[f64; 6]>,
}

/// Returns centre and tensor of all links, with the centre seen from `at`; `None` without mass. A link
/// whose tensor is missing, or one of a body larger than `reach` (mm), counts as a point mass; where such
/// links are most of the mass, the tensor is unknown.
pub(super) fn weight(links: &[(&Link, Transform)], at: Point, reach: f64) -> Option<Weight> {
    let total = mass(links);
    let heavy = || links.iter().filter(|(link, _)| link.mass > 0.0);
    if total <= 0.0 {
        return None;
    }
    let place = |(link, pose): &(&Link, Transform)| pose.then(&link.centre).origin();
    let centre = heavy().fold([0.0; 3], |sum, own| {
        let (share, place) = (own.0.mass / total, place(own));
        [0, 1, 2].map(|axis| sum[axis] + share * place[axis])
    });
    let is_known = |link: &Link| !is_flat(link) && !is_doubtful(link, reach);
    let known: f64 = heavy()
        .filter(|(link, _)| is_known(link))
        .map(|(link, _)| link.mass)
        .sum();
    let inertia = heavy().fold([0.0; 6], |sum, own| {
        let (link, pose) = own;
        let turned = match is_known(link) {
            true => pose.then(&link.centre).tensor(link.inertia),
            false => [0.0; 6],
        };
        let place = place(own);
        let away = [0, 1, 2].map(|axis| (place[axis] - centre[axis]) / 1000.0);
        let moved = point_tensor(link.mass, away);
        std::array::from_fn(|element| sum[element] + turned[element] + moved[element])
    });
    let inertia = rounded(inertia);
    let is_sound = InertialProperties { centre, inertia }.is_sound();
    Some(Weight {
        centre: [0, 1, 2].map(|axis| centre[axis] - at[axis]),
        inertia: (2.0 * known >= total && is_sound).then_some(inertia),
    })
}

/// Returns true if a link has mass but no inertia about some axis.
pub(super) fn is_flat(link: &Link) -> bool {
    let [xx, yy, zz, ..] = link.inertia;
    link.mass > 0.0 && [xx, yy, zz].iter().any(|moment| *moment <= 0.0)
}

/// Returns true if a link has mass, and an inertia of no rigid body, or of one that is larger than
/// the robot.
pub(super) fn is_doubtful(link: &Link, reach: f64) -> bool {
    let own = InertialProperties {
        centre: [0.0; 3],
        inertia: link.inertia,
    };
    let [xx, yy, zz, ..] = link.inertia;
    let most = link.mass * (reach / 1000.0) * (reach / 1000.0);
    link.mass > 0.0 && !is_flat(link) && !(own.is_sound() && xx.max(yy).max(zz) <= most)
}

/// Rounds the elements of a tensor, and clears the noise of its rotation.
fn rounded(tensor: [f64; 6]) -> [f64; 6] {
    let most = tensor
        .iter()
        .fold(0.0_f64, |most, element| most.max(element.abs()));
    tensor.map(|element| match element.abs() > most * 1e-12 {
        true => format!("{element:.DIGITS$e}").parse().unwrap_or(element),
        false => 0.0,
    })
}

/// Limits of sizes and positions in descriptions, mm.
const MIN_SIZE: f64 = frame::MIN_SIZE;
const MAX_SIZE: f64 = 1e6;

/// Returns the collision shapes of links that move as one, seen from `at` (mm), in a frame that is
/// parallel to the robot frame.
pub(super) fn shapes(links: &[(&Link, Transform)], at: Point) -> Vec<Shape> {
    let all = all(links, at).map(|(_, shape)| shape);
    all.filter(is_possible).collect()
}

/// Reports the dropped shapes of legs and base, a line for each reason.
pub(super) fn dropped(
    legs: &[Chain<'_>],
    base: &[(&Link, Transform)],
    has_body: bool,
) -> Vec<Importing> {
    const HERE: Point = [0.0; 3];
    let joints = legs.iter().flat_map(|leg| &leg.joints);
    let mut rigid: Vec<(&[(&Link, Transform)], Point)> = Vec::new();
    if has_body {
        rigid.push((base, HERE));
    }
    rigid.extend(joints.map(|turning| (turning.links.as_slice(), turning.at)));
    let is_mesh = |piece: &Piece| piece.geometry == Geometry::Mesh;
    let links = rigid.iter().flat_map(|(links, _)| *links);
    let meshes = links.filter(|(link, _)| link.collisions.iter().any(is_mesh));
    let shapes = rigid.iter().flat_map(|(links, at)| all(links, *at));
    let impossible = shapes.filter(|(_, shape)| !is_possible(shape));
    let of_base = !has_body && !self::shapes(base, HERE).is_empty();
    [
        listed(meshes.map(|(link, _)| &link.name)).map(|links| Importing::Meshes { links }),
        listed(impossible.map(|(link, _)| &link.name)).map(|links| Importing::NoSize { links }),
        of_base.then_some(Importing::BaseShapes),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// Returns the box around shapes, at least one of which has to be a block: a body is hardly made of
/// others alone.
pub(super) fn shape_extents(shapes: &[Shape]) -> Option<[Range; 3]> {
    let is_block = |shape: &Shape| matches!(shape.form, Form::Block(_));
    shapes.iter().any(is_block).then(|| {
        [0, 1, 2].map(|axis| {
            let ends = shapes
                .iter()
                .map(|shape| (shape.at[axis], half(shape, axis)));
            ends.fold(
                Range::new(f64::INFINITY, f64::NEG_INFINITY),
                |range, (at, half)| Range::new(range.min.min(at - half), range.max.max(at + half)),
            )
        })
    })
}

/// Returns the half extent of a shape along an axis of the robot frame, mm.
fn half(shape: &Shape, axis: usize) -> f64 {
    let [x, y, z] = shape.axes.map(|own| own[axis].abs());
    match shape.form {
        Form::Block([a, b, c]) => (a * x + b * y + c * z) / 2.0,
        // The rim of its end, seen from the side.
        Form::Cylinder { radius, length } => length * z / 2.0 + radius * (x * x + y * y).sqrt(),
        Form::Sphere { radius } => radius,
    }
}

/// Iterates over each link's shapes, including those that no description can have.
fn all<'a>(links: &[(&'a Link, Transform)], at: Point) -> impl Iterator<Item = (&'a Link, Shape)> {
    let pieces = links.iter().flat_map(|(link, pose)| {
        let pieces = link.collisions.iter();
        pieces.map(|piece| (*link, pose.then(&piece.origin), piece))
    });
    pieces.flat_map(move |(link, pose, piece)| {
        let parts = parts(&piece.geometry).into_iter();
        parts.map(move |(form, up)| (link, placed(form, &pose, up, at)))
    })
}

/// Returns true if a description can have a shape.
fn is_possible(shape: &Shape) -> bool {
    let sizes = match shape.form {
        Form::Block(sides) => sides.to_vec(),
        Form::Cylinder { radius, length } => vec![radius, length],
        Form::Sphere { radius } => vec![radius],
    };
    let is_size = |size: &f64| (MIN_SIZE..=MAX_SIZE).contains(size);
    let is_near = |part: &f64| (-MAX_SIZE..=MAX_SIZE).contains(part);
    sizes.iter().all(is_size) && shape.at.iter().all(is_near)
}

/// Returns the forms of a geometry, each with its position on the geometry's z axis, m. A block has
/// x to the right, as in the robot frame.
fn parts(geometry: &Geometry) -> Vec<(Form, f64)> {
    let mm = |metres: &f64| metres * 1000.0;
    let cylinder = |radius, length| Form::Cylinder {
        radius: mm(radius),
        length: mm(length),
    };
    let sphere = |radius| Form::Sphere { radius: mm(radius) };
    match geometry {
        Geometry::Box([x, y, z]) => vec![(Form::Block([y, x, z].map(mm)), 0.0)],
        Geometry::Cylinder { radius, length } => vec![(cylinder(radius, length), 0.0)],
        Geometry::Capsule { radius, length } => vec![
            (cylinder(radius, length), 0.0),
            (sphere(radius), length / 2.0),
            (sphere(radius), -length / 2.0),
        ],
        Geometry::Sphere { radius } => vec![(sphere(radius), 0.0)],
        Geometry::Mesh => Vec::new(),
    }
}

/// Returns a form in a frame of URDF, moved up its z axis by `up` (m).
fn placed(form: Form, pose: &Transform, up: f64, from: Point) -> Shape {
    let at = pose.then(&Transform::shifted([0.0, 0.0, up])).origin();
    Shape {
        form,
        at: [0, 1, 2].map(|axis| at[axis] - from[axis]),
        // To the right is what is not to the left, forward is x.
        axes: [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]].map(|own| pose.direction(own)),
    }
}
